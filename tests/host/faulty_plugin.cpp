// Faults that show only when a mechanism is made or asked: the host tells them and lives on.
#include <catch2/catch.hpp>
#include <core/host/plugin_file.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <optional>
#include <string_view>

using namespace pmreport::mechanics;

namespace {

const pm_mechanism& mechanism(std::string_view file, std::string_view name) {
  const auto plugin = pmreport::host::load_plugin(std::string(FIXTURES "/") + std::string(file));
  for (const pm_mechanism* m : plugin.mechanisms)
    if (m->name == name) return *m;
  throw std::logic_error("no fixture of that name");
}

struct Refusal {
  pm_status status;
  std::string sentence;
};
std::optional<Refusal> refusal(const pm_mechanism& m) {
  try {
    const Machine machine(m, default_values(describe(m)));
  } catch (const MechanismError& error) {
    return Refusal{error.status, error.what()};
  }
  return {};
}

}  // namespace

TEST_CASE("an exception of a constructor arrives as a status and its sentence") {
  const auto refused = refusal(mechanism("faulty.so", "throwing"));
  REQUIRE(refused);
  CHECK(refused->status == PM_FAILED);
  CHECK(refused->sentence.find("the cylinder has no oil") != std::string::npos);
}

TEST_CASE("parameters that a mechanism refuses are the user's, not the plugin's mistake") {
  const auto refused = refusal(mechanism("faulty.so", "refusing"));
  REQUIRE(refused);
  CHECK(refused->status == PM_BAD_ARGUMENT);
  CHECK(refused->sentence.find("mass must be that of the drawing") != std::string::npos);
}

TEST_CASE("results that are not finite are a plugin's failure") {
  const auto refused = refusal(mechanism("faulty.so", "not-finite"));
  REQUIRE(refused);
  CHECK(refused->status == PM_FAILED);
  CHECK(refused->sentence.find("finite") != std::string::npos);
}

TEST_CASE("a mechanism in plain C is a mechanism like any other") {
  const pm_mechanism& m = mechanism("plain.so", "plain-slider");
  const Machine machine(m, default_values(describe(m)));
  REQUIRE(machine.dof() == 1);
  const double x[] = {0.05};
  const Pose pose = machine.pose(x);
  REQUIRE(pose.status == PM_OK);
  CHECK(machine.origin(pose, 1).x() == 0.05);
  CHECK(machine.centre(pose, 0).x() == 0.05);
}
