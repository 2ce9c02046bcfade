#!/usr/bin/env bash
# Each fuzz target has seeds: every claim that is thought to hold at least one, and claims that are
# known to be false give theirs to the others of their suite. No seed refutes its claim.
#   target_seeds_test.sh PROGRAMS CCDFUZZ
set -euo pipefail
programs=$1 ccdfuzz=$2
source=$(cd "$(dirname "$0")/.." && pwd)
seeds=$(mktemp -d)
trap 'rm -rf "$seeds"' EXIT

fail() {
  echo "FAILED: $1"
  exit 1
}

mapfile -t suites < <(sed -n 's/^ccdfuzz_suite(\([a-z_]*\).*/\1/p' "$source/properties/CMakeLists.txt")
for target in "${suites[@]}" query witnessed; do
  "$source/fuzz/target_seeds.sh" "$programs" "$target" "$seeds/$target"
done
# (A claim about any method asks one that the user names, and is of no target.)
for claim in $("$ccdfuzz" properties --json |
    sed -n '/"any_method":true/!s/.*"property":"\([^"]*\)".*"expected_to_fail":false.*/\1/p'); do
  compgen -G "$seeds/*/$claim-*" >/dev/null || fail "no seed of $claim"
done
[ "$(find "$seeds/tdibm_e" -type f | wc -l)" -ge 10 ] || fail 'the corpus gave no seed'
[ -e "$seeds/case_reader/corpus-engines-fcl-missed-EE.json" ] || fail 'no case of an engine'
for target in "${suites[@]}"; do
  [ "$target" != case_reader ] || continue  # texts, most of them no cases
  "$ccdfuzz" triage "$seeds/$target" --target "$target" -o "$seeds/finds" --json >"$seeds/said"
  grep -q '"failures":0.*"refuting":0' "$seeds/said" || fail "a seed of $target: $(cat "$seeds/said")"
done
# An open find that is taken into the corpus is no seed: its target would end on it.
mkdir -p "$seeds/corpus/claims"
sed 's/"property": "[^"]*"/"property": "limits.of_splits"/' "$source/corpus/claims/tdibm.mirror.json" \
  >"$seeds/corpus/claims/open.json"
"$programs/claim_inputs" limits "$seeds/open" "$seeds/corpus" >/dev/null
[ "$(find "$seeds/open" -name 'limits.of_splits-*' | wc -l)" -eq 1 ] || fail 'an open find is a seed'
if "$programs/claim_inputs" none "$seeds/none" "$source/corpus" 2>/dev/null; then fail 'a suite that is not there'; fi
