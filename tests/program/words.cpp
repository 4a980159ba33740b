// Words of all kinds in titles and paths.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <nlohmann/json.hpp>

using namespace program_test;
using Catch::Contains;

TEST_CASE("markup in a title is text in every file of the report") {
  const Workshop here;
  const std::string title = "<script>alert('x')</script> & \\\"quoted\\\"";
  REQUIRE(here.report(with(small, {{"\"Small\"", "\"" + title + "\"\nauthor = \"<img src=x>\""}})).status == 0);
  const std::string html = bytes_of(here.report_folder() / "report.html");
  CHECK(html.find("<script>alert") == std::string::npos);
  CHECK(html.find("<img src=x>") == std::string::npos);
  CHECK_THAT(html, Contains("&lt;script&gt;alert("));
  CHECK(run({"xmllint", "--noout", (here.report_folder() / "junit.xml").string()}).status == 0);
  CHECK(nlohmann::json::parse(bytes_of(here.report_folder() / "results.json"))["title"] == "<script>alert('x')</script> & \"quoted\"");
}

TEST_CASE("titles and paths may be of any script, with blanks and quotes") {
  const Workshop here;
  const std::string folder = "Prüfung 机构 'neu' & <b>", title = "Größe θ, 并联机构, Механизм";
  here.write(folder + "/Maß.toml", with(small, {{"Small", title}}));
  const Result result = run_pmreport({folder + "/Maß.toml", "--out", folder + "/Bericht 报告"}, {.folder = here.path()});
  INFO(result.err);
  CHECK(result.status == 0);
  CHECK_THAT(result.out, Contains(folder + "/Bericht 报告/report.html"));
  const std::filesystem::path report = here / (folder + "/Bericht 报告");
  CHECK_THAT(bytes_of(report / "report.html"), Contains("Größe θ, 并联机构, Механизм"));
  CHECK(nlohmann::json::parse(bytes_of(report / "results.json"))["title"] == title);
  const Result text = run({"pdftotext", (report / "report.pdf").string(), "-"});
  CHECK(text.status == 0);
  CHECK_THAT(text.out, Contains("Größe θ") && Contains("Механизм"));
}

TEST_CASE("the report's folder is named after the scenario") {
  const Workshop here;
  here.write("sub/my.first.toml", small);
  REQUIRE(run_pmreport({"sub/my.first.toml"}, {.folder = here.path()}).status == 0);
  CHECK(std::filesystem::exists(here / "my.first-report/report.html"));
}

TEST_CASE("the report is whole in itself: nothing is fetched from elsewhere") {
  const Workshop here;
  REQUIRE(here.report(small).status == 0);
  const std::string html = bytes_of(here.report_folder() / "report.html");
  for (const char* fetched : {"src=\"http", "href=\"http", "@import", "<script src"}) {
    INFO(fetched);
    CHECK(html.find(fetched) == std::string::npos);
  }
  // Its icon is in the page.
  const std::size_t link = html.find("<link ");
  CHECK(link == html.find("<link rel=\"icon\" href=\"data:"));
  CHECK(html.find("<link ", link + 1) == std::string::npos);
}
