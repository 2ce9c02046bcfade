#!/bin/sh
# bench/hunt_by_shape.sh with a stand-in for the hunts, which notes how it is called. Usage:
# hunt_by_shape_test.sh CCDFUZZ, which says what is a method and a seed.
set -eu
script=$(cd "$(dirname "$0")/../.." && pwd)/bench/hunt_by_shape.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export REAL="$1" CALLS="$work/calls" CCDFUZZ="$work/ccdfuzz"
records=$work/records

cat >"$CCDFUZZ" <<'END'
#!/bin/sh
case " $* " in *' --seconds 1e-9 '*) exec "$REAL" "$@" ;; esac
echo "$*" >>"$CALLS"
echo '{"row":"cell","class":"VV","n":3,"missed":1,"late":1,"undecided":1,"mutants":1000,"lost_mutants":2,"margin_ulps":null,"cpu_seconds":0.25}'
echo '{"row":"cell","class":"VE","n":2,"missed":0,"late":0,"undecided":0,"mutants":0,"lost_mutants":0,"margin_ulps":7,"cpu_seconds":0.25}'
echo '{"row":"summary"}'
END
chmod +x "$CCDFUZZ"

fail() {
  echo "FAILED: $1"
  cat "$work/out" "$work/err"
  exit 1
}

# hunt STATUS ARGUMENT...: what it prints goes to $work/out and $work/err.
hunt() {
  wanted=$1
  shift
  status=0
  : >"$CALLS"
  "$script" "$@" >"$work/out" 2>"$work/err" || status=$?
  [ "$status" -eq "$wanted" ] || fail "exit $status, not $wanted, of: $*"
}
says() { grep -qF -- "$2" "$work/$1" || fail "no \"$2\" in $1"; }
# The sum of all shapes: so many queries, and what follows them.
says_all() { grep -qE "^[|] all [|] [0-9,]+ [|] $1 [|]" "$work/out" || fail "not $1 in all"; }
hunts() { [ "$(wc -l <"$CALLS")" -eq "$1" ] || fail "not $1 hunts"; }

hunt 2
says err 'hunt_by_shape.sh RECORDS METHOD'
hunt 2 "$records"
says err 'hunt_by_shape.sh RECORDS METHOD'
hunt 0 --help
says out 'hunt_by_shape.sh RECORDS METHOD'

hunt 2 "$records" nosuch 1
says err 'unknown method "nosuch"'
hunt 2 "$records" tdibm,tdibm-e 1
says err 'METHOD: "tdibm,tdibm-e" is no single method'
for seconds in 0.0 -1 nan 1e3 ''; do
  hunt 2 "$records" tdibm "$seconds"
  says err "SECONDS: \"$seconds\" is no number > 0"
done
for seed in -1 1.5 18446744073709551616; do
  hunt 2 "$records" tdibm 1 "$seed"
  says err "$seed"
  says err SEED
done
[ ! -e "$records" ] || fail 'what was refused began a file'

hunt 0 "$records" tdibm 0.5
hunts 40
grep -q -- '--seconds 0.5 --seed 1 ' "$CALLS" || fail 'SECONDS and SEED are not handed on'
says out '| curve:3 | 0 | 5 | 1 | 2 | 1,000 | 2 | 7 |'
says_all '200 [|] 40 [|] 80 [|] 40,000 [|] 80 [|] 7'
# The CPU time is the hunt's; of a record without one, that of its queries.
sed 's/"cpu_seconds":[0-9.]*,"cells"/"cpu_seconds":36000,"cells"/' "$records" >"$work/slow"
hunt 0 "$work/slow" tdibm 0.5
says out '| all | 1,440,000 | 200 |'
sed 's/"cpu_seconds":[0-9.]*,"cells"/"cells"/' "$records" >"$work/slow"
hunt 0 "$work/slow" tdibm 0.5
says out '| all | 20 | 200 |'
[ "$(wc -l <"$records")" -eq 40 ] || fail 'not 40 records'
cp "$records" "$work/whole"

hunt 0 "$records" tdibm 0.5
hunts 0
says_all 200

# The table is of what is asked for.
for other in 's/"seed":1/"seed":2/' 's/"seconds":0.5/"seconds":7/' 's/"tdibm"/"tdibm-e"/'; do
  sed "$other" "$work/whole" | head -n 5 >>"$records"
done
hunt 0 "$records" tdibm 0.5
hunts 0
says_all 200

# Of all that a record says but for the time.
sum_of() { sed 's/"cpu_seconds":[0-9.]*,"cells"/"cells"/' "$1" | sort | md5sum; }

# A last line that is cut anywhere behind its start is hunted again; one without its end stays.
for bytes in 1 2 200; do
  head -c -"$bytes" "$work/whole" >"$records"
  hunt 0 "$records" tdibm 0.5
  if [ "$bytes" -eq 1 ]; then hunts 0; else hunts 1; fi
  says_all 200
  [ "$(sum_of "$records")" = "$(sum_of "$work/whole")" ] || fail 'the records differ'
done

# Anything else that is no record is an error, and stays.
for line in '{"shape":"curve:1","method":"tdibm","seconds":0.5,"seed":1,"cel' '[]' '' \
  '{"shape":"curve:1","method":"tdibm","seconds":0.5,"seed":1,"cells":[{"n":1}]}'; do
  { head -n 2 "$work/whole"; echo "$line"; tail -n +4 "$work/whole"; } >"$records"
  cp "$records" "$work/damaged"
  hunt 2 "$records" tdibm 0.5
  hunts 0
  says err "$records:3: is no record of a hunt by shape"
  cmp "$records" "$work/damaged" || fail 'the file was changed'
done
printf 'a text' >"$records"
hunt 2 "$records" tdibm 0.5
[ "$(cat "$records")" = 'a text' ] || fail 'another file was changed'
hunt 2 "$work/nosuch/records" tdibm 0.5
hunt 2 "$work" tdibm 0.5

# A shape that two hunts at a time wrote counts once.
{ cat "$work/whole"; head -n 3 "$work/whole"; } >"$records"
hunt 0 "$records" tdibm 0.5
says_all 200

# Paths are those of where it is called.
(cd "$work" && CCDFUZZ=./ccdfuzz && hunt 0 records tdibm 0.5 && hunts 0)
hunt 2 "$records" plugin:./lib.so 1
says err 'METHOD: "plugin:./lib.so" is no absolute path'

# A hunt that fails fails, and what the others came to is told.
printf '#!/bin/sh\ncase " $* " in *" 1e-9 "*) exit 1 ;; esac\nexit 3\n' >"$CCDFUZZ"
head -n 39 "$work/whole" >"$records"
hunt 3 "$records" tdibm 0.5
says_all 195

# None goes on behind one that is stopped.
cat >"$CCDFUZZ" <<'END'
#!/bin/sh
case " $* " in *' 1e-9 '*) exit 1 ;; esac
trap 'echo stopped >>"$CALLS"; exit 1' TERM
echo begun >>"$CALLS"
sleep 1200 &
wait
END
: >"$CALLS"
"$script" "$records" tdibm 0.5 >"$work/out" 2>"$work/err" &
stopped=$!
until [ -s "$CALLS" ]; do sleep 0.1; done
kill "$stopped"
status=0
wait "$stopped" || status=$?
[ "$status" -eq 143 ] || fail "exit $status of one that was stopped"
is_stopped() { [ "$(grep -c stopped "$CALLS")" -ge "$(grep -c begun "$CALLS")" ]; }
for _ in $(seq 6000); do if is_stopped; then break; fi; sleep 0.1; done
is_stopped || fail 'a hunt goes on'
echo PASSED
