#!/bin/sh
# Whether what reads and writes doubles compiles with LLVM's standard library, as fuzzing services bring it
# along: up to 19 it has no std::from_chars for them. Exit code 77, and a word, where it is not installed.
#   libcxx_test.sh CLANG
set -eu
cd "$(dirname "$0")/../.."
check() {
  "$1" -std=c++20 -stdlib=libc++ -fsyntax-only -Isrc -I. -isystem /usr/include/eigen3 "$2"
}
probe=$(mktemp --suffix=.cpp)
trap 'rm -f "$probe"' EXIT
echo '#include <charconv>' >"$probe"
if ! check "$1" "$probe" 2>/dev/null; then
  echo "skipped: $1 has no libc++"
  exit 77
fi
for file in $(grep -rlE 'charconv|read_double' --include='*.cpp' src); do
  check "$1" "$file"
done
