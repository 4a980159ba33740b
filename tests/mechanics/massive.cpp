#include <tests/mechanics/massive.hpp>

namespace pmreport::test {

mechanics::Machine make_rotor() { return make(contract::mechanism<Rotor<1>>); }
mechanics::Machine make_rotor_on_two_bearings() { return make(contract::mechanism<Rotor<2>>); }
mechanics::Machine make_engine() { return make(contract::mechanism<Engine>); }

mechanics::State state_of(const mechanics::Machine& machine, double q, double rate, double acceleration) {
  mechanics::State s;
  mechanics::evaluate(machine, &q, &rate, &acceleration, s);
  return s;
}

}  // namespace pmreport::test
