// summary.md and annotations: what fails by name, nothing that a user typed is markup or a command.
#include <catch2/catch.hpp>

#include <reports/document/write.hpp>
#include <tests/document/sample.hpp>

#include <algorithm>
#include <string>

using namespace pmreport::document;
using Catch::Contains;

namespace {

std::size_t lines(const std::string& text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

Report failing(std::size_t checks) {
  Report r = sample::report();
  for (std::size_t i = 0; i < checks; ++i)
    r.checks.push_back(
        {"force " + std::to_string(i), "500 N", "< 400 N", 500, 400, "N", false, "t = 1 s: too much", static_cast<int>(i) + 7});
  return r;
}

}  // namespace

TEST_CASE("the summary has verdict, key numbers, findings and what was not asked") {
  const std::string text = to_markdown(sample::report());
  CHECK_THAT(text, Contains("## ✓ 4SPS\\-SPR\\: kinematics and statics"));
  CHECK_THAT(text, Contains("**Passed**: checks: 1 passed; evidence: 4 passed"));
  CHECK_THAT(text, Contains("| Stroke used most | **812\\.4 mm** | 107 % |"));
  CHECK_THAT(text, Contains("* ⚠ t = 3\\.20 s to 4\\.10 s"));
  CHECK_THAT(text, Contains("dynamics and workspace"));
}

TEST_CASE("what fails stands in a table, twenty at most, and the rest is counted") {
  const std::string text = to_markdown(failing(33));
  CHECK_THAT(text, Contains("**Failed**") && Contains("| **force 0**<br>t = 1 s\\: too much | 500 N | &lt; 400 N |") &&
                       Contains("13 more in the report\\."));
  CHECK(text.find("force 20**") == std::string::npos);
}

TEST_CASE("nothing that was typed is markup in the summary, and no text is long") {
  Report r = failing(1);
  r.title = "# <script>alert(1)</script> [x](http://y) | a\nb";
  r.checks.back().name = std::string(5000, 'w') + "| <img>";
  const std::string text = to_markdown(r);
  CHECK(text.find("<script") == std::string::npos);
  CHECK(text.find("](") == std::string::npos);
  CHECK_THAT(text, Contains("\\# &lt;script&gt;") && Contains("\\| a b"));
  CHECK(text.size() < 8000);
}

TEST_CASE("annotations are one command a failure, ten at most, whatever the words") {
  CHECK(to_annotations(sample::report(), "a.toml").empty());
  Report r = failing(12);
  r.checks[1].name = "a,b: 50 %\n::error::x";
  const std::string text = to_annotations(r, "my, scenario.toml");
  CHECK(lines(text) == 10);
  CHECK_THAT(text, Contains("::error file=my%2C scenario.toml,line=7,title=a%2Cb%3A 50 %25%0A%3A%3Aerror%3A%3Ax::t = 1 s: too much\n") &&
                       Contains("(2 more fail)"));
}
