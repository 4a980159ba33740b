// report.pdf as other programs read it: qpdf and poppler are the oracles.
#include <reports/document/write.hpp>
#include <tests/document/pdf/pdf_sample.hpp>
#include <tests/document/pdf/pdf_tools.hpp>
#include <tests/document/sample.hpp>

#include <catch2/catch.hpp>

#include <stdlib.h>

#include <clocale>
#include <limits>

using namespace pmreport;
using namespace pmreport::document;
using sample::ask;
using sample::contains;
using sample::count;

namespace {

// A variable of the environment, as it was again at the end.
class Environment {
 public:
  Environment(const char* name, const char* value) : name_(name) {
    if (const char* old = getenv(name)) old_ = old;
    if (value) {
      setenv(name, value, 1);
    } else {
      unsetenv(name);
    }
  }
  ~Environment() {
    if (old_) {
      setenv(name_, old_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

Report with_block(Block block) {
  Report r;
  r.title = "A report";
  r.sections.push_back({"one", "", "One", {std::move(block)}});
  return r;
}

std::string text_of(const Report& r) { return ask("pdftotext -layout {} -", to_pdf(r)).value_or(""); }

int count_pages(const Report& r) {
  const auto info = ask("pdfinfo {}", to_pdf(r));
  return info ? std::stoi("0" + sample::field(*info, "Pages")) : 0;
}

}  // namespace

TEST_CASE("the PDF has the same bytes in every run, time zone and locale") {
  const Environment no_date("SOURCE_DATE_EPOCH", nullptr);
  const Report r = sample::full_report();
  const std::string first = to_pdf(r);
  CHECK((first == to_pdf(r)));
  const Environment zone("TZ", "Asia/Kolkata"), language("LC_ALL", "de_DE.UTF-8");
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (!std::setlocale(LC_ALL, "")) WARN("de_DE.UTF-8 is not installed: another decimal sign is not tested");
  const std::string there = to_pdf(r);
  std::setlocale(LC_ALL, before.c_str());
  CHECK((first == there));
}

TEST_CASE("qpdf finds no fault in the PDF") {
  for (const Report& r : {sample::full_report(), sample::report(), Report{}}) {
    CAPTURE(r.title);
    if (const auto said = ask("qpdf --check {}", to_pdf(r))) CHECK(contains(*said, "No syntax or stream encoding errors found"));
  }
}

TEST_CASE("the PDF says what it is, in any script") {
  const Environment no_date("SOURCE_DATE_EPOCH", nullptr);
  const Report r = sample::full_report();
  const auto info = ask("pdfinfo {}", to_pdf(r));
  if (!info) return;
  CHECK(sample::field(*info, "Title") == r.title);
  CHECK(sample::field(*info, "Author") == r.author);
  CHECK(sample::field(*info, "Subject") == r.mechanism_title);
  CHECK(sample::field(*info, "Creator") == "pmreport 1.0.0");
  CHECK(contains(*info, "(A4)"));
  CHECK(std::stoi(sample::field(*info, "Pages")) >= 8);
  CHECK_FALSE(contains(*info, "CreationDate"));
}

TEST_CASE("the PDF carries the date that SOURCE_DATE_EPOCH asks for, and none that makes no sense") {
  const Environment utc("TZ", "UTC");
  for (const char* nonsense : {"", "yesterday", "-5", "12x", "99999999999999999999"}) {
    const Environment date("SOURCE_DATE_EPOCH", nonsense);
    CAPTURE(nonsense);
    if (const auto info = ask("pdfinfo {}", to_pdf(Report{}))) CHECK_FALSE(contains(*info, "CreationDate"));
  }
  const Environment date("SOURCE_DATE_EPOCH", "1700000000");  // date -u -d @1700000000: Tue Nov 14 22:13:20 UTC 2023
  const std::string pdf = to_pdf(Report{});
  if (const auto said = ask("qpdf --check {}", pdf)) CHECK(contains(*said, "No syntax or stream encoding errors found"));
  if (const auto info = ask("pdfinfo -isodates {}", pdf)) CHECK(sample::field(*info, "CreationDate") == "2023-11-14T22:13:20Z");
}

TEST_CASE("all that the report says can be read in the PDF, as it was typed") {
  Report r = sample::full_report();
  r.files = {{"data/mesh.stl", "boundary of the workspace", "12345"}};
  const std::string text = text_of(r);
  if (text.empty()) return;
  for (const char* part : {"4SPS-SPR: kinematics and statics",
                           "<script>alert(1)</script>",
                           "Лев Толстой & Søren Ångström",
                           "The mechanism",
                           "Snapshots",
                           "Displacement",
                           "Velocity & <b>rates</b>",
                           "Acceleration",
                           "Statics",
                           "Checks",
                           "Scenario",
                           "Provenance",
                           "FAILED",
                           "2 checks",
                           "4 lines of evidence",
                           "1 error",
                           "2.1 × 10⁻¹⁵ m",
                           "2.5 × 10⁻⁹",
                           "not computed",
                           "Figure 6.",
                           "Table 3.",
                           "Data: data/displacement.csv",
                           "boundary of the workspace",
                           "max(abs(actuator_force)) < 400 N",
                           "limb 3 needs 812.4 mm",
                           "use = \"4sps-spr\"",
                           "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"}) {
    CAPTURE(part);
    CHECK(contains(text, part));
  }
  CHECK(text.find("t = 1.32 s: limb 3") < text.find("501 samples over 10 s"));
  CHECK_FALSE(contains(text, " nan"));
}

TEST_CASE("every section is a destination, an entry of the outline and of the contents") {
  const Report r = sample::full_report();
  const std::string pdf = to_pdf(r);
  const auto destinations = ask("pdfinfo -dests {}", pdf);
  const auto plain = ask("qpdf --qdf --object-streams=disable {} -", pdf);
  if (!destinations || !plain) return;
  const int entries = static_cast<int>(r.sections.size()) + 3, links_to_data = 6;
  for (const char* name :
       {"mechanism", "snapshots", "displacement", "velocity", "acceleration", "statics", "checks", "scenario", "provenance"}) {
    CAPTURE(name);
    CHECK(contains(*destinations, '"' + std::string(name) + '"'));
  }
  CHECK(count(*destinations, "XYZ") == entries);
  const int pointers_of_the_verdict = 3;  // to the failed check, and to each failed line of evidence
  CHECK(count(*plain, "/Subtype /Link") == entries + pointers_of_the_verdict + links_to_data);
  CHECK(contains(*plain, "/Title (3  Displacement)"));
  CHECK(contains(*plain, "/Title (Provenance)"));
  CHECK(contains(*plain, "/PageLabels"));
}

TEST_CASE("sections of one name, or of no usable name, keep their own destinations") {
  Report r;
  for (const char* id : {"a", "a", "checks", "x'y] \\", ""}) r.sections.push_back({id, "", "Section", {}});
  const auto destinations = ask("pdfinfo -dests {}", to_pdf(r));
  if (destinations) CHECK(count(*destinations, "XYZ") == 5 + 2);  // and scenario and provenance
}

TEST_CASE("contents give the page on which a section begins") {
  Report r;
  for (int i = 0; i < 4; ++i)
    r.sections.push_back({"s" + std::to_string(i), "", "Section number " + std::to_string(i), {sample::grid(50, 3)}});
  const std::string pdf = to_pdf(r);
  const auto contents = ask("pdftotext -f 1 -l 1 -layout {} -", pdf);
  if (!contents) return;
  for (int i = 0; i < 4; ++i) {
    const std::string title = "Section number " + std::to_string(i);
    const auto at = contents->find(title);
    REQUIRE(at != std::string::npos);
    const int page = std::stoi(contents->substr(at + title.size()));
    const auto text_on = [&](int p) { return *ask("pdftotext -f " + std::to_string(p) + " -l " + std::to_string(p) + " {} -", pdf); };
    CAPTURE(i, page);
    CHECK(contains(text_on(page), title));
    if (page > 2) CHECK_FALSE(contains(text_on(page - 1), title));
  }
}

TEST_CASE("fonts are DejaVu, embedded, and can be read back") {
  const auto fonts = ask("pdffonts {}", to_pdf(sample::full_report()));
  if (!fonts) return;
  CHECK(contains(*fonts, "DejaVuSansMono"));
  const int rows = count(*fonts, "\n") - 2;
  CHECK(rows > 0);
  CHECK(count(*fonts, "+DejaVu") == rows);
  CHECK(count(*fonts, " yes yes yes ") == rows);
}

TEST_CASE("a table longer than a page repeats its heading, and loses no row") {
  const Report r = with_block(sample::grid(55, 4));
  Report longer = r;
  std::get<Table>(longer.sections[0].blocks[0]).headings[0] = "a heading [s]";
  longer.sections[0].blocks.insert(longer.sections[0].blocks.begin(), sample::plot("above", 4, 2));
  const std::string text = text_of(longer);
  if (text.empty()) return;
  CHECK(count(text, "a heading [s]") == 2);
  CHECK(contains(text, "Table 1, continued"));
  for (int i = 1; i <= 55; ++i) {
    CAPTURE(i);
    CHECK(contains(text, std::to_string(i) + ".03"));
  }
}

TEST_CASE("a table of ten thousand rows shows the first and says where the others are") {
  const Report r = with_block(sample::grid(10000, 4));
  const std::string text = text_of(r);
  if (text.empty()) return;
  CHECK(contains(text, "Rows 1 to 60 of 10000 are shown; report.html has all of them."));
  CHECK(contains(text, "60.03"));
  CHECK_FALSE(contains(text, "61.03"));
  CHECK(count_pages(r) <= 5);
}

TEST_CASE("a wide table stays on the paper") {
  for (const int columns : {14, 24, 90}) {
    CAPTURE(columns);
    Table t = sample::grid(3, columns);
    for (auto& cell : t.rows[1]) cell = "123456.789";
    const auto boxes = ask("pdftotext -bbox {} -", to_pdf(with_block(t)));
    if (!boxes) return;
    double right = 0;
    for (std::size_t at = boxes->find("xMax=\""); at != std::string::npos; at = boxes->find("xMax=\"", at + 1)) {
      right = std::max(right, std::stod(boxes->substr(at + 6)));
    }
    CHECK(right > 500);
    CHECK(right < 192 / 25.4 * 72 + 1);  // the right edge of the text [pt]
  }
}

TEST_CASE("figures go in as vectors, pictures as images without a mask, no finer than print shows") {
  Report plots = with_block(sample::plot("p", 6, 2));
  auto images = ask("pdfimages -list {}", to_pdf(plots));
  if (!images) return;
  const int heading = 2;  // lines
  CHECK(count(*images, "\n") == heading);
  const std::string png = sample::ball(1600, 1200);
  const Report pictures = with_block(Gallery{{{"a", "left", png, 1600, 1200}, {"b", "right", png, 1600, 1200}}, "Two."});
  images = ask("pdfimages -list {}", to_pdf(pictures));
  CHECK(count(*images, "\n") == heading + 2);
  CHECK(count(*images, "smask") == 0);
  CHECK(count(*images, " 300 ") == 2 * 2);  // resolution, both ways
}

TEST_CASE("nothing at all is still a report") {
  Report r;
  r.sections.push_back({"a", "", "", {}});
  r.sections.push_back({"b", "", "Empty things", {Paragraph{}, Table{}, figure::Figure{}, Gallery{}, Proof{}, Table{"t", {"h"}, {}, {}}}});
  const std::string text = text_of(r);
  if (text.empty()) return;
  CHECK(contains(text, "Untitled report"));
  CHECK(contains(text, "NOTHING TO CHECK"));
  CHECK(contains(text, "This section is empty."));
  CHECK(contains(text, "No rows."));
}

TEST_CASE("a picture that is none is told in its place") {
  const std::string png = sample::ball(64, 48);
  Gallery g{{{"a", "one", "not a picture", 64, 48}, {"b", "two", png.substr(0, png.size() / 2), 64, 48}, {"c", "three", "", 0, 0}}, ""};
  const std::string text = text_of(with_block(g));
  if (!text.empty()) CHECK(count(text, "This picture cannot be read.") == 3);
}

TEST_CASE("text that is none, and words without end, do no harm") {
  Report r = with_block(Paragraph{Paragraph::Tone::warning, std::string(5000, 'w')});
  r.title = std::string("broken \xff\xc3 and \x01 and ") + std::string(1, '\0') + " \u202Ereversed";
  r.summary.push_back({Paragraph::Tone::plain, "first\r\nsecond"});
  r.scenario_text = std::string(300000, 'y') + "\nlast = 1\n";
  r.checks.push_back({std::string(3000, 'c'), "", "", 0, 0, "", false, std::string(9000, 'm'), 1});
  const std::string pdf = to_pdf(r);
  if (const auto said = ask("qpdf --check {}", pdf)) CHECK(contains(*said, "No syntax or stream encoding errors found"));
  const auto text = ask("pdftotext {} -", pdf);
  if (!text) return;
  CHECK(contains(*text, "first\nsecond"));
  CHECK(contains(*text, "last = 1"));
  CHECK(count(*text, "w") >= 5000);
  CHECK_FALSE(contains(*text, "\u202E"));
}
