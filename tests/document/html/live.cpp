// The page and what moves the machine in it.
#include <tests/document/sample.hpp>

#include <catch2/catch.hpp>
#include <reports/document/html/html_page.hpp>
#include <reports/document/write.hpp>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace pmreport::document;
using sample::contains;

namespace {

bool node_is_here() {
  if (std::system("command -v node >/dev/null") == 0) return true;
  WARN("node is not here: the scripts of report.html were not tested");
  return false;
}

}  // namespace

TEST_CASE("what moves the machine stands before the scripts of the page, and where nothing does they are told so") {
  Report r = sample::report();
  CHECK(contains(to_html(r), "<script type=\"module\">const liveModel = null;\n"));
  r.live = "{name:\"a\"}";
  CHECK(contains(to_html(r), "<script type=\"module\">const liveModel = {name:\"a\"};\n"));
}

TEST_CASE("the functions of the live machine pass their own tests") {
  if (!node_is_here()) return;
  CHECK(std::system("node --test " SOURCE "/tests/document/html/live_test.js") == 0);
}

TEST_CASE("the scripts of the page are one module, in which no name stands for two things") {
  if (!node_is_here()) return;
  std::string file = (std::filesystem::temp_directory_path() / "pmreport-scripts-XXXXXX.mjs").string();
  const int made = mkstemps(file.data(), 4);
  REQUIRE(made >= 0);
  close(made);
  std::ofstream(file) << "const liveModel = null;\n" << html_script;
  CHECK(std::system(("node --check '" + file + "'").c_str()) == 0);
  std::filesystem::remove(file);
}
