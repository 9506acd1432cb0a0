#!/usr/bin/env bash
# What would void the bounds does not compile, and says why. usage: refused_flags.sh SETTINGS
set -euo pipefail
source "$1"
failed=0
for compiler in "$cxx" "$clang"; do
  compile=("$compiler" -std=c++20 -E -o /dev/null -I"$source_dir/core" -isystem "$eigen_include" "$source_dir/tests/consumer/project/two_boxes.cpp")
  # #error is the preprocessor's: nothing else need run.
  "${compile[@]}" -O2 || { echo "$compiler: refuses them without the flags too"; exit 1; }
  for flag in -ffast-math -Ofast; do
    if said=$("${compile[@]}" $flag 2>&1); then
      echo "$compiler $flag: accepted"
      failed=1
    elif ! grep -q 'graze: -ffast-math voids' <<<"$said"; then
      echo "$compiler $flag: refused with another reason:"
      head -5 <<<"$said"
      failed=1
    fi
  done
done
exit $failed
