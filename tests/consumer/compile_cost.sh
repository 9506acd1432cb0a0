#!/usr/bin/env bash
# What a user's file pays for a public header of the compiled library, in units that do not depend on the machine: lines
# after preprocessing, beside those of <Eigen/Core>, and functions that the file itself holds without optimisation.
# usage: compile_cost.sh SETTINGS
#
# One cast of two given bodies; and one of two boxes made, placed and thrown away, most of which is std::variant.
# Seconds: bench/compile_cost.py.
set -euo pipefail
source "$1"
build="$scratch/compile_cost"
rm -rf "$build"
mkdir -p "$build"

compiler() { "$cxx" -std=c++20 -DGRAZE_COMPILED -I"$source_dir/core" -isystem "$eigen_include" "$@"; }
lines() { compiler -E -P "$1" | wc -l; }
functions() { compiler -O0 -c "$1" -o "$build/object" && "$nm" --defined-only "$build/object" | grep -cE ' [tTwWvV] '; }

echo '#include <Eigen/Core>' >"$build/eigen.cpp"
eigen=$(lines "$build/eigen.cpp")
failed=0
# costs NAME LINES FUNCTIONS: at most 1/100 of Eigen's lines, and functions.
costs() {
  local lines functions
  lines=$(lines "$build/$1.cpp") functions=$(functions "$build/$1.cpp")
  echo "$1: $lines lines ($((100 * lines / eigen)) % of <Eigen/Core>), $functions functions"
  ((100 * lines <= $2 * eigen && functions <= $3)) || { echo "  more than $2 % or $3 functions"; failed=1; }
}

cat >"$build/cast.cpp" <<'END'
#include <graze/cast.hpp>
double toi(const graze::Body<double>& a, const graze::Body<double>& b) { return graze::cast(a, b).toi_lower; }
END
cat >"$build/rotating_cast.cpp" <<'END'
#include <graze/rotating_cast.hpp>
double toi(const graze::RotatingBody<double>& a, const graze::RotatingBody<double>& b) {
  return graze::cast(a, b).toi_lower;
}
END
cp "$source_dir/tests/consumer/project/two_boxes.cpp" "$build/two_boxes.cpp"
costs cast 112 100
costs rotating_cast 112 150
costs two_boxes 112 1800
exit $failed
