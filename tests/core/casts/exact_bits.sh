#!/usr/bin/env bash
# The exact tier, built with other compilers and flags, gives the same bits.
# usage: exact_bits.sh REFERENCE DIRECTORY INCLUDES LAUNCHER COMPILER FLAGS
set -euo pipefail
reference=$1 directory=$2 includes=$3 launcher=$4 compiler=$5 flags=$6
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$directory"
"$reference" >"$directory/expected"
# Both lists are meant to be split.
# shellcheck disable=SC2086
$launcher "$compiler" -std=c++20 $flags $includes -c "$here/exact_bits.cpp" -o "$directory/bits.o"
"$compiler" "$directory/bits.o" -o "$directory/bits"
if [[ $flags == *-mfma* ]] && ! grep -qw fma /proc/cpuinfo; then
  echo "built; not run: this processor has no fused multiply-add"
  exit 77
fi
for mode in "" flush; do
  "$directory/bits" $mode >"$directory/seen"
  diff "$directory/expected" "$directory/seen" || { echo "other bits with $compiler $flags $mode"; exit 1; }
done
cat "$directory/expected"
