#!/usr/bin/env bash
# Packs the command with the libraries that it needs beyond the C library, so that it runs on any Linux whose glibc is at
# least as new as this one's. usage: movable.sh BUILD_DIR FOLDER
set -euo pipefail
folder=graze-$(uname -m)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
made=$work/$folder
cmake --install "$1" --component command --strip --prefix "$made" >&2
rm -r "$made/share/lintian"
mkdir -p "$made/lib/graze"
ldd "$made/bin/graze" | awk '$3 ~ /^\// && $1 !~ /^lib(c|m|dl|pthread|rt)\.so/ {print $3}' | while read -r library; do
  cp -L "$library" "$made/lib/graze"
  package=$(dpkg -S "*/$(uname -m)-linux-gnu/$(basename "$library")" | sed -n '1s/:.*//p')
  cp "/usr/share/doc/$package/copyright" "$made/lib/graze/$package.copyright"
done
patchelf --force-rpath --set-rpath "\$ORIGIN/../lib/graze" "$made/bin/graze"
tar -C "$work" --owner=0 --group=0 -czf "$2/$folder.tar.gz" "$folder"
