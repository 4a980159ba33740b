#include <tests/given/two_legs.hpp>

namespace pmreport::test {

const pm_mechanism& two_legs() { return contract::mechanism<TwoLegs>; }

}  // namespace pmreport::test
