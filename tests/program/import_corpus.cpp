// Settings that a fuzzer found, or began with. In the process itself: in a file of its own, for the tests' run_pmreport() is the program.
#include <catch2/catch.hpp>
#include <tests/fuzz/corpus.hpp>
#include <tests/fuzz/import.hpp>

TEST_CASE("no settings of the fuzzer's corpus break a promise") {
  CHECK(fuzz::broken_in(SOURCE "/tests/fuzz/corpus/import", fuzz::broken_by_import) == "");
}
