#!/bin/sh
# sh tests/coverage.sh [ROOM...]: which lines and branches of core/ the tests of the rooms (default: all of core) run, a line for each room of
# core/. Builds into build/coverage, where coverage.html shows each source. Branches that only exceptions take are left out.
set -eu
cd "$(dirname "$0")/.."
# shellcheck source=reports/packages.sh
. reports/packages.sh
[ $# -gt 0 ] || set -- pmreport text linear recorded_program chunks scan mechanics classification host scenario analysis
for room in "$@"; do
  [ -d "tests/$room" ] || { echo "there is no room tests/$room" >&2 && exit 2; }
done

# shellcheck disable=SC2086  # lists of words
install_packages $program_packages $test_packages gcovr
build=$PWD/build/coverage
flags="-O0 -g1 --coverage -fprofile-update=atomic"
[ -f "$build/build.ninja" ] || cmake -G Ninja -S . -B "$build" -DCMAKE_UNITY_BUILD=ON -DPMREPORT_LEVELS= -DCMAKE_BUILD_TYPE=Counted \
  "-DCMAKE_CXX_FLAGS_COUNTED=$flags" \
  "-DCMAKE_C_FLAGS_COUNTED=$flags"
# shellcheck disable=SC2046  # a list of words
cmake --build "$build" --parallel "$(nproc)" --target $(printf 'test_%s ' "$@")

find "$build" -name '*.gcda' -delete
failed=
for room in "$@"; do
  "$build/bin/test_$room" || failed="$failed $room"
done
root=$(pwd -P)
# Headers are counted in the sources that include them, and once.
gcovr --root "$root" --filter "$root/core/" --object-directory "$build" --exclude-throw-branches --exclude-unreachable-branches -j "$(nproc)" \
  --csv "$build/coverage.csv" --html-details "$build/coverage.html" "$build"
awk -F, '
  NR > 1 { split($1, part, "/"); room = part[1] "/" part[2]; n[room] += $2; seen[room] += $3; m[room] += $5; taken[room] += $6
           n["all"] += $2; seen["all"] += $3; m["all"] += $5; taken["all"] += $6 }
  END { for (r in n) printf "%-18s lines %5.1f %% of %6d, branches %5.1f %% of %6d\n", r, n[r] ? 100 * seen[r] / n[r] : 0, n[r], m[r] ? 100 * taken[r] / m[r] : 0, m[r] }
' "$build/coverage.csv" | sort
[ -z "$failed" ] || { echo "tests failed in:$failed" && exit 1; }
