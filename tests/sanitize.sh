#!/bin/sh
# sh tests/sanitize.sh SANITIZERS [ROOM...]: builds the tests of the rooms (default: all of core) with SANITIZERS, address,undefined or thread,
# and with the assertions of Eigen and of the standard library, and runs them; the first finding ends the tests of its room. Builds into
# build/address-undefined or build/thread.
set -eu
cd "$(dirname "$0")/.."
# shellcheck source=reports/packages.sh
. reports/packages.sh
usage="sh tests/sanitize.sh address,undefined|thread [ROOM...]"
[ $# -gt 0 ] || { echo "$usage" >&2 && exit 2; }
sanitizers=$1 && shift
case "$sanitizers" in
  address,undefined | thread) ;;
  *) echo "expected $usage; seen $sanitizers" >&2 && exit 2 ;;
esac
[ $# -gt 0 ] || set -- pmreport text linear recorded_program chunks scan mechanics host scenario analysis
for room in "$@"; do
  [ -d "tests/$room" ] || { echo "there is no room tests/$room" >&2 && exit 2; }
done

# shellcheck disable=SC2086  # lists of words
install_packages $program_packages $test_packages
build=$PWD/build/$(echo "$sanitizers" | tr , -)
[ -f "$build/build.ninja" ] || cmake -G Ninja -S . -B "$build" -DCMAKE_UNITY_BUILD=ON -DPMREPORT_LEVELS= -DCMAKE_BUILD_TYPE=Checked \
  "-DCMAKE_CXX_FLAGS_CHECKED=-g1 -O1 -D_GLIBCXX_ASSERTIONS" \
  "-DCMAKE_C_FLAGS_CHECKED=-g1 -O1" "-DPMREPORT_SANITIZE=$sanitizers"
# shellcheck disable=SC2046  # a list of words
cmake --build "$build" --parallel "$(nproc)" --target $(printf 'test_%s ' "$@")

export ASAN_OPTIONS=halt_on_error=1:strict_string_checks=1:detect_stack_use_after_return=1
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
export TSAN_OPTIONS="halt_on_error=1:suppressions=$PWD/tests/thread.supp"
wrong=0
for room in "$@"; do
  "$build/bin/test_$room" || wrong=$((wrong + 1))
done
[ "$wrong" -eq 0 ] && echo "$sanitizers: nothing found in $# rooms" || { echo "$sanitizers: $wrong of $# rooms went wrong" && exit 1; }
