#!/usr/bin/env bash
# clang-tidy on every source that includes neither CGAL nor RapidCheck. usage: tidy.sh SOURCE_DIR BUILD_DIR
set -euo pipefail
cd "$1"
command -v clang-tidy-14 >/dev/null || { echo "clang-tidy-14 is missing: packages.txt lists it"; exit 1; }
mapfile -t files < <(grep -LE 'CGAL|rapidcheck|properties/generate/generators' $(find certify corpus draw engines fuzz properties report tools examples \
  -name '*.cpp' | sort))
((${#files[@]} > 10)) || { echo "found only ${#files[@]} sources: wrong folder?"; exit 1; }
said=$(printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P 2 clang-tidy-14 --quiet --extra-arg=-Wno-unknown-warning-option -p "$2" 2>&1) && failed=0 || failed=1
grep -vE 'warnings generated|^$' <<<"$said" || true
((failed)) || echo "${#files[@]} sources are tidy"
exit $failed
