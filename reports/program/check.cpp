#include <reports/program/check.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <limits>

namespace pmreport::program {

namespace {

double share_of_tolerance(const mechanics::Property& p) {
  if (p.worst == 0) return 0;
  return p.tolerance > 0 ? p.worst / p.tolerance : std::numeric_limits<double>::infinity();
}

}  // namespace

Checked print_properties(const mechanics::Machine& machine, int poses) {
  fmt::print("{}: home and {} random poses\n\n{:<50} {:>9} {:>9}      \n", machine.info().name, poses, "property", "worst", "allowed");
  Checked c{machine.info().name, 0, 0, "", -1};
  for (const mechanics::Property& p : check_properties(machine, {poses, 1})) {
    fmt::print("{:<50} {:>9.1e} {:>9.0e} {:<4} {}\n", p.claim, p.worst, p.tolerance, p.unit, p.passed() ? "pass" : "FAIL");
    if (!p.passed()) fmt::print("    compared: {}\n    worst: {}\n", p.how, p.where);
    ++c.properties;
    if (p.passed()) ++c.passed;
    if (const double share = share_of_tolerance(p); share > c.share) c.closest = p.claim, c.share = share;
  }
  return c;
}

void print_table(const std::vector<Checked>& all) {
  std::size_t width = 9;
  for (const Checked& c : all) width = std::max(width, c.mechanism.size());
  fmt::print("\n{:<{}}  {:<16} {:>11}  {}\n", "mechanism", width, "properties", "of allowed", "by");
  for (const Checked& c : all)
    fmt::print("{:<{}}  {:<16} {:>11.1e}  {}\n", c.mechanism, width,
               fmt::format("{} of {} {}", c.passed, c.properties, c.all_passed() ? "pass" : "FAIL"), c.share, c.closest);
}

}  // namespace pmreport::program
