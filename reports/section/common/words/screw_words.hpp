// Screws in the words of the field: what a force acts along, what a platform turns about.
#pragma once

#include <core/mechanics/mobility/mobility.hpp>
#include <core/text/text.hpp>
#include <reports/section/common/analysis.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

// The joints of a pose, by which screws are told. All angles and distances are judged within 1e-6, of `length` [m].
struct Surroundings {
  const mechanics::Machine& machine;
  const mechanics::State& state;
  double length;
  std::vector<int> joints;  // those that may be named
};
Surroundings surroundings(const mechanics::Machine& machine, const mechanics::State& state, double length);  // with all joints

// "X"; "the axis of B5 (0.598, 0.802, 0)"; "(0.6, 0.48, 0.64)".
std::string direction_words(const Surroundings& s, const Eigen::Vector3d& unit);
// "(12.3, −45, 0) mm".
std::string point_words(const Eigen::Vector3d& point, double length);
// "a couple about Z", "a force along X through A5", "a wrench of pitch 12 mm along ...".
std::string wrench_words(const Surroundings& s, const mechanics::Screw& wrench);
// "turn about the line through S1, S5 and S2", "move along X without turning", "turn about the axis ... with 12 mm of translation a
// radian".
std::string twist_words(const Surroundings& s, const mechanics::Screw& twist);

// The kinds of the wrenches of a system: "1 force", "2 couples and 1 force"; "none".
std::string kinds_of(const std::vector<mechanics::NamedWrench>& wrenches);

}  // namespace pmreport::section
