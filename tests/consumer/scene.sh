#!/usr/bin/env bash
# Somebody's game links graze::scene through the installed package; who asks for no scene needs no threads.
# usage: scene.sh SETTINGS
set -euo pipefail
source "$1"
build="$scratch/scene"
rm -rf "$build"
run() { "$@" >"$build.log" 2>&1 || { cat "$build.log"; exit 1; }; }
run "$cmake" -S "$source_dir/tests/consumer/scene" -B "$build" -DCMAKE_PREFIX_PATH="$scratch/prefix" \
  -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_BUILD_TYPE=Release -DEigen3_DIR="$eigen_dir"
run "$cmake" --build "$build"
[[ $("$build/game") == "wall meets crate at 0.5" ]] || { "$build/game"; exit 1; }
if grep -q Threads "$scratch/prefix/lib/cmake/graze/graze-targets.cmake"; then
  echo "graze::graze asks for threads"
  exit 1
fi
