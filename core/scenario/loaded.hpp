// From TOML to what was asked: a scenario validated against its mechanism. All errors of a file are told in one run.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>
#include <core/scenario/diagnostic.hpp>
#include <core/scenario/scenario.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pmreport::scenario {

struct Asked;  // read/asked.hpp

// Finds a mechanism by its name. `names` are all there are, for "did you mean".
struct MechanismSource {
  std::function<const pm_mechanism*(const std::string&)> find;
  std::vector<std::string> names;
};

// Where a scenario comes from, for the other scenarios that it names: they are read with the same kinds and mechanisms.
struct Origin {
  const std::filesystem::path& file;
  const MechanismSource& source;
  Kinds kinds;             // of the sections that it may ask for
  bool named = false;      // by another scenario, for its mechanism and what that is asked; no report is made of it
  Asked* asked = nullptr;  // notes what the reading asks for, whatever is wrong with the scenario
};

// A validated scenario, the motion that it asks for, and the machine that it describes. Throws ScenarioError (bad file, exit 2), or
// mechanics::MechanismError when the plugin breaks (exit 3); parameters that the mechanism refuses are a ScenarioError at the line of
// [mechanism]. The motion is solved on the way, for the times that sections and checks may name are those that it reaches. A trajectory
// asks the machine for its poses: it must not outlive it.
struct Loaded {
  Scenario scenario;
  mechanics::Trajectory trajectory;  // of no samples when the scenario has no motion
  std::unique_ptr<mechanics::Machine> machine;
};
Loaded load(const std::filesystem::path& file, const MechanismSource& source, Kinds kinds);
Loaded load_text(const std::string& text, const std::filesystem::path& file, const MechanismSource& source, Kinds kinds);
Loaded load(const Origin& origin);
Loaded load_text(const std::string& text, const Origin& origin);

// Largest number of samples; more is refused with the estimate of time and memory.
inline constexpr std::size_t max_samples = 1'000'000;

}  // namespace pmreport::scenario
