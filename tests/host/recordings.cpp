// Plugins of every version of the contract that there was, with and without a recording.
#include <catch2/catch.hpp>
#include <core/mechanics/conformance/properties.hpp>
#include <core/program/program.hpp>
#include <tests/host/slider.hpp>

#include <algorithm>

using namespace pmreport;
using mechanics::Property;
using mechanics::Verdict;

namespace {

bool needs_recording(const Property& p) { return p.claim.starts_with("recording "); }

}  // namespace

TEST_CASE("a plugin in plain C records") {
  const Slider slider("plain");
  REQUIRE(slider.machine.program() != nullptr);
  CHECK(slider.machine.program()->steps().size() == 3);
  for (const Property& p : check_properties(slider.machine, {20, 1}))
    if (needs_recording(p)) {
      CAPTURE(p.claim, p.where);
      CHECK(p.verdict() == Verdict::passed);
    }
}

TEST_CASE(
    "plugins of earlier versions, and those that record nothing, work as before, and what needs a recording says why it is not examined") {
  for (const char* fixture : {"contract_1_0", "contract_1_2", "unrecorded"}) {
    CAPTURE(fixture);
    const Slider slider(fixture);
    std::string why;
    CHECK_FALSE(slider.machine.records());
    CHECK(slider.machine.program(&why) == nullptr);
    CHECK(why == "the plugin was built before geometry was recorded (contract 1.3)");

    // Extended precision is asked of the plugin itself.
    const double x[] = {0.05, 1e-18};
    std::vector<double> placement(2 * slider.machine.layout().size());
    REQUIRE(slider.machine.place(PM_EXTENDED, 1, x, placement.data()) == PM_OK);
    const std::size_t actuator = slider.machine.layout().actuator(0);
    CHECK(placement[2 * actuator] == 0.05);
    CHECK(placement[2 * actuator + 1] == 1e-18);

    int unexamined = 0;
    for (const Property& p : check_properties(slider.machine, {20, 1})) {
      CAPTURE(p.claim, p.where, p.unexamined);
      if (!needs_recording(p)) {
        CHECK(p.verdict() != Verdict::failed);
        continue;
      }
      ++unexamined;
      CHECK(p.verdict() == Verdict::not_examined);
      CHECK(p.unexamined == why);
    }
    CHECK(unexamined == 3);
  }
}
