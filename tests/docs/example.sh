#!/usr/bin/env bash
# usage: example.sh SOURCE_DIR PAGE NAME EXECUTABLE PATTERN...
# PAGE shows examples/NAME.cpp, line for line, and what the executable prints has a line for each pattern.
set -euo pipefail
source=$1 page=$2 name=$3 executable=$4
shift 4
shown=$(mktemp -d)
trap 'rm -rf "$shown"' EXIT
awk -v begin='^```cpp$' -v end='^```$' -v to="$shown/" -f "$(dirname "$0")/blocks.awk" "$source/$page"
found=
for block in "$shown"/*; do
  if cmp -s "$block" "$source/examples/$name.cpp"; then found=1; fi
done
[[ $found ]] || { echo "$page does not show examples/$name.cpp as it is"; exit 1; }
printed=$("$executable")
echo "$printed"
for pattern; do
  grep -qE "$pattern" <<<"$printed" || { echo "nothing printed matches $pattern"; exit 1; }
done
