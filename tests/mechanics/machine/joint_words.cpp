#include <core/mechanics/machine/joint_words.hpp>

#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

Topology two_balls() {
  Topology t;
  t.platform = t.add(Body{"table", 0, false, {}});
  t.add(Body{"leg", 1, false, {}});
  t.add(Joint{"A", JointKind::spherical, 0, 2, {{0, 1}}, 2});
  t.add(Joint{"B", JointKind::spherical, 2, 1, {{0, 1}}, 2});
  return t;
}

}  // namespace

TEST_CASE("a motion counts from home unless a ball declares a direction, told by the axis of its socket") {
  Topology t = two_balls();
  CHECK(origin_of(t, t.joints[0]) == "home");
  CHECK(origins_of(t) == "home");

  t.joints[0].from = {0, 0, 2};  // of any length
  t.joints[1].from = {0, -1, 0};
  CHECK(origin_of(t, t.joints[0]) == "axis z of base");
  CHECK(origin_of(t, t.joints[1]) == "axis -y of table");
  CHECK(origins_of(t) == "home; those of A from axis z of base; those of B from axis -y of table");

  t.joints[1].from = {0, 1, 1};
  CHECK(origin_of(t, t.joints[1]) == "a direction in table");
}

TEST_CASE("joints that count from the same direction are told together") {
  Topology t = two_balls();
  t.add(Joint{"C", JointKind::spherical, 0, 2, {{0, 1}}, 2, {0, 0, 1}});
  t.joints[0].from = {0, 0, 1};
  CHECK(origins_of(t) == "home; those of A, C from axis z of base");
}
