// One symbol a quantity, over every mechanism there is.
#include <catch2/catch.hpp>

#include <reports/section/common/words/words.hpp>
#include <tests/plugins/every_mechanism.hpp>

#include <map>

using namespace pmreport;
using section::Effort, section::effort_symbol, section::symbol, section::with_dots;

TEST_CASE("no two quantities of a mechanism share a symbol, and a torque is no F") {
  for (const test::Named& named : test::every_mechanism()) DYNAMIC_SECTION(named.name) {
      const Topology& t = named.machine->topology();
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
