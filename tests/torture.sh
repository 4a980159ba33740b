#!/bin/sh
# sh tests/torture.sh [PLACES]: makes calls of the program fail one after the other, at so many places of each kind (default 200), and kills
# it at as many moments, and ends long work, alone and shared by ranks of MPI, by every signal. Each time the report must be the old one, whole,
# or the new one, whole; nothing may be left beside it; and the exit status must say why. Builds what it needs into build/.
set -eu
cd "$(dirname "$0")/.."
places=${1:-200}
# shellcheck source=reports/packages.sh
. reports/packages.sh
# shellcheck disable=SC2086  # a list of words
install_packages $program_packages $test_packages
[ -f build/build.ninja ] || cmake -G Ninja -S . -B build -DCMAKE_BUILD_TYPE=Release -DPMREPORT_TESTS=ON -DPMREPORT_LEVELS=
cmake --build build --parallel "$(nproc)" --target pmreport pmreport-mpi fail_nth plain plugin-gough

program=$PWD/build/bin/pmreport spread=$PWD/tests/data/spread.toml shim=$(find "$PWD/build" -name libfail_nth.so)
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
mkdir "$room/plugins"
cp build/tests/host/plugins/plain.so "$room/plugins"
cat >"$room/slider.toml" <<'X'
title = "Torture"
[mechanism]
use = "plain-slider"
[motion]
duration = "1 s"
samples = 11
x = "10 mm * sin(t * 1 rad/s)"
[[section]]
kind = "snapshots"
[[section]]
kind = "displacement"
[[section]]
kind = "dynamics"
X
cd "$room"
report() { "$program" slider.toml --out report --plugin-path plugins; }
report >/dev/null
cp -r report good

wrong=0 clears=now
# judge STATUS ALLOWED WHAT: the report is whole, the status is one of those, and nothing is left, where it is cleared away now.
judge() {
  case " $2 " in *" $1 "*) ;; *) wrong=$((wrong + 1)) && echo "exit status $1 at $3: $(tail -n 1 err)" ;; esac
  if ! diff -r report good >/dev/null; then
    wrong=$((wrong + 1)) && echo "another report, exit status $1, at $3" && rm -rf report && cp -r good report
  fi
  [ "$clears" = now ] && left=$(find . -maxdepth 1 -name '.report*') || left=
  [ -z "$left" ] || { wrong=$((wrong + 1)) && echo "left behind at $3:$left" && rm -rf .report*; }
}

for kind in write fsync rename mkdir open mmap thread malloc; do
  for where in worker parent; do
    rm -f count
    FAIL_CALL=$kind FAIL_IN=$where FAIL_AT=0 FAIL_COUNT=$room/count LD_PRELOAD=$shim report >/dev/null 2>&1
    all=$(sort -n count 2>/dev/null | tail -n 1)
    all=${all:-0}
    step=$(((all + places - 1) / places))
    [ "$step" -gt 0 ] || step=1
    tried=0 at=1
    while [ "$at" -le "$all" ]; do
      FAIL_CALL=$kind FAIL_IN=$where FAIL_AT=$at LD_PRELOAD=$shim timeout 60 "$program" slider.toml --out report --plugin-path plugins \
        >/dev/null 2>err && status=0 || status=$?
      # Before main() nobody can take what a library throws: the shell tells such an end as 134.
      allowed="0 4 5"
      [ "$kind $where" != "malloc parent" ] || allowed="0 4 5 134"
      judge "$status" "$allowed" "$kind $at of $all in the $where"
      tried=$((tried + 1)) at=$((at + step))
    done
    echo "$kind in the $where: $tried of $all places tried"
    # The parent makes no thread and writes nothing; the worker makes every kind of call.
    if [ "$where" = worker ] && [ "$tried" -eq 0 ]; then wrong=$((wrong + 1)) && echo "no $kind was seen in the worker"; fi
  done
done

moment=0
while [ "$moment" -lt "$places" ]; do
  report >/dev/null 2>err &
  sleep "0.$(printf '%03d' $((moment * 700 / places)))"
  kill -KILL $! 2>/dev/null || true
  wait $! 2>/dev/null && status=0 || status=$?
  # The worker sees that its parent is gone, and clears away.
  patience=100
  while [ -n "$(find . -maxdepth 1 -name '.report*')" ] && [ "$patience" -gt 0 ]; do sleep 0.1 && patience=$((patience - 1)); done
  # 4: the worker of the run before, killed as it began, had not yet seen that it is alone.
  judge "$status" "0 4 137" "a kill at moment $moment"
  moment=$((moment + 1))
done
echo "$places kills"

# Long work: motions, grids, random poses, studies, proofs. What is kept of them makes the report in the end that nobody disturbed.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
cp "$spread" spread.toml
# A shell lets what it starts beside itself ignore SIGINT and SIGQUIT.
alone() { exec env --default-signal=INT,QUIT "$program" spread.toml --out report --resume; }
ranks() { exec env --default-signal=INT,QUIT mpiexec -n 2 "$program-mpi" spread.toml --out report --resume; }
rm -rf report good
begin=$(date +%s%N)
(alone) >/dev/null
long=$((($(date +%s%N) - begin) / 1000000)) # [ms]
cp -r report good
each=$(((places + 19) / 20))
for who in alone ranks; do
  for signal in INT TERM HUP QUIT KILL; do
    moment=0
    while [ "$moment" -lt "$each" ]; do
      ($who) >/dev/null 2>err &
      sleep "$(awk -v m="$moment" -v n="$each" -v ms="$long" 'BEGIN { printf "%.3f", ms * (m + 0.5) / n / 1000 }')"
      kill "-$signal" $! 2>/dev/null || true
      wait $! 2>/dev/null && status=0 || status=$?
      # Where mpiexec is gone at once its ranks are too, and what they leave is cleared away by the next run.
      case "$who $signal" in "ranks QUIT" | "ranks KILL") clears=later ;; *) clears=now ;; esac
      patience=100
      while [ "$clears" = now ] && [ -n "$(find . -maxdepth 1 -name '.report*')" ] && [ "$patience" -gt 0 ]; do
        sleep 0.1 && patience=$((patience - 1))
      done
      allowed="0 4 129 130 131 137 143"
      [ "$who" = alone ] || allowed="$allowed 1 15" # as mpiexec has it
      judge "$status" "$allowed" "SIG$signal to $who at moment $moment"
      moment=$((moment + 1))
    done
    echo "SIG$signal to $who: $each moments"
  done
  clears=now
  ($who) >/dev/null 2>err && status=0 || status=$?
  judge "$status" 0 "the run of $who that nobody disturbs"
  [ ! -e report.chunks ] || { wrong=$((wrong + 1)) && echo "chunks are left of $who"; }
done
[ "$wrong" -eq 0 ] && echo "nothing went wrong" || { echo "$wrong went wrong" && exit 1; }
