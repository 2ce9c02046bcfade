#!/usr/bin/env bash
# What margins add to coverage: how many kinds of lost contacts (method, class, level, axes, what is
# wrong) fuzz_witnessed keeps with them as extra counters and without, from the same seeds.
#   bench/fuzz_guidance.sh TARGET_PROGRAM [SECONDS [RUNS]]
# TARGET_PROGRAM: fuzz_witnessed, of whatever build. SECONDS: of CPU time for each run (default 60).
set -euo pipefail
program=$(realpath "$1") seconds=${2:-60} runs=${3:-5}
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
  ! grep -q 'loses the contact' "$scratch/log" || { tail "$scratch/log" >&2; exit 1; }
  find "$scratch/lost" -type f | wc -l
}

echo '| seed | coverage alone | and margins |'
echo '|---|---|---|'
for ((seed = 1; seed <= runs; ++seed)); do
  echo "| $seed | $(kinds_kept "$seed" '') | $(kinds_kept "$seed" margins) |"
done
