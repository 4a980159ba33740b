// Reports of scenarios without a motion.
#include <catch2/catch.hpp>

#include <reports/section/kinds.hpp>
#include <reports/section/make_report.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using Catch::Contains;

namespace {

document::Report report(const std::string& sections) {
  const std::string text = "title = \"Stage\"\n[mechanism]\nuse = \"stage\"\n" + sections;
  INFO(trial::told(text));
  return section::make_report(scenario::load_text(text, "a.toml", stage::source(), section::kinds()), "1", "test", {});
}

}  // namespace

TEST_CASE("a report without a motion says so, and demands nothing of samples that there are none of") {
  const document::Report r = report("[[section]]\nkind = \"mobility\"\n[[check]]\nthat = \"mobility.freedoms\"\nabove = 1\n");
  REQUIRE(r.summary.size() == 1);
  CHECK(r.summary[0].text == "No motion is prescribed; 2 degrees of freedom.");
  REQUIRE(r.checks.size() == 1);
  CHECK(r.checks[0].name == "mobility.freedoms > 1");
  CHECK(r.checks[0].passed);
  CHECK(r.data.empty());
}

TEST_CASE("a section singularity without a motion looks at its poses and its map alone") {
  const document::Report r = report(
      "[[section]]\nkind = \"singularity\"\nposes = [{ x = \"10 mm\" }]\nmap = { x = [\"-1 mm\", \"1 mm\"], phi = [\"-1 deg\", \"1 deg\"], "
      "points = 5 }\n");
  for (const document::Value& v : r.values) CHECK(v.name.ends_with("_1"));  // of the pose; none of the motion
  CHECK(r.values.size() == 2);
  REQUIRE(r.data.size() == 1);
  CHECK(r.data[0].name == "singularity-map");
  for (const document::Block& b : r.sections.at(0).blocks)
    if (const auto* p = std::get_if<document::Paragraph>(&b)) CHECK_THAT(p->text, !Contains("motion"));
}
