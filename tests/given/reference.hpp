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
const json& reference(const std::string& name);

// Numbers may stand as texts, with more digits than a double holds.
double number(const json& j);
Eigen::VectorXd vector(const json& j);
Eigen::Vector3d vector3(const json& j);
Eigen::MatrixXd matrix(const json& rows);

// Every number of `seen` equals that of `expected`, relative to the larger of the number itself and of the vector's `scale`; 0: its
// largest number, which is what an error is to be compared with when a component passes through zero.
void check_equal(const char* what, const Eigen::VectorXd& seen, const Eigen::VectorXd& expected, double scale = 0);
void check_equal(const char* what, double seen, double expected, double scale = 0);

}  // namespace pmreport::test
