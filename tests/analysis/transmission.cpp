// Indices of transmission over a grid of the Delta robot (tests/data/transmission.json).
#include <core/analysis/columns.hpp>
#include <core/analysis/transmission/grid.hpp>
#include <tests/given/reference.hpp>
#include <tests/plugins/delta.hpp>

#include <algorithm>

using namespace pmreport;
using namespace pmreport::analysis;
using nlohmann::json;
using test::check_equal;

namespace {

const IndexOverGrid& index_named(const mechanics::Machine& m, const TransmissionGrid& grid, const std::string& name) {
  const std::vector<Column> columns = transmission_columns(m.topology());
  const auto at = std::ranges::find(columns, name, &Column::name);
  REQUIRE(at != columns.end());
  return grid.indices[static_cast<std::size_t>(at - columns.begin())];
}

}  // namespace

TEST_CASE("means and extremes over a grid of the Delta robot equal the reference") {
  const json& cases = test::reference("transmission.json")["cases"];
  const auto found = std::ranges::find_if(cases, [](const json& c) { return c["kind"] == "grid"; });
  REQUIRE(found != cases.end());
  const json &c = *found, &e = c["expected"];
  std::map<std::string, std::vector<double>> changes;
  for (const auto& [name, value] : c["parameters"].items()) changes[name] = {value.get<double>()};
  const mechanics::Machine m(test::delta(), test::values_with(test::delta(), changes));
  GridRequest request;
  request.joints = false;  // "strokes"
  for (const char* axis : {"x", "y", "z"})
    request.ranges.push_back({axis[0] - 'x', c["grid"][axis]["from"], c["grid"][axis]["to"], c["grid"][axis]["count"]});

  const mechanics::Transmission t(m);
  const auto grid = transmission_grid(t, request);
  REQUIRE(grid);
  CHECK(grid->poses == e["poses"].get<std::size_t>());
  CHECK(grid->accepted == e["accepted"].get<std::size_t>());
  const IndexOverGrid &local = index_named(m, *grid, "local_transmission"), &conditioning = index_named(m, *grid, "local_conditioning");
  check_equal("mean", local.mean, e["mean_transmission_index"]);
  check_equal("least", local.least, e["transmission_min"]);
  check_equal("most", local.most, e["transmission_max"]);
  CHECK(local.good == e["good_transmission"]["points"].get<std::size_t>());
  check_equal("conditioning", conditioning.mean, e["global_conditioning_index"]);
  check_equal("least conditioning", conditioning.least, e["conditioning_min"]);
  check_equal("most conditioning", conditioning.most, e["conditioning_max"]);
  // Where it is least: mirrored in X the pose beside it has the same index but for rounding.
  const json& at = e["transmission_min_at"];
  CHECK(std::abs(std::abs(local.least_at(0)) - std::abs(at["x"].get<double>())) < 1e-9);
  CHECK(local.least_at(1) == Approx(at["y"].get<double>()));
  CHECK(local.least_at(2) == Approx(at["z"].get<double>()));
}

TEST_CASE("columns of transmission are one an index, with a reason for each that the mechanism lacks, and belong to what they are of") {
  const mechanics::Machine m(test::delta(), test::values_with(test::delta(), {}));
  const std::vector<Column> columns = transmission_columns(m.topology());
  const std::vector<std::string> reasons = why_without(mechanics::Transmission(m));
  REQUIRE(columns.size() == 3 * 3 + 3 + 4);
  REQUIRE(reasons.size() == columns.size());
  CHECK(std::ranges::all_of(reasons, &std::string::empty));
  CHECK(columns[0].name == "theta1_pressure");
  CHECK(columns[0].unit == "rad");
  CHECK(owner_of(columns[0]) == "theta1");
  CHECK(owner_of(columns[3]) == "theta1");
  CHECK(owner_of(columns[9]) == "couple1");
}

TEST_CASE("a grid of one pose has the numbers of that pose, and one without an accepted pose has none") {
  const mechanics::Machine m(test::delta(), test::values_with(test::delta(), {}));
  const mechanics::Transmission t(m);
  GridRequest request;
  const double z = m.home()(2);
  request.ranges.push_back({2, z, z, 1});
  const auto one = transmission_grid(t, request);
  REQUIRE(one);
  CHECK(one->accepted == 1);
  std::vector<double> here(16);
  mechanics::Transmission::Work work;
  const Eigen::VectorXd home = m.home();
  transmission_numbers(t, {home.data(), 3}, work, here);
  for (std::size_t i = 0; i < here.size(); ++i) CHECK(one->indices[i].mean == here[i]);
  request.ranges[0] = {2, 100, 100, 1};
  const auto none = transmission_grid(t, request);
  REQUIRE(none);
  CHECK(none->accepted == 0);
  CHECK(std::isnan(none->indices[0].mean));
}
