// One suite of properties over every mechanism there is, and proof that the suite can fail.
#include <core/mechanics/conformance/properties.hpp>
#include <core/mechanics/conformance/settings.hpp>
#include <core/mechanics/conformance/wrench_properties.hpp>
#include <core/mechanics/model/closed_form.hpp>

#include <fmt/core.h>

#include <core/host/plugin_file.hpp>
#include <tests/given/slider_crank.hpp>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <set>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

std::string table(const std::vector<Property>& properties) {
  std::string out = "\n";
  for (const Property& p : properties) {
    out +=
        fmt::format("{:7}{:46}{:>9.1e} of {:.1e} {} {}\n", p.holds() ? "" : "FAILS", p.claim, p.worst, p.tolerance, p.unit, p.unexamined);
    if (!p.holds()) out += fmt::format("       {}; {}\n", p.how, p.where);
  }
  return out;
}

std::vector<std::filesystem::path> plugins() {
  std::vector<std::filesystem::path> out;
  for (const auto& entry : std::filesystem::directory_iterator(PLUGINS))
    if (entry.path().extension() == ".so") out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

void require_properties(const Machine& machine, int poses) {
  const std::vector<Property> properties = check_properties(machine, {poses, 1});
  INFO(table(properties));
  for (const Property& p : properties) CHECK(p.holds());
}

}  // namespace

TEST_CASE("every plugin has every property, at home and at a thousand random poses") {
  REQUIRE_FALSE(plugins().empty());
  for (const auto& path : plugins())
    for (const pm_mechanism* mechanism : host::load_plugin(path).mechanisms) DYNAMIC_SECTION(mechanism->name) {
        const Machine machine(*mechanism, default_values(describe(*mechanism)));
        require_properties(machine, 1000);
      }
}

TEST_CASE("every build of a plugin for older processors has every property too") {
  for (const char* processor : {"x86-64", "x86-64-v3"}) {
    setenv("PMREPORT_PROCESSOR", processor, 1);
    for (const auto& path : plugins())
      for (const pm_mechanism* mechanism : host::load_plugin(path).mechanisms) {
        INFO(mechanism->name << " for " << processor);
        require_properties(Machine(*mechanism, default_values(describe(*mechanism))), 60);  // fills lanes of any width
      }
    unsetenv("PMREPORT_PROCESSOR");
  }
}

TEST_CASE("every plugin has every property with other choices and working modes") {
  for (const auto& path : plugins())
    for (const pm_mechanism* mechanism : host::load_plugin(path).mechanisms) {
      const Machine machine(*mechanism, default_values(describe(*mechanism)));
      const Settings others = other_choices(machine, 16);
      if (others.refused > 0) CHECK_FALSE(others.example.empty());
      for (const Setting& s : others.taken) DYNAMIC_SECTION(mechanism->name << " with " << s.words) {
          require_properties(*s.machine, 100);
        }
    }
}

// One in four: `pmreport check --all` looks at all of them.
TEST_CASE("every plugin has every property at other sizes: many at once, and each towards the ends of its range") {
  for (const auto& path : plugins())
    for (const pm_mechanism* mechanism : host::load_plugin(path).mechanisms) DYNAMIC_SECTION(mechanism->name) {
        const Settings others = other_numbers(Machine(*mechanism, default_values(describe(*mechanism))), 12, 2);
        CHECK(others.taken.size() > 20);
        for (std::size_t i = 0; i < others.taken.size(); i += 4) {
          const std::vector<Property> properties = check_properties(*others.taken[i].machine, {.poses = 10, .seed = 1, .out_of_reach = 1});
          INFO(others.taken[i].words << table(properties));
          for (const Property& p : properties) CHECK(p.verdict() != Verdict::failed);
        }
      }
}

TEST_CASE("each fault fails the property that names it, what must follow from it, and nothing else") {
  using Claims = std::set<std::string>;
  struct Faulty {
    const char* fault;
    Claims fails;  // the first one names the fault; the others say the same of the same joint
  };
  const Faulty all[] = {
      {"none", {}},
      // The rod drifts from its pin: bodies apart, and moving apart; the joint's force acts on both at a point where only one of them is.
      {"gap",
       {"joints close", "relative velocities are allowed", "relative accelerations are allowed", "every body is in balance",
        "virtual work equals Newton and Euler"}},
      // The crank turns about another line than its joint says: its axis moves, and forces are divided by the wrong lever.
      {"axis",
       {"joint axes agree", "relative velocities are allowed", "relative accelerations are allowed",
        "closed-form statics equal the generic model's", "virtual work equals Newton and Euler"}},
      {"unit", {"axes and rotations are unit"}},
      {"idle", {"mobility is as declared"}},
      // The actuator's value is not the travel of its joint; its row of the Jacobian was made to match.
      {"actuator",
       {"actuators measure their joints", "closed-form statics equal the generic model's", "virtual work equals Newton and Euler"}},
      // A row of the Jacobian a thousandth too long: its rates, and its forces.
      {"jacobian",
       {"jacobian gives the actuator rates", "jacobian gives the actuator accelerations", "closed-form statics equal the generic model's",
        "virtual power balances"}},
      {"lanes", {"lanes equal doubles"}},
      {"jet_lanes", {"lanes equal doubles"}},
      // A rate that is not that of the value: also not that of the partials.
      {"rates", {"rates are exact", "recording has the same rates", "partials are exact"}},
      {"acceleration", {"accelerations are exact", "recording has the same rates"}},
      {"partials", {"partials are exact", "recording has the same partials"}},
      // A NaN equals nothing.
      {"partials_nan",
       {"partials are exact", "recording has the same partials", "lanes equal doubles", "mass matrix is positive definite",
        "energy balances", "virtual work equals Newton and Euler"}},
      // A body whose partials are not those of its place: what the load does to it is not what its joints feel.
      {"body_partials",
       {"partials are exact", "recording has the same partials", "energy balances", "virtual work equals Newton and Euler"}},
      // Extended precision is that of the recording; a height that is off by a constant has the right rates.
      {"recorded", {"recording equals place and jacobian", "extended precision agrees"}},
      {"reach", {"poses are in reach"}},
  };
  const pm_mechanism& mechanism = test::slider_crank();
  for (const Faulty& faulty : all) {
    const auto which =
        std::find(std::begin(test::SliderCrank::faults), std::end(test::SliderCrank::faults), std::string_view(faulty.fault));
    REQUIRE(which != std::end(test::SliderCrank::faults));
    ParameterValues values = default_values(describe(mechanism));
    values[0] = {static_cast<double>(which - std::begin(test::SliderCrank::faults))};
    const Machine machine(mechanism, values);
    const std::vector<Property> properties = check_properties(machine, {300, 1});
    Claims failed;
    for (const Property& p : properties)
      if (p.verdict() == Verdict::failed) failed.insert(p.claim);
    INFO(faulty.fault << table(properties));
    CHECK(failed == faulty.fails);
  }
}

TEST_CASE("a mass or an inertia that no body has is refused before anything is computed") {
  const pm_mechanism& mechanism = test::slider_crank();
  const std::pair<const char*, const char*> faults[] = {
      {"mass", "fault gives body slider what no body can have: its mass is -0.001 kg"},
      {"inertia",
       "fault gives body crank what no body can have: the principal moments of its inertia are -0.9, 0.001 and 0.004 kg m^2, and none can "
       "be negative; is a product of inertia too large, a unit wrong, or are they about another point than the centre of mass?"}};
  for (const auto& [fault, sentence] : faults) {
    const auto which = std::find(std::begin(test::SliderCrank::faults), std::end(test::SliderCrank::faults), std::string_view(fault));
    ParameterValues values = default_values(describe(mechanism));
    values[0] = {static_cast<double>(which - std::begin(test::SliderCrank::faults))};
    CHECK_THROWS_WITH(Machine(mechanism, values), sentence);
  }
}

TEST_CASE("couples of the Delta's limbs in each other's rows are found by the limbs that they name") {
  const auto file = host::load_plugin(PLUGINS "/delta.so");
  const Machine machine(*file.mechanisms.at(0), default_values(describe(*file.mechanisms.at(0))));
  for (const double shift : {0.0, 0.2}) {
    Eigen::VectorXd q = machine.home();
    q(0) += shift, q(1) -= 0.5 * shift;
    const State state = state_at_rest(machine, q);
    const GenericModel model = generic_model(machine, state);
    Eigen::Matrix<double, 6, 6> g = closed_form(machine, state, characteristic_length(machine)).jacobian;
    CHECK(limb_deviation(machine, state, model, g).value < 1e-12);
    g.row(3).swap(g.row(4));  // those of limbs 1 and 2, which stand at 120 degrees
    const WrenchDeviation wrong = limb_deviation(machine, state, model, g);
    CHECK(wrong.value > 0.3);
    CHECK((wrong.row == 3 || wrong.row == 4));
  }
}

TEST_CASE("numbers that are not finite fail, and say so") {
  const pm_mechanism& mechanism = test::slider_crank();
  ParameterValues values = default_values(describe(mechanism));
  values[0] = {13};  // the fault "nan"
  const Machine machine(mechanism, values);
  bool told = false;
  for (const Property& p : check_properties(machine, {100, 1}))
    if (p.claim == "axes and rotations are unit") {
      told = !p.holds();
      CHECK(p.where == "the geometry has no finite numbers there");
    }
  CHECK(told);
}

TEST_CASE("the same seed tries the same poses, another seed others") {
  const pm_mechanism& mechanism = test::slider_crank();
  const Machine machine(mechanism, default_values(describe(mechanism)));
  const auto worst = [&](std::uint64_t seed) {
    std::vector<double> out;
    for (const Property& p : check_properties(machine, {20, seed})) out.push_back(p.worst);
    return out;
  };
  CHECK(worst(5) == worst(5));
  CHECK(worst(5) != worst(6));
}
