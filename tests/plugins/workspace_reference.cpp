// The counts of grids against cases that two other programs computed, with body frames and with angles in closed form. No value of theirs
// lies so near a limit that rounding could change a count.
#include <core/scan/proved_volume.hpp>
#include <tests/plugins/workspace.hpp>

#include <map>

namespace pmreport::test {

namespace {

using Counts = std::map<std::string, std::uint64_t>;

Counts named(const mechanics::PoseMargins& margins, const std::vector<std::uint64_t>& counts) {
  Counts out;
  for (std::size_t m = 0; m < counts.size(); ++m)
    if (counts[m] > 0) out[margins.margins[m].name] += counts[m];
  return out;
}

Counts expected_counts(const json& j) {
  Counts out;
  for (const auto& [name, count] : j.items())
    if (count > 0) out[name] = count;
  return out;
}

mechanics::PoseMargins margins_of(const mechanics::Machine& machine, const json& c) {
  mechanics::LimitChoice choice;
  choice.joints = c.at("limits") != "strokes";
  std::string why;
  auto margins = mechanics::pose_margins(machine, choice, &why);
  INFO(why);
  REQUIRE(margins);
  return *margins;
}

}  // namespace

TEST_CASE("grids of every mechanism accept the poses that reference programs accept, and refuse the others for the same reasons") {
  for (const json& c : reference("workspace.json").at("cases")) {
    const std::string id = c.at("id");
    CAPTURE(id);
    const json& expected = c.at("expected");
    const auto machine = machine_of(c);
    const mechanics::PoseMargins margins = margins_of(*machine, c);
    const scan::Scan scan = scan_of(*machine, c.at("grid"), c.at("points"));
    const scan::GridCounts counts = scan::count_grid(pose_set(margins), scan, {});
    CHECK(counts.tally.poses == expected.at("poses"));
    CHECK(counts.tally.accepted == expected.at("accepted"));
    CHECK(counts.tally.on_a_limit == 0);
    CHECK(named(margins, counts.tally.first) == expected_counts(expected.at("refused_first")));
    CHECK(named(margins, counts.tally.any) == expected_counts(expected.at("refused_any")));
    for (std::size_t a = 0; a < scan.points.size(); ++a) {
      const std::string name = machine->topology().coordinates[static_cast<std::size_t>(scan.points[a].input)].name;
      const json& box = expected.at("box_of_accepted").at(name);
      CHECK(counts.low[a] == Approx(box[0].get<double>()).margin(1e-12));
      CHECK(counts.high[a] == Approx(box[1].get<double>()).margin(1e-12));
      CHECK(counts.centroid[a] == Approx(expected.at("centroid_of_accepted").at(name).get<double>()).margin(1e-12));
    }
    if (scan.orientations.empty())
      CHECK(scan.cell() * double(counts.tally.accepted) == Approx(expected.at("measure").get<double>()).epsilon(1e-12));
    if (expected.contains("points_with_at_least"))
      for (const auto& [n, points] : expected.at("points_with_at_least").items()) {
        const auto least = static_cast<std::uint32_t>(std::stoul(n));
        CHECK(std::ranges::count_if(counts.accepted_at, [&](std::uint32_t k) { return k >= least; }) == points);
      }
  }
}

TEST_CASE("proved volumes hold the measures that are known in closed form") {
  int looked_at = 0;
  for (const json& c : reference("workspace.json").at("cases")) {
    if (!c.contains("exact") || c.at("exact").is_null()) continue;
    const std::string id = c.at("id");
    CAPTURE(id);
    const auto machine = machine_of(c);
    const mechanics::PoseMargins margins = margins_of(*machine, c);
    scan::VolumeOptions options;
    options.gap = 0.01;
    const scan::ProvedVolume v = scan::prove_volume(pose_set(margins), scan_of(*machine, c.at("grid"), c.at("points")), options);
    const double exact = c.at("exact").at("measure"), error = c.at("exact").at("error");
    CAPTURE(v.volume.low, v.volume.high, exact, v.boxes, v.why);
    CHECK(v.volume.low <= exact + error);
    CHECK(exact - error <= v.volume.high);
    CHECK(v.enough);
    ++looked_at;
  }
  CHECK(looked_at == 5);
}

}  // namespace pmreport::test
