// Files that are a report's results, and files that are none.
#include <catch2/catch.hpp>
#include <reports/compare/data_names.hpp>
#include <reports/compare/page.hpp>
#include <reports/compare/replaced_file.hpp>
#include <reports/compare/spreadsheet.hpp>
#include <reports/document/write.hpp>
#include <tests/compare/reports.hpp>
#include <tests/fuzz/corpus.hpp>
#include <tests/fuzz/results.hpp>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace pmreport;
using Catch::Contains;
using compare_test::report, compare_test::results;
namespace fs = std::filesystem;

namespace {

std::string refusal(const std::string& text) {
  try {
    compare::read_results(text, "file.json");
  } catch (const compare::InputError& e) {
    return e.what();
  }
  return "";
}

// results.json of the sample with one part replaced.
std::string with(const std::string& from, const std::string& to) {
  std::string text = document::to_json(report());
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "pmreport-compare-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }
  fs::path put(const std::string& name, const std::string& bytes) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }

 private:
  fs::path path_;
};

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string refusal_of_file(const fs::path& file) {
  try {
    compare::read_report(file.string());
  } catch (const compare::InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("what is no results.json is refused with what was expected and seen") {
  const std::string whole = document::to_json(report());
  CHECK(refusal(whole).empty());
  CHECK(refusal("") == "file.json: expected the results of a report; the file is empty");
  CHECK_THAT(refusal("[1, 2]"), Contains("seen other JSON"));
  CHECK_THAT(refusal("null"), Contains("seen other JSON"));
  CHECK_THAT(refusal("{}"), Contains("\"schema\": \"pmreport-results\""));
  CHECK_THAT(refusal("{\n  \"a\": oops}"), Contains("expected JSON; it is none at line 2, column "));
  CHECK_THAT(refusal(whole.substr(0, whole.size() / 2)), Contains("the file ends in its midst"));
  CHECK_THAT(refusal("{\"a\": 1e999}"), Contains("too large"));
  CHECK_THAT(refusal(std::string(100000, '[')), Contains("more than 64 deep"));
  CHECK_THAT(refusal(with("\"schema_version\": 2", "\"schema_version\": 1")), Contains("expected schema_version 2; seen 1"));
  CHECK_THAT(refusal(with("\"schema_version\": 2", "\"schema_version\": \"2\"")), Contains("seen string"));
  CHECK_THAT(refusal(with("\"schema_version\": 2,", "")), Contains("seen none"));
  CHECK_THAT(refusal(with("\"value\": 0.5", "\"value\": \"0.5\"")), Contains("values[0].value: expected a number or null; seen string"));
  CHECK_THAT(refusal(with("\"name\": \"max(x)\",", "")), Contains("values[0].name is missing"));
  CHECK_THAT(refusal(with("\"evidence\": [", "\"evidence\": [7,")), Contains("sections[0].evidence[0]: expected an object; seen number"));
  CHECK_THAT(refusal(with("Sample", "\xff")), Contains("expected JSON; it is none at line 4"));
}

TEST_CASE("a file is read whole or refused, and never waited for") {
  const Folder here;
  CHECK_THAT(refusal_of_file(here.path() / "nowhere"), Contains("nowhere: cannot be read: No such file"));
  CHECK_THAT(refusal_of_file(here.path()), Contains("expected the folder of a report; it has no results.json"));
  const fs::path pipe = here.path() / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THAT(refusal_of_file(pipe), Contains("expected a file; seen a pipe"));
  CHECK_THAT(refusal_of_file("/dev/zero"), Contains("expected a file; seen a device"));
  const fs::path huge = here.put("huge.json", "");
  fs::resize_file(huge, (std::uintmax_t{64} << 20) + 1);
  CHECK_THAT(refusal_of_file(huge), Contains("expected at most 64 MiB; it is larger"));
  fs::create_directories(here.path() / "odd/results.json");
  CHECK_THAT(refusal_of_file(here.path() / "odd"), Contains("expected a file; seen a folder"));
}

TEST_CASE("results.json leads to no file outside of its data") {
  const Folder here;
  for (const char* name : {"../secret.csv", "data/../secret.csv", "/etc/passwd", "data/", "data/.hidden", "data/a/b.csv"}) {
    CAPTURE(name);
    const fs::path file = here.put("results.json", with("data/displacement.csv", name));
    CHECK_THAT(refusal_of_file(file), Contains("data: expected a file in data/; seen \"" + std::string(name) + "\""));
  }
}

TEST_CASE("a report read from its folder is the report that was made") {
  const Folder here;
  here.put("results.json", document::to_json(report()));
  CHECK(compare::read_report(here.path().string()).curves_missing == "it stands alone, without the folder data/");
  here.put("data/displacement.csv", document::to_csv(report().data[0]));
  std::vector<compare::Results> both = results({report()});
  both.push_back(compare::read_report(here.path().string()));
  CHECK(both[1].curves_missing.empty());
  const compare::Comparison c = compare::compare(both, {0, 0});
  CHECK(c.agree);
  CHECK(c.curves.size() == 1);
  here.put("data/displacement.csv", "t [s],x [m]\n0,oops\n");
  CHECK_THAT(compare::read_report(here.path().string()).curves_missing,
             Contains("displacement.csv: line 2: expected a number or nothing in each cell"));
}

TEST_CASE("a data file is read as it was written, and curves are what has a course of time") {
  const auto read = [](const std::string& csv) { return compare::read_curves(csv, "s"); };
  const auto curves = read("t [s],\"a, \"\"b\"\"\"\r\n0,\r\n1,-2.5e-3\r\n");
  REQUIRE(curves);
  CHECK(curves->headings == std::vector<std::string>{"a, \"b\""});
  CHECK(curves->time == std::vector<double>{0, 1});
  CHECK(std::isnan(curves->columns[0][0]));
  CHECK(curves->columns[0][1] == -2.5e-3);
  CHECK(read("t [s],x\n")->time.empty());
  CHECK_FALSE(read("x [m],y\n0,1\n"));
  CHECK_FALSE(read("t [s],y\n1,1\n0,1\n"));  // runs back
  CHECK_FALSE(read("t [s],y\n,1\n"));
  CHECK_THROWS_WITH(read(""), Contains("the file is empty"));
  CHECK_THROWS_WITH(read("t [s],y\n0\n"), "line 2: expected 2 cells; seen 1");
  CHECK_THROWS_WITH(read("t [s],y\n0,1,2\n"), "line 2: expected 2 cells; seen 3");
  CHECK_THROWS_WITH(read("t [s],y\n0,nan\n"), Contains("line 2: expected a number"));
  CHECK_THROWS_WITH(read("t [s],y\n0,1e999\n"), Contains("line 2: expected a number"));
  CHECK_THROWS_WITH(read("\"t [s]"), Contains("has no end"));
  CHECK_THROWS_WITH(read("\"t [s]\"x,y\n"), Contains("expected a comma"));
}

TEST_CASE("a page escapes what users typed, and is the same twice") {
  document::Report evil = report();
  evil.title = "<script>alert(1)</script>";
  evil.provenance.mechanism = "\"><img src=x>";
  evil.values[0].name = "=HYPERLINK(\"<b>\")";
  evil.data[0].headings[1] = "</svg><script>y [m]";
  evil.checks[0].name = "<i>";
  document::Report other = evil;
  other.data[0].columns[1][1] = 0.75;
  other.values[0].value = 1;
  other.checks[0].passed = false;
  const auto both = results({evil, other});
  const std::string page = compare::to_html(compare::compare(both, {}), "1.0.0");
  for (const char* markup : {"<script>", "<img", "<b>", "<i>"}) {
    CAPTURE(markup);
    CHECK_THAT(page, !Contains(markup));
  }
  CHECK_THAT(page, Contains("&lt;script&gt;alert(1)&lt;/script&gt;") && Contains("=HYPERLINK(&quot;&lt;b&gt;&quot;)"));
  CHECK_THAT(page, Contains("<svg"));
  CHECK(page == compare::to_html(compare::compare(both, {}), "1.0.0"));
}

TEST_CASE("a file is replaced as a whole, and a failure leaves nothing beside it") {
  const Folder here;
  const fs::path file = here.put("baseline.json", "old");
  compare::replace_file(file, "new");
  CHECK(bytes_of(file) == "new");
  fs::create_symlink("baseline.json", here.path() / "link.json");
  compare::replace_file(here.path() / "link.json", "newer");
  CHECK(bytes_of(file) == "newer");
  CHECK(fs::is_symlink(here.path() / "link.json"));
  fs::create_directory(here.path() / "folder");
  CHECK_THROWS_AS(compare::replace_file(here.path() / "folder", "x"), document::OutputError);
  CHECK_THROWS_AS(compare::replace_file(here.path() / "no/where.json", "x"), document::OutputError);
  CHECK_THROWS_AS(compare::replace_file(file / "below", "x"), document::OutputError);
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(here.path())) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  CHECK(names == std::vector<std::string>{"baseline.json", "folder", "link.json"});
}

TEST_CASE("no results of the fuzzer's corpus, and none made of them, break a promise") {
  fuzz::check_promises("results", fuzz::broken_by_results);
}
