#include <tests/mechanics/swinging.hpp>

namespace pmreport::test {

const pm_mechanism& pendulum() { return contract::mechanism<Pendulum>; }
const pm_mechanism& trolley() { return contract::mechanism<Trolley>; }

}  // namespace pmreport::test
