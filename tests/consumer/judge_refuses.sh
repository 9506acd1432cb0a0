#!/usr/bin/env bash
# The judge of a consumer's answers refuses planted faults. usage: judge_refuses.sh SETTINGS
set -euo pipefail
source "$1"
build="$scratch/judge_refuses"
rm -rf "$build"
mkdir -p "$build/all" "$build/right"
"$reference" "$build/all" >/dev/null
for file in answers.txt proofs.jsonl; do head -n 1000 "$build/all/$file" >"$build/right/$file"; done
"$judge" "$build/right" "$build/right"

# plant NAME FILE SED_PROGRAM FAULT: one line changed, and the judge names the fault.
plant() {
  cp -r "$build/right" "$build/$1"
  sed -i "$3" "$build/$1/$2"
  ! cmp -s "$build/$1/$2" "$build/right/$2" || { echo "$1: nothing was changed"; exit 1; }
  if said=$("$judge" "$build/right" "$build/$1"); then
    echo "$1: accepted"
    exit 1
  fi
  grep -q "$4" <<<"$said" || { echo "$1: refused with another reason: $said"; exit 1; }
  echo "$1: $(head -1 <<<"$said" | cut -c1-160)"
}
# The first line of the answers is the ball on the floor, by conservative advancement: a hit at 0.475.
plant late_time answers.txt '1s/^hit 0x[^ ]* 0x[^ ]*/hit 0x1.e7p-2 0x1.e7p-2/' 'late by a depth'
plant early_time answers.txt '1s/^hit 0x[^ ]* 0x[^ ]*/hit 0x1.e6p-2 0x1.e6p-2/' 'is early by'
plant false_proof proofs.jsonl '1s/"proof": {"toi_lower": "0x[^"]*"/"proof": {"toi_lower": "0x1.e7p-2"/' 'proof refused'
plant other_scene proofs.jsonl '1s/"radius": "0x1p-1"/"radius": "0x1.8p-1"/' 'the scene differs'
sed '1s/^hit .*/miss inf inf 0 0 0 0 0 0 0 0 0/' "$build/right/answers.txt" >"$build/miss"
plant wrong_miss proofs.jsonl '1s/"outcome": "hit"/"outcome": "miss"/' 'does not go with'
cp "$build/miss" "$build/wrong_miss/answers.txt"
said=$("$judge" "$build/right" "$build/wrong_miss") && { echo "wrong_miss: accepted"; exit 1; }
grep -q 'miss claimed of a path of depth' <<<"$said" || { echo "wrong_miss: refused with another reason: $said"; exit 1; }
echo "wrong_miss: $(head -1 <<<"$said" | cut -c1-160)"
