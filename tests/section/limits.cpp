// Limits that are broken by many: one sentence, the worst by name. On the gantry, whose rail P1 bears two thirds of a push along Y, and
// rail P2, through the hinge R, the third that is left.
#include <catch2/catch.hpp>

#include <reports/section/common/words/limits.hpp>
#include <tests/section/gantry.hpp>

using namespace pmreport;
using Catch::Contains;
using Catch::StartsWith;

namespace {

// Pushed by 7 N t / s: P1 bears 14/3 N t / s, P2 and R 7/3 N t / s and R the inertia of the trolley along X, 0.5 N at most, besides.
gantry::Run pushed(const std::string& limits) {
  return gantry::Run("[load]\nforce = [\"0 N\", \"7 N * t / 1 s\", \"0 N\"]\n[limits]\njoint_force = " + limits +
                     "\n[[section]]\nkind = \"reactions\"\n");
}

}  // namespace

TEST_CASE("joints of one letter beyond their limits share a sentence, which names the worst") {
  const gantry::Run r = pushed("\"1 N\"");
  const auto told = section::limit_sentences(r.analysis);
  REQUIRE(told.size() == 2);
  CHECK(told[0] ==
        "The forces in the joints P1 and P2 exceed their limits at 18 of 21 samples, t = 0.3 s to 2 s; worst is P1 at t = 2 s: it is "
        "9.333 N, the limit is 1 N.");
  CHECK_THAT(told[1], StartsWith("t = 0.") && Contains("force in joint R is 4.667 N, the limit is 1 N"));
  CHECK(section::joint_limit_sentences(r.analysis) == told);
}

TEST_CASE("the worst is the one that exceeds its own limit most, whichever is first and whichever is largest") {
  // P1 bears 9.33 of 9 N at the end, R 4.67 of 1 N from the first on.
  const auto told = section::limit_sentences(pushed("{ P1 = \"9 N\", R = \"1 N\" }").analysis);
  REQUIRE(told.size() == 2);
  CHECK_THAT(told[0], Contains("force in joint R"));
  CHECK_THAT(told[1], Contains("force in joint P1 is 9.333 N, the limit is 9 N"));
}

TEST_CASE("limits that are kept are not told") { CHECK(section::limit_sentences(pushed("\"10 N\"").analysis).empty()); }
