#!/bin/sh
# script/test names what is no stage, and the jobs of CI run together what `script/test all` runs.
set -eu
cd "$(dirname "$0")/../.."
code=0
said=$(script/test nosuch 2>&1) || code=$?
[ "$code" = 2 ] || { echo "script/test nosuch: exit code $code" && exit 1; }
case $said in *'no stage "nosuch"; there are: setup '*) ;; *) echo "it says: $said" && exit 1 ;; esac

words() { tr ' ' '\n' | sort -u; }
all=$(sed -n 's/^all=(\(.*\))$/\1/p' script/test | words)
jobs=$(sed -n 's/^ *stages: //p' .github/workflows/test.yml | words)
[ "$all" = "$jobs" ] || { printf 'script/test all:\n%s\n.github/workflows/test.yml:\n%s\n' "$all" "$jobs" && exit 1; }
grep -q 'script/test" all$' .ci/run || { echo '.ci/run does not run all' && exit 1; }
