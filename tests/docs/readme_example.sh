#!/usr/bin/env bash
# usage: readme_example.sh SOURCE_DIR NAME EXECUTABLE PATTERN...
# README.md shows examples/NAME.cpp, line for line, and what the executable prints has a line for each pattern.
set -euo pipefail
source=$1 name=$2 executable=$3
shift 3
shown=$(mktemp -d)
trap 'rm -rf "$shown"' EXIT
awk -v to="$shown" '/^```cpp$/ {file = to "/" ++k; next} /^```$/ {file = ""} file {print > file}' "$source/README.md"
found=
for block in "$shown"/*; do
  if cmp -s "$block" "$source/examples/$name.cpp"; then found=1; fi
done
[[ $found ]] || { echo "README.md does not show examples/$name.cpp as it is"; exit 1; }
printed=$("$executable")
echo "$printed"
for pattern; do
  grep -qE "$pattern" <<<"$printed" || { echo "nothing printed matches $pattern"; exit 1; }
done
