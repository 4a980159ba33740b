// What a joint's motion counts from is told where the motion is named, and where its limit is broken.
#include <core/analysis/breaches.hpp>
#include <core/analysis/columns.hpp>

#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::analysis;

namespace {

Topology two_balls() {
  Topology t;
  t.platform = t.add(Body{"platform", 0, false, {}});
  t.add(Joint{"A", JointKind::spherical, 0, 1, {{0, 0.5}}, 1});
  t.add(Joint{"B", JointKind::spherical, 0, 1, {{0, 0.5}}, 1, {0, 0, 1}});
  return t;
}

}  // namespace

TEST_CASE("the column of a deflection names the direction that it counts from") {
  const std::vector<Column> all = displacement_columns(two_balls());
  REQUIRE(all.size() == 2);
  CHECK(all[0].title == "deflection of joint A from home");
  CHECK(all[1].title == "deflection of joint B from axis z of base");
}

TEST_CASE("a broken limit names the direction that it counts from, if that is not home") {
  const Topology t = two_balls();
  ColumnStore columns;
  for (const Joint& j : t.joints) {
    columns.add(joint_column(j, 0), 1);
    columns.put(joint_column(j, 0), 0, 0.75);
  }
  const std::vector<LimitBreach> breaches = find_breaches(t, columns);
  REQUIRE(breaches.size() == 2);
  CHECK(breaches[0].subject == "joint A");
  CHECK(breaches[1].subject == "joint B (from axis z of base)");
}
