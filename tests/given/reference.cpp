#include <tests/given/reference.hpp>

namespace pmreport::test {

const json& reference(const std::string& name) {
  static std::map<std::string, json> files;
  auto found = files.find(name);
  if (found == files.end()) {
    std::ifstream file(TEST_DATA "/" + name);
    REQUIRE(file);
    found = files.emplace(name, json::parse(file)).first;
  }
  return found->second;
}

double number(const json& j) { return j.is_string() ? json::parse(j.get<std::string>()).get<double>() : j.get<double>(); }

Eigen::VectorXd vector(const json& j) {
  Eigen::VectorXd v(static_cast<Eigen::Index>(j.size()));
  for (std::size_t i = 0; i < j.size(); ++i) v(static_cast<Eigen::Index>(i)) = number(j[i]);
  return v;
}

Eigen::Vector3d vector3(const json& j) { return vector(j); }

Eigen::MatrixXd matrix(const json& rows) {
  Eigen::MatrixXd m(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows.at(0).size()));
  for (std::size_t i = 0; i < rows.size(); ++i) m.row(static_cast<Eigen::Index>(i)) = vector(rows[i]).transpose();
  return m;
}

void check_equal(const char* what, const Eigen::VectorXd& seen, const Eigen::VectorXd& expected, double scale) {
  CAPTURE(what, seen.transpose(), expected.transpose());
  REQUIRE(seen.size() == expected.size());
  if (scale == 0) scale = expected.lpNorm<Eigen::Infinity>();
  for (Eigen::Index i = 0; i < seen.size(); ++i)
    CHECK(std::abs(seen(i) - expected(i)) <= tolerance * std::max(std::abs(expected(i)), scale));
}

void check_equal(const char* what, double seen, double expected, double scale) {
  check_equal(what, Eigen::VectorXd::Constant(1, seen), Eigen::VectorXd::Constant(1, expected), scale);
}

}  // namespace pmreport::test
