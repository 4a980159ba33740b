// The mechanisms of the house, each in a small closed motion about home, loaded and analysed.
#pragma once

#include <core/analysis/analysis.hpp>
#include <core/host/plugin_file.hpp>
#include <core/scenario/loaded.hpp>
#include <reports/section/kinds.hpp>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace house {

using namespace pmreport;

inline std::vector<std::string> names() {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(PLUGINS))
    if (entry.path().extension() == ".so") out.push_back(entry.path().stem().string());
  std::sort(out.begin(), out.end());
  REQUIRE(out.size() >= 9);
  return out;
}

inline const pm_mechanism& table_of(const std::string& name) { return *host::load_plugin(PLUGINS "/" + name + ".so").mechanisms.at(0); }

struct Run {
  // `more` follows the motion.
  explicit Run(const std::string& name, const std::string& more)
      : loaded(scenario::load_text(text(name, more), "a.toml", source(), section::kinds())),
        analysis(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {}) {}
  scenario::Loaded loaded;
  analysis::Analysis analysis;

 private:
  static scenario::MechanismSource source() {
    return {[](const std::string& name) { return &table_of(name); }, names()};
  }
  static std::string text(const std::string& name, const std::string& more) {
    const mechanics::Machine machine(table_of(name), mechanics::default_values(mechanics::describe(table_of(name))));
    std::string out = fmt::format("title = \"{}\"\n[mechanism]\nuse = \"{}\"\n[motion]\nduration = \"1 s\"\nsamples = 5\n", name, name);
    int i = 0;
    for (const Coordinate& c : machine.topology().coordinates)
      out += fmt::format("{0} = \"{1} {3} + {2} {3} * sin(2*pi*t/1 s + {4})\"\n", c.name, c.home, 0.1 * (c.box.max - c.home), c.unit, i++);
    return out + more;
  }
};

}  // namespace house
