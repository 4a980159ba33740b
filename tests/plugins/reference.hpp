// Reference cases in JSON files, and the comparison that they are held to.
#pragma once

#include <Eigen/Core>
#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace pmreport::test {

using nlohmann::json;

inline constexpr double tolerance = 1e-9;  // promised; what double precision gives is some 1e-13

// Read once and kept, so that a loop over a part of it has something to stand on.
inline const json& reference(const std::string& name) {
  static std::map<std::string, json> files;
  auto found = files.find(name);
  if (found == files.end()) {
    std::ifstream file(TEST_DATA "/" + name);
    REQUIRE(file);
    found = files.emplace(name, json::parse(file)).first;
  }
  return found->second;
}

// Numbers may stand as texts, with more digits than a double holds.
inline double number(const json& j) { return j.is_string() ? json::parse(j.get<std::string>()).get<double>() : j.get<double>(); }
inline Eigen::VectorXd vector(const json& j) {
  Eigen::VectorXd v(static_cast<Eigen::Index>(j.size()));
  for (std::size_t i = 0; i < j.size(); ++i) v(static_cast<Eigen::Index>(i)) = number(j[i]);
  return v;
}
inline Eigen::Vector3d vector3(const json& j) { return vector(j); }
inline Eigen::MatrixXd matrix(const json& rows) {
  Eigen::MatrixXd m(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows.at(0).size()));
  for (std::size_t i = 0; i < rows.size(); ++i) m.row(static_cast<Eigen::Index>(i)) = vector(rows[i]).transpose();
  return m;
}

// Every number of `seen` equals that of `expected`, relative to the larger of the number itself and of the vector's `scale`; 0: its
// largest number, which is what an error is to be compared with when a component passes through zero.
inline void check_equal(const char* what, const Eigen::VectorXd& seen, const Eigen::VectorXd& expected, double scale = 0) {
  CAPTURE(what, seen.transpose(), expected.transpose());
  REQUIRE(seen.size() == expected.size());
  if (scale == 0) scale = expected.lpNorm<Eigen::Infinity>();
  for (Eigen::Index i = 0; i < seen.size(); ++i)
    CHECK(std::abs(seen(i) - expected(i)) <= tolerance * std::max(std::abs(expected(i)), scale));
}
inline void check_equal(const char* what, double seen, double expected, double scale = 0) {
  check_equal(what, Eigen::VectorXd::Constant(1, seen), Eigen::VectorXd::Constant(1, expected), scale);
}

}  // namespace pmreport::test
