#!/usr/bin/env bash
# Builds tests/consumer/project with a user's flags, runs it, and has its answers judged.
# usage: variant.sh SETTINGS NAME installed|subdirectory STANDARD COMPILER FLAGS MODES
#
# Modes: plain; flush (the program flushes subnormals); fast_link (linked with -ffast-math, which flushes them).
set -euo pipefail
source "$1"
name=$2 source=$3 standard=$4 compiler=$5 flags=$6 modes=$7
build="$scratch/$name"
rm -rf "$build"
mkdir -p "$build"

run() { "$@" >"$build/log" 2>&1 || { cat "$build/log"; exit 1; }; }

options=(-DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags" -DCMAKE_CXX_STANDARD="$standard"
  -DCMAKE_CXX_EXTENSIONS=OFF -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DEigen3_DIR="$eigen_dir" -DGRAZE_VERSION="$version")
[[ -z $launcher ]] || options+=(-DCMAKE_CXX_COMPILER_LAUNCHER="$launcher")
# Header-only, where the user's flags reach graze; the variant that is called library links the compiled one.
target=graze::core
[[ $name != *library* ]] || target=graze::graze
options+=(-DGRAZE_TARGET="$target")
if [[ $source == installed ]]; then
  options+=(-DCMAKE_PREFIX_PATH="$scratch/prefix")
else
  options+=(-DGRAZE_SUBDIRECTORY="$source_dir" -DEVERY_HEADER=ON)
fi
# Once header-only by another compiler, once compiled.
[[ $source != subdirectory && $name != *library* ]] || options+=(-DKEPT=ON)
run "$cmake" -S "$source_dir/tests/consumer/project" -B "$build" --no-warn-unused-cli "${options[@]}" "${without[@]}"

# The user's flags, the standard, include paths: nothing of ours may be among them.
command=$(grep -m1 '"command".*main.cpp' "$build/compile_commands.json")
seen=$(grep -oE ' -[A-Zfmstdw][^ ]*' <<<"$command" | grep -vE '^ -(I|isystem|DGRAZE_COMPILED)' | sort | tr -d '\n')
wanted=$(printf ' %s\n' $flags -std=c++"$standard" | sed 's/c++23/c++2b/' | sort | tr -d '\n')
[[ ${seen/c++23/c++2b} == "$wanted" ]] || { echo "compiled with$seen"; echo "wanted       $wanted"; exit 1; }
# With a subdirectory the headers are the user's own as to warnings.
[[ $source == installed ]] || grep -qE -- "-I *$source_dir/core" <<<"$command" || { echo "not by -I: $command"; exit 1; }

run "$cmake" --build "$build" -j2
if [[ $flags == *-mfma* ]] && ! grep -qw fma /proc/cpuinfo; then
  echo "built; not run: this processor has no fused multiply-add"
  exit 77
fi
reference_answers="$build/reference"
mkdir -p "$reference_answers"
run "$reference" "$reference_answers"
[[ ! -x $build/consumer_kept ]] || "$build/consumer_kept"
for mode in $modes; do
  program="$build/consumer" argument=""
  case $mode in
    flush) argument=flush ;;
    fast_link) program="$build/consumer_fast_link" argument=flushed ;;
  esac
  mkdir -p "$build/$mode"
  "$program" "$build/$mode" $argument | sed "s/^/$mode: /"
  "$judge" "$reference_answers" "$build/$mode"
done
