#!/usr/bin/env bash
# Every source is laid out by clang-format with the repository's settings. usage: format.sh SOURCE_DIR [--write]
# --write: those that are not are laid out so; no other is written, as a file's new date compiles all that includes it.
set -euo pipefail
cd "$1"
command -v clang-format-14 >/dev/null || { echo "clang-format-14 is missing: packages.txt lists it"; exit 1; }
mapfile -t files < <(find core scene corpus oracles engines properties reports certify fuzz tools tests bench examples \
  -path reports/viewer/node_modules -prune -o \( -name '*.hpp' -o -name '*.h' -o -name '*.cpp' \) -print | sort)
((${#files[@]} > 20)) || { echo "found only ${#files[@]} sources: wrong folder?"; exit 1; }
# Copies are laid out, all at once, and compared: --dry-run takes the comment that ends an inline namespace for wrong,
# and would write the same; a process a file takes twenty times as long.
copies=$(mktemp -d)
trap 'rm -rf "$copies"' EXIT
cp --parents .clang-format core/.clang-format "${files[@]}" "$copies"
(cd "$copies" && printf '%s\0' "${files[@]}" | xargs -0 -n 200 -P "$(nproc)" clang-format-14 -i)
failed=0
for file in "${files[@]}"; do
  cmp -s "$copies/$file" "$file" && continue
  if [ "${2:-}" = --write ]; then
    cat "$copies/$file" > "$file"
    echo "$file: laid out anew"
  else
    echo "$file: not as clang-format lays it out"
    failed=1
  fi
done
((failed)) || echo "${#files[@]} sources are laid out as .clang-format says"
exit $failed
