// What a study may be asked, and what its user is told of mistakes.
#include <catch2/catch.hpp>

#include <tests/scenario/trial.hpp>
#include <tests/section/study/cross_table.hpp>

using namespace pmreport;
using Catch::Contains;
using cross_table::text;
using cross_table::told;

namespace {

std::string sweep_of(const std::string& what) { return text("sweep = " + what + "\n"); }
std::string optimise(const std::string& what) { return text("optimise = " + what + "\n"); }
std::string pareto(const std::string& what) { return text("pareto = " + what + "\n"); }

}  // namespace

TEST_CASE("a study asks one of its questions, and no more") {
  CHECK_THAT(told(text("")), Contains("has nothing to do: expected sweep, variants, optimise or pareto"));
  CHECK_THAT(told(text("sweep = { a = [\"100 mm\", \"200 mm\", 3] }\nvariants = [{ name = \"x\" }]\n")),
             Contains("a study asks one question, and sweep stands before variants"));
  CHECK(told(sweep_of("{ a = [\"100 mm\", \"200 mm\", 3] }")).empty());
}

TEST_CASE("numbers that a study cannot look at are told with those that it can") {
  const std::string sweep = "sweep = { a = [\"100 mm\", \"200 mm\", 3] }\n";
  CHECK_THAT(told(text("measure = [\"workspace.volum\"]\n" + sweep)),
             Contains("no number that a study could look at is called \"workspace.volum\"; did you mean \"workspace.volume\"?") &&
                 Contains("they are workspace.volume, workspace.x_low, workspace.x_high, workspace.y_low, workspace.y_high, "
                          "home.condition and home.smallest_singular_value"));
  CHECK_THAT(told(text("measure = [\"home.condition\", \"home.condition\"]\n" + sweep)), Contains("is given twice"));
  CHECK_THAT(told(text(sweep, "")), Contains("belongs to the section \"workspace\", which this scenario does not have"));
  CHECK(told(text("measure = [\"home.condition\"]\n" + sweep, "")).empty());
  CHECK(told(text("measure = [\"workspace.low.volume\", \"workspace.low.x_high\"]\n" + sweep, cross_table::grid + "name = \"low\"\n"))
            .empty());
}

TEST_CASE("ranges are of parameters that are single numbers, rise, and stay within what the mechanism takes") {
  CHECK_THAT(told(sweep_of("{ c = [\"1 mm\", \"2 mm\", 3] }")),
             Contains("cross-table has no parameter \"c\"") && Contains("its numbers are a, b and ratio"));
  CHECK_THAT(told(sweep_of("{ look = [0, 1, 2] }")), Contains("look is a choice and has no range") && Contains("write variants"));
  CHECK_THAT(told(sweep_of("{ marks = [\"0 mm\", \"1 mm\", 2] }")), Contains("marks is a list of numbers and has no range"));
  CHECK_THAT(told(sweep_of("{ a = [\"200 mm\", \"100 mm\", 3] }")), Contains("expected a range of a that rises, seen one that falls"));
  CHECK_THAT(told(sweep_of("{ a = [\"200 mm\", \"200 mm\", 3] }")), Contains("seen one value at both ends"));
  CHECK_THAT(told(sweep_of("{ a = [\"1 mm\", \"200 mm\", 3] }")), Contains("expected 10 mm to 600 mm for a, seen 1 mm"));
  CHECK_THAT(told(sweep_of("{ a = [\"100 mm\", \"200 mm\"] }")), Contains("two ends of a range and how many values"));
  CHECK_THAT(told(sweep_of("{ a = [\"100 mm\", \"200 mm\", 1] }")), Contains("expected a whole number from 2 to 10000, seen the number 1"));
  CHECK_THAT(told(sweep_of("{ a = [\"100 mm\", \"200 mm\", 200], b = [\"100 mm\", \"200 mm\", 200] }")),
             Contains("expected at most 10000 variants, seen 40000"));
  CHECK_THAT(told(sweep_of("{ a = [0.1, 0.2, 2], b = [0.1, 0.2, 2], ratio = [1, 2, 2] }")),
             Contains("expected 1 to 2 parameters in sweep, seen 3"));
  CHECK_THAT(told(sweep_of("{}")), Contains("expected 1 to 2 parameters in sweep, seen 0"));
}

TEST_CASE("a search needs a goal, ranges and bounds of the right kind") {
  const std::string over = "over = { a = [\"100 mm\", \"300 mm\"] }";
  CHECK_THAT(told(optimise("{ " + over + " }")), Contains("expected one goal in optimise, seen 0"));
  CHECK_THAT(told(optimise("{ maximise = \"workspace.volume\", minimise = \"home.condition\", " + over + " }")),
             Contains("expected one goal in optimise, seen 2"));
  CHECK_THAT(told(optimise("{ maximise = \"workspace.volume\" }")), Contains("expected the key \"over\""));
  CHECK_THAT(told(optimise("{ maximise = \"workspace.volume\", " + over + ", points = 3 }")), Contains("unknown key \"points\""));
  CHECK_THAT(told(optimise("{ maximise = \"workspace.volume\", " + over + ", evaluations = 5 }")),
             Contains("expected a whole number from 20 to 10000, seen the number 5"));
  CHECK_THAT(told(optimise("{ maximise = \"workspace.volume\", " + over +
                           ", subject_to = [{ that = \"workspace.x_high\", below = \"2 deg\" }] }")),
             Contains("expected a length"));
  CHECK_THAT(told(optimise("{ maximise = \"workspace.volume\", " + over + ", subject_to = [{ that = \"workspace.x_high\" }] }")),
             Contains("expected below or above in a constraint"));
  CHECK_THAT(told(pareto("{ maximise = \"workspace.volume\", " + over + " }")), Contains("expected two goals in pareto, seen 1"));
  CHECK_THAT(told(pareto("{ maximise = [\"workspace.volume\", \"workspace.volume\"], " + over + " }")),
             Contains("\"workspace.volume\" is a goal already"));
  CHECK_THAT(told(pareto("{ maximise = [\"workspace.x_high\", \"workspace.y_high\"], " + over + ", points = 12, evaluations = 100 }")),
             Contains("12 points of a front need 120 evaluations or more, seen 100"));
  CHECK(told(pareto("{ maximise = \"workspace.volume\", minimise = \"home.condition\", " + over + " }")).empty());
}

TEST_CASE("other scenarios lie in the folder, are no other than they seem, and have what is asked of them") {
  const trial::Folder folder;
  const std::string sound = text("sweep = { a = [\"100 mm\", \"200 mm\", 3] }\n");
  folder.write("other.toml", sound);
  folder.write("bare.toml", text("measure = [\"home.condition\"]\nsweep = { a = [\"100 mm\", \"200 mm\", 3] }\n", ""));
  folder.write("broken.toml", "title = 3\n");
  const auto tell = [&](const std::string& variant) {
    const std::string own = text("variants = [" + variant + "]\n");
    return told(own, folder.write("a.toml", own));
  };
  CHECK(tell("{ name = \"other\", scenario = \"other.toml\" }").empty());
  CHECK_THAT(tell("{ name = \"x\", scenario = \"a.toml\" }"), Contains("expected another scenario, seen \"a.toml\", this one"));
  CHECK_THAT(tell("{ name = \"x\", scenario = \"../a.toml\" }"), Contains("it leads out of the folder"));
  CHECK_THAT(tell("{ name = \"x\", scenario = \"none.toml\" }"), Contains("there is no such file"));
  CHECK_THAT(tell("{ name = \"x\", scenario = \"broken.toml\" }"), Contains("broken.toml:1:9: error: expected a text"));
  CHECK_THAT(tell("{ name = \"x\", scenario = \"bare.toml\" }"), Contains("\"bare.toml\" has no workspace.volume"));
  CHECK_THAT(tell("{ name = \"x\" }, { name = \"x\" }"), Contains("a variant called \"x\" stands before"));
  CHECK_THAT(tell("{ scenario = \"other.toml\" }"), Contains("expected the key \"name\""));
  CHECK_THAT(tell("{ name = \"x\", parameters = { a = \"2 m\" } }"), Contains("expected 10 mm to 600 mm for a, seen 2000 mm"));
  CHECK_THAT(tell("3"), Contains("expected a variant, seen the number 3"));
  // Two that name each other are read without end by nobody.
  folder.write("other.toml", text("variants = [{ name = \"back\", scenario = \"a.toml\" }]\n"));
  CHECK(tell("{ name = \"other\", scenario = \"other.toml\" }").empty());
}

TEST_CASE("checks name the numbers of a study, as its question has them") {
  const auto check = [](const std::string& study, const std::string& that, const std::string& bound) {
    return told(text(study + "[[check]]\nthat = \"" + that + "\"\nabove = \"" + bound + "\"\n"));
  };
  const std::string sweep = "sweep = { a = [\"100 mm\", \"200 mm\", 3] }\n",
                    best = "optimise = { maximise = \"workspace.volume\", over = { a = [\"100 mm\", \"200 mm\"] } }\n";
  CHECK(check(sweep, "study.largest_volume", "0 m^2").empty());
  CHECK(check(sweep, "study.volume_3", "0 m^2").empty());
  CHECK_THAT(check(sweep, "study.volume_4", "0 m^2"), Contains("no quantity is called \"study.volume_4\""));
  CHECK_THAT(check(sweep, "study.best_volume", "0 m^2"), Contains("no quantity is called"));
  CHECK_THAT(check(sweep, "study.volume_3", "0 m"), Contains("expected"));
  for (const auto& [that, bound] : {std::pair{"study.best_volume", "0 m^2"},
                                    {"study.best_volume_low", "0 m^2"},
                                    {"study.at_a", "0 mm"},
                                    {"study.gain", "0"},
                                    {"study.failed", "-1"}})
    CHECK(check(best, that, bound).empty());
  CHECK(check("name = \"reach\"\n" + best, "study.reach.best_volume", "0 m^2").empty());
}
