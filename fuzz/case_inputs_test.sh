#!/bin/sh
# The corpus as seeds of a target, each run once and shown as a case again.
set -eu
program=$1 corpus=$2 seeds=$3
rm -rf "$seeds" "$seeds.lost"
"$program" encode "$seeds" "$corpus"
"$program" run "$seeds"/*
[ "$("$program" decode "$seeds"/* | grep -c '"collides":true')" -ge 50 ]
if "$program" decode "$program" 2>/dev/null; then exit 1; fi

# What tdibm-e alone misses is lost by the input that names it, the fifth of fuzz/unproven.hpp, alone.
rm -rf "$seeds"
mkdir "$seeds.one" "$seeds.lost"
trap 'rm -rf "$seeds.one"' EXIT
cp "$corpus"/cases/tdibm-e-underflow.json "$seeds.one"
"$program" encode "$seeds" "$seeds.one"
CCDFUZZ_LOST=$seeds.lost "$program" run "$seeds"/*
[ "$(for lost in "$seeds.lost"/*; do head -c 1 "$lost" | od -An -tu1; done)" -eq 4 ]
