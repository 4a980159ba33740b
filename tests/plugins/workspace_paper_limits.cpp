// Limits that papers count otherwise than from home, against reference programs.
#include <core/numbers.hpp>
#include <core/scan/components.hpp>
#include <tests/plugins/workspace.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <numbers>

namespace pmreport::test {

namespace {

using mechanics::AskedLimit;

const json& case_named(const std::string& id) {
  for (const json& c : reference("workspace-paper-limits.json").at("cases"))
    if (c.at("id") == id) return c;
  throw std::out_of_range(id);
}

mechanics::PoseMargins margins_of(const mechanics::Machine& machine, const mechanics::LimitChoice& choice) {
  for (const AskedLimit& asked : choice.asked) {
    const auto why = mechanics::refusal(machine, asked);
    INFO(why.value_or(""));
    REQUIRE_FALSE(why);
  }
  std::string why;
  auto margins = mechanics::pose_margins(machine, choice, &why);
  INFO(why);
  REQUIRE(margins);
  return *margins;
}

AskedLimit angle(const char* name, std::vector<int> limbs, mechanics::Direction against, double max) {
  AskedLimit out;
  out.name = name;
  out.what = mechanics::AskedAngle{std::move(limbs), against};
  out.max = max;
  return out;
}

AskedLimit distance(const char* name, std::vector<int> limbs, std::vector<int> with, double min) {
  AskedLimit out;
  out.name = name;
  out.what = mechanics::AskedDistance{std::move(limbs), std::move(with), false};
  out.min = min;
  return out;
}

AskedLimit value(const char* name, double min, double max) { return {"", mechanics::AskedValue{name}, min, max}; }

// Poses refused first by margins whose names begin so.
std::uint64_t first_of(const mechanics::PoseMargins& margins, const scan::Tally& tally, const std::string& beginning) {
  std::uint64_t out = 0;
  for (std::size_t m = 0; m < margins.margins.size(); ++m)
    if (margins.margins[m].name.starts_with(beginning)) out += tally.first[m];
  return out;
}

std::uint64_t points_with(const scan::GridCounts& counts, std::uint32_t least) {
  return static_cast<std::uint64_t>(std::ranges::count_if(counts.accepted_at, [&](std::uint32_t n) { return n >= least; }));
}

}  // namespace

TEST_CASE("limits of a parallel-cross mechanism as its paper counts them give the counts of reference programs") {
  const json& c = case_named("inner-P1-paper-limits");
  const json &limits = c.at("limits"), &expected = c.at("expected");
  json with = c;
  with["parameters"]["leg_min"] = limits.at("rho")[0], with["parameters"]["leg_max"] = limits.at("rho")[1];
  with["parameters"]["cross_min"] = limits.at("cross")[0], with["parameters"]["cross_max"] = limits.at("cross")[1];
  const auto machine = machine_of(with);
  const double cone = limits.at("cone").get<double>() * deg, hinge = limits.at("hinge").get<double>() * deg, apart = limits.at("distance");
  const int platform = machine->topology().platform;
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  mechanics::LimitChoice choice;
  choice.joints = false;
  choice.asked = {angle("base cone", {1, 2, 3}, {0, z}, cone),        angle("platform cone", {1, 2, 3}, {platform, z}, cone),
                  value("derived", hinge, std::numbers::pi - hinge),  distance("leg-leg", {1, 2, 3}, {}, apart),
                  distance("cross-leg", {1, 2, 3}, {4, 5, 6}, apart), distance("cross-cross", {4, 5, 6}, {}, apart)};

  scan::Scan scan;
  scan.at.assign(6, 0.0);
  for (int i = 0; i < 2; ++i) scan.points.push_back({i, -1.2, 1.2, 25});
  scan.points.push_back({2, 0.1, 1.3, 13});
  scan.turned = {3, 4, 5};
  for (int a = -6; a <= 6; ++a)
    for (int b = -6; b <= 6; ++b)
      for (int g = -6; g <= 6; ++g) scan.orientations.push_back({a * 10 * deg, b * 10 * deg, g * 10 * deg});

  const mechanics::PoseMargins geometry = margins_of(*machine, choice);
  const program::Program sign = mechanics::determinant_program(*machine);
  scan::GridOptions options;
  options.sign = &sign;
  const scan::GridCounts counts = scan::count_grid(pose_set(geometry), scan, options);
  CHECK(counts.tally.poses == expected.at("poses"));
  CHECK(counts.tally.accepted == expected.at("accepted_poses"));
  CHECK(counts.positive == expected.at("accepted_by_sign_of_det").at("+"));
  CHECK(counts.negative == expected.at("accepted_by_sign_of_det").at("-"));
  for (const std::uint32_t n : {1u, 100u, 200u, 400u})
    CHECK(points_with(counts, n) == expected.at("points_with_at_least_" + std::to_string(n)));
  for (const auto& [ours, theirs] : {std::pair{"rho1", "rho1"},
                                     {"rho2", "rho2"},
                                     {"rho3", "rho3"},
                                     {"rho4", "rho4"},
                                     {"rho5", "rho5"},
                                     {"rho6", "rho6"},
                                     {"base cone", "base cone"},
                                     {"platform cone", "platform cone"},
                                     {"hinge", "hinge"},
                                     {"leg-leg", "leg-leg distance"},
                                     {"cross-leg", "cross-leg distance"},
                                     {"cross-cross", "cross-cross distance"}}) {
    CAPTURE(ours);
    CHECK(first_of(geometry, counts.tally, ours) == expected.at("refused_first").at(theirs));
  }

  AskedLimit pressure;
  pressure.what = mechanics::AskedPressure{};
  pressure.max = limits.at("pressure").get<double>() * deg;
  choice.asked.push_back(pressure);
  options = {};
  options.reasons = false;
  const scan::GridCounts with_pressure = scan::count_grid(pose_set(margins_of(*machine, choice)), scan, options);
  CHECK(with_pressure.tally.accepted == expected.at("accepted_poses_with_pressure"));
  for (const std::uint32_t n : {1u, 100u, 200u, 400u})
    CHECK(points_with(with_pressure, n) == expected.at("points_with_at_least_" + std::to_string(n) + "_and_pressure"));
}

TEST_CASE("limbs against base Z and readings between two values give the counts of reference programs") {
  const json& c = case_named("p2prpu-P1-level-paper-cones");
  const json &limits = c.at("limits"), &expected = c.at("expected");
  const auto machine = machine_of(c);
  mechanics::LimitChoice choice;
  choice.joints = false;
  const double s1 = limits.at("S1_tilt"), u = limits.at("U_tilt");
  choice.asked = {angle("limb", {1, 2, 3}, {0, Eigen::Vector3d::UnitZ()}, limits.at("limb_against_Z")), value("S1_tilt", -s1, s1),
                  value("U2_tilt", -u, u), value("U3_tilt", -u, u)};
  const mechanics::PoseMargins margins = margins_of(*machine, choice);
  const scan::GridCounts counts = scan::count_grid(pose_set(margins), scan_of(*machine, c.at("grid"), {"x", "y", "z"}), {});
  CHECK(counts.tally.poses == expected.at("poses"));
  CHECK(counts.tally.accepted == expected.at("accepted"));
  for (const auto& [name, count] : expected.at("refused_first").items()) {
    const std::string ours = name.starts_with("limb") ? "limb " + name.substr(4, 1) : name;
    CAPTURE(name);
    CHECK(first_of(margins, counts.tally, ours) == count);
  }
}

TEST_CASE("the sheet of home is what single steps reach without a change of sign of det G") {
  const json& c = case_named("outer-P2-one-sheet");
  const json& expected = c.at("expected");
  const auto machine = machine_of(c);
  mechanics::LimitChoice choice;
  choice.joints = false;
  const program::Program sign = mechanics::determinant_program(*machine);
  scan::GridOptions options;
  options.sign = &sign;
  options.keep_poses = true;
  const scan::Scan scan = scan_of(*machine, c.at("grid"), {"x", "y", "alpha"});
  const scan::GridCounts counts = scan::count_grid(pose_set(margins_of(*machine, choice)), scan, options);
  CHECK(counts.tally.accepted == expected.at("accepted"));
  CHECK(counts.positive == expected.at("accepted_with_positive_det"));
  CHECK(counts.negative == expected.at("accepted_with_negative_det"));
  std::vector<std::size_t> sizes;
  std::uint64_t start = 0;
  for (const scan::Axis& a : scan.points) {
    sizes.push_back(a.count);
    const std::string name = machine->topology().coordinates[static_cast<std::size_t>(a.input)].name;
    const double k = std::round((c.at("start").at(name).get<double>() - a.from) / a.step());
    start = start * a.count + static_cast<std::uint64_t>(k);
  }
  const scan::Sheet sheet = scan::sheet_of(sizes, {}, counts, start);
  CHECK(sheet.sign == expected.at("sign_at_start"));
  CHECK(sheet.poses == expected.at("on_the_sheet_of_home"));
  CHECK(sheet.connected == expected.at("connected_without_regard_to_sign"));
}

// Glazunov et al. 2008 give no number for these; two programs agree on them: at home the pressure angles of legs and cross drives.
TEST_CASE("pressure angles at home are those that reference programs found") {
  struct Case {
    const char *plugin, *variant;
    double leg, cross;  // [deg], to the digit that is printed
  };
  for (const Case& k : {Case{"gough", "", 69.9, 69.9},
                        {"stewart", "", 6.0, 33.6},
                        {"parallel-cross", "inner", 8.1, 55.3},
                        {"parallel-cross", "outer", 14.0, 66.1}}) {
    CAPTURE(k.plugin, k.variant);
    const pm_mechanism& table = plugin(k.plugin);
    std::map<std::string, std::vector<double>> changes;
    if (*k.variant != '\0') changes["variant"] = {choice(table, "variant", k.variant)};
    const mechanics::Machine machine(table, values_with(table, changes));
    for (const double slack : {-0.05, 0.05}) {
      for (int i = 0; i < 6; ++i) {
        AskedLimit pressure;
        pressure.what = mechanics::AskedPressure{};
        pressure.max = ((i < 3 ? k.leg : k.cross) + slack) * deg;
        const mechanics::PoseMargins margins = margins_of(machine, {true, true, {pressure}});
        REQUIRE(margins.late == 6);
        const Eigen::VectorXd home = machine.home();
        std::vector<double> at(6);
        margins.judge_late(1, home.data(), at.data());
        CHECK((at[static_cast<std::size_t>(i)] >= 0) == (slack > 0));
      }
    }
  }
}

}  // namespace pmreport::test
