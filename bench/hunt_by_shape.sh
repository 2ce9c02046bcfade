#!/usr/bin/env bash
# Hunts false negatives of one method at ordinary scales (within 2^±40), where neither under- nor
# overflow explains them, over all kinds of shapes and degrees 1 to 8: how many contacts it met, and
# how nearly it lost one.
#   bench/hunt_by_shape.sh RECORDS METHOD [SECONDS [SEED]]
# RECORDS: one JSON object a line, for what was hunted; what is there already is not hunted again, so
# that a session can be stopped and gone on with. SECONDS: of one thread for each of the 40 pairs of
# shapes (default 360, which are four hours in all), as many at once as there are processors. Finds
# go to finds/by-shape.
set -euo pipefail
records=$(realpath "${1:?RECORDS}") method=${2:?METHOD} seconds=${3:-360} seed=${4:-1}
cd "$(dirname "$0")/.."
ccdfuzz=${CCDFUZZ:-build/release/ccdfuzz}
touch "$records"

# Queries may take 1,000 boxes: more are needed only where nothing is found, at seconds each.
hunt_one() {  # shapes
  local rows
  rows=$("$ccdfuzz" hunt --json --threads 1 --shape "$1" --within 40 --methods "$method" --max-pops 1000 \
    --shrink none --seconds "$seconds" --seed "$seed" --corpus finds/by-shape) || return
  printf '{"shape":"%s","method":"%s","seconds":%s,"seed":%s,"cells":[%s]}\n' "$1" "$method" "$seconds" \
    "$seed" "$(grep '"row":"cell"' <<<"$rows" | paste -sd, -)" >>"$records"
}

shapes=() hunts=()
for n in 1 2 3 4 5 6 7 8; do
  shapes+=("triangle:$n" "tensor:${n}x$n" "curve:$n" "point,tensor:${n}x$((9 - n))" "triangle:$n,tensor:$((9 - n))x$n")
done
for shape in "${shapes[@]}"; do
  ! grep -qF "{\"shape\":\"$shape\",\"method\":\"$method\",\"seconds\":$seconds,\"seed\":$seed," "$records" || continue
  while [ "$(jobs -pr | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done  # its status is asked for below
  echo "$shape" >&2
  hunt_one "$shape" &
  hunts+=($!)
done
for hunt in "${hunts[@]}"; do wait "$hunt"; done

python3 - "$records" "$method" <<'END'
import json, sys

tallies = {}
for line in open(sys.argv[1]):
    record = json.loads(line)
    if record["method"] != sys.argv[2]:
        continue
    for row in record["cells"]:
        for name in (record["shape"], "all"):
            t = tallies.setdefault(name, {"n": 0, "undecided": 0, "failed": 0, "mutants": 0, "lost": 0, "margin": None})
            t["n"] += row["n"]
            t["undecided"] += row["undecided"]
            t["failed"] += row["missed"] + row["late"]
            t["mutants"] += row["mutants"]
            t["lost"] += row["lost_mutants"]
            margins = [m for m in (t["margin"], row["margin_ulps"]) if m is not None]
            t["margin"] = min(margins, default=None)
print("| shapes | queries | undecided | missed or late | mutants traced | lost | smallest margin, ulps |")
print("|---|---|---|---|---|---|---|")
for name, t in sorted(tallies.items(), key=lambda item: item[0] == "all"):
    print(f"| {name} | {t['n']:,} | {t['undecided']:,} | {t['failed']} | {t['mutants']:,} | {t['lost']} | {t['margin']} |")
END
