#!/usr/bin/env bash
# Installs the judge, moves what was installed, and lets somebody else's project (judged/) be judged through
# find_package(graze COMPONENTS judge): a right cast passes, and ctest's output names each planted bug.
# usage: judged.sh SETTINGS BUILD_DIR
set -euo pipefail
source "$1"
build="$scratch/judged" prefix="$scratch/judge"
rm -rf "$build" "$prefix" "$prefix-made"
"$cmake" --install "$2" --prefix "$prefix-made" >"$scratch/judge.log"
mv "$prefix-made" "$prefix"
# The corpus is the one beside the command.
"$prefix/bin/graze" cast "$prefix"/share/graze/corpus/cases/*.json >"$scratch/cast.log"
! grep -rlF -e "$scratch" "$prefix/lib" || { echo "the package names the folder that it was installed to"; exit 1; }
"$cmake" -S "$source_dir/tests/consumer/judged" -B "$build" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$cxx" >"$build.log" 2>&1 ||
  { cat "$build.log"; exit 1; }
"$cmake" --build "$build" >>"$build.log" 2>&1 || { cat "$build.log"; exit 1; }
judge() { (cd "$build" && ctest --output-on-failure -R "^$1_cast\.random$") >"$build/$1.log" 2>&1; }
judge right || { cat "$build/right.log"; exit 1; }
convicted() {
  ! judge "$1" || { echo "$1: not convicted"; cat "$build/$1.log"; exit 1; }
  grep -q "$2" "$build/$1.log" || { echo "$1: the output does not say: $2"; cat "$build/$1.log"; exit 1; }
}
convicted late "late"
convicted flipped "contact off\|normal"
convicted falling "SIGABRT"
convicted lacking "does not take the shape hull"
for engine in late flipped falling; do
  grep -q "<failure" "$build/$engine-random.xml"
  [[ -s $build/$engine-random.jsonl ]]
done
echo "a right cast passes; late, flipped, falling and lacking ones are named"
