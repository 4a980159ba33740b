#include <tests/proof/mechanisms.hpp>

#include <core/host/plugin_file.hpp>

#include <algorithm>
#include <numbers>

namespace pmreport::test {

std::unique_ptr<mechanics::Machine> mechanism_of_the_house(const std::string& name) {
  const pm_mechanism& table = *host::load_plugin(PLUGINS "/" + name + ".so").mechanisms[0];
  return std::make_unique<mechanics::Machine>(table, mechanics::default_values(mechanics::describe(table)));
}

std::vector<Sine> random_sines(const mechanics::Machine& machine, std::mt19937_64& random, double least_share, double largest_share,
                               double duration) {
  std::uniform_real_distribution<double> share(least_share, largest_share), turns(1, 3), phase(0, 2 * std::numbers::pi);
  std::vector<Sine> out;
  for (const Coordinate& c : machine.topology().coordinates)
    out.push_back({c.home, share(random) * std::min(c.box.max - c.home, c.home - c.box.min),
                   2 * std::numbers::pi / duration * turns(random), phase(random)});
  return out;
}

}  // namespace pmreport::test
