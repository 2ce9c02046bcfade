#!/bin/sh
# A Slurm of its own on this machine runs a job array, and its shares merge into what one run makes.
# Usage: slurm_test.sh CCDFUZZ SOURCE_DIR. Exit code 77: skipped.
set -eu
CCDFUZZ=$1
source=$2
export CCDFUZZ
PATH=$PATH:/usr/sbin:/sbin

for program in munged mungekey slurmctld slurmd sbatch scontrol squeue; do
  command -v $program >/dev/null || {
    echo "SKIPPED: $program is not installed; script/setup all installs slurmctld, slurmd, slurm-client and munge"
    exit 77
  }
done

scratch=$(mktemp -d "${TMPDIR:-/tmp}/ccdfuzz-slurm-XXXXXX")
chmod 755 "$scratch"
daemons=''
finish() {
  status=$?
  # shellcheck disable=SC2086
  [ -z "$daemons" ] || kill $daemons 2>/dev/null || true
  wait
  if [ $status -ne 0 ] && [ $status -ne 77 ]; then
    for log in "$scratch"/*.log "$scratch"/out/*.log; do
      [ ! -s "$log" ] || { echo "== $log"; tail -n 30 "$log"; }
    done
  fi
  rm -rf "$scratch"
}
trap finish EXIT
trap 'exit 1' INT TERM

fail() { echo "FAILED: $1"; exit 1; }

# What is wrong is said before anything is made or submitted.
for wrong in '0 generate' '08 generate' '00 generate' '1x generate' '2 query'; do
  code=0
  "$source/script/slurm/submit" "${wrong% *}" "$scratch/wrong" "${wrong#* }" 2>/dev/null || code=$?
  [ $code = 2 ] && [ ! -e "$scratch/wrong" ] || fail "submit $wrong: exit code $code"
done

user=$(id -un)
host=$(hostname -s)
port=$(shuf -i 20000-59999 -n 1)
mkdir "$scratch/munge" "$scratch/state" "$scratch/spool"
mungekey --create --keyfile "$scratch/munge/key"
munged --foreground --force --key-file="$scratch/munge/key" --socket="$scratch/munge/socket" \
  --pid-file="$scratch/munge/pid" --log-file="$scratch/munge/log" --seed-file="$scratch/munge/seed" \
  >"$scratch/munged.log" 2>&1 &
daemons=$!
cat >"$scratch/slurm.conf" <<CONF
ClusterName=ccdfuzz
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$scratch/munge/socket
SlurmctldPort=$port
SlurmdPort=$((port + 1))
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool
SlurmctldPidFile=$scratch/slurmctld.pid
SlurmdPidFile=$scratch/slurmd.pid
SlurmctldLogFile=$scratch/slurmctld.log
SlurmdLogFile=$scratch/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerParameters=batch_sched_delay=0,sched_interval=1
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc)
PartitionName=test Nodes=$host Default=YES State=UP
CONF
export SLURM_CONF="$scratch/slurm.conf"
unset SLURM_JOB_ID SLURM_ARRAY_TASK_ID SLURM_CPUS_PER_TASK
# Slowness is no failure; yet what hangs is to be named before ctest's own limit.
deadline=$(($(date +%s) + 1200))
has_time() { [ "$(date +%s)" -lt $deadline ]; }
# wait_until COMPLAINT COMMAND...: until the command succeeds.
wait_until() {
  complaint=$1
  shift
  while has_time; do
    ! "$@" 2>/dev/null || return 0
    sleep 0.1
  done
  fail "$complaint"
}
node_is_idle() { sinfo -h -o %t | grep -q idle; }
wait_until 'munged did not come up' test -S "$scratch/munge/socket"
slurmctld -D -c >"$scratch/slurmctld.out.log" 2>&1 &
daemons="$daemons $!"
slurmd -D -N "$host" >"$scratch/slurmd.out.log" 2>&1 &
daemons="$daemons $!"
wait_until 'slurmctld and slurmd did not come up' node_is_idle

# Until the job is gone from the queue, or cannot start any more.
wait_for_job() {
  while has_time; do
    state=$(scontrol show job "$1" 2>/dev/null | sed -n 's/.*JobState=\([A-Z]*\).*/\1/p')
    case $state in
      COMPLETED) return 0 ;;
      PENDING | RUNNING | COMPLETING | CONFIGURING | REQUEUED) sleep 0.2 ;;
      *) fail "job $1 is ${state:-lost}" ;;
    esac
  done
  fail "job $1 did not end"
}

# generate: three shares on Slurm, against one run.
"$CCDFUZZ" generate --paper --one-in 3000 --seed 5 --threads 1 -o "$scratch/whole.jsonl.zst" >/dev/null
jobs=$("$source/script/slurm/submit" 3 "$scratch/out" generate --paper --one-in 3000 --seed 5)
wait_for_job "${jobs#* }"
cmp "$scratch/whole.jsonl.zst" "$scratch/out/merged.jsonl.zst" || fail 'the cases differ'

# evaluate: the same, but for the seconds.
"$CCDFUZZ" evaluate "$scratch/whole.jsonl.zst" --methods tdibm-c --threads 1 -o "$scratch/answers" >/dev/null
jobs=$("$source/script/slurm/submit" 2 "$scratch/out" evaluate "$scratch/whole.jsonl.zst" --methods tdibm-c)
wait_for_job "${jobs#* }"
for folder in "$scratch/answers" "$scratch/out/merged"; do
  sed 's/"seconds":[^},]*//g' "$folder/answers.jsonl" >"$folder/answers"
done
cmp "$scratch/answers/answers" "$scratch/out/merged/answers" || fail 'the answers differ'
[ "$(wc -l <"$scratch/answers/answers")" -gt 20 ] || fail 'there are hardly any answers'
for folder in "$scratch/answers" "$scratch/out/merged"; do
  sed 's/,"mean_seconds".*//' "$folder/rows.jsonl" >"$folder/rows"
done
cmp "$scratch/answers/rows" "$scratch/out/merged/rows" || fail 'the rows differ'

# A share that cannot be made leaves no merged file behind, and says why.
jobs=$("$source/script/slurm/submit" 2 "$scratch/bad" evaluate "$scratch/missing.jsonl")
wait_until 'no complaint about missing.jsonl' grep -q missing.jsonl "$scratch/bad/share-0.log"
[ ! -e "$scratch/bad/merged" ] || fail 'something was merged'
echo 'PASSED'
