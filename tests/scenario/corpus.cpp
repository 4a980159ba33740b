// Inputs that fuzzers found, or began with.
#include <catch2/catch.hpp>
#include <tests/fuzz/corpus.hpp>
#include <tests/fuzz/expression.hpp>
#include <tests/fuzz/motion_file.hpp>
#include <tests/fuzz/scenario.hpp>

TEST_CASE("no scenario of the fuzzer's corpus, and none made of them, breaks a promise") {
  fuzz::check_promises("scenario", fuzz::broken_by_scenario);
}

TEST_CASE("no expression of the fuzzer's corpus, and none made of them, breaks a promise") {
  fuzz::check_promises("expression", fuzz::broken_by_expression);
}

TEST_CASE("no file of a motion of the fuzzer's corpus, and none made of them, breaks a promise") {
  fuzz::check_promises("motion_file", fuzz::broken_by_motion_file);
}
