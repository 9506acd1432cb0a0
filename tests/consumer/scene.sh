#!/usr/bin/env bash
# Somebody's game links graze::scene through the installed package, by CMake and by pkg-config. graze::graze alone needs no
# threads.
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

# The same by pkg-config, as Meson and Autotools ask.
export PKG_CONFIG_PATH="$scratch/prefix/lib/pkgconfig"
[[ $(pkg-config --modversion graze) == "$version" ]] || { echo "graze.pc has another version"; exit 1; }
run "$cxx" -std=c++20 -O1 "$source_dir/tests/consumer/scene/main.cpp" $(pkg-config --cflags --libs graze-scene) \
  -o "$build/game_by_pkg_config"
[[ $("$build/game_by_pkg_config") == "wall meets crate at 0.5" ]] || { "$build/game_by_pkg_config"; exit 1; }
