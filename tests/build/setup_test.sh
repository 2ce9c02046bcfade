#!/bin/sh
# script/setup on machines that it cannot have here: package tools, sudo and id are stand-ins that
# note how they are called.
set -eu
setup=$(cd "$(dirname "$0")/../.." && pwd)/script/setup
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"

stand_in() {  # NAME, then its script on stdin
  { echo '#!/bin/sh'; cat; } >"$work/bin/$1"
  chmod +x "$work/bin/$1"
}
stand_in id <<'END'
echo "${USER_ID:-0}"
END
# Everything is installed but what MISSING names.
stand_in dpkg-query <<'END'
for package in $ALL; do
  case " ${MISSING:-} " in
    *" $package "*) echo "not-installed $package" ;;
    *) echo "installed $package" ;;
  esac
done
END
stand_in apt-get <<'END'
echo "apt-get $*" >>"$WORK/calls"
case "$* " in *update*) exit "${UPDATE_STATUS:-0}" ;; esac
exit "${INSTALL_STATUS:-0}"
END
stand_in sudo <<'END'
[ "${SUDO:-no}" = yes ] || exit 1
[ "$1" = -n ] && exit 0
echo sudo >>"$WORK/calls"
exec "$@"
END

ALL=$(sed -n "/^packages='/,/'$/p" "$setup" | sed "s/packages='//; s/'//")
export ALL WORK="$work" PATH="$work/bin:$PATH"

word=''
run() {  # assignments…; leaves status, output and calls
  : >"$work/calls"
  status=0
  # shellcheck disable=SC2086
  env "$@" "$setup" $word >"$work/output" 2>&1 </dev/null || status=$?
  calls=$(cat "$work/calls")
  output=$(cat "$work/output")
}
expect() {  # what, condition…
  what=$1
  shift
  "$@" || { echo "FAILED: $what (status $status, calls: $calls, output: $output)"; exit 1; }
}
says() { case $output in *"$1"*) ;; *) return 1 ;; esac; }

run MISSING=
expect 'nothing missing: success' [ "$status" = 0 ]
expect 'nothing missing: quiet' [ -z "$output" ]
expect 'nothing missing: no package tool is called' [ -z "$calls" ]

run 'MISSING=cmake libgmp-dev'
expect 'as root: success' [ "$status" = 0 ]
expect 'as root: updates, then installs what is missing and nothing else' [ "$calls" = \
  "apt-get -q update
apt-get -q -y --no-install-recommends install cmake libgmp-dev" ]

word=hunt
run MISSING=cmake
expect 'a word that is none: exit 2' [ "$status" = 2 ]
expect 'a word that is none: names it' says '"hunt" is none of'
expect 'a word that is none: no attempt' [ -z "$calls" ]
brings() { case " $calls " in *" $1 "*) ;; *) return 1 ;; esac; }
for more in 'fuzz clang-19' 'tests clang-format' 'all slurmctld' 'all chromium' 'coverage gcovr' 'fuzz-engines afl++' 'engines libfcl-dev'; do
  word=${more% *}
  run MISSING=
  expect "$word: success" [ "$status" = 0 ]
  expect "$more" brings "${more#* }"
done
word='tests hunt'
run MISSING=cmake
expect 'two words: exit 2' [ "$status" = 2 ]
word=''

run USER_ID=1000 SUDO=yes MISSING=cmake
expect 'through sudo: success' [ "$status" = 0 ]
expect 'through sudo: both calls' [ "$(echo "$calls" | grep -c '^sudo$')" = 2 ]

run USER_ID=1000 MISSING=cmake
expect 'without the right: exit 2' [ "$status" = 2 ]
expect 'without the right: names the package' says 'missing: cmake'
expect 'without the right: says what to run' says 'apt-get install -y --no-install-recommends cmake'
expect 'without the right: no attempt' [ -z "$calls" ]

run MISSING=cmake UPDATE_STATUS=100
expect 'without network: exit 2' [ "$status" = 2 ]
expect 'without network: says so' says 'no network'
expect 'without network: names the package' says 'missing: cmake'

run MISSING=cmake INSTALL_STATUS=100
expect 'a package that cannot be had: exit 2' [ "$status" = 2 ]
expect 'a package that cannot be had: names it' says 'missing: cmake'
echo 'all as expected'
