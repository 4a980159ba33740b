#!/bin/sh
# sh tests/slurm.sh: a job array of Slurm's on this machine alone makes a report in five shards, one of which is killed and queued again; it
# must be the report that one process makes. Installs Slurm and starts its daemons in a folder of their own; to be run by root. Takes the
# program from build/, or from PMREPORT.
set -eu
cd "$(dirname "$0")/.."
# shellcheck source=reports/packages.sh
. reports/packages.sh
install_packages slurmctld slurmd slurm-client munge
program=${PMREPORT:-$PWD/build/bin/pmreport}
[ -x "$program" ] || { echo "there is no $program: sh reports/run.sh builds it" >&2 && exit 1; }

room=$(mktemp -d)
daemons=
finish() {
  for daemon in $daemons; do kill "$daemon" 2>/dev/null || true; done
  wait 2>/dev/null || true
  rm -rf "$room"
}
trap finish EXIT
chmod 755 "$room"
mkdir "$room/state" "$room/spool"
dd if=/dev/urandom of="$room/key" bs=1024 count=1 2>/dev/null
chown munge "$room/key" && chmod 400 "$room/key"
mkdir "$room/munge" && chown munge "$room/munge"
setpriv --reuid=munge --clear-groups --inh-caps=-all munged --foreground --key-file="$room/key" --socket="$room/munge/socket" \
  --pid-file="$room/munge/pid" --log-file="$room/munge/log" --seed-file="$room/munge/seed" 2>"$room/munged.log" &
daemons="$daemons $!"

export SLURM_CONF=$room/slurm.conf
cat >"$SLURM_CONF" <<X
ClusterName=here
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$room/munge/socket
CredType=cred/munge
StateSaveLocation=$room/state
SlurmdSpoolDir=$room/spool
SlurmctldPidFile=$room/slurmctld.pid
SlurmdPidFile=$room/slurmd.pid
SlurmctldPort=16817
SlurmdPort=16818
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
JobRequeue=1
SchedulerParameters=batch_sched_delay=1,sched_interval=2
NodeName=$(hostname) NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
X
slurmctld -D >"$room/slurmctld.log" 2>&1 &
daemons="$daemons $!"
slurmd -D -N "$(hostname)" >"$room/slurmd.log" 2>&1 &
daemons="$daemons $!"
patience=60
until sinfo -h -o %t 2>/dev/null | grep -q idle; do
  patience=$((patience - 1))
  [ "$patience" -gt 0 ] || { cat "$room"/*.log >&2 && exit 1; }
  sleep 1
done

cp tests/data/spread.toml "$room/machine.toml"
cd "$room"
"$program" machine.toml -o alone --quiet
cat >array.sh <<X
#!/bin/sh
#SBATCH --array=1-5
#SBATCH --requeue
#SBATCH --output=shard-%a.log
exec "$program" machine.toml -o together --threads 1 --shard "\$SLURM_ARRAY_TASK_ID/5"
X
array=$(sbatch --parsable array.sh)
sleep 1
scontrol requeue "${array}_2" 2>/dev/null || true # killed where it runs, and begun anew
sbatch --wait --dependency="afterok:$array" --output=merge.log --wrap "exec \"$program\" merge machine.toml -o together" >/dev/null ||
  { cat shard-*.log merge.log >&2 && exit 1; }
cat shard-*.log merge.log
diff -r alone together
echo "five shards of a job array make the same report, byte by byte"
