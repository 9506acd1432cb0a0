#!/bin/sh
# Builds the site as ./run docs does and opens it in a browser: site.sh GRAZE VIEWER-BUILT NODE CHROMIUM FOLDER.
set -eu
graze=$1 built=$2 node=$3 chromium=$4 folder=$5
here=$(dirname "$0")
skip() { echo "skipped: $1"; exit 77; }
[ "$built" = ON ] || skip "this build has no viewer (GRAZE_VIEWER)"
case $node in ''|*-NOTFOUND) skip "there is no Node (Debian: nodejs)";; esac
case $chromium in ''|*-NOTFOUND) skip "there is no chromium (Debian: chromium)";; esac
command -v doxygen >/dev/null || skip "there is no doxygen (Debian: doxygen)"
[ -d /usr/share/doxygen-awesome-css ] || skip "there is no style for doxygen (Debian: doxygen-awesome-css)"
mkdocs build --help >/dev/null 2>&1 || skip "there is no mkdocs (Debian: mkdocs-material)"
[ -d /usr/share/mkdocs/themes/material ] || skip "there is no theme for mkdocs (Debian: mkdocs-material)"
python3 -B "$here/../../docs/site/build.py" --graze "$graze" --work "$folder/work" --out "$folder/site"
exec "$node" "$here/site_test.mjs" "$chromium" "$folder/site"
