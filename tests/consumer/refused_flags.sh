#!/usr/bin/env bash
# What would void the bounds does not compile, and says why; or, of the two flags of which clang says nothing
# before the program runs, the door of every query refuses its input. usage: refused_flags.sh SETTINGS
set -euo pipefail
source "$1"
failed=0
program="$source_dir/tests/consumer/project/arithmetic.cpp"
include=(-std=c++20 -I"$source_dir/core" -isystem "$eigen_include")

# refused COMPILER REASON FLAG...
refused() {
  local compiler=$1 reason=$2 said
  shift 2
  # The preprocessor's #error, or clang's of a pragma, which -fsyntax-only shows without optimising; it is the first.
  if said=$("$compiler" "${include[@]}" -fsyntax-only -Wfatal-errors -O2 "$@" "$program" 2>&1); then
    echo "$compiler $*: accepted"
    failed=1
  elif ! grep -q "$reason" <<<"$said"; then
    echo "$compiler $*: refused with another reason:"
    head -5 <<<"$said"
    failed=1
  fi
}

says='graze: -ffast-math voids'
# The line above the pragma says why; clang shows the pragma.
shows='flags.hpp.*float_control.*is illegal when precise is disabled'
for compiler in "$cxx" "$clang"; do
  "$compiler" "${include[@]}" -fsyntax-only -O2 "$program" || { echo "$compiler: refuses them without the flags too"; exit 1; }
  for flag in -ffast-math -Ofast -ffinite-math-only; do refused "$compiler" "$says" $flag; done
  [[ $compiler == "$clang" ]] && reason=$shows || reason=$says
  refused "$compiler" "$reason" -funsafe-math-optimizations
  refused "$compiler" "$reason" -fassociative-math -fno-signed-zeros -fno-trapping-math
  refused "$compiler" "$reason" -freciprocal-math
  refused "$compiler" "$reason" -fno-signed-zeros
  refused "$compiler" "$reason" -ffast-math -fno-finite-math-only
done
refused "$cxx" "$says" -ffast-math -fno-associative-math -fno-reciprocal-math -fno-finite-math-only
refused "$clang" "$says" -fno-honor-nans -fno-honor-infinities
refused "$clang" "$says" -ffp-model=fast
refused "$clang" "$shows" -fapprox-func

# The same where clang ignores the pragma, as it does for other processors: a copy of the headers without it.
copy="$scratch/without_pragma"
rm -rf "$copy"
mkdir -p "$copy"
cp -r "$source_dir/core/graze" "$copy/graze"
sed -i '/^#pragma float_control/d' "$copy/graze/detail/numeric/flags.hpp"
# at_run_time kept|refused HEADERS FLAG...: what the door says.
at_run_time() {
  local wanted=$1 headers=$2 said
  shift 2
  "$clang" -std=c++20 -I"$headers" -isystem "$eigen_include" "$@" -o "$scratch/arithmetic" "$program"
  said=$("$scratch/arithmetic")
  [[ $said == "$wanted" ]] || { echo "$clang $*: $said, wanted $wanted"; failed=1; }
}
for optimise in -O1 "-O3 -march=native"; do
  at_run_time kept "$source_dir/core" $optimise
  at_run_time kept "$copy" $optimise
  at_run_time refused "$source_dir/core" $optimise -fno-honor-nans
  at_run_time refused "$source_dir/core" $optimise -fno-honor-infinities
  at_run_time refused "$copy" $optimise -funsafe-math-optimizations
  at_run_time refused "$copy" $optimise -fassociative-math -fno-signed-zeros -fno-trapping-math
  at_run_time refused "$copy" $optimise -freciprocal-math
done
exit $failed
