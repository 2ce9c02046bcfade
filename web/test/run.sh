#!/bin/sh
# run.sh bundle | gltf WORK | page CCDFUZZ WORK [SCREENSHOTS]: the tests that need Node, with what npm installs.
# Ends with 77, which ctest shows as skipped, where a tool is absent.
set -eu
web=$(cd "$(dirname "$0")/.." && pwd)

skip() {
  echo "SKIPPED: $1"
  exit 77
}
command -v node >/dev/null || skip 'there is no node (script/setup all installs it)'
command -v npm >/dev/null || skip 'there is no npm (script/setup all installs it)'

# Two tests may come here at once.
exec 9>"$web/.npm-lock"
flock 9
if ! cmp -s "$web/package-lock.json" "$web/node_modules/.installed"; then
  (cd "$web" && npm ci --no-audit --no-fund >"$web/.npm-log" 2>&1) || {
    cat "$web/.npm-log"
    skip 'npm ci failed (no network?)'
  }
  cp "$web/package-lock.json" "$web/node_modules/.installed"
fi
flock -u 9

case $1 in
  bundle) exec node "$web/build.mjs" --check ;;
  gltf) exec node "$web/test/gltf.mjs" "$web/../corpus/cases" "$2" ;;
  page)
    shift
    command -v chromium >/dev/null || command -v chromium-browser >/dev/null ||
      skip 'there is no chromium (script/setup all installs it)'
    exec node "$web/test/page.mjs" "$1" "$web/../corpus" "$2" ${3+"$3"}
    ;;
esac
