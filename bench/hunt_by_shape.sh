#!/usr/bin/env bash
# Hunts false negatives of one method at ordinary scales (within 2^±40), where neither under- nor
# overflow explains them, over all kinds of shapes and degrees 1 to 8: how many contacts it met, and
# how nearly it lost one.
#   bench/hunt_by_shape.sh RECORDS METHOD [SECONDS [SEED]]
# RECORDS: one JSON object a line, for what was hunted; what is there already is not hunted again, so
# that a session can be stopped and gone on with. SECONDS: by the clock, with one thread, for each of
# the 40 pairs of shapes (default 360, which are four hours in all), as many at once as there are
# processors; the table says how much CPU time that was. SEED: a whole number (default 1). The table
# is of the records with this METHOD, SECONDS and SEED. Finds go to finds/by-shape. CCDFUZZ names the
# program, by default build/release/ccdfuzz.
set -euo pipefail

usage() { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"; }

refuse() {
  echo "bench/hunt_by_shape.sh: $1" >&2
  exit 2
}

case ${1-} in -h | --help) usage; exit ;; esac
if [ $# -lt 2 ] || [ $# -gt 4 ]; then
  usage >&2
  exit 2
fi
method=$2 seconds=${3-360} seed=${4-1}
[[ $seconds =~ ^(0|[1-9][0-9]*)(\.[0-9]+)?$ && $seconds =~ [1-9] ]] ||
  refuse "SECONDS: \"$seconds\" is no number > 0, such as 360 or 0.5"
[[ $seed =~ ^(0|[1-9][0-9]*)$ ]] || refuse "SEED: \"$seed\" is no whole number"
[[ $method != *[,\"\\]* ]] || refuse "METHOD: \"$method\" is no single method"
[[ $method != plugin:[!/]* ]] || refuse "METHOD: \"$method\" is no absolute path"
records=$(realpath -- "$1") || exit 2
ccdfuzz=$(realpath -- "${CCDFUZZ:-$(dirname "$0")/../build/release/ccdfuzz}") || exit 2
command -v "$ccdfuzz" >/dev/null || refuse "there is no program $ccdfuzz"
cd "$(dirname "$0")/.."

scratch=$(mktemp -d)
set -m  # a process group for each hunt, which ends as a whole
stop_hunts() {
  local hunt
  for hunt in $(jobs -pr); do kill -- "-$hunt" 2>/dev/null || true; done
}
trap 'trap "" INT TERM; stop_hunts; wait; rm -rf "$scratch"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
# Too short to ask anything, which is exit 1; 2 says what is wrong with METHOD or SEED.
status=0
"$ccdfuzz" hunt --json --seconds 1e-9 --methods "$method" --seed "$seed" --corpus "$scratch/finds" \
  >"$scratch/out" 2>"$scratch/err" || status=$?
[ $status -le 1 ] || refuse "METHOD or SEED: $(cat "$scratch/err")"

[ -e "$records" ] || : >"$records" || exit 2
bench/by_shape_records.py hunted "$records" "$method" "$seconds" "$seed" >"$scratch/hunted"

# Queries may take 1,000 boxes: more are needed only where nothing is found, at seconds each.
hunt_one() {  # shapes
  local rows spent TIMEFORMAT='%U %S'
  spent=$(mktemp "$scratch/spent.XXXXXX")
  {
    time rows=$("$ccdfuzz" hunt --json --threads 1 --shape "$1" --within 40 --methods "$method" \
      --max-pops 1000 --shrink none --seconds "$seconds" --seed "$seed" --corpus finds/by-shape 2>&3)
  } 3>&2 2>"$spent" || return
  printf '{"shape":"%s","method":"%s","seconds":%s,"seed":%s,"cpu_seconds":%s,"cells":[%s]}\n' "$1" "$method" \
    "$seconds" "$seed" "$(awk '{ printf "%.3f", $1 + $2 }' "$spent")" \
    "$(grep '"row":"cell"' <<<"$rows" | paste -sd, -)" >>"$records"
}

shapes=() hunts=()
for n in 1 2 3 4 5 6 7 8; do
  shapes+=("triangle:$n" "tensor:${n}x$n" "curve:$n" "point,tensor:${n}x$((9 - n))" "triangle:$n,tensor:$((9 - n))x$n")
done
for shape in "${shapes[@]}"; do
  ! grep -qxF "$shape" "$scratch/hunted" || continue
  while [ "$(jobs -pr | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done  # its status is asked for below
  echo "$shape" >&2
  hunt_one "$shape" &
  hunts+=($!)
done
status=0
for hunt in "${hunts[@]}"; do wait "$hunt" || status=$?; done
bench/by_shape_records.py table "$records" "$method" "$seconds" "$seed"
exit $status
