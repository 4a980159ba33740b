// Section `drives`, and its parts.
#pragma once

#include <core/analysis/study/drive_balance.hpp>
#include <core/mechanics/dynamics/drive.hpp>
#include <reports/section/kind.hpp>

#include <numbers>
#include <string>
#include <vector>

namespace pmreport::section {

constexpr double rpm = 30 / std::numbers::pi;  // per rad/s

const std::vector<Actuator>& actuators(const Analysis& a);
const mechanics::DriveTrain& train(const Analysis& a, std::size_t actuator);
using analysis::driven_back;
using analysis::has_motor;
bool any_motor(const Analysis& a);

Result drives_section(const Analysis& a);

std::vector<document::Paragraph> drive_words(const Analysis& a);
std::vector<figure::Figure> drive_figures(const Analysis& a);
std::vector<document::Table> drive_tables(const Analysis& a);

}  // namespace pmreport::section
