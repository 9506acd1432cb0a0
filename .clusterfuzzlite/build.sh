#!/bin/bash -eu
# Builds every target of fuzz/targets.txt into $OUT, with its seeds, as ClusterFuzzLite and OSS-Fuzz want it. They set
# CC, CXX, CFLAGS, CXXFLAGS (sanitizer and engine included), LIB_FUZZING_ENGINE, SRC, OUT and WORK.
set -o pipefail
: "${SRC:?}" "${OUT:?}" "${WORK:?}" "${CXX:?}" "${LIB_FUZZING_ENGINE:?}"
source=$SRC/graze
build=$WORK/graze

# The packages that the oracles stand on (GMP, MPFR, FLINT, fmt) are built for libstdc++.
export CXXFLAGS="${CXXFLAGS//-stdlib=libc++/}"
arb=()
if [[ ! -e /usr/include/arb.h && -e /usr/include/flint/arb.h ]]; then
  # Since FLINT 3, Arb is part of it.
  CXXFLAGS+=" -isystem /usr/include/flint"
  arb=("-DGRAZE_ARB=flint")
fi

targets=$(sed -n 's/^\([a-z][a-z0-9_]*\) .*/\1/p' "$source/fuzz/targets.txt")
cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DGRAZE_FUZZ=ON \
  -DGRAZE_FUZZ_ENGINE="$LIB_FUZZING_ENGINE" "-DCMAKE_EXE_LINKER_FLAGS=-Wl,-rpath,'\$ORIGIN/lib'" "${arb[@]}"
read -ra programs <<<"graze_fuzz_${targets//$'\n'/ graze_fuzz_}"
cmake --build "$build" --target "${programs[@]}"

# The machines that run the targets lack the libraries: they travel along.
mkdir -p "$OUT/lib"
for target in $targets; do
  cp "$build/fuzz/graze_fuzz_$target" "$OUT/"
  ldd "$OUT/graze_fuzz_$target" | awk '/=> \/.*\/lib(gmp|gmpxx|mpfr|flint|flint-arb|fmt|stdc\+\+)[-.]/ {print $3}' |
    while read -r library; do cp -L "$library" "$OUT/lib/"; done
  pool=$(awk -v target="$target" '$1 == target {print $2}' "$source/fuzz/targets.txt")
  seeds=()
  for folder in "$source/fuzz/seeds/$pool" "$source/fuzz/findings/$target"; do
    if [[ -d $folder ]]; then seeds+=("$folder"); fi
  done
  if ((${#seeds[@]})); then zip -q -j -r "$OUT/graze_fuzz_${target}_seed_corpus.zip" "${seeds[@]}"; fi
  if [[ -e $source/fuzz/dictionaries/$target.dict ]]; then
    cp "$source/fuzz/dictionaries/$target.dict" "$OUT/graze_fuzz_$target.dict"
  fi
  if [[ -e $source/fuzz/options/$target.options ]]; then
    cp "$source/fuzz/options/$target.options" "$OUT/graze_fuzz_$target.options"
  fi
done
