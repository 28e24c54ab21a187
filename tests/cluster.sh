#!/usr/bin/env bash
# Tries the files of cases/cluster, and holds what each comes to against the same study on one machine:
#   tests/cluster.sh PLUMB [FOLDER]
# Slurm is a real one, of a controller and two nodes on this machine, which are ended with the script: an array of eight
# shares, of which one is cancelled at work and one before it began, then the missing ones, then a job of MPI over both
# nodes. GNU parallel is real too; of GitHub, GitLab and Kubernetes the shell lines are run (tests/cluster_files.py).
# Needs munge, slurm-wlm, parallel and python3-yaml, ends with 77 where one is missing; root, unless munge and Slurm may
# run as the user who calls it.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
cluster=$(realpath "$here/../cases/cluster")
PLUMB=$(realpath "$1")
export PLUMB PATH=$PATH:/usr/sbin
if [ $# -gt 1 ]; then mkdir -p "$2"; fi
folder=$(realpath "${2:-$(mktemp -d)}")

for tool in munged slurmctld slurmd sbatch parallel; do
  command -v $tool >/dev/null || {
    echo "cluster: skipped: there is no $tool"
    exit 77
  }
done
python3 -c 'import yaml' 2>/dev/null || {
  echo "cluster: skipped: there is no python3-yaml"
  exit 77
}

run=$(mktemp -d) # of the daemons; a socket's path must be short
daemons=()
finish() {
  local daemon k
  for ((k = ${#daemons[@]} - 1; k >= 0; --k)); do kill "${daemons[k]}" 2>/dev/null || true; done
  for daemon in "${daemons[@]}"; do wait "$daemon" 2>/dev/null || true; done
  rm -rf "$run"
  if [ $# -eq 0 ]; then rm -rf "$folder"; fi
}
trap 'finish "${@:2}"' EXIT
trap 'exit 130' INT TERM HUP

# A daemon that stays in the foreground: NAME COMMAND...
daemon() {
  "${@:2}" >"$run/$1.log" 2>&1 &
  daemons+=($!)
}

# Until a command succeeds, at most a minute: WHAT COMMAND...
await() {
  local k
  for ((k = 0; k < 1200; ++k)); do
    if "${@:2}" >/dev/null 2>&1; then return; fi
    sleep 0.05
  done
  echo "cluster: $1: not within a minute" >&2
  tail -n 5 "$run"/*.log >&2
  exit 1
}

free_ports() {
  python3 -c '
import socket
sockets = [socket.socket() for _ in range(3)]
for one in sockets: one.bind(("127.0.0.1", 0))
print(*(one.getsockname()[1] for one in sockets))'
}

start_slurm() {
  local host controller_port one_port two_port
  host=$(hostname -s)
  read -r controller_port one_port two_port < <(free_ports)
  chmod 755 "$run"
  (umask 077 && head -c 1024 /dev/urandom >"$run/munge.key")
  daemon munge munged --foreground --force --key-file="$run/munge.key" --socket="$run/munge" \
    --pid-file="$run/munged.pid" --log-file="$run/munged.log" --seed-file="$run/munge.seed"
  await munge munge --socket="$run/munge" --no-input
  mkdir "$run/state"
  export SLURM_CONF=$run/slurm.conf
  cat >"$SLURM_CONF" <<END
ClusterName=plumb
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$controller_port
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthInfo=socket=$run/munge
StateSaveLocation=$run/state
SlurmdSpoolDir=$run/spool-%n
SlurmctldPidFile=$run/slurmctld.pid
SlurmdPidFile=$run/slurmd-%n.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
KillWait=5
NodeName=one NodeHostname=$host NodeAddr=127.0.0.1 Port=$one_port CPUs=1 State=UNKNOWN
NodeName=two NodeHostname=$host NodeAddr=127.0.0.1 Port=$two_port CPUs=1 State=UNKNOWN
PartitionName=all Nodes=one,two Default=YES State=UP
END
  daemon controller slurmctld -D
  daemon one slurmd -D -N one
  daemon two slurmd -D -N two
  await "two idle nodes" sh -c '[ "$(sinfo --noheader --format=%D --states=idle)" = 2 ]'
  sinfo --Node --long
}

# Waits for a job without asking again and again.
finished() { sbatch --wait --output=/dev/null --dependency="afterany:$1" --wrap true >/dev/null; }
exit_code() { scontrol show job "$1" | sed -n 's/.*ExitCode=\([0-9]*\):.*/\1/p'; }

differ=0
# Holds the results of a folder against those of one machine: WHAT FOLDER
compare() {
  printf '== %s: ' "$1"
  python3 "$here/same_results.py" "$folder/one/results.json" "$2/results.json" || differ=1
}

expect() {
  if [ "$2" != "$3" ]; then
    echo "cluster: $1: $2, not $3" >&2
    exit 1
  fi
}

cd "$folder"
case=$folder/random_sweep.toml
sed 's/^cases = .*/cases = 60/; s/^seed = 1/seed = 3/; s/^time_limit = .*/time_limit = 60/' \
  "$cluster/../failure/random_sweep.toml" >"$case"
echo "== one machine"
"$PLUMB" study "$case" sweep -o one | tail -n 1

echo "== Slurm: $(slurmctld -V), two nodes"
start_slurm
submit() { SHARES=8 "$cluster/slurm.sh" "$case" sweep "$folder/slurm"; }
said=$(submit)
echo "$said"
shares=$(sed 's/.*shares: job \([0-9]*\);.*/\1/' <<<"$said")
merge=${said##* }
scancel "${shares}_8"
# One that has not written for half a second, as a long run keeps it.
at_work() { find slurm -name 'share-*.unfinished.jsonl' -size +0 ! -newermt '0.5 seconds ago'; }
await "a share in a long run" sh -c "$(declare -f at_work); at_work | grep -q ."
running=$(at_work | head -n 1)
share=${running//[!0-9]/}
had=$(grep -c '"point"' "$running" || true)
scancel "${shares}_$share"
echo "cancelled: share 8 before it began, share $share with $had points at a run of some seconds"
finished "$merge"
expect "exit status of the merge" "$(exit_code "$merge")" 3
cat "slurm/job-$merge.log"
said=$(submit)
echo "$said"
merge=${said##* }
finished "$merge"
expect "exit status of the second merge" "$(exit_code "$merge")" 0
echo "points computed: $(cat slurm/{share,missing}-*/points.jsonl $(find slurm -name '*.unfinished.jsonl') |
  grep -o '"point":"[^"]*"' | sort | uniq -c | awk '{ ++keys; lines += $1 } END { print keys " points in " lines " lines" }')"
compare "Slurm, eight shares, two cancelled, the missing ones" slurm/study

if command -v mpirun >/dev/null && [ -e "$(dirname "$PLUMB")/libplumb_mpi.so" ]; then
  sbatch --wait --output=mpi.log --nodes=2 --ntasks=2 --wrap \
    "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun '$PLUMB' study '$case' sweep -o mpi" || cat mpi.log
  compare "Slurm, MPI over two nodes" mpi
fi

echo "== GNU parallel: $(parallel --version | head -n 1)"
SHARES=5 "$cluster/parallel.sh" "$case" sweep "$folder/parallel" 2>&1 | tail -n 1
compare "GNU parallel, five shares" parallel/study
# Two hosts that are this machine, under names of their own.
printf '#!/bin/sh\nwhile [ "$1" != -- ]; do shift; done\nshift\nexec sh -c "$*"\n' >ssh
chmod +x ssh
PARALLEL_SSH=$folder/ssh SHARES=5 HOSTS=1/anna,1/otto "$cluster/parallel.sh" "$case" sweep "$folder/hosts" 2>&1 | tail -n 1
awk 'NR > 1 { ++of[$2] } END { for (host in of) print host ": " of[host] " shares" }' hosts/shares.log
compare "GNU parallel, five shares on two hosts" hosts/study

echo "== the lines of github.yml, gitlab-ci.yml and kubernetes.yaml"
rm -rf services
python3 "$here/cluster_files.py" "$PLUMB" "$case" sweep one/results.json services || differ=1
if [ $differ -ne 0 ]; then
  echo "cluster: results differ"
  exit 1
fi
echo "cluster: all the same as on one machine"
