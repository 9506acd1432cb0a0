#!/usr/bin/env bash
# The Debian package: made, unpacked into a folder of its own, moved, and used from there. It says which licence is whose,
# and the engine of a template is judged by it.
# usage: package.sh SETTINGS BUILD_DIR
set -euo pipefail
source "$1"
for tool in dpkg-deb dpkg-shlibdeps c++ python3; do
  command -v "$tool" >/dev/null || { echo "no $tool: skipped"; exit 77; }
done
made="$scratch/package" root="$scratch/root"
rm -rf "$made" "$root" "$root-made"
"${cmake%cmake}cpack" -B "$made" --config "$2/CPackConfig.cmake" -D CPACK_COMPONENTS_ALL=command >"$scratch/cpack.log" 2>&1 ||
  { cat "$scratch/cpack.log"; exit 1; }
package=$(echo "$made"/graze_*.deb)
dpkg-deb --info "$package" >"$scratch/info"
for words in "Package: graze" "Depends:.*libc6" "MIT" "GPL, version 3"; do
  grep -q "$words" "$scratch/info" || { echo "the package does not say: $words"; cat "$scratch/info"; exit 1; }
done
dpkg-deb -x "$package" "$root-made"
mv "$root-made" "$root"
usr="$root/usr"
fail() { echo "$1"; exit 1; }
[[ $("$usr/bin/graze" --version)-1 == "graze $(dpkg-deb -f "$package" Version)" ]] || fail "graze --version is not the package's"
for file in share/doc/graze/copyright share/graze/templates/engine.c share/graze/schemas share/graze/corpus/flags.json \
  include/graze_adapter.hpp include/graze_engine.h; do
  [[ -e $usr/$file ]] || fail "the package lacks $file"
done
grep -A2 "^Files: usr/bin/graze" "$usr/share/doc/graze/copyright" | grep -q "License: GPL-3+" || fail "whose is the GPL?"
grep -q "^License: MIT" "$usr/share/doc/graze/copyright" || fail "whose is MIT?"
if grep -rlF -e "$source_dir" "$usr"; then fail "these name the folder that they were built from"; fi
# By what is in it, and nothing of where it was built.
cd "$scratch"
templates="$usr/share/graze/templates"
c++ -std=c++17 -I"$usr/include" "$templates/engine.cpp" -o "$scratch/packaged_engine"
env -i PATH="$PATH" "$usr/bin/graze" certify --engine "$scratch/packaged_engine" --family random --count 40 --time-limit 10
env -i PATH="$PATH" "$usr/bin/graze" certify --engine "python3 '$templates/engine.py'" --count 0 --rotating 0 --queries 0 --time-limit 10
echo "packed, moved, and used: $(basename "$package")"
