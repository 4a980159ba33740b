#!/bin/sh
# sh tests/run.sh [CTEST OPTION...]: builds everything and runs the whole test suite.
set -eu
cd "$(dirname "$0")/.."
# shellcheck source=reports/packages.sh
. reports/packages.sh

# shellcheck disable=SC2086  # lists of words
install_packages $program_packages $test_packages $judge_packages
# Where a change is judged warnings are errors, and GCC, which has the memory there, collects its garbage later: a tenth of the time. Elsewhere
# other flags would only compile anew what reports/run.sh has compiled.
cmake -G Ninja -S . -B build -DCMAKE_BUILD_TYPE=Release -DPMREPORT_TESTS=ON -DCMAKE_UNITY_BUILD=ON \
  ${CI:+-DPMREPORT_WERROR=ON -DCMAKE_CXX_FLAGS=--param=ggc-min-heapsize=800000} \
  -DPMREPORT_LEVELS=x86-64-v3 "-DPMREPORT_LEVELS_OF=gough;delta" # two show that builds for newer processors are chosen, and agree
cmake --build build --parallel "$(nproc)"
exec ctest --test-dir build --output-on-failure --parallel "$(nproc)" "$@"
