#!/bin/sh
# AFL++ of a clang that is too old is skipped, with words, and nothing is built.
set -eu
cd "$(dirname "$0")/../.."
tools=$(mktemp -d)
trap 'rm -rf "$tools"' EXIT
for tool in afl-clang-fast++ afl-fuzz zip unzip; do
  printf '#!/bin/sh\necho 14.0.6\n' >"$tools/$tool"
  chmod +x "$tools/$tool"
done
code=0
said=$(PATH=$tools:$PATH script/fuzz-engines afl 2>&1) || code=$?
[ "$code" = 77 ] || { echo "exit code $code" && exit 1; }
case $said in *'is of clang 14; 16 or later is needed') ;; *) echo "it says: $said" && exit 1 ;; esac
