// One symbol a quantity, over every mechanism there is.
#include <catch2/catch.hpp>

#include <core/host/plugin_file.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <reports/section/common/words/words.hpp>

#include <algorithm>
#include <filesystem>
#include <map>

using namespace pmreport;
using section::Effort, section::effort_symbol, section::symbol, section::with_dots;

namespace {

std::vector<std::filesystem::path> plugins() {
  std::vector<std::filesystem::path> out;
  for (const auto& entry : std::filesystem::directory_iterator(PLUGINS))
    if (entry.path().extension() == ".so") out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

TEST_CASE("no two quantities of a mechanism share a symbol, and a torque is no F") {
  REQUIRE(plugins().size() >= 9);
  for (const auto& path : plugins())
    for (const pm_mechanism* mechanism : host::load_plugin(path).mechanisms) DYNAMIC_SECTION(mechanism->name) {
        const mechanics::Machine machine(*mechanism, mechanics::default_values(mechanics::describe(*mechanism)));
        const Topology& t = machine.topology();
        std::map<std::string, std::string> meanings;
        const auto means = [&](const std::string& sign, const std::string& meaning) {
          CAPTURE(sign, meaning, meanings[sign]);
          CHECK(meanings[sign].empty());
          meanings[sign] = meaning;
        };
        const auto moves = [&](const std::string& name) {
          for (int dots = 0; dots < 3; ++dots) means(with_dots(symbol(name), dots), name + " and dots: " + std::to_string(dots));
        };
        for (const Coordinate& c : t.coordinates) moves(c.name);
        for (const Derived& d : t.derived) moves(d.name);
        for (const Actuator& x : t.actuators) {
          moves(x.name);
          means(effort_symbol(t, x), "effort of " + x.name);
          means(effort_symbol(t, x, Effort::power), "power of " + x.name);
          CHECK(effort_symbol(t, x).starts_with(x.unit == "m" ? "F" : "τ"));
        }
        for (const Constraint& c : t.constraints) means(t.constraints.size() == 1 ? "Fτ" : symbol(c.name), c.name);
        for (const Reading& r : t.readings) means(symbol(r.name), r.name);
        for (const char* vector : {"v", "ω", "a", "ω\u0307"})
          for (const char* axis : {"x", "y", "z"}) means(vector + std::string(axis), "component of a twist or its rate");
      }
}
