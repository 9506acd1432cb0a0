#!/usr/bin/env bash
# clang-tidy on every source that includes neither CGAL nor RapidCheck, nor other people's engines (engines/zoo), and on
# each public header by itself. Sources that the build compiles several at once are looked at several at once; then each
# is only parsed, by itself. All without our precompiled headers, so that what a file uses and does not include is an error.
# usage: tidy.sh SOURCE_DIR BUILD_DIR
set -euo pipefail
cd "$1"
command -v clang-tidy-14 >/dev/null || { echo "clang-tidy-14 is missing: packages.txt lists it"; exit 1; }
plain=$2/without_precompiled_headers
rooms=(certify corpus engines examples fuzz properties reports scene tools)
mapfile -t sources < <(grep -LE 'CGAL|rapidcheck|properties/generate/generators' $(find "${rooms[@]}" \
  -path engines/zoo -prune -o -path reports/viewer/node_modules -prune -o -name '*.cpp' -print | sort))
((${#sources[@]} > 10)) || { echo "found only ${#sources[@]} sources: wrong folder?"; exit 1; }
printf '%s\n' "${sources[@]}" | python3 -B tests/style/tidy_files.py "$2/compile_commands.json" "$plain" core/graze/*.hpp
failed=0
said=$(xargs -a "$plain/united.txt" -n 1 -P 2 clang-tidy-14 --quiet --extra-arg=-Wno-unknown-warning-option -p "$plain" \
  2>&1) || failed=1
grep -vE 'warnings generated|^$' <<<"$said" || true
xargs -a "$plain/parts.txt" -d '\n' -n 1 -P 2 sh -c || failed=1
((failed)) || echo "${#sources[@]} sources and the public headers are tidy"
exit $failed
