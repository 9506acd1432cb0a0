#!/usr/bin/env bash
# A program that casts two boxes holds nothing of EPA, of the other queries, or of rotating motion. usage: symbols.sh SETTINGS
#
# Without optimisation every function that is used has a symbol. The pose of a body is a rotation, so `rotation_matrix`
# and the like belong to a linear cast; a rotating motion, and what answers other queries, do not.
set -euo pipefail
source "$1"
foreign='\b(epa|Epa\w*|[Pp]enetration\w*|swept_\w+|Swept\w+|brute_force\w*|BruteForce\w*|line|Line[A-Z]\w*|overlap_\w+|Overlap[A-Z]\w*)\b'
foreign+='|\b(\w*[Rr]otating\w*|\w*[Aa]ngular\w*|[Bb]ilateral\w*|[Ss]pin\w*|\w*time_step\w*|[Ss]ubdivi\w*|plan|Plan([A-Z]\w*)?)\b'
build="$scratch/symbols"
rm -rf "$build"
mkdir -p "$build"

# build_symbols COMPILER NAME: the program's functions of graze to NAME.symbols, the headers it read to NAME.headers.
build_symbols() {
  "$1" -std=c++20 -O0 -I"$source_dir/core" -isystem "$eigen_include" -MMD -MF "$build/$2.headers" \
    "$source_dir/tests/consumer/project/$2.cpp" -o "$build/$2"
  "$build/$2"
  "$nm" -C --defined-only "$build/$2" | cut -d' ' -f2- | grep 'graze::' >"$build/$2.symbols"
}

# The patterns find what is there to be found.
build_symbols "$cxx" other_queries
grep -E "$foreign" "$build/other_queries.symbols" >"$build/found"
for name in epa penetration swept_overlap; do
  grep -q "graze::.*$name" "$build/found" ||
    { echo "nm shows no $name in a program that uses it: the patterns find nothing"; exit 1; }
done

for compiler in "$cxx" "$clang"; do
  build_symbols "$compiler" two_boxes
  grep -q 'graze::header_only::cast<double>' "$build/two_boxes.symbols" || { echo "nm shows no cast"; exit 1; }
  if grep -E "$foreign" "$build/two_boxes.symbols"; then
    echo "$compiler: two boxes hold the above"
    exit 1
  fi
  if grep -oE 'graze/([a-z_/]*/)?(epa|penetration|overlap|rotating|plan)[a-z_/]*\.hpp' "$build/two_boxes.headers"; then
    echo "$compiler: <graze/cast.hpp> includes the above"
    exit 1
  fi
  echo "$(basename "$compiler"): $(wc -l <"$build/two_boxes.symbols") functions of graze, none foreign to a linear cast"
done
