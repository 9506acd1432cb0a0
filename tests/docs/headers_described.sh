#!/usr/bin/env bash
# usage: headers_described.sh SOURCE_DIR HEADER...
# Doxygen finds a description of every type, function, field and enumerator of the public headers, and warns of nothing else.
set -euo pipefail
cd "$1"
shift
command -v doxygen >/dev/null || { echo "doxygen is missing: packages.txt lists it"; exit 1; }
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
doxygen - >"$out/printed" 2>"$out/warnings" <<SETTINGS
INPUT = $(printf '"%s" ' "$@")
STRIP_FROM_PATH = .
OUTPUT_DIRECTORY = $out
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
JAVADOC_AUTOBRIEF = YES
EXTRACT_ALL = NO
WARN_IF_UNDOCUMENTED = YES
EXCLUDE_SYMBOLS = graze::detail
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
PREDEFINED = GRAZE_COMPILED
# Doxygen takes the name of an inline namespace for one that callers write.
INPUT_FILTER = "sed -E 's/^namespace graze \{ inline namespace GRAZE_LINKAGE/namespace graze/; s/^\}\}/}/'"
SETTINGS
if grep -v '^$' "$out/warnings"; then exit 1; fi
found=$(grep -ho 'kind="\(function\|struct\|class\|enum\|variable\)"' "$out"/xml/*.xml | wc -l)
((found >= 300)) || { echo "Doxygen finds only $found things in the headers: were they read?"; exit 1; }
echo "$found types, functions and fields, all described"
