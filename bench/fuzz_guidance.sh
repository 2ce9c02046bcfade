#!/usr/bin/env bash
# What guides best, in one table: how many kinds of contacts (class, level, axes, what is wrong) each
# method loses within some CPU time, from nothing, on draws alone, on what libFuzzer makes of
# coverage, and on what a hunt breeds by chance and by margins. Medians over seeds. libFuzzer runs as
# always: an input names its method (fuzz/unproven.hpp), and one run has the time of all methods
# together; the others have each method's time for it alone.
#   bench/fuzz_guidance.sh FIRST_FINDS TARGET [SECONDS [RUNS]]
# FIRST_FINDS: the program ccdfuzz_first_finds. TARGET: fuzz_witnessed. Both without sanitizers, or
# both with. SECONDS: of CPU time for each method and run, a whole number (default 10). RUNS: how many
# seeds (default 5).
set -euo pipefail

refuse() {
  echo "bench/fuzz_guidance.sh: $1" >&2
  exit 2
}

usage() { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"; }

case ${1-} in -h | --help) usage; exit ;; esac
if [ $# -lt 2 ]; then
  usage >&2
  exit 2
fi
[ -x "$1" ] || refuse "FIRST_FINDS: $1 is no program"
[ -x "$2" ] || refuse "TARGET: $2 is no program"
first_finds=$(realpath "$1") target=$(realpath "$2") seconds=${3:-10} runs=${4:-5}
[[ $seconds =~ ^[1-9][0-9]*$ ]] || refuse "SECONDS: \"$seconds\" is no whole number above 0"
[[ $runs =~ ^[1-9][0-9]*$ ]] || refuse "RUNS: \"$runs\" is no whole number above 0"
cd "$(dirname "$0")/.."
mapfile -t methods < <(sed -n '/kUnproven = {/,/};/p' fuzz/unproven.hpp | grep -o '"[^"]*"' | tr -d '"')
mapfile -t options < <(fuzz/target_options.sh witnessed)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The places of the methods that lost something, one a kind.
kinds_kept() {  # seed
  local status kept
  rm -rf "$scratch/lost" "$scratch/corpus"
  mkdir "$scratch/lost" "$scratch/corpus"
  # The target's own time is the wall's; the limit of the shell is of CPU time, and ends it.
  (
    ulimit -t $((seconds * ${#methods[@]}))
    CCDFUZZ_LOST=$scratch/lost "$target" -seed="$1" "${options[@]}" \
      -artifact_prefix="$scratch/" "$scratch/corpus" >"$scratch/log" 2>&1
  ) 2>/dev/null && status=0 || status=$?
  # SIGXCPU or SIGKILL of the limit, or libFuzzer's word for the former; nothing else ends it.
  case $status in
    152 | 137 | 0) ;;
    *) tail "$scratch/log" >&2; return 1 ;;
  esac
  if ! grep -q '^#[0-9]' "$scratch/log"; then tail "$scratch/log" >&2; return 1; fi
  for kept in "$scratch/lost"/*; do head -c 1 "$kept" | od -An -tu1; done
}

for ((seed = 1; seed <= runs; ++seed)); do
  kinds_kept "$seed" >"$scratch/kinds.$seed"
done
echo "| kinds lost in $seconds s | draws | coverage | bred by chance | bred by margins |"
echo '|---|---|---|---|---|'
for place in "${!methods[@]}"; do
  row=$("$first_finds" --kinds --only "${methods[place]}" --seconds "$seconds" --seeds "$runs" | tail -n 1)
  IFS='|' read -r _ name draws chance margins _ <<<"$row"
  coverage=$(for ((seed = 1; seed <= runs; ++seed)); do grep -cx " *$place" "$scratch/kinds.$seed" || true; done |
    sort -n | sed -n "$((runs / 2 + 1))p")
  echo "|$name|$draws| $coverage |$chance|$margins|"
done
