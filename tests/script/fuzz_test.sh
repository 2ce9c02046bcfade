#!/bin/sh
# script/fuzz: which options it takes, and what it makes of them. Setup, cmake and the one target are
# stand-ins.
set -eu
source=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/script" "$work/bin" "$work/fuzz" "$work/build/libfuzzer/fuzz" "$work/build/release"
cp "$source/script/fuzz" "$work/script/fuzz"
printf 'one\nquery\n' >"$work/build/libfuzzer/fuzz-targets.txt"
for stand_in in script/setup bin/cmake fuzz/target_options.sh build/libfuzzer/fuzz/witnessed_inputs; do
  printf '#!/bin/sh\n' >"$work/$stand_in"
done
cat >"$work/build/libfuzzer/fuzz/fuzz_one" <<END
#!/bin/sh
echo "\$*" >>'$work/calls'
END
cat >"$work/build/libfuzzer/fuzz/fuzz_query" <<END
#!/bin/sh
touch "\$CCDFUZZ_LOST/input"
END
cat >"$work/build/release/ccdfuzz" <<END
#!/bin/sh
echo "\$*" >>'$work/calls'
END
chmod +x "$work"/build/release/* "$work"/script/* "$work"/bin/* "$work"/fuzz/* "$work"/build/libfuzzer/fuzz/*
PATH=$work/bin:$PATH

fail() {
  echo "FAILED: $1"
  cat "$work/out"
  exit 1
}

fuzz() {  # STATUS ARGUMENT...
  wanted=$1
  shift
  status=0
  : >"$work/calls"
  "$work/script/fuzz" "$@" >"$work/out" 2>&1 || status=$?
  [ "$status" -eq "$wanted" ] || fail "exit $status, not $wanted, of: $*"
}
says() { grep -qF -- "$1" "$work/out" || fail "it does not say: $1"; }

refuses() {  # OPTION VALUE MOST
  fuzz 2 "$1" "$2"
  says "script/fuzz: $1: \"$2\" is no whole number from 1 to $3"
  fuzz 2 "$1=$2"
  says "script/fuzz: $1: \"$2\" is no whole number from 1 to $3"
  [ ! -s "$work/calls" ] || fail 'it ran'
}
for value in 0 -1 1.5 x '' 2147483648 9999999999 99999999999999999999; do
  for option in --seconds --runs --at-once; do refuses $option "$value" 2147483647; done
done
refuses --jobs 1001 1000
fuzz 2 --runs
fuzz 2 --fresh=yes
says 'unknown option --fresh=yes'
fuzz 2 -- --runs
says 'no target "--runs"; there are: one query'

ran_with() { grep -qF -- "$1" "$work/calls" || fail "not run with $1: $(cat "$work/calls")"; }
fuzz 0 --seconds=5 --runs 2147483647 --jobs=2 one
ran_with '-runs=2147483647 -max_total_time=5 '
[ "$(wc -l <"$work/calls")" -eq 2 ] || fail 'not two processes'
fuzz 0 --seconds 5 -- one
ran_with '-runs=-1 -max_total_time=5 '

# What methods lost is put to triage, which alone takes away what it is done with.
fuzz 0 query --seconds 5
ran_with 'triage build/fuzz-lost/query --remove --known corpus -o finds --seconds 20'
[ -e "$work/build/fuzz-lost/query/input" ] || fail 'an input that nobody looked at is gone'
echo PASSED
