#!/usr/bin/env bash
# Every source is laid out by clang-format with the repository's settings. usage: format.sh SOURCE_DIR
set -euo pipefail
cd "$1"
command -v clang-format-14 >/dev/null || { echo "clang-format-14 is missing: packages.txt lists it"; exit 1; }
mapfile -t files < <(find core scene adapter corpus oracles engines external properties price report draw show viewer certify fuzz tools tests bench examples \
  -path viewer/node_modules -prune -o \( -name '*.hpp' -o -name '*.h' -o -name '*.cpp' \) -print | sort)
((${#files[@]} > 20)) || { echo "found only ${#files[@]} sources: wrong folder?"; exit 1; }
# By its output: --dry-run takes the comment that ends an inline namespace for wrong, and would write the same.
failed=0
for file in "${files[@]}"; do
  clang-format-14 "$file" | diff -q - "$file" >/dev/null || { echo "$file: not as clang-format lays it out"; failed=1; }
done
((failed)) || echo "${#files[@]} sources are laid out as .clang-format says"
exit $failed
