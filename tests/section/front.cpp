// The first page: key numbers against their limits, findings from what was computed, what it rests on and what nobody asked.
#include <tests/section/whole_report.hpp>

#include <catch2/catch.hpp>

#include <tests/given/only.hpp>
#include <tests/given/two_legs.hpp>

#include <algorithm>
#include <cmath>

using namespace pmreport;
using namespace whole_report;
using Catch::Matchers::Contains;
using Kind = document::Finding::Kind;

namespace {

// The table of two legs, 300 mm apart, moves along x at height y: [motion] and sections follow.
document::Report of_legs(const std::string& rest) {
  return report_of("title = \"Two legs\"\n[mechanism]\nuse = \"two-legs\"\n[motion]\nduration = \"1 s\"\nsamples = 11\n" + rest,
                   test::only(test::two_legs()));
}
std::string asked(std::initializer_list<const char*> kinds) {
  std::string out;
  for (const char* k : kinds) out += std::string("[[section]]\nkind = \"") + k + "\"\n";
  return out;
}
const document::KeyNumber* key(const document::Report& r, const std::string& what) {
  for (const document::KeyNumber& k : r.key_numbers)
    if (k.what == what) return &k;
  return nullptr;
}

}  // namespace

TEST_CASE("the stroke used most is the one nearest to an end, with its share of the way there from the middle") {
  // Legs of 0 to 1 m; at x = 150 mm and y from 500 to 900 mm both are as long, 912.4 mm at the end.
  const auto r = of_legs("x = \"150 mm\"\ny = \"500 mm + 400 mm * t / 1 s\"\n" + asked({"displacement"}));
  const document::KeyNumber* k = key(r, "Stroke used most");
  REQUIRE(k);
  const double length = std::hypot(0.15, 0.9);
  CHECK(k->number == Approx(length).epsilon(1e-12));
  CHECK(k->used == Approx((length - 0.5) / 0.5).epsilon(1e-12));
  CHECK(k->bound == 1);
  CHECK(k->section == "displacement");
  CHECK_THAT(k->where, Contains("t = 1 s"));
  CHECK_FALSE(k->broken());
}

TEST_CASE("between its samples a stroke is used most where it is proved to be") {
  // y swings once between two samples: its largest, 900 mm, is at none of them.
  const auto r = of_legs("x = \"150 mm\"\ny = \"700 mm + 200 mm * sin(2*pi*(t - 0.3 s)/1.3 s)\"\n" + asked({"displacement"}));
  const document::KeyNumber* k = key(r, "Stroke used most");
  REQUIRE(k);
  CHECK(k->number == Approx(std::hypot(0.15, 0.9)).epsilon(1e-6));
  CHECK_THAT(k->where, Contains("t = 0.625 s"));
}

TEST_CASE("a stroke that is left comes first among the key numbers, and a fault first among the findings") {
  const auto r = of_legs("x = \"150 mm\"\ny = \"500 mm + 600 mm * t / 1 s\"\n" + asked({"displacement", "singularity"}));
  REQUIRE_FALSE(r.key_numbers.empty());
  CHECK(r.key_numbers.front().what == "Stroke used most");
  CHECK(r.key_numbers.front().broken());
  REQUIRE_FALSE(r.findings.empty());
  CHECK(r.findings.front().kind == Kind::fault);
  CHECK(r.findings.front().section == "displacement");
  CHECK(std::ranges::is_sorted(r.findings, {}, &document::Finding::kind));
}

TEST_CASE("a key number without a limit of its own is held against the check that bounds it") {
  const std::string motion = "x = \"150 mm\"\ny = \"300 mm + 100 mm * t / 1 s\"\n", sections = asked({"statics"}),
                    load = "[load]\nforce = [\"0 N\", \"-100 N\", \"0 N\"]\n";
  const auto free = of_legs(motion + load + sections);
  const document::KeyNumber* k = key(free, "Largest force of an actuator, at rest");
  REQUIRE(k);
  CHECK_FALSE(k->limited());
  const double force = k->number;
  const auto checked = of_legs(motion + load + sections + "[[check]]\nthat = \"max(abs(actuator_force))\"\nbelow = \"80 N\"\n");
  k = key(checked, "Largest force of an actuator, at rest");
  REQUIRE(k);
  CHECK(k->used == Approx(force / 80).epsilon(1e-12));
  CHECK(k->bound == 80);
  CHECK_THAT(k->limit, Contains("80 N"));
}

TEST_CASE("a check whose bound is no limit of the number's size lends it none") {
  const std::string motion = "x = \"150 mm\"\ny = \"300 mm + 100 mm * t / 1 s\"\n", sections = asked({"statics"}),
                    load = "[load]\nforce = [\"0 N\", \"100 N\", \"0 N\"]\n";
  // Both legs pull with some 60 N: below zero, and so a bound above -400 N says nothing of how much.
  for (const char* check :
       {"that = \"min(l1_force)\"\nabove = \"-400 N\"\n", "that = \"max(abs(l1_force))\"\nabove = \"10 N\"\nbelow = \"400 N\"\n",
        "that = \"max(l1_force)\"\nbelow = \"-1 N\"\n"}) {
    CAPTURE(check);
    const auto r = of_legs(motion + load + sections + "[[check]]\n" + check);
    CHECK(r.checks.front().passed);
    const document::KeyNumber* k = key(r, "Largest force of an actuator, at rest");
    REQUIRE(k);
    CHECK_FALSE(k->limited());
  }
}

TEST_CASE("with limits the force nearest to its own is told, and called so") {
  const std::string motion = "x = \"100 mm\"\ny = \"300 mm + 100 mm * t / 1 s\"\n",
                    load = "[load]\nforce = [\"0 N\", \"-100 N\", \"0 N\"]\n";
  const auto r = of_legs(motion + load + "[limits]\nactuator_force = { l1 = \"1000 N\", l2 = \"50 N\" }\n" + asked({"dynamics"}));
  const document::KeyNumber* k = key(r, "Force of an actuator nearest to its limit");
  REQUIRE(k);
  CHECK(k->bound == 50);
  CHECK(k->used == Approx(k->number / 50).epsilon(1e-12));
  CHECK_THAT(k->where, Contains("l₂"));
}

TEST_CASE("a load that asks many times itself of an actuator is told with its factor and the condition number") {
  // High up the legs are nearly parallel: a force across them, F, asks F l / d of each, l their length and d = 300 mm.
  const auto force = [](double y) { return std::hypot(0.15, y) / 0.3; };
  const auto surprise = [](const document::Report& r) {
    for (const document::Finding& f : r.findings)
      if (f.kind == Kind::surprise && f.text.starts_with("A load of")) return f.text;
    return std::string();
  };
  const std::string load = "[load]\nforce = [\"10 N\", \"0 N\", \"0 N\"]\n";
  const auto high = of_legs("x = \"150 mm\"\ny = \"1600 mm + 100 mm * t / 1 s\"\n" + load + asked({"dynamics", "singularity"}));
  CHECK(force(1.7) > 5.6);
  CHECK_THAT(surprise(high),
             Contains("A load of 10 N asks 56.9 N of ") && Contains("t = 1 s, 5.7 times as much, where the condition number is "));
  CHECK(force(0.7) < 3);
  const auto low = of_legs("x = \"150 mm\"\ny = \"600 mm + 100 mm * t / 1 s\"\n" + load + asked({"dynamics", "singularity"}));
  CHECK(surprise(low).empty());
}

TEST_CASE("what asks for the largest force is told in shares that sum to all of it") {
  const auto r = of_gantry("[load]\nforce = [\"7 N\", \"0 N\", \"0 N\"]\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"]\n" +
                           asking_for({"dynamics"}));
  int told = 0;
  for (const document::Finding& f : r.findings) {
    if (!f.text.starts_with("Of the largest")) continue;
    ++told;
    CHECK(f.kind == Kind::result);
    int sum = 0;
    for (std::size_t at = f.text.find(" %"); at != std::string::npos; at = f.text.find(" %", at + 1)) {
      std::size_t first = at;
      while (first > 0 && std::isdigit(static_cast<unsigned char>(f.text[first - 1]))) --first;
      const bool minus = f.text.substr(0, first).ends_with("−");
      sum += (minus ? -1 : 1) * std::stoi(f.text.substr(first, at - first));
    }
    CHECK(std::abs(sum - 100) <= 1);
  }
  CHECK(told == 1);
}

TEST_CASE("assumptions are those that this run rests on, and what was not asked is told") {
  const auto moved = of_gantry(asking_for({"displacement"}));
  const auto has = [](const std::vector<std::string>& all, const std::string& part) {
    return std::ranges::any_of(all, [&](const std::string& s) { return s.find(part) != std::string::npos; });
  };
  CHECK(has(moved.assumptions, "Bodies are rigid"));
  CHECK_FALSE(has(moved.assumptions, "weightless"));
  CHECK(has(moved.not_asked, "dynamics"));
  const auto forced = of_gantry("[load]\nforce = [\"7 N\", \"0 N\", \"0 N\"]\n" + asking_for({"dynamics"}));
  CHECK(has(forced.assumptions, "weightless"));
  CHECK(has(forced.assumptions, "reference point"));
  CHECK_FALSE(has(forced.not_asked, "dynamics"));
}
