// Elastic elements through the contract: of plugins that declare some, of those that could not yet, of those that declare nonsense.
#include <catch2/catch.hpp>
#include <tests/host/slider.hpp>

#include <cmath>

using namespace pmreport;

TEST_CASE("a plugin in plain C declares what gives way") {
  const Slider slider("plain");
  REQUIRE(slider.machine.topology().elements.size() == 1);
  const Element& e = slider.machine.topology().elements[0];
  CHECK(e.name == "seat");
  CHECK(e.kind == ElementKind::bearing);
  CHECK(e.to == 0);
  CHECK(e.stiffness[1] == 5e7);
  CHECK(std::isinf(e.stiffness[0]));
}

TEST_CASE("plugins of every earlier version of the contract load, and are rigid") {
  for (const char* fixture : {"contract_1_0", "contract_1_2", "contract_1_3"}) {
    CAPTURE(fixture);
    CHECK(Slider(fixture).machine.topology().elements.empty());
  }
}

TEST_CASE("a plugin with a stiffness that is none is refused by the element's name") {
  CHECK_THROWS_WITH(Slider("negative_stiffness"), Catch::Contains("element seat: expected a stiffness above zero, seen -1"));
}
