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
for stand_in in script/setup bin/cmake fuzz/target_options.sh fuzz/target_seeds.sh; do
  printf '#!/bin/sh\n' >"$work/$stand_in"
done
# As libFuzzer: the last of its words but for the seeds is the corpus.
cat >"$work/build/libfuzzer/fuzz/fuzz_one" <<END
#!/bin/sh
echo \$\$ >'$work/pid'
echo "\$*" >>'$work/calls'
case \$* in
  -merge=1*)
    [ ! -e '$work/merge-fails' ] || exit 1
    sleep 5 >/dev/null 2>&1 &
    cp "\$3/a" "\$2"
    ;;
  *)
    echo '#5 INITED cov: 2 corp: 1'
    echo '#7 NEW cov: 3 corp: 2'
    echo 'stat::number_of_executed_units: 7'
    if [ -e '$work/runs-long' ]; then exec sleep 600; fi
    if [ -e '$work/fails' ]; then
      echo 'the last words'
      touch build/fuzz-finds/one/crash-1
      exit 77
    fi
    ;;
esac
END
cat >"$work/build/libfuzzer/fuzz/fuzz_query" <<END
#!/bin/sh
[ -z "\$CCDFUZZ_LOST" ] || touch "\$CCDFUZZ_LOST/input"
END
cat >"$work/build/release/ccdfuzz" <<END
#!/bin/sh
echo "\$*" >>'$work/calls'
[ -e '$work/no-time' ] || case \$* in *--remove*) rm -f "\$2"/* ;; esac
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
ran_with '/seeds-of-one'
[ "$(wc -l <"$work/calls")" -eq 2 ] || fail 'not two processes'
fuzz 0 --seconds 5 -- one
ran_with '-runs=-1 -max_total_time=5 '

# What libFuzzer is told of the real targets.
targets=$(sed -n 's/^ccdfuzz_suite(\([a-z_]*\).*/\1/p' "$source/properties/CMakeLists.txt")
for target in tdibm_rational query_csv query witnessed; do
  case " $(echo $targets) query witnessed " in
    *" $target "*) ;;
    *) fail "not among the targets: $target" ;;
  esac
done
for target in $targets query witnessed; do
  "$source/fuzz/target_options.sh" "$target" | grep -qx -e -len_control=0 ||
    fail "$target starves: its inputs grow slowly"
  "$source/fuzz/target_options.sh" "$target" | grep -qx -e '-timeout=[13]0' || fail "$target may hang"
done

# What methods lost is put to triage, which alone takes away what it is done with.
fuzz 0 query --seconds 5
ran_with 'triage build/fuzz-todo/query --remove --known corpus -o finds --seconds 20'
touch "$work/no-time"
fuzz 0 query --seconds 5
[ -e "$work/build/fuzz-todo/query/input" ] || fail 'an input that nobody looked at is gone'
rm "$work/no-time"
[ "$(wc -l <"$work/calls")" -eq 1 ] || fail 'triage of what did not fail'
fuzz 0 one --seconds 5
! grep -qF triage "$work/calls" || fail 'triage of nothing'

# A failing target: its words, its input, which is put to triage, and exit 1, after the others.
touch "$work/fails"
fuzz 1 --seconds 5 one query
says 'the last words'
says 'script/fuzz: one failed; its input is in build/fuzz-finds/one'
says 'script/fuzz: failed: one'
[ -e "$work/build/fuzz-finds/one/crash-1" ] || fail 'no input'
ran_with 'triage build/fuzz-todo/one --remove --target one --known corpus -o finds --seconds 20'
ran_with 'triage build/fuzz-todo/query --remove --known'
# A triage that cannot be built must not be another, and leaves the input to the next.
printf '#!/bin/sh\ntouch build/fuzz-finds/query/crash-2 build/fuzz-finds/query/slow-unit-3; exit 1\n' \
  >"$work/build/libfuzzer/fuzz/fuzz_query"
printf '#!/bin/sh\ncase $* in *release*) exit 1 ;; esac\n' >"$work/bin/cmake"
fuzz 1 --seconds 30 query
! grep -qF triage "$work/calls" || fail 'triage by a program that was not built'
[ "$(ls "$work/build/fuzz-todo/query")" = 0-crash-2 ] || fail 'not left to the next run'
printf '#!/bin/sh\n' >"$work/bin/cmake"
printf '#!/bin/sh\n' >"$work/build/libfuzzer/fuzz/fuzz_query"
fuzz 0 --seconds 30 query
says 'query mutated nothing: its seeds took all of the time'
ran_with 'triage build/fuzz-todo/query --remove --known corpus -o finds --seconds 30'
# Each is put to triage once, and once more if it is found again; so is what another run left.
fuzz 0 query
! grep -qF triage "$work/calls" || fail 'triage of what was looked at before'
sleep 0.1
touch "$work/build/fuzz-finds/query/crash-2" "$work/build/fuzz-finds/query/crash-1"
touch "$work/no-time"
fuzz 0 query
[ "$(echo $(ls "$work/build/fuzz-todo/query"))" = '0-crash-1 0-crash-2' ] || fail 'not all that is new'
rm "$work/no-time" "$work/fails"

# --fresh: neither corpus nor what was lost before, and seeds that are told.
rm -r "$work/build/fuzz-corpus"
fuzz 0 --fresh --jobs 2 --runs 9 one
says '14 runs'
ran_with '-seed=1 -runs=9 '
ran_with '-seed=2 -runs=9 '
! grep -qF build/fuzz-corpus "$work/calls" || fail 'a corpus that --fresh must not have'
printf '#!/bin/sh\n[ -z "$CCDFUZZ_LOST" ]\n' >"$work/build/libfuzzer/fuzz/fuzz_query"
fuzz 0 --fresh --runs 1 query
fuzz 2 --fresh --merge one
says '--fresh has no corpus to --merge'

# --merge: what it leaves takes the corpus' place; if it fails, nothing changes.
corpus=$work/build/fuzz-corpus/one
mkdir -p "$corpus"
touch "$corpus/a" "$corpus/b"
touch "$work/merge-fails"
fuzz 1 --merge one
[ "$(ls "$corpus")" = "a
b" ] || fail 'a merge that failed changed the corpus'
rm "$work/merge-fails"
fuzz 0 --merge one
says 'one: 1 of 2 inputs kept'
[ "$(ls "$corpus")" = a ] || fail 'not merged'
[ "$(ls "$work/build/fuzz-corpus")" = one ] || fail 'leftovers of a merge'
# Of a merge that was ended while neither was the corpus.
mv "$corpus" "$corpus.old"
fuzz 0 --runs 1 one
[ -e "$corpus/a" ] || fail 'the corpus is lost'

# While a corpus is merged nothing else writes to it.
exec 8>"$work/build/.fuzz-one-lock"
flock -s 8
fuzz 0 --runs 1 one
fuzz 1 --merge one
says 'another run is at work on build/fuzz-corpus/one'
[ -e "$corpus/a" ] || fail 'a corpus in use is merged'
flock 8
fuzz 1 --runs 1 one
says 'another run is at work on build/fuzz-corpus/one'
fuzz 0 --fresh --runs 1 one
exec 8>&-

# A signal ends it and what it started.
touch "$work/runs-long"
for signal in INT TERM; do
  : >"$work/calls"
  # A shell without a terminal has background jobs ignore SIGINT.
  env --default-signal=INT setsid "$work/script/fuzz" --seconds 600 one >"$work/out" 2>&1 &
  pid=$!
  until [ -s "$work/calls" ]; do
    kill -0 $pid || fail 'it ended by itself'
    sleep 0.1
  done
  kill -s $signal $pid
  status=0
  wait $pid || status=$?
  case $signal:$status in
    INT:130 | TERM:143) ;;
    *) fail "exit $status after SIG$signal" ;;
  esac
  # One that is dead stays until somebody asks, and may be about to be.
  left=/proc/$(cat "$work/pid")/status
  for try in 1 2 3 4 5 6 7 8 9 10; do
    grep -q '^State:.[^ZX]' "$left" 2>/dev/null || break
    [ $try -lt 10 ] || fail "SIG$signal leaves a process"
    sleep 0.5
  done
done
echo PASSED
