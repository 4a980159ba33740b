#include <tests/mechanics/mechanisms.hpp>

namespace pmreport::test {

using namespace pmreport::mechanics;

Machine make(const pm_mechanism& table) { return Machine(table, default_values(describe(table))); }
Machine make_hexapod(BaseJoint base) { return Machine(hexapod(), {{static_cast<double>(base)}}); }

namespace {
template <class List>
int named(const List& list, std::string_view name) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].name == name) return static_cast<int>(i);
  throw std::out_of_range("nothing is called " + std::string(name));
}
}  // namespace

int joint_named(const Machine& machine, std::string_view name) { return named(machine.topology().joints, name); }
int body_named(const Machine& machine, std::string_view name) { return named(machine.topology().bodies, name); }

State Motion::state(const Machine& machine, double t) const {
  const Eigen::VectorXd now = at(t), now_rate = rate_at(t);
  State s;
  evaluate(machine, now.data(), now_rate.data(), acceleration.data(), s);
  return s;
}

Motion random_motion(const Machine& machine, std::mt19937_64& random) {
  const int dof = machine.dof();
  Motion m{Eigen::VectorXd(dof), Eigen::VectorXd(dof), Eigen::VectorXd(dof)};
  std::uniform_real_distribution<double> symmetric(-1, 1);
  for (int i = 0; i < dof; ++i) {
    const Range& box = machine.topology().coordinates[static_cast<std::size_t>(i)].box;
    const double half = 0.5 * (box.max - box.min);
    m.q(i) = box.min + half * (1 + symmetric(random));
    m.rate(i) = half * symmetric(random);
    m.acceleration(i) = 2 * half * symmetric(random);
  }
  return m;
}

}  // namespace pmreport::test
