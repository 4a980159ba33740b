// One suite of properties over every mechanism there is, and proof that the suite can fail.
#include <core/mechanics/conformance/properties.hpp>

#include <fmt/core.h>

#include <core/host/plugin_file.hpp>
#include <tests/mechanics/slider_crank.hpp>

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
    out += fmt::format("{:7}{:46}{:>9.1e} of {:.1e} {}\n", p.passed() ? "" : "FAILS", p.claim, p.worst, p.tolerance, p.unit);
    if (!p.passed()) out += fmt::format("       {}; {}\n", p.how, p.where);
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
  for (const Property& p : properties) CHECK(p.passed());
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

TEST_CASE("every plugin has every property whatever it is told to choose") {
  for (const auto& path : plugins())
    for (const pm_mechanism* mechanism : host::load_plugin(path).mechanisms) {
      const MechanismInfo info = describe(*mechanism);
      for (std::size_t i = 0; i < info.parameters.size(); ++i)
        for (std::size_t choice = 0; choice < info.parameters[i].choices.size(); ++choice) {
          const double given = static_cast<double>(choice);
          if (given == info.parameters[i].defaults[0]) continue;  // the case before
          DYNAMIC_SECTION(fmt::format("{} with {} = {}", info.name, info.parameters[i].name, info.parameters[i].choices[choice])) {
            ParameterValues values = default_values(info);
            values[i] = {given};
            try {
              const Machine machine(*mechanism, values);
              require_properties(machine, 200);
            } catch (const MechanismError& e) {  // a choice that the other parameters rule out
              CHECK(e.status == PM_BAD_ARGUMENT);
              CHECK_FALSE(std::string(e.what()).empty());
            }
          }
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
      {"rates", {"rates are exact", "partials are exact"}},
      {"acceleration", {"accelerations are exact"}},
      {"partials", {"partials are exact"}},
      // A NaN equals nothing.
      {"partials_nan",
       {"partials are exact", "lanes equal doubles", "mass matrix is positive definite", "energy balances",
        "virtual work equals Newton and Euler"}},
      // A body whose partials are not those of its place: what the load does to it is not what its joints feel.
      {"body_partials", {"partials are exact", "energy balances", "virtual work equals Newton and Euler"}},
      // The rest outweighs a mass that is slightly negative, but not a negative inertia of that size.
      {"mass", {"masses and inertias are not negative"}},
      {"inertia", {"masses and inertias are not negative", "mass matrix is positive definite"}},
      {"extended", {"extended precision agrees"}},
      {"reach", {"poses are in reach"}},
  };
  const pm_mechanism& mechanism = contract::mechanism<test::SliderCrank>;
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
      if (!p.passed()) failed.insert(p.claim);
    INFO(faulty.fault << table(properties));
    CHECK(failed == faulty.fails);
  }
}

TEST_CASE("numbers that are not finite fail, and say so") {
  const pm_mechanism& mechanism = contract::mechanism<test::SliderCrank>;
  ParameterValues values = default_values(describe(mechanism));
  values[0] = {13};  // the fault "nan"
  const Machine machine(mechanism, values);
  bool told = false;
  for (const Property& p : check_properties(machine, {100, 1}))
    if (p.claim == "axes and rotations are unit") {
      told = !p.passed();
      CHECK(p.where == "the plugin returned numbers that are not finite");
    }
  CHECK(told);
}

TEST_CASE("the same seed tries the same poses, another seed others") {
  const pm_mechanism& mechanism = contract::mechanism<test::SliderCrank>;
  const Machine machine(mechanism, default_values(describe(mechanism)));
  const auto worst = [&](std::uint64_t seed) {
    std::vector<double> out;
    for (const Property& p : check_properties(machine, {20, seed})) out.push_back(p.worst);
    return out;
  };
  CHECK(worst(5) == worst(5));
  CHECK(worst(5) != worst(6));
}
