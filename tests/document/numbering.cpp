// The numbers of sections, figures and tables, and that page and PDF print the same.
#include <reports/document/html/html_page.hpp>
#include <reports/document/numbering.hpp>
#include <reports/document/write.hpp>
#include <tests/document/pdf/pdf_sample.hpp>
#include <tests/document/pdf/pdf_tools.hpp>
#include <tests/document/sample.hpp>

#include <catch2/catch.hpp>

#include <regex>

using namespace pmreport;
using namespace pmreport::document;

namespace {

// All that matches, in the order of the text; white space of any kind is one blank.
std::vector<std::string> all_of(const std::string& text, const char* pattern) {
  const std::regex wanted(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), wanted), end; at != end; ++at) found.push_back(at->str(1));
  return found;
}

std::string without_tags(const std::string& html) { return std::regex_replace(html, std::regex("<[^>]*>"), ""); }

}  // namespace

TEST_CASE("plots and galleries share one count, tables have theirs, and what is neither has no number") {
  Report r;
  const Gallery empty, one{{{"a", "", "", 1, 1}}, ""};
  r.sections.push_back({"one", "", "One", {Paragraph{}, figure::Figure{}, Table{}, one, Proof{}}});
  r.sections.push_back({"two", "", "Two", {empty, Table{}, figure::Figure{}}});
  const Numbering n = numbering_of(r);
  CHECK(n.sections == std::vector<std::string>{"1", "2"});
  CHECK(n.blocks == std::vector<std::vector<int>>{{0, 1, 1, 2, 0}, {0, 2, 3}});
  CHECK(n.checks.empty());
  CHECK(n.scenario == "A");
  CHECK(n.files.empty());
}

TEST_CASE("checks are numbered after the last section, files after the scenario") {
  Report r = sample::full_report();
  r.files = {{"data/mesh.stl", "a mesh", "x"}};
  const Numbering n = numbering_of(r);
  CHECK(n.checks == std::to_string(r.sections.size() + 1));
  CHECK(n.files == "B");
}

TEST_CASE("page and PDF have the same numbers in the same order") {
  Report r = sample::full_report();
  r.files = {{"data/mesh.stl", "a mesh", "x"}};
  const std::string html = to_html(r);
  const auto text = sample::ask("pdftotext -raw {} -", to_pdf(r));
  if (!text) return;
  // Without marks of movement: a figure may stand behind the table that follows it, yet never behind another figure.
  for (const char* kind : {"Figure", "Table"}) {
    CAPTURE(kind);
    const auto page = all_of(html, (std::string("<strong>") + kind + " (\\d+)\\.</strong>").c_str());
    const auto pdf = all_of(*text, (std::string("(?:^|\n)") + kind + " (\\d+)\\. ").c_str());
    CHECK(!page.empty());
    CHECK(page == pdf);
  }
  const auto headings = all_of(html, "<h2><span class=\"section-number\">(.*?)</h2>");
  REQUIRE(headings.size() == r.sections.size() + 3);
  std::size_t at = text->find("Contents");
  for (const std::string& heading : headings) {
    const std::string number = heading.substr(0, heading.find('<'));
    CAPTURE(number);
    const std::size_t next = text->find("\n" + number + " ", at);
    CHECK(next != std::string::npos);
    at = next;
  }
  CHECK(without_tags(headings.front()) == "1 The mechanism");
  CHECK(without_tags(headings.back()) == "B Files");
}

TEST_CASE("pictures of one gallery have letters, and after z numbers") {
  CHECK(letter_of(0) == "(a)");
  CHECK(letter_of(25) == "(z)");
  CHECK(letter_of(26) == "(27)");
}
