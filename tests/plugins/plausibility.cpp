// Nothing of the mechanisms of the house looks odd; mistakes planted in copies of them do.
#include <core/mechanics/conformance/plausibility.hpp>
#include <core/mechanics/machine/contract.hpp>
#include <tests/plugins/every_mechanism.hpp>

#include <algorithm>
#include <functional>

using namespace pmreport;
using namespace pmreport::mechanics;
using Catch::Contains;

namespace {

std::string all_of(const std::vector<Remark>& remarks) {
  std::string out;
  for (const Remark& r : remarks) out += sentence(r) + "\n";
  return out;
}

bool remarked(const std::vector<Remark>& remarks, const std::string& of, const std::string& words) {
  return std::any_of(remarks.begin(), remarks.end(), [&](const Remark& r) {
    return std::find(r.of.begin(), r.of.end(), of) != r.of.end() && sentence(r).find(words) != std::string::npos;
  });
}

using Change = std::function<void(const std::string& body, pm_inertia&)>;

// A plugin whose bodies are other than it says.
class Copy {
 public:
  Copy(const pm_mechanism& table, Change change) : table_(table) {
    original = &table, change_ = std::move(change);
    table_.dynamics = &dynamics_;
  }
  std::vector<Remark> remarks() const { return plausibility(Machine(table_, default_values(describe(table_)))); }

 private:
  static pm_status inertias(const pm_instance* instance, pm_list* out, pm_text* text) {
    static std::vector<pm_inertia> changed;
    pm_topology t{};
    pm_list list{};
    original->kinematics->topology(instance, &t, text);
    const pm_status status = original->dynamics->inertias(instance, &list, text);
    changed = mechanics::contract::map<pm_inertia>(list, [](const pm_inertia& i) { return i; });
    for (std::size_t i = 0; i < changed.size(); ++i) change_(mechanics::contract::item<pm_body>(t.bodies, i).name, changed[i]);
    *out = {changed.data(), changed.size(), sizeof(pm_inertia)};
    return status;
  }
  static inline const pm_mechanism* original = nullptr;
  static inline Change change_;
  static constexpr pm_dynamics dynamics_{sizeof(pm_dynamics), inertias};
  pm_mechanism table_;
};

std::vector<double> base_points(double step) {
  constexpr double deg = std::numbers::pi / 180;
  std::vector<double> out;
  for (int i = 0; i < 6; ++i) {
    const double azimuth = (-150 + step * (i / 2) + (i % 2 == 0 ? -10.6 : 10.6)) * deg;
    out.insert(out.end(), {0.3 * std::cos(azimuth), 0.3 * std::sin(azimuth), 0});
  }
  return out;
}

}  // namespace

TEST_CASE("no remark falls on the mechanisms of the house") {
  for (const auto& [name, machine] : test::every_mechanism()) {
    INFO(name << ": " << all_of(plausibility(*machine)));
    CHECK(plausibility(*machine).empty());
  }
}

TEST_CASE("a parameter in another unit, forgotten or mistyped is remarked") {
  std::vector<double> misplaced = base_points(120);
  misplaced[6] += 0.05;
  struct Mistake {
    const char* mechanism;
    std::map<std::string, std::vector<double>> parameters;
    const char *of, *words;
  };
  const Mistake all[] = {
      {"gough", {{"base_radius", {100}}}, "platform", "one of the lengths may be in mm"},
      {"gough", {{"cylinder_radius", {30}}}, "cylinder 4", "a solid 60 m in size"},
      {"gough", {{"rod_radius", {2e-5}}}, "rod 1", "kg/m^3"},
      {"gough", {{"platform_mass", {0}}}, "platform", "no mass"},
      {"gough", {{"base_points", base_points(100)}}, "A3", "every 100 deg"},
      {"gough", {{"base_points", misplaced}}, "A3", "50 mm away"},
      {"gough", {{"home_position", {0, 0, 9.5}}}, "rho1", "its stroke goes from 760 mm to 1410 mm"},
      {"stewart", {{"leg_rod_radius", {20}}}, "leg rod 2", "a solid 40 m in size"},
      {"stewart", {{"platform_mass", {0}}}, "platform", "no mass"},
      {"stewart", {{"cross_rod_length", {30}}}, "cross rod 4", "30 m long along z"},
      {"delta", {{"platform_mass", {0}}}, "platform", "no mass"},
      {"delta", {{"rod_spacing", {0.001}}}, "platform", "1 mm apart"},
      {"delta", {{"rod_mass", {140}}}, "platform", "a mass may be in g"},
      {"2q-spr", {{"upper_beam", {12.5}}}, "upper beam g1", "25 m long"},
      {"2q-spr", {{"platform_inertia", {2, 2, 2, 0, 0, 0}}}, "platform", "1100 mm long"},
      {"4sps-spr", {{"base_radius", {100}}}, "l3", "stands at 99.9 m"},
      {"4sps-spr", {{"cylinder_centre", {20}}}, "cylinder 2", "outside"},
      {"4sps-spr", {{"platform_inertia", {0.055, 0.055, 0.03, 0, 0, 0}}}, "platform", "exchanged"},
      {"4sps-spr", {{"cylinder_inertia", {60}}, {"cylinder_axial_inertia", {3}}}, "cylinder 5", "13.2 m long"},
  };
  for (const Mistake& m : all) {
    const pm_mechanism& table = test::plugin(m.mechanism);
    const std::vector<Remark> remarks = plausibility(Machine(table, test::values_with(table, m.parameters)));
    INFO(m.mechanism << " with " << m.parameters.begin()->first << ": " << all_of(remarks));
    CHECK(remarked(remarks, m.of, m.words));
  }
}

TEST_CASE("a body of a copy that is not what it should be is remarked") {
  const auto mirror = [](const std::string& stem) {
    return [stem](const std::string& name, pm_inertia& i) {
      if (name.starts_with(stem)) i.centre[2] *= -1;
    };
  };
  const auto exchange = [](const std::string& name, pm_inertia& i) {
    if (name == "platform") i.inertia[4] = std::exchange(i.inertia[8], std::exchange(i.inertia[0], i.inertia[8]));
  };
  struct Planted {
    const char* mechanism;
    Change change;
    const char *of, *words;
  };
  const Planted all[] = {
      {"gough", mirror("cylinder"), "cylinder 1", "along -z"},
      {"gough", exchange, "platform", "exchanged"},
      {"stewart", mirror("leg rod"), "leg rod 3", "along +z"},
      {"stewart", exchange, "platform", "exchanged"},
      {"delta", mirror("arm"), "arm 1", "along -z"},
      {"delta", exchange, "platform", "exchanged"},
      {"2q-spr", mirror("piston"), "piston 11", "along +z"},
      {"4sps-spr", mirror("piston"), "piston 5", "along +z"},
      {"5pus-upu", mirror("rod"), "rod 2", "along -z"},
      {"p2prpu-prps", mirror("upper"), "upper 1", "along +z"},
      {"parallel-cross", mirror("cross rod"), "cross rod 5", "along +z"},
  };
  for (const Planted& p : all) {
    const std::vector<Remark> remarks = Copy(test::plugin(p.mechanism), p.change).remarks();
    INFO(p.mechanism << ": " << all_of(remarks));
    CHECK(remarked(remarks, p.of, p.words));
  }
}
