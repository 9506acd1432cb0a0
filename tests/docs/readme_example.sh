#!/usr/bin/env bash
# usage: readme_example.sh SOURCE_DIR EXECUTABLE
set -euo pipefail
shown=$(sed -n '/^```cpp$/,/^```$/p' "$1/README.md" | sed '1d;$d')
diff <(printf '%s\n' "$shown") "$1/examples/ball_and_floor.cpp" || { echo "README.md shows another example"; exit 1; }
printed=$("$2")
echo "$printed"
# (10 - 0.5166) / 20
grep -q '^touch at t = 0\.4741[67]' <<<"$printed" && grep -q '^proved: 0\.4741' <<<"$printed"
