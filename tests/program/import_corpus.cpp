// Settings that a fuzzer found, or began with, in the process itself.
#include <catch2/catch.hpp>
#include <tests/fuzz/corpus.hpp>
#include <tests/fuzz/import.hpp>

TEST_CASE("no settings of the fuzzer's corpus, and none made of them, break a promise") {
  fuzz::check_promises("import", fuzz::broken_by_import);
}
