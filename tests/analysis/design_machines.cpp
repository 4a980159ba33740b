// Numbers by which machines are compared, of a table whose workspace is a rectangle.
#include <catch2/catch.hpp>

#include <core/analysis/design/machine_numbers.hpp>
#include <core/mechanics/singularity/singularity.hpp>
#include <tests/section/study/cross_table.hpp>

#include <cmath>

using namespace pmreport;
using namespace pmreport::analysis;
using What = MachineNumber::What;

namespace {

std::unique_ptr<mechanics::Machine> table(double a, double b, double ratio = 1) {
  const pm_mechanism& plugin = *cross_table::source().find("cross-table");
  mechanics::ParameterValues values = mechanics::default_values(mechanics::describe(plugin));
  values[0] = {a}, values[1] = {b}, values[2] = {ratio};
  return std::make_unique<mechanics::Machine>(plugin, values);
}

MachineStudy study(ScanMethod method) {
  MachineStudy out;
  WorkspaceRequest r;
  r.methods = {method};
  r.scan = {{0, -0.5, 0.5, 101}, {1, -0.5, 0.5, 51}};
  out.requests = {r};
  out.numbers = {{What::volume, "workspace.volume"},
                 {What::low, "workspace.x_low", 0, 0},
                 {What::high, "workspace.y_high", 0, 1},
                 {What::condition, "home.condition"},
                 {What::smallest_singular_value, "home.smallest_singular_value"}};
  return out;
}

double singular_values_apart(const mechanics::Machine& m, double length) {
  return mechanics::conditioning(m, m.jacobian(m.home_pose()).matrix, length).condition();
}

}  // namespace

TEST_CASE("a grid's numbers are counted, those of home computed") {
  const auto m = table(0.2, 0.3, 3);
  const Judged j = judge(*m, study(ScanMethod::grid), {});
  REQUIRE(j.made());
  REQUIRE(j.numbers.size() == 5);
  CHECK(j.numbers[0].value == Approx(41 * 31 * 0.01 * 0.02));
  CHECK(j.numbers[0].width() == 0);
  CHECK(j.numbers[1].value == Approx(-0.2));
  CHECK(j.numbers[2].value == Approx(0.3));
  CHECK(j.numbers[3].value == Approx(singular_values_apart(*m, 1)));
  CHECK(j.notes.empty());
}

TEST_CASE("a set that goes up to the end of a range is told, and so is an empty one with what refuses home") {
  const Judged wide = judge(*table(0.55, 0.02), study(ScanMethod::grid), {});
  REQUIRE(wide.notes.size() == 1);
  CHECK(wide.notes[0] == "may go on beyond the range of x");
  MachineStudy away = study(ScanMethod::grid);
  away.requests[0].scan[0] = {0, 0.4, 0.5, 11};
  const Judged none = judge(*table(0.2, 0.3), away, {});
  REQUIRE(none.made());
  CHECK(none.numbers[0].value == 0);
  CHECK_FALSE(none.numbers[1].known());
  REQUIRE(none.notes.size() == 1);
  CHECK(none.notes[0] == "empty");
}

TEST_CASE("a proof's volume lies in its bracket, and a closer look narrows it about the same number") {
  const MachineStudy s = study(ScanMethod::proof);
  const auto m = table(0.23, 0.31);
  const Judged j = judge(*m, s, {}), closer = judge(*m, finer(s), {});
  REQUIRE(j.made());
  const double area = 4 * 0.23 * 0.31;
  CHECK(j.numbers[0].low <= area);
  CHECK(j.numbers[0].high >= area);
  CHECK(j.numbers[0].width() <= 1.01e-3 * area);
  CHECK(closer.numbers[0].low <= area);
  CHECK(closer.numbers[0].high >= area);
  CHECK(closer.numbers[0].width() <= 1.01e-4 * area);
  CHECK(j.numbers[2].low <= 0.31);
  CHECK(j.numbers[2].high >= 0.31);
}

TEST_CASE("random poses give an interval, and a closer look takes others") {
  const MachineStudy s = study(ScanMethod::monte_carlo);
  const auto m = table(0.25, 0.25);
  const Judged j = judge(*m, s, {}), closer = judge(*m, finer(s), {});
  // A million poses, of which a quarter is within: the interval is 1.96 sqrt(0.25 0.75 / 10^6) to either side.
  CHECK(j.numbers[0].width() == Approx(2 * 1.96 * std::sqrt(0.25 * 0.75 / 1e6)).epsilon(0.01));
  CHECK(closer.numbers[0].width() == Approx(j.numbers[0].width() / 2).epsilon(0.01));
  CHECK(j.numbers[0].value != closer.numbers[0].value);
  CHECK(j.numbers[0].value == Approx(0.25).margin(5 * 0.000433));
  CHECK_FALSE(j.numbers[1].known());
}

TEST_CASE("parameters that the mechanism refuses give their reason, and others a machine of their own") {
  const auto m = table(0.1, 0.1);
  const Progress quiet;
  const Judge by = judge_of_parameters(*m, {1, 0}, study(ScanMethod::grid), quiet);
  CHECK(by({0.3, 0.2}).numbers[0].value == Approx(41 * 31 * 0.01 * 0.02));
  const Judged refused = by({0.5, 0.2});
  CHECK_FALSE(refused.made());
  CHECK(refused.why == "a and b together are longer than the frame");
}
