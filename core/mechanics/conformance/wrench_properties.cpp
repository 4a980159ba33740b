#include <core/mechanics/conformance/wrench_properties.hpp>

#include <core/mechanics/mobility/mobility.hpp>

#include <cmath>

namespace pmreport::mechanics {

WrenchDeviation unit_deviation(const Machine& machine, const Matrix6d& jacobian) {
  const Topology& t = machine.topology();
  WrenchDeviation worst;
  for (std::size_t i = 0; i < t.constraints.size(); ++i) {
    const int row = machine.dof() + static_cast<int>(i);
    const double size = t.constraints[i].sense() == Sense::rotary ? jacobian.row(row).tail<3>().norm() : jacobian.row(row).head<3>().norm();
    if (const double off = std::abs(size - 1); !(off <= worst.value) || worst.row < 0) worst = {off, row};
  }
  return worst;
}

int limb_named(const Constraint& constraint) {
  int found = 0, count = 0;
  const std::string& s = constraint.title;
  const std::string word = "limb ";
  const auto letter = [&](std::size_t i) { return std::isalpha(static_cast<unsigned char>(s[i])) != 0; };
  const auto digit = [&](std::size_t i) { return i < s.size() && std::isdigit(static_cast<unsigned char>(s[i])) != 0; };
  for (std::size_t at = s.find(word); at != std::string::npos; at = s.find(word, at + 1)) {
    if ((at > 0 && letter(at - 1)) || !digit(at + word.size())) continue;
    ++count;
    found = 0;
    for (std::size_t i = at + word.size(); digit(i) && found < 1000; ++i) found = 10 * found + (s[i] - '0');
  }
  return count == 1 && s.find("limbs") == std::string::npos ? found : 0;
}

WrenchDeviation limb_deviation(const Machine& machine, const State& state, const GenericModel& model, const Matrix6d& jacobian) {
  const Topology& t = machine.topology();
  const double length = characteristic_length(machine);
  WrenchDeviation worst;
  std::vector<LimbSystem> limbs;
  for (std::size_t i = 0; i < t.constraints.size(); ++i) {
    const int limb = limb_named(t.constraints[i]), row = machine.dof() + static_cast<int>(i);
    if (limb == 0) continue;
    if (limbs.empty()) limbs = limb_systems(machine, state, model);
    for (const LimbSystem& l : limbs) {
      if (l.limb != limb || !l.alone || jacobian.row(row).isZero()) continue;  // zero is no wrench, and is told as that
      ScrewSystem wrench = l.constraints;
      wrench.basis = jacobian.row(row).transpose();
      const double off = l.constraints.dimension() == 0 ? 1 : outside(wrench, l.constraints, length);
      if (!(off <= worst.value) || worst.row < 0) worst = {off, row};
    }
  }
  return worst;
}

}  // namespace pmreport::mechanics
