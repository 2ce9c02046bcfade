#!/usr/bin/env bash
# Runs each fuzz target against each fault planted into what it is there for (target_faults.txt), as
# `script/fuzz` would, without a corpus but the tracked one, and prints a table: the executions and
# seconds of CPU time until the target stops on its own.
#   [SEED=N] bench/scoreboard/targets.sh BUILD [SECONDS [TARGET...]]
# SEED: of libFuzzer's choices (default 1).
# BUILD: a build by clang with -DCCDFUZZ_FUZZ=ON -DCCDFUZZ_SCOREBOARD=ON, target planted_fuzz_targets.
# SECONDS: of CPU time for each fault, a whole number (default 40).
# Exits 1 if a target stops without a fault, or with none.
set -euo pipefail
usage() { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"; }
case ${1-} in
  '') usage >&2; exit 2 ;;
  -h | --help) usage; exit ;;
esac
build=$(cd "$1" && pwd) || exit 2
seconds=${2:-40}
shift $(($# < 2 ? $# : 2))
cd "$(dirname "$0")/../.."
here=bench/scoreboard
mapfile -t faults < <(awk -F': ' '
  $1 == "fault" { if (name) print name; name = $2 } $1 == "equivalent" { name = "" }
  END { if (name) print name }' $here/faults.txt)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The limit of the shell is of CPU time; whoever reaches it has noticed nothing.
run_limited() {  # seconds, fault or nothing, program, arguments...
  (
    ulimit -S -t "$1"
    CCDFUZZ_FAULT=$2 exec "${@:3}"
  ) >"$scratch/log" 2>&1
}

# Sets status, runs and used (CPU seconds).
run_target() {  # target, seconds, fault or nothing
  local options
  mapfile -t options < <(fuzz/target_options.sh "$1")
  [ -d "$scratch/seeds/$1" ] || fuzz/target_seeds.sh "$build/fuzz" "$1" "$scratch/seeds/$1" >/dev/null
  options+=("$scratch/seeds/$1")
  rm -rf "$scratch/corpus"
  mkdir "$scratch/corpus"
  status=0
  local TIMEFORMAT=%U
  { time run_limited "$2" "${3-}" "$build/bench/scoreboard/planted_fuzz_$1" -seed="${SEED:-1}" \
    -artifact_prefix="$scratch/" -print_final_stats=1 "$scratch/corpus" "${options[@]}" \
    || status=$?; } 2>"$scratch/time"
  used=$(grep -x "[0-9.]*" "$scratch/time" | tail -n 1)  # the shell says there, too, what ended it
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$scratch/log")
  [ $status -ne $((128 + $(kill -l XCPU))) ] || status=0
  [ -n "$runs" ] || runs=$(sed -n 's/^#\([0-9]*\).*/\1/p' "$scratch/log" | tail -n 1)
}

wrong=0
echo '| target | fault | noticed after | executions |'
echo '|---|---|---|---|'
while IFS=': ' read -r target patterns; do
  [ $# -eq 0 ] || [[ " $* " == *" $target "* ]] || continue
  run_target "$target" 5
  if [ $status -ne 0 ]; then
    echo "| $target | none | **false alarm** | $runs |"
    wrong=1
  fi
  noticed=0
  for fault in "${faults[@]}"; do
    for pattern in $patterns; do
      # shellcheck disable=SC2053
      [[ $fault == $pattern ]] || continue
      run_target "$target" "$seconds" "$fault"
      if [ $status -ne 0 ]; then
        echo "| $target | $fault | $used s | $runs |"
        noticed=$((noticed + 1))
      else
        echo "| $target | $fault | - ($used s) | $runs |"
      fi
    done
  done
  [ $noticed -gt 0 ] || wrong=1
done < <(grep -v '^#' $here/target_faults.txt)
exit $wrong
