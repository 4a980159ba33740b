#include <tests/given/gantry.hpp>

namespace gantry {

const pm_mechanism& table() { return contract::mechanism<Gantry>; }

}  // namespace gantry
