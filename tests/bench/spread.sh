#!/bin/sh
# sh tests/bench/spread.sh [RUNS]: what it costs and gains to spread work, medians of so many runs (default 5) of every way in turn. A grid that
# is judged pose by pose, so that all chunks are alike; one thread a process, as on a machine whose cores are shared by ranks.
set -eu
cd "$(dirname "$0")/../.."
runs=${1:-5}
program=$PWD/build/bin/pmreport
[ -x "$program-mpi" ] || program=${PMREPORT:?"build/bin/pmreport-mpi is not there: name another program by PMREPORT"}
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
cd "$room"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
scenario() { # POINTS a side: a second of work and less, and what is to be measured
  cat <<X
title = "Spread"
[mechanism]
use = "gough"
[[section]]
kind = "workspace"
method = "grid"
safe = false
pictures = false
exports = false
limits = ["strokes"]
scan = { x = ["-500 mm", "500 mm", $1], y = ["-500 mm", "500 mm", $1], z = ["600 mm", "1300 mm", $1] }
[[section.limit]]
index = "condition"
max = "12"
X
}
scenario 11 >small.toml
scenario 161 >large.toml

seconds() { # COMMAND...
  begin=$(date +%s%N)
  "$@" >/dev/null 2>&1
  end=$(date +%s%N)
  echo $(((end - begin) / 1000000))
  rm -rf report report.chunks chunks
}
median() { sort -n "$1" | awk '{ a[NR] = $1 } END { print (NR % 2 ? a[(NR + 1) / 2] : (a[NR / 2] + a[NR / 2 + 1]) / 2) / 1000 }'; }
# Bound to one core, as mpiexec would have one rank, it has less than a program that nobody binds.
way() { # NAME
  case $1 in
    alone-*) echo "$program ${1#*-}.toml -o report --threads 1" ;;
    kept-*) echo "$program ${1#*-}.toml -o report --threads 1 --shard 1/1" ;;
    rank1-*) echo "mpiexec --bind-to none -n 1 $program-mpi ${1#*-}.toml -o report --threads 1" ;;
    rank2-*) echo "mpiexec --bind-to none -n 2 $program-mpi ${1#*-}.toml -o report --threads 1" ;;
  esac
}
ways="alone-small alone-large kept-small kept-large rank1-small rank1-large rank2-small rank2-large"
run=0
while [ "$run" -lt "$runs" ]; do
  for name in $ways; do
    # shellcheck disable=SC2046  # words of a command
    seconds $(way "$name") >>"$name.ms"
  done
  run=$((run + 1))
done
for name in $ways; do echo "$name: $(median "$name.ms") s"; done
# The work alone: what a small report takes is taken off.
awk -v a="$(median alone-large.ms)" -v a0="$(median alone-small.ms)" -v k="$(median kept-large.ms)" -v k0="$(median kept-small.ms)" \
  -v r="$(median rank1-large.ms)" -v r0="$(median rank1-small.ms)" -v s="$(median rank2-large.ms)" -v s0="$(median rank2-small.ms)" \
  'BEGIN {
    printf "keeping chunks costs %.1f %%\n", 100 * ((k - k0) / (a - a0) - 1)
    printf "2 ranks against 1: the work %.2f times as fast, all of it %.2f times\n", (r - r0) / (s - s0), r / s
  }'
