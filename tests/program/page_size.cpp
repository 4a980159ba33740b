// How large the page of a usual report is: it is sent by mail and kept by CI for every run.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

using namespace program_test;

TEST_CASE("the page of a report with pictures, plots and what plays with them is no larger than 3 MB") {
  const std::string scenario = GENERATE("gough/motion", "p2prpu-prps/sweep");  // many curves, many pictures
  const Workshop here;
  const Result made = here.report(bytes_of(SOURCE "/plugins/" + scenario + ".toml"));
  CAPTURE(scenario, made.err);
  REQUIRE(made.status == 0);
  CHECK(std::filesystem::file_size(here.report_folder() / "report.html") < 3'000'000);
}
