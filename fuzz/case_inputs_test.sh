#!/bin/sh
# The corpus as seeds of a target, each run once and shown as a case again.
set -eu
program=$1 corpus=$2 seeds=$3
rm -rf "$seeds"
"$program" encode "$seeds" "$corpus"
"$program" run "$seeds"/*
[ "$("$program" decode "$seeds"/* | grep -c '"collides":true')" -ge 50 ]
if "$program" decode "$program" 2>/dev/null; then exit 1; fi
