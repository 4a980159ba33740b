#include <tests/given/slider_crank.hpp>

namespace pmreport::test {

const pm_mechanism& slider_crank() { return contract::mechanism<SliderCrank>; }

}  // namespace pmreport::test
