#!/bin/sh
# sh tests/run.sh [CTEST OPTION...]: builds everything and runs the whole test suite.
set -eu
cd "$(dirname "$0")/.."
# shellcheck source=reports/packages.sh
. reports/packages.sh

# shellcheck disable=SC2086  # lists of words
install_packages $program_packages $test_packages $judge_packages
# Warnings are errors where a change is judged. Elsewhere another flag would only compile anew what reports/run.sh has compiled.
cmake -G Ninja -S . -B build -DCMAKE_BUILD_TYPE=Release -DPMREPORT_TESTS=ON ${CI:+-DPMREPORT_WERROR=ON} \
  -DPMREPORT_LEVELS=x86-64-v3 "-DPMREPORT_LEVELS_OF=gough;delta" # two show that builds for newer processors are chosen, and agree
cmake --build build --parallel "$(nproc)"
exec ctest --test-dir build --output-on-failure --parallel "$(nproc)" "$@"
