#!/usr/bin/env bash
# Prints what libFuzzer is to be told of a target, a line each: its .options (target.options unless it
# has its own) and its dictionary.
#   fuzz/target_options.sh TARGET
set -euo pipefail
cd "$(dirname "$0")/.."
options=fuzz/$1.options
[ -e "$options" ] || options=fuzz/target.options
sed -n 's/^\([a-z_]*\) = /-\1=/p' "$options"
[ ! -e "fuzz/$1.dict" ] || echo "-dict=fuzz/$1.dict"
