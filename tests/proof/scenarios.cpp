// The scenarios of the house, each motion that is prescribed by coordinates proved and attacked as it was loaded.
#include <core/host/plugin_file.hpp>
#include <core/scenario/loaded.hpp>
#include <reports/section/kinds.hpp>
#include <tests/proof/attack.hpp>
#include <tests/proof/mechanisms.hpp>

#include <catch2/catch.hpp>

#include <filesystem>

using namespace pmreport;
using namespace pmreport::analysis;
using namespace pmreport::test;

namespace {

scenario::MechanismSource source() {
  return {[](const std::string& name) -> const pm_mechanism* {
            const auto& names = names_of_the_house();
            if (std::ranges::find(names, name) == names.end()) return nullptr;
            return host::load_plugin(PLUGINS "/" + name + ".so").mechanisms[0];
          },
          names_of_the_house()};
}

// The motion in doubles: right to the rounding of its law.
Law law_of(const mechanics::Trajectory& motion, std::size_t dof) {
  return [&motion, dof](long double t, long double* value, long double* rate, long double* acceleration) {
    std::vector<double> now(3 * dof);
    motion.at(static_cast<double>(t), now.data(), now.data() + dof, now.data() + 2 * dof);
    for (std::size_t i = 0; i < dof; ++i) value[i] = now[i], rate[i] = now[dof + i], acceleration[i] = now[2 * dof + i];
  };
}
constexpr Attack in_doubles{.random = 200, .dense = 1000, .tolerance = 1e-12L, .of_rates = 1e-11L, .of_accelerations = 1e-9L};

}  // namespace

TEST_CASE("what is proved of the scenarios of the house holds at random instants") {
  int proved = 0;
  for (const std::string& name : names_of_the_house())
    for (const auto& file : std::filesystem::directory_iterator(SOURCE "/plugins/" + name)) {
      if (file.path().extension() != ".toml") continue;
      const scenario::Loaded loaded = scenario::load(file.path(), source(), section::kinds());
      if (!loaded.trajectory.over) continue;  // no motion, or one that follows from actuators or forces
      INFO(file.path());
      const MotionProof proof = prove_motion(*loaded.machine, loaded.trajectory, {});
      REQUIRE(proof.unexamined == "");
      CHECK(proof.recording < 1e-12);
      const std::size_t dof = static_cast<std::size_t>(loaded.machine->dof());
      CHECK(joined(contradictions(*loaded.machine, proof, law_of(loaded.trajectory, dof), in_doubles)) == "");
      CHECK(joined(contradictions_by_plugin(*loaded.machine, proof, law_of(loaded.trajectory, dof), 100, 1)) == "");
      ++proved;
    }
  CHECK(proved > 5);
}

// A ball-screw stage's worth of laws that are anything but smooth, on a mechanism of the house: kinks, an angle's cut, a pole.
TEST_CASE("laws with kinks and cuts are proved as they are, and one with a pole is undecided about it") {
  const auto loaded = [](const std::string& x, const std::string& alpha) {
    return scenario::load_text("title = \"A trial\"\n[mechanism]\nuse = \"gough\"\n[motion]\nduration = \"2 s\"\nsamples = 41\nx = \"" + x +
                                   "\"\nalpha = \"" + alpha + "\"\n[[section]]\nkind = \"displacement\"\n",
                               "trial.toml", source(), section::kinds());
  };
  const auto attacked = [](const scenario::Loaded& l) {
    const MotionProof proof = prove_motion(*l.machine, l.trajectory, {});
    CHECK(proof.evaluations <= 2 * ProofOptions().most_intervals);
    return joined(contradictions(*l.machine, proof, law_of(l.trajectory, 6), in_doubles));
  };
  CHECK(attacked(loaded("20 mm * abs(t/1 s - 0.73)", "1 deg * min(t/1 s, 1.3)")) == "");
  CHECK(attacked(loaded("10 mm * max(0, sin(5*t/1 s))", "2 deg * sin(3*t/1 s)")) == "");
  CHECK(attacked(loaded("1 mm * atan2(sin(2*t/1 s), cos(2*t/1 s)) / 1 rad", "1 deg * t/1 s")) == "");
}
