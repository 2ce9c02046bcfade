#!/bin/sh
# readme_test.sh SOURCE CCDFUZZ: every command of the README that calls ccdfuzz or g++ runs as it
# stands there, one after the other in one folder; every script and path that it names exists.
set -eu
source=$1
ccdfuzz=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/build/release"
ln -s "$ccdfuzz" "$work/build/release/ccdfuzz"
cp -r "$source/corpus" "$work/corpus"
ln -s "$source/src" "$source/examples" "$work"
cd "$work"

# shellcheck disable=SC2016
sed -n '/^```sh$/,/^```$/p' "$source/README.md" | grep -v '^```' >commands
count=0
while IFS= read -r command; do
  case $command in
    build/release/ccdfuzz* | g++*)
      echo "\$ $command"
      sh -c "$command" >output 2>&1 </dev/null || {
        status=$?
        cat output
        echo "FAILED: exit $status"
        exit 1
      }
      count=$((count + 1))
      ;;
    script/*)
      [ -x "$source/${command%% *}" ] || { echo "FAILED: no ${command%% *}"; exit 1; }
      ;;
  esac
done <commands
[ "$count" -ge 3 ] || { echo "FAILED: only $count commands of ccdfuzz in the README"; exit 1; }

tr '`' '\n' <"$source/README.md" |
  grep -E '^(src|generators|properties|fuzz|tests|corpus|bench|cmake|script)/[A-Za-z0-9_./-]*$' |
  while IFS= read -r path; do
    [ -e "$source/$path" ] || { echo "FAILED: the README names $path, which is not there"; exit 1; }
  done
echo "$count commands ran"
