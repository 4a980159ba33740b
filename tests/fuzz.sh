#!/bin/sh
# sh tests/fuzz.sh [SECONDS | -runs=N] [TARGET...]: tries inputs that nobody wrote on what reads files, plugins and programs, each target for so
# many seconds (default 60) or inputs, under the sanitizers. Builds what it needs into build/fuzz. What is new in a run is kept in
# build/fuzz/found and the next run begins with it. Exit status 1: an input breaks a promise, and the line before last names its file.
set -eu
cd "$(dirname "$0")/.."
# shellcheck source=reports/packages.sh
. reports/packages.sh
bound=-max_total_time=60
case "${1:-}" in
  -runs=*) bound=$1 && shift ;;
  [0-9]*) bound=-max_total_time=$1 && shift ;;
esac
all=$(cd tests/fuzz/corpus && echo *)
for target in "$@"; do
  case " $all " in *" $target "*) ;; *) echo "$target is no target; there are: $all" >&2 && exit 2 ;; esac
done
[ $# -gt 0 ] || eval "set -- $all"

# shellcheck disable=SC2086  # lists of words
install_packages $program_packages $test_packages clang-14 libclang-rt-14-dev
build=$PWD/build/fuzz
[ -f "$build/build.ninja" ] || cmake -G Ninja -S . -B "$build" -DPMREPORT_FUZZ=ON -DPMREPORT_LEVELS= -DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14
# shellcheck disable=SC2046  # a list of words
cmake --build "$build" --parallel "$(nproc)" --target $(printf 'fuzz_%s ' "$@")

mkdir -p "$build/failures"
[ ! -w /dev/shm ] || export TMPDIR=/dev/shm # a file for each input, of no use on a disk
wrong=0
for target in "$@"; do
  found=$build/found/$target
  mkdir -p "$found"
  longest=4096
  [ "$target" != scenario ] || longest=65536 # dotted keys, long lists
  # An input that takes a second takes some ten with the sanitizers on a busy machine.
  "$build/bin/fuzz_$target" "$bound" -max_len=$longest -timeout=10 -rss_limit_mb=3000 -print_final_stats=1 \
    "-artifact_prefix=$build/failures/$target-" "$found" "tests/fuzz/corpus/$target" >"$build/$target.log" 2>&1 </dev/null && status=0 || status=$?
  number() { sed -n "s/^stat::$1: *//p" "$build/$target.log"; }
  # Without inputs in the log the target did not even begin.
  inputs=$(number number_of_executed_units)
  echo "$target: ${inputs:-no} inputs, $(number average_exec_per_sec) a second, $(number new_units_added) of them new, slowest $(number slowest_unit_time_sec) s, $(number peak_rss_mb) MB"
  [ "$status" -ne 0 ] || [ -z "$inputs" ] || continue
  wrong=$((wrong + 1))
  grep -m 1 -E '^broken promise|ERROR: |runtime error' "$build/$target.log" || tail -n 3 "$build/$target.log"
  reproducer=$(sed -n 's/.*Test unit written to //p' "$build/$target.log")
  echo "again: $build/bin/fuzz_$target ${reproducer:-, see $build/$target.log}"
done
[ "$wrong" -eq 0 ] && echo "nothing went wrong" || { echo "$wrong of $# targets went wrong" && exit 1; }
