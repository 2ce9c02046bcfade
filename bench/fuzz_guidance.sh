#!/usr/bin/env bash
# What guides best, in one table: how many kinds of contacts (class, level, axes, what is wrong) each
# method loses within some CPU time, from nothing, on draws alone, on what libFuzzer makes of
# coverage alone and of the margins as extra counters, and on what a hunt breeds by chance and by
# margins. Medians over seeds.
#   bench/fuzz_guidance.sh FIRST_FINDS TARGET [SECONDS [RUNS [METHOD...]]]
# FIRST_FINDS: the program ccdfuzz_first_finds. TARGET: fuzz_witnessed. Both without sanitizers, or
# both with. SECONDS: of CPU time for each run, a whole number (default 10). RUNS: how many seeds
# (default 5). METHOD: by default all that lose contacts.
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
shift $(($# < 4 ? $# : 4))
methods=("$@")
[ $# -gt 0 ] || methods=(tdibm tdibm-h:1e-16 tdibm-h:1e-12 tdibm-e-literal tdibm-e trad)
cd "$(dirname "$0")/.."
mapfile -t options < <(fuzz/target_options.sh witnessed)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

kinds_kept() {  # method, seed, "margins" or nothing
  local status
  rm -rf "$scratch/lost" "$scratch/corpus"
  mkdir "$scratch/lost" "$scratch/corpus"
  # The target's own time is the wall's; the limit of the shell is of CPU time, and ends it.
  (
    ulimit -t "$seconds"
    [ -n "$3" ] || export CCDFUZZ_WITHOUT_MARGINS=1
    CCDFUZZ_TRACED_METHOD=$1 CCDFUZZ_LOST=$scratch/lost "$target" -seed="$2" "${options[@]}" \
      -artifact_prefix="$scratch/" "$scratch/corpus" >"$scratch/log" 2>&1
  ) 2>/dev/null && status=0 || status=$?
  # SIGXCPU or SIGKILL of the limit, or libFuzzer's word for the former; nothing else ends it.
  case $status in
    152 | 137 | 0) ;;
    *) tail "$scratch/log" >&2; return 1 ;;
  esac
  if ! grep -q '^#[0-9]' "$scratch/log"; then tail "$scratch/log" >&2; return 1; fi
  find "$scratch/lost" -type f | wc -l
}

median_of_libfuzzer() {  # method, "margins" or nothing
  local seed
  for ((seed = 1; seed <= runs; ++seed)); do kinds_kept "$1" "$seed" "$2" || return; done |
    sort -n | sed -n "$((runs / 2 + 1))p"
}

echo "| kinds lost in $seconds s | draws | coverage | and margins | bred by chance | bred by margins |"
echo '|---|---|---|---|---|---|'
for method in "${methods[@]}"; do
  row=$("$first_finds" --kinds --only "$method" --seconds "$seconds" --seeds "$runs" | tail -n 1)
  IFS='|' read -r _ name draws chance margins _ <<<"$row"
  coverage=$(median_of_libfuzzer "$method" '')
  counters=$(median_of_libfuzzer "$method" margins)
  echo "|$name|$draws| $coverage | $counters |$chance|$margins|"
done
