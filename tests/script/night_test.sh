#!/bin/sh
# script/night: a night of a second, in a folder of its own. Its argument is the folder of the build.
set -eu
source=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/script"
cp "$source/script/night" "$work/script/night"
export CCDFUZZ_BUILD="$1" CCDFUZZ_NIGHT_TESTS='^rc[.]'

for wrong in '--seed 0' '--seconds 1.5' '--seconds' '--nights 2'; do
  code=0
  # shellcheck disable=SC2086
  "$work/script/night" $wrong >"$work/out" 2>&1 || code=$?
  [ "$code" = 2 ] || { echo "$wrong: exit code $code" && exit 1; }
  grep -q -- "${wrong%% *}" "$work/out" || { echo "$wrong: not named" && cat "$work/out" && exit 1; }
done

"$work/script/night" --seed 20261125 --seconds 1 >"$work/out" 2>&1 || { cat "$work/out" && exit 1; }
for said in 'seed 20261125, 1 s' '100% tests passed' 'tdibm-c' 'counterexamples in finds'; do
  grep -q -- "$said" "$work/out" || { echo "not said: $said" && cat "$work/out" && exit 1; }
done

# Ctrl-C while claims are checked: no hunt begins.
CCDFUZZ_NIGHT_TESTS=none timeout -s INT 4 "$work/script/night" --seconds 60 >"$work/out" 2>&1 || true
! grep -q 'queries drawn' "$work/out" || { cat "$work/out" && exit 1; }

# SIGTERM and a closed terminal end the night, and what runs.
for signal in TERM:143 HUP:129; do
  CCDFUZZ_NIGHT_TESTS=none "$work/script/night" --seconds 60 >"$work/out" 2>&1 &
  night=$!
  child=''
  until [ -n "$child" ]; do
    kill -0 "$night" || { cat "$work/out" && exit 1; }
    sleep 0.1
    for found in $(cat "/proc/$night/task/$night/children"); do
      [ "$(cat "/proc/$found/comm")" != ccdfuzz ] || child=$found
    done
  done
  kill -"${signal%:*}" "$night"
  code=0
  wait "$night" || code=$?
  [ "$code" = "${signal#*:}" ] || { echo "after SIG${signal%:*}: exit code $code" && exit 1; }
  ! kill -0 "$child" 2>/dev/null || { echo "SIG${signal%:*} leaves a process" && kill "$child" && exit 1; }
done
