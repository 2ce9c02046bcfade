#!/usr/bin/env bash
# What margins add to coverage: how many kinds of lost contacts (method, class, level, axes, what is
# wrong) fuzz_witnessed keeps with them as extra counters and without, from the same seeds.
#   bench/fuzz_guidance.sh TARGET_PROGRAM [SECONDS [RUNS]]
# TARGET_PROGRAM: fuzz_witnessed, of whatever build. SECONDS: of CPU time for each run (default 60).
# RUNS: how many seeds (default 5).
set -euo pipefail

refuse() {
  echo "bench/fuzz_guidance.sh: $1" >&2
  exit 2
}

usage() { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"; }

case ${1-} in
  '') usage >&2; exit 2 ;;
  -h | --help) usage; exit ;;
esac
[ -x "$1" ] || refuse "TARGET_PROGRAM: $1 is no program"
program=$(realpath "$1") seconds=${2:-60} runs=${3:-5}
[[ $seconds =~ ^[1-9][0-9]*$ ]] || refuse "SECONDS: \"$seconds\" is no whole number above 0"
[[ $runs =~ ^[1-9][0-9]*$ ]] || refuse "RUNS: \"$runs\" is no whole number above 0"
cd "$(dirname "$0")/.."
mapfile -t options < <(fuzz/target_options.sh witnessed)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

kinds_kept() {  # seed, margins or nothing
  rm -rf "$scratch/lost" "$scratch/corpus"
  mkdir "$scratch/lost" "$scratch/corpus"
  # The target's own time is the wall's; the limit of the shell is of CPU time, and ends it.
  (
    ulimit -t "$seconds"
    [ -n "$2" ] || export CCDFUZZ_WITHOUT_MARGINS=1
    CCDFUZZ_LOST=$scratch/lost "$program" -seed="$1" "${options[@]}" "$scratch/corpus" \
      >"$scratch/log" 2>&1
  ) 2>/dev/null || true
  if grep -q 'loses the contact' "$scratch/log" || ! grep -q '^#[0-9]' "$scratch/log"; then
    tail "$scratch/log" >&2
    return 1
  fi
  find "$scratch/lost" -type f | wc -l
}

echo '| seed | coverage alone | and margins |'
echo '|---|---|---|'
for ((seed = 1; seed <= runs; ++seed)); do
  alone=$(kinds_kept "$seed" '')
  with=$(kinds_kept "$seed" margins)
  echo "| $seed | $alone | $with |"
done
