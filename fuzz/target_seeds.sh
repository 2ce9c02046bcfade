#!/usr/bin/env bash
# Writes the seeds of a fuzz target into a folder. PROGRAMS is where witnessed_inputs and claim_inputs
# are built. Both paths are absolute, or of the project's folder.
#   fuzz/target_seeds.sh PROGRAMS TARGET FOLDER
set -euo pipefail
cd "$(dirname "$0")/.."
programs=$1 target=$2 folder=$3
mkdir -p "$folder"
case $target in
  query | witnessed) exec "$programs/witnessed_inputs" encode "$folder" corpus ;;
  case_reader)  # any text may be a case; finds of two engines may have one name
    find corpus -name '*.json' | while read -r entry; do cp "$entry" "$folder/${entry//\//-}"; done
    ;;
esac
exec "$programs/claim_inputs" "$target" "$folder" corpus
