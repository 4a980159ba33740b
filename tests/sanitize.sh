#!/bin/sh
# sh tests/sanitize.sh CHECKS [ROOM...]: builds the tests of the rooms (default: all of core) with CHECKS and runs them; the first finding ends
# the tests of its room. CHECKS: address,undefined or thread, sanitizers of the compiler; or assertions, those of Eigen and of the standard
# library. Builds into build/address-undefined, build/thread or build/assertions.
set -eu
cd "$(dirname "$0")/.."
# shellcheck source=reports/packages.sh
. reports/packages.sh
usage="sh tests/sanitize.sh address,undefined|thread|assertions [ROOM...]"
[ $# -gt 0 ] || { echo "$usage" >&2 && exit 2; }
checks=$1 && shift
case "$checks" in
  address,undefined | thread) flags=-O1 sanitize=$checks ;;
  assertions) flags="-O1 -D_GLIBCXX_ASSERTIONS" sanitize= ;;
  *) echo "expected $usage; seen $checks" >&2 && exit 2 ;;
esac
[ $# -gt 0 ] || set -- pmreport text linear recorded_program chunks scan mechanics host scenario analysis
for room in "$@"; do
  [ -d "tests/$room" ] || { echo "there is no room tests/$room" >&2 && exit 2; }
done

# shellcheck disable=SC2086  # lists of words
install_packages $program_packages $test_packages
build=$PWD/build/$(echo "$checks" | tr , -)
[ -f "$build/build.ninja" ] || cmake -G Ninja -S . -B "$build" -DPMREPORT_LEVELS= -DCMAKE_BUILD_TYPE=Checked "-DCMAKE_CXX_FLAGS_CHECKED=-g1 $flags" \
  "-DCMAKE_C_FLAGS_CHECKED=-g1 $flags" "-DPMREPORT_SANITIZE=$sanitize"
# shellcheck disable=SC2046  # a list of words
cmake --build "$build" --parallel "$(nproc)" --target $(printf 'test_%s ' "$@")

export ASAN_OPTIONS=halt_on_error=1:strict_string_checks=1:detect_stack_use_after_return=1
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
export TSAN_OPTIONS="halt_on_error=1:suppressions=$PWD/tests/thread.supp"
wrong=0
for room in "$@"; do
  "$build/bin/test_$room" || wrong=$((wrong + 1))
done
[ "$wrong" -eq 0 ] && echo "$checks: nothing found in $# rooms" || { echo "$checks: $wrong of $# rooms went wrong" && exit 1; }
