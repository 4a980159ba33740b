// What a report does with a proof: demands, checks, evidence, section. The proofs are made by hand, the samples are those of the stage: its
// slide x goes from 0 to 20 mm in 20 equal steps of 0.1 s, its turn psi stays at 5 degrees.
#include <catch2/catch.hpp>

#include <reports/section/checks.hpp>
#include <reports/section/every_instant/every_instant.hpp>
#include <tests/analysis/run.hpp>
#include <tests/scenario/trial.hpp>
#include <tests/section/report_words.hpp>
#include <tests/section/whole_report.hpp>

#include <memory>

using namespace pmreport;
using namespace pmreport::section;
using Catch::Contains;
using document::Verdict;
using About = analysis::Claim::About;
using State = analysis::Claim::State;

namespace {

struct Trial {
  explicit Trial(const std::string& more = "") : run(trial::with("20 mm * sin(2*pi*t/10 s)", "10 mm * t / 1 s") + more) {
    proof.end = 2, proof.intervals = 12, proof.resolution = 1e-7;
    claim(About::assembled, 0, {0, 0});
    for (int i = 0; i < 2; ++i) claim(About::stroke, i, run.analysis.machine().topology().actuators[static_cast<std::size_t>(i)].stroke);
    claim(About::regular, 0, {0, 0});
    extreme("x", {-1e-9, 0}, {0.02, 0.02 + 1e-9});
  }
  void claim(About about, int index, Range range) {
    analysis::Claim c;
    c.about = about, c.index = index, c.range = range, c.state = State::holds;
    proof.claims.push_back(c);
  }
  void extreme(const std::string& column, Bounds least, Bounds largest) {
    std::erase_if(proof.extremes, [&](const analysis::Extreme& e) { return e.column.name() == column; });
    proof.extremes.push_back({ColumnId::named(column), least, largest, 0, 2});
  }
  void breaks(std::size_t claim, Bounds begin, Bounds end) {
    proof.claims[claim].state = State::broken;
    proof.claims[claim].broken = {{begin, end, true, Bounds::exactly(0.5001), begin.middle()}};
  }
  Proved proved() const { return {proof, run.analysis.machine().topology()}; }
  std::vector<document::Check> checks() const { return evaluate_checks(run.analysis, proved(), {}); }
  std::vector<document::Evidence> lines(const std::vector<analysis::Unseen>& unseen = {}) const {
    return proof_of_motion(run.analysis, proved(), unseen).lines;
  }

  trial::Run run;
  MotionProof proof;
};
constexpr std::size_t assembly = 0, slide = 1, turn = 2, regularity = 3;

document::Check check(const std::string& that, const std::string& bound, Bounds least, Bounds largest, const std::string& column = "x") {
  Trial t("[[check]]\nthat = \"" + that + "\"\n" + bound + "\n");
  t.extreme(column, least, largest);
  return t.checks().front();
}

const document::Evidence& line(const std::vector<document::Evidence>& lines, const std::string& claim) {
  for (const document::Evidence& e : lines)
    if (e.claim == claim) return e;
  FAIL("no line " << claim);
  return lines.front();
}

}  // namespace

TEST_CASE("what a proof shows for every instant the demands say so of") {
  const auto all = Trial().checks();
  REQUIRE(all.size() == 3);
  for (const document::Check& c : all) CHECK(c.passed);
  CHECK(all[0].measured == "at every instant (proved)");
  CHECK(all[0].proved);
  CHECK(all[1].measured == "at every instant (proved)");
  CHECK_THAT(all[2].message, Contains("det G keeps its sign at every instant (proved)"));
}

TEST_CASE("a stroke that is left between two samples fails the report, although every sample keeps it") {
  Trial t;
  t.breaks(slide, {1.234, 1.2340004}, {1.25, 1.2500004});
  const document::Check c = t.checks()[1];
  CHECK_FALSE(c.passed);
  CHECK(c.name == "strokes and joint limits are kept");
  CHECK(c.measured == "1 time between samples");
  CHECK_THAT(c.message, Contains("q leaves its stroke from t = 1.234000 s to 1.250000 s, at most by 100 µm") &&
                            Contains(", first between the samples t = 1.2 s and t = 1.3 s."));
  CHECK(t.checks()[0].passed);
  CHECK(t.checks()[2].passed);
}

TEST_CASE("a reach that is lost between two samples fails the report") {
  Trial t;
  t.breaks(assembly, {0.51, 0.5104}, {0.54, 0.5404});
  const document::Check c = t.checks()[0];
  CHECK_FALSE(c.passed);
  CHECK_THAT(c.message, Contains("The mechanism cannot be assembled from t = ") && Contains("between the samples t = 0.5 s and t = 0.6 s"));
}

TEST_CASE("what a proof does not decide the samples do, and the demands say that they did") {
  Trial t;
  t.proof.claims[slide].state = State::undecided;
  t.proof.claims[slide].undecided = {{1, 1.1}};
  CHECK(t.checks()[1].passed);
  CHECK(t.checks()[1].measured == "at 21 of 21 samples");
  CHECK_FALSE(t.checks()[1].proved);
  t.proof.unexamined = "it follows from forces";
  for (const document::Check& c : t.checks()) CHECK(c.passed);
  CHECK(t.checks()[0].measured == "at 21 of 21 samples");
}

TEST_CASE("a change of the sign of det G that the proof alone knows is a singular surface met") {
  Trial t;
  t.proof.claims[regularity].state = State::broken;
  t.proof.meetings = {{analysis::Meeting::What::crossing, {0.51, 0.5100004}}};
  const document::Check c = t.checks()[2];
  CHECK_FALSE(c.passed);
  CHECK_THAT(c.message, Contains("det G changes its sign at t = 0.510000 s"));
}

TEST_CASE("a bracket decides a bound on a largest or least value, and says so") {
  const Bounds still{0, 0};
  const document::Check kept = check("max(x)", "below = \"21 mm\"", still, {0.0200001, 0.0200003});
  CHECK(kept.passed);
  CHECK(kept.proved);
  CHECK(kept.message == "at every instant: 20.0001 … 20.0003 mm");
  CHECK(kept.measured == "20 mm");
  CHECK(kept.bracket.high == 0.0200003);
  // Every sample keeps 20.5 mm, and between two of them x goes beyond it.
  const document::Check broken = check("max(x)", "below = \"20.5 mm\"", still, {0.0206, 0.02072});
  CHECK_FALSE(broken.passed);
  CHECK(broken.proved);
  CHECK(broken.measured == "20.6 … 20.8 mm");
  CHECK_THAT(broken.message,
             Contains("max(x): 20.6 … 20.8 mm at every instant, which is not below 20.5") && Contains("the samples alone keep it"));
  CHECK_FALSE(check("min(x)", "above = \"-1 mm\"", {-0.003, -0.002}, {0.02, 0.02}).passed);
  CHECK(check("min(x)", "above = \"-4 mm\"", {-0.003, -0.002}, {0.02, 0.02}).passed);
  CHECK_FALSE(check("max(abs(x))", "below = \"21 mm\"", {-0.023, -0.022}, {0.02, 0.02}).passed);
}

TEST_CASE("where a bracket holds the bound inside, the samples decide and the message says so") {
  const document::Check c = check("max(x)", "below = \"20.5 mm\"", {0, 0}, {0.0204, 0.0206});
  CHECK(c.passed);
  CHECK_FALSE(c.proved);
  CHECK(c.message == "at every instant: 20.4 … 20.6 mm; the bound lies within this bracket, so the samples decide");
}

TEST_CASE("of two bounds each is held against the bracket") {
  CHECK(check("max(x)", "below = \"21 mm\"\nabove = \"19 mm\"", {0, 0}, {0.0200001, 0.0200003}).passed);
  CHECK_FALSE(check("max(x)", "below = \"30 mm\"\nabove = \"25 mm\"", {0, 0}, {0.0206, 0.0207}).passed);
  CHECK_FALSE(check("max(x)", "below = \"20.5 mm\"\nabove = \"19 mm\"", {0, 0}, {0.0206, 0.0207}).passed);
}

TEST_CASE("a bracket decides an equality within its distance") {
  CHECK(check("max(x)", "equals = \"20 mm\"\nwithin = \"0.1 mm\"", {0, 0}, {0.0200001, 0.0200003}).proved);
  CHECK(check("max(x)", "equals = \"20 mm\"\nwithin = \"0.1 mm\"", {0, 0}, {0.0200001, 0.0200003}).passed);
  CHECK_FALSE(check("max(x)", "equals = \"20 mm\"\nwithin = \"0.1 mm\"", {0, 0}, {0.0202, 0.0203}).passed);
  CHECK_FALSE(check("max(x)", "equals = \"20 mm\"\nwithin = \"0.1 mm\"", {0, 0}, {0.02009, 0.02011}).proved);
}

TEST_CASE("a recording that is not what the plugin computes fails the proof that stands on it") {
  Trial t;
  t.proof.recording = 1e-14;
  CHECK(line(t.lines(), "What was recorded is what the plugin computes").verdict() == Verdict::passed);
  t.proof.recording = 1e-6;
  CHECK(line(t.lines(), "What was recorded is what the plugin computes").verdict() == Verdict::failed);
}

TEST_CASE("a check of what has no bracket is as before") {
  const document::Check c = check("rms(x)", "below = \"21 mm\"", {0, 0}, {0.0206, 0.0207});
  CHECK(c.passed);
  CHECK_FALSE(c.proved);
  CHECK(c.message.empty());
}

TEST_CASE("a proof that holds is a line a kind of claim, each of which says what it rests on") {
  const auto lines = Trial().lines();
  REQUIRE(lines.size() == 7);
  for (const document::Evidence& e : lines) CHECK_FALSE(e.how.empty());
  CHECK(line(lines, "The mechanism can be assembled").verdict() == Verdict::passed);
  CHECK(line(lines, "Strokes are kept").verdict() == Verdict::passed);
  CHECK(line(lines, "Joint limits are kept").verdict() == Verdict::not_applicable);
  CHECK(line(lines, "det G keeps its sign, and G is finite").verdict() == Verdict::passed);
  CHECK(line(lines, "Values and rates of the prescribed motion do not jump").verdict() == Verdict::passed);
  CHECK(line(lines, "The samples show the motion").verdict() == Verdict::passed);
}

TEST_CASE("where claims of a kind differ, each state has its line, with names, times and reasons") {
  Trial t;
  t.breaks(slide, {1.234, 1.2340004}, {1.25, 1.2500004});
  const auto broken = t.lines();
  CHECK(line(broken, "The stroke of psi is kept").verdict() == Verdict::passed);
  const document::Evidence& failed = line(broken, "The stroke of q is kept");
  CHECK(failed.verdict() == Verdict::failed);
  CHECK(failed.value == 1);
  CHECK_THAT(failed.reason, Contains("q leaves its stroke from t = 1.234000 s"));
  CHECK(failed.demanded_by == t.checks()[1].name);

  t.proof.claims[slide].state = State::undecided, t.proof.claims[slide].broken.clear(), t.proof.claims[slide].undecided = {{1, 1.1}};
  CHECK(line(t.lines(), "The stroke of q is kept").verdict() == Verdict::not_decided);
  CHECK_THAT(line(t.lines(), "The stroke of q is kept").reason, Contains("not decided from t = 1 s to 1.1 s"));
  t.proof.claims[slide].state = State::unexamined, t.proof.claims[slide].undecided.clear(), t.proof.claims[slide].reason = "no program";
  CHECK(line(t.lines(), "The stroke of q is kept").verdict() == Verdict::not_examined);
  CHECK(line(t.lines(), "The stroke of q is kept").reason == "no program");
  t.proof.claims[turn] = t.proof.claims[slide];
  CHECK(line(t.lines(), "Strokes are kept").verdict() == Verdict::not_examined);
}

TEST_CASE("a proof that did not look is not examined, line for line, and fails nothing") {
  Trial t;
  t.proof = {};
  t.proof.unexamined = "it follows from forces";
  const auto lines = t.lines();
  int unexamined = 0;
  for (const document::Evidence& e : lines) {
    CHECK_FALSE(e.failed());
    if (e.verdict() != Verdict::not_examined) continue;
    CHECK(e.reason == "it follows from forces");
    ++unexamined;
  }
  CHECK(unexamined == 5);  // the recording among them
}

TEST_CASE("regularity does not apply to an architecture that is singular at every pose") {
  Trial t;
  const Proved p{t.proof, t.run.analysis.machine().topology(), true};
  CHECK(line(proof_of_motion(t.run.analysis, p, {}).lines, "det G keeps its sign, and G is finite").verdict() == Verdict::not_applicable);
}

TEST_CASE("crossings are counted in the line of det G, and told with what stays open") {
  Trial t;
  t.proof.claims[regularity].state = State::broken;
  t.proof.meetings = {{analysis::Meeting::What::crossing, {0.51, 0.5100004}},
                      {analysis::Meeting::What::crossing, {0.61, 0.6100004}},
                      {analysis::Meeting::What::touch, {1, 1.1}}};
  const auto lines = t.lines();
  const document::Evidence& e = line(lines, "det G keeps its sign, and G is finite");
  CHECK(e.verdict() == Verdict::failed);
  CHECK(e.value == 2);
  CHECK_THAT(e.reason, Contains("at t = 0.510000 s and at t = 0.610000 s; det G touches zero, or comes so near") &&
                           Contains("from t = 1 s to 1.1 s"));
}

TEST_CASE("what moves between the samples is a line that fails with the demand") {
  const auto lines = Trial().lines({{"x", "m", OfMotion::value, 0.001, 0.5, 0.02, 0.02, 201}});
  const document::Evidence& e = line(lines, "The samples show the motion");
  CHECK(e.verdict() == Verdict::failed);
  CHECK(e.demanded_by == "the samples show the motion");
  CHECK_THAT(e.reason, Contains("201 do"));
}

TEST_CASE("a corner is no failure where the report shows nothing that follows from rates, and is named") {
  const auto lines_of = [](const std::string& kind) {
    const trial::Run run(
        "title = \"Corner\"\n[mechanism]\nuse = \"stage\"\n[motion]\nduration = \"1 s\"\nsamples = 21\n"
        "x = \"50 mm - 100 mm * abs(t/1 s - 0.5)\"\n[[section]]\nkind = \"" +
        kind + "\"\n");
    return proof_of_motion(run.analysis, proved(run.analysis), {}).lines;
  };
  const char* claim = "Values and rates of the prescribed motion do not jump";
  const auto places = lines_of("displacement"), rates = lines_of("velocity");
  CHECK(line(places, claim).verdict() == Verdict::not_applicable);
  CHECK_THAT(line(places, claim).reason, Contains("The rate of x jumps by 200 mm/s at t = 0.5 s"));
  CHECK(line(rates, claim).verdict() == Verdict::failed);
  CHECK(line(rates, claim).value == 1);
}

TEST_CASE("the table sets the brackets beside the samples, and the data have them all") {
  Trial t;
  t.extreme("q", {-1e-9, 0}, {0.0200001, 0.0200003});
  t.extreme("q_rate", {0.01, 0.01}, {0.01, 0.01});
  const AtEveryInstant r = every_instant_section(t.run.analysis, t.proved(), {});
  CHECK(r.section.id == "every-instant");
  const document::Table& table = report_words::table_of(r.section, "Least and largest values");
  REQUIRE(table.rows.size() == 3);  // both ends of a stroke, of a rate the larger
  CHECK(table.rows[0] == std::vector<std::string>{"q [mm]", "least", "−500", "0", "−0.000001 … 0.000000", "0"});
  CHECK(table.rows[1] == std::vector<std::string>{"q [mm]", "largest", "500", "20", "20.0001 … 20.0003", "2"});
  CHECK(table.rows[2] == std::vector<std::string>{"q_rate [mm/s]", "largest", "", "10", "10", "2"});
  REQUIRE(r.data.size() == 1);
  CHECK(r.data[0].name == "every_instant");
  CHECK(r.data[0].words[0] == std::vector<std::string>{"x", "q", "q_rate"});
  CHECK(r.data[0].words[1] == std::vector<std::string>{"m", "m", "m/s"});
  CHECK(r.data[0].columns[4][1] == 0.0200003);
}

TEST_CASE("meetings with a singular surface stand in a table with their enclosing times, the first two dozen of many") {
  Trial t;
  t.proof.meetings = {{analysis::Meeting::What::crossing, {0.5123456, 0.5123458}}, {analysis::Meeting::What::touch, {1, 1.1}}};
  const document::Section s = every_instant_section(t.run.analysis, t.proved(), {}).section;
  const document::Table& table = report_words::table_of(s, "Where the motion meets a singular surface");
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0] == std::vector<std::string>{"det G changes its sign", "0.5123456", "0.5123458"});
  CHECK(table.rows[1][0] == "det G touches zero, or comes too near to tell");
  t.proof.meetings.resize(30, t.proof.meetings.front());
  const document::Section many = every_instant_section(t.run.analysis, t.proved(), {}).section;
  CHECK(report_words::table_of(many, "Where the motion meets a singular surface").rows.size() == 24);
  CHECK_THAT(report_words::table_of(many, "Where the motion meets a singular surface").caption, Contains("The first 24 of 30"));
}

TEST_CASE("every report of a motion closes with what holds at every instant, and its findings have the same sentence") {
  const document::Report r = whole_report::of_gantry(whole_report::asking_for({"displacement"}));
  REQUIRE(r.sections.back().id == "every-instant");
  const auto sentence = std::get<document::Paragraph>(r.sections.back().blocks.front()).text;
  REQUIRE(r.every_instant);
  CHECK(r.every_instant->sentence == sentence);
  bool told = false;
  for (const document::Finding& f : r.findings) told = told || f.text == sentence;
  CHECK(told);
}

TEST_CASE("results have every claim with its state, range and times") {
  Trial t;
  t.breaks(slide, {1.234, 1.2340004}, {1.25, 1.2500004});
  const document::EveryInstant out = every_instant_results(t.run.analysis, t.proved());
  REQUIRE(out.claims.size() == 4);
  CHECK(out.claims[0].about == "assembly");
  CHECK(out.claims[1].subject == "q");
  CHECK(out.claims[1].state == "broken");
  CHECK(out.claims[1].range.high == 0.5);
  CHECK(out.claims[1].broken[0].side == "above");
  CHECK(out.claims[1].broken[0].begin.low == 1.234);
  CHECK(out.claims[3].about == "regularity");
  CHECK(out.claims[3].state == "holds");
  CHECK(out.extremes[0].column == "x");
}
