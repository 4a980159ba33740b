// Kinds of sections as data: the registered ones agree with README.md and with what reading accepts, and one of a test's own goes the whole
// way, from its keys to the report, with nothing else touched.
#include <catch2/catch.hpp>

#include <core/scenario/section/keys.hpp>
#include <reports/section/checks.hpp>
#include <reports/section/kinds.hpp>
#include <reports/section/make_report.hpp>
#include <tests/scenario/trial.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <numbers>
#include <set>

using namespace pmreport;
using Catch::Contains;
namespace keys = scenario::keys;

namespace {

// The circumference of a wheel, so many times: a kind that nothing else knows.
struct WheelOptions : scenario::Options {
  int turns = 3;
  std::string name = "wheel";
  double radius = 0.5;  // [m]
  scenario::Measured place;
};

std::vector<scenario::Quantity> wheel_quantities(const scenario::Options* options) {
  const auto* own = static_cast<const WheelOptions*>(options);
  std::vector<scenario::Quantity> out{{"wheel.way", "m", "way of the rim", false}};
  for (int i = 1; i <= (own != nullptr ? own->turns : 9); ++i)
    out.push_back({fmt::format("wheel.way_{}", i), "m", "way of one turn", false});
  return out;
}

section::Result make_wheel(const section::Context& c, const scenario::Section& s) {
  const auto& own = options_of<WheelOptions>(s);
  const double turn = 2 * std::numbers::pi * own.radius;
  section::Result out{
      {fmt::format("wheel{}", c.number), "wheel", "Wheel", {document::Paragraph{document::Paragraph::Tone::plain, own.name}}}};
  out.values.push_back({"wheel", "way", "m", own.turns * turn});
  out.values.push_back({"wheel", "place", "m", section::measure(c.analysis, own.place, c.values).value});
  return out;
}

const section::SectionKind& wheel_kind() {
  static const section::SectionKind kind{
      {.name = "wheel",
       .purpose = "a wheel",
       .keys = {keys::whole<WheelOptions>("turns", &WheelOptions::turns, 1, 9, "how often it turns"),
                keys::text<WheelOptions>("name", &WheelOptions::name, "of the wheel"),
                keys::required(keys::of<WheelOptions>("radius", scenario::Shape::quantity(Dimension{1, 0, 0, 0}), "of the rim", "",
                                                      [](const scenario::Entry& e, const scenario::Reading& r, WheelOptions& o) {
                                                        o.radius = r.reader.quantity(e.value, {1, 0, 0, 0}).value_or(o.radius);
                                                      }),
                               "radius = \"0.5 m\""),
                keys::late(keys::of<WheelOptions>("place", scenario::Shape::text(), "a number of another section", "",
                                                  [](const scenario::Entry& e, const scenario::Reading& r, WheelOptions& o) {
                                                    if (auto m = read_measured(e.value, *r.measurable, r.reader)) o.place = *m;
                                                  }))},
       .needs = {.statics = true, .values_of_others = true},
       .tables = {{"limits", "a limit, and there is none", "add [limits]", "wheels alone heed them"}},
       .quantities = wheel_quantities,
       .make_options = scenario::plain_options<WheelOptions>},
      make_wheel};
  return kind;
}

// The kinds that there are, and the wheel at their end.
scenario::Kinds with_wheel() {
  static const std::vector<const scenario::SectionKind*> all = [] {
    std::vector<const scenario::SectionKind*> out(section::kinds().begin(), section::kinds().end());
    out.push_back(&wheel_kind());
    return out;
  }();
  return all;
}

std::string told_with_wheel(const std::string& text) {
  try {
    (void)scenario::load_text(text, "a.toml", stage::source(), with_wheel());
  } catch (const scenario::ScenarioError& e) {
    return e.what();
  }
  return {};
}

const std::string limits = "[limits]\nactuator_speed = { q = \"1 m/s\" }\n";
std::string wheel(const std::string& lines) { return "[[section]]\nkind = \"wheel\"\n" + lines; }

}  // namespace

TEST_CASE("a kind of a test's own is read by its keys") {
  const scenario::Loaded loaded = scenario::load_text(
      trial::with_more(limits + wheel("turns = 2\nradius = \"25 cm\"\nplace = \"max(x)\"\n")), "a.toml", stage::source(), with_wheel());
  const scenario::Section& s = loaded.scenario.sections.at(1);
  CHECK(s.kind == &wheel_kind());
  const auto& own = options_of<WheelOptions>(s);
  CHECK(own.turns == 2);
  CHECK(own.name == "wheel");
  CHECK(own.radius == 0.25);
  CHECK(own.place.columns == std::vector<std::string>{"x"});
  CHECK(loaded.scenario.asks_for(wheel_kind()));
  CHECK(loaded.scenario.needs().statics);
  CHECK_FALSE(loaded.scenario.needs().dynamics);
  CHECK_FALSE(loaded.scenario.needs().pictures);
}

TEST_CASE("mistakes in a kind of a test's own are told as in any other") {
  const auto tell = [](const std::string& lines) { return told_with_wheel(trial::with_more(limits + wheel(lines))); };
  CHECK_THAT(tell(""), Contains("expected the key \"radius\" in [[section]]") && Contains("add a line: radius = \"0.5 m\""));
  CHECK_THAT(tell("radius = \"1 m\"\nturns = 10\n"),
             Contains("a.toml:17:9: error: expected a whole number from 1 to 9, seen the number 10"));
  CHECK_THAT(tell("radius = \"1 m\"\nturn = 1\n"), Contains("unknown key \"turn\" in a section of kind \"wheel\"; did you mean "
                                                            "\"turns\"?") &&
                                                       Contains("the keys are kind, title, turns, name, radius and place"));
  CHECK_THAT(tell("radius = \"1 m\"\nplace = \"max(l7)\"\n"), Contains("no column or group is called \"l7\""));
  CHECK_THAT(told_with_wheel(trial::with_more(wheel("radius = \"1 m\"\n"))),
             Contains("a section \"wheel\" needs a limit, and there is none"));
  CHECK_THAT(told_with_wheel(trial::with_more(limits)),
             Contains("[limits] is for the section \"wheel\", which this scenario does not have") &&
                 Contains("kind = \"wheel\"; wheels alone heed them"));
  CHECK_THAT(told_with_wheel(trial::with_more("[[section]]\nkind = \"weel\"\n")), Contains("did you mean \"wheel\"?"));
}

TEST_CASE("checks find the quantities of a kind of a test's own, as its options have them") {
  const auto check = [](const char* that) { return "[[check]]\nthat = \"" + std::string(that) + "\"\nbelow = \"9 m\"\n"; };
  const auto tell = [&](const char* that, const std::string& sections) {
    return told_with_wheel(trial::with_more(limits + sections + check(that)));
  };
  const std::string asked = wheel("turns = 2\nradius = \"1 m\"\n");
  CHECK(tell("wheel.way", asked).empty());
  CHECK(tell("wheel.way_2", asked).empty());
  CHECK_THAT(tell("wheel.way_3", asked), Contains("no quantity is called \"wheel.way_3\"") &&
                                             Contains("the quantities of wheel are wheel.way, wheel.way_1 and wheel.way_2"));
  CHECK_THAT(tell("wheel.way_9", ""), Contains("\"wheel.way_9\" belongs to the section \"wheel\", which this scenario does not have"));
}

TEST_CASE("a report has the section of a kind of a test's own, in its place, made when the values of the others are known") {
  const scenario::Loaded loaded =
      scenario::load_text(trial::with_more(limits + wheel("title = \"Round\"\nradius = \"1 m\"\nplace = \"classification.by_rule\"\n") +
                                           "[[section]]\nkind = \"classification\"\n[[check]]\nthat = \"wheel.way\"\nabove = \"18.8 m\"\n"),
                          "a.toml", stage::source(), with_wheel());
  const document::Report r = section::make_report(loaded, "1", "", {});
  REQUIRE(r.sections.size() == 4);
  CHECK(r.sections[1].title == "Round");
  CHECK(r.sections[2].kind == "classification");
  CHECK(r.checks.at(0).passed);  // three times round a wheel of 1 m: 18.85 m
  const auto place = std::find_if(r.values.begin(), r.values.end(), [](const document::Value& v) { return v.name == "place"; });
  REQUIRE(place != r.values.end());
  CHECK(place->value == 151);
}

TEST_CASE("README.md has the table of the registered kinds and their keys") {
  CHECK_THAT(trial::read(SOURCE "/README.md"), Contains(section::kinds_as_markdown(section::kinds())));
}

TEST_CASE("reading accepts the keys that are described, and no others") {
  for (const scenario::SectionKind* kind : section::kinds()) {
    std::vector<std::string> known{"kind", "title"};
    for (const scenario::Key& k : kind->keys) known.push_back(k.name);
    CAPTURE(kind->name);
    CHECK_THAT(trial::told(trial::with_more("[[section]]\nkind = \"" + kind->name + "\"\nno_such_key = 1\n")) + "\n",
               Contains("unknown key \"no_such_key\"") && Contains("hint: the keys are " + listed(known, "and") + "\n"));
  }
}

TEST_CASE("tables within sections accept the keys that are described") {
  const auto described = [](const std::string& kind, const std::string& key) {
    for (const scenario::SectionKind* k : section::kinds())
      for (const scenario::Key& found : k->keys) {
        if (k->name != kind || found.name != key) continue;
        const scenario::Shape* shape = &found.shape;
        while (shape->kind == scenario::Shape::Kind::list || shape->kind == scenario::Shape::Kind::either) shape = &shape->of.back();
        std::vector<std::string> names;
        for (const scenario::Key& inner : shape->keys) names.push_back(inner.name);
        return "the keys are " + listed(names, "and");
      }
    return std::string("nothing is described");
  };
  CHECK_THAT(trial::told(trial::with_more("[[section]]\nkind = \"comparison\"\n[[section.row]]\nno_such_key = 1\n")),
             Contains(described("comparison", "row")));
  CHECK_THAT(trial::told(trial::with_more("[[section]]\nkind = \"snapshots\"\nviews = [{ no_such_key = 1 }]\n")),
             Contains(described("snapshots", "views")));
}

TEST_CASE("every kind has a purpose and a maker: its quantities begin with its name") {
  std::set<std::string> names;
  for (const scenario::SectionKind* kind : section::kinds()) {
    CAPTURE(kind->name);
    CHECK(names.insert(kind->name).second);
    CHECK_FALSE(kind->purpose.empty());
    CHECK(static_cast<const section::SectionKind*>(kind)->make != nullptr);
    CHECK(kind->keys.empty() == (kind->make_options == nullptr));
    if (kind->quantities == nullptr) continue;
    for (const scenario::Quantity& q : kind->quantities(nullptr)) CHECK(q.name.starts_with(kind->name + "."));
  }
  CHECK(names.size() == 19);
}
