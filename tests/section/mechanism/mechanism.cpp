// Section `mechanism`: parameters, joints, bodies and mobility, as declared and as counted by hand.
#include <catch2/catch.hpp>

#include <tests/given/only.hpp>
#include <tests/section/gantry.hpp>
#include <tests/section/report_words.hpp>
#include <tests/section/whole_report.hpp>

#include <algorithm>

using namespace pmreport;
using namespace whole_report;
using Catch::Contains;
using report_words::check_proofs, report_words::row_of, report_words::table_of, report_words::text_of;

namespace {

using Row = std::vector<std::string>;

// The gantry, whose trolley has a mass and whose platform has none.
class WithoutMass : public gantry::Gantry {
 public:
  using Gantry::Gantry;
  Topology topology() const {
    Topology t = Gantry::topology();
    t.bodies[1].inertia = {};
    return t;
  }
};

}  // namespace

TEST_CASE("every parameter has its value in the unit that a reader expects, and the line that sets it") {
  const auto r = of_stage(", cone = \"30 deg\"", "x = \"0 mm\"\nphi = \"0 deg\"\n", asking_for({"mechanism"}));
  const document::Section& s = section_of(r, "mechanism");
  const auto parameter = [&](const std::string& name) { return row_of(s, "Parameters", name); };
  const Row arm = parameter("arm");
  CHECK(Row(arm.begin(), arm.end() - 1) == Row{"arm", "length r of the feeler", "200", "mm"});
  CHECK_THAT(arm.back(), Catch::StartsWith("line "));
  CHECK(parameter("cone").back() == arm.back());  // both stand in one line
  CHECK(parameter("cone").at(3) == "°");
  CHECK(parameter("stroke_min") == Row{"stroke_min", "lower end of the slide", "−500", "mm", "default"});
  CHECK(parameter("ratio").at(2) == "2");
  CHECK(parameter("dependent").at(2) == "y");
  const Row x = row_of(s, "Motion, load", "motion.x");
  CHECK(x.at(1) == "0 mm");
  CHECK(std::stoi(x.at(2)) > 0);
  CHECK_THAT(text_of(s), Contains("Stage: slide and turntable. Source: made for the tests."));
}

TEST_CASE("joints and bodies of the gantry are listed as they are declared") {
  const auto r = of_gantry(asking_for({"mechanism"}));
  const document::Section& s = section_of(r, "mechanism");
  const Row drive = row_of(s, "Joints", "P1"), rail = row_of(s, "Joints", "P2"), hinge = row_of(s, "Joints", "R");
  CHECK_THAT(drive.at(1), Contains("drives q"));
  CHECK(Row(drive.begin() + 2, drive.begin() + 5) == Row{"base", "platform", "1"});
  CHECK_THAT(rail.at(1), !Contains("drives"));
  CHECK(Row(rail.begin() + 2, rail.begin() + 5) == Row{"base", "trolley", "1"});
  CHECK(Row(hinge.begin() + 2, hinge.begin() + 5) == Row{"trolley", "platform", "1"});
  CHECK(row_of(s, "Bodies", "platform") == Row{"platform", "–", "2", "(0, 0, 0)", "0.01, 0.01, 0.01"});
  CHECK(row_of(s, "Bodies", "trolley") == Row{"trolley", "1", "1", "(0, 0, 0)", "0.01, 0.01, 0.01"});
}

TEST_CASE("the mobility of the gantry is that of its count and its four self-stresses") {
  // Base, platform, trolley; three joints of one freedom: 6 (3 - 3 - 1) + 3 = -3. Its only loop is an identity for four of six equations.
  const auto r = of_gantry(asking_for({"mechanism"}));
  const document::Section& s = section_of(r, "mechanism");
  const auto value = [&](const std::string& quantity) { return row_of(s, "Mobility", quantity).at(1); };
  CHECK(value("links n, base included") == "3");
  CHECK(value("joints g") == "3");
  CHECK(value("sum of joint freedoms Σf") == "3");
  CHECK(value("Grübler–Kutzbach 6(n − g − 1) + Σf − ζ") == "-3");
  CHECK(value("constraint rows, their rank") == "15, 11");
  CHECK(value("redundant constraints, by rank") == "4");
  CHECK(value("degrees of freedom, by rank") == "1");
  check_proofs(s, 3);
}

TEST_CASE("a mechanism is shown at home, in one picture, and as a line drawing, both also as vectors") {
  const auto r = of_gantry(asking_for({"mechanism"}));
  const auto galleries = report_words::pointers<document::Gallery>(section_of(r, "mechanism"));
  REQUIRE(galleries.size() == 2);
  for (const document::Gallery* g : galleries) {
    REQUIRE(g->pictures.size() == 1);
    CHECK(g->pictures[0].png.starts_with("\x89PNG"));
    CHECK(g->pictures[0].pdf.starts_with("%PDF"));
    CHECK(g->pictures[0].svg.starts_with("<svg"));
  }
  CHECK(galleries[0]->pictures[0].id == "mechanism");
  CHECK_FALSE(galleries[0]->pictures[0].as_lines);
  const document::Picture& diagram = galleries[1]->pictures[0];
  CHECK(diagram.id == "diagram");
  CHECK(diagram.as_lines);
  // What the gantry has not is not explained.
  CHECK(diagram.caption.ends_with(
      ": cylinders are revolute joints, boxes prismatic ones; grey joints are driven, dash-dot lines are axes, dashed lines are hidden."));
}

TEST_CASE("data that look odd are warned of on the mechanism's page, and among the findings where a number depends on them") {
  const auto odd = [](const std::string& text) { return text.starts_with("Odd data: platform: the platform has no mass"); };
  const auto on_page = [&](const document::Report& r) {
    const auto all = report_words::blocks<document::Paragraph>(section_of(r, "mechanism"));
    return std::count_if(all.begin(), all.end(),
                         [&](const document::Paragraph& p) { return p.tone == document::Paragraph::Tone::warning && odd(p.text); });
  };
  const auto found = [&](const document::Report& r) {
    return std::count_if(r.findings.begin(), r.findings.end(),
                         [&](const document::Finding& f) { return f.kind == document::Finding::Kind::fault && odd(f.text); });
  };
  const document::Report sound = of_gantry(asking_for({"mechanism", "dynamics"}));
  CHECK(on_page(sound) == 0);
  CHECK(found(sound) == 0);
  const auto of_odd = [](const std::string& more) {
    return report_of("title = \"t\"\n[mechanism]\nuse = \"gantry\"\n[motion]\nduration = \"2 s\"\nsamples = 21\n" + more,
                     test::only<WithoutMass>());
  };
  const document::Report moving = of_odd(asking_for({"mechanism", "dynamics"}));
  CHECK(on_page(moving) == 1);
  CHECK(found(moving) == 1);
  const document::Report shown = of_odd(asking_for({"mechanism", "displacement"}));
  CHECK(on_page(shown) == 1);
  CHECK(found(shown) == 0);
  const document::Report weighing =
      of_odd("[load]\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"]\n" + asking_for({"mechanism", "statics"}));
  CHECK(found(weighing) == 1);
}
