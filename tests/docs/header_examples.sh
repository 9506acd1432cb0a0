#!/usr/bin/env bash
# usage: header_examples.sh OUT.cpp HEADER...
# Writes a program that runs the examples of the headers: the blocks between @code and @endcode of their comments. Each block
# is the body of a function, and asserts what it says.
set -euo pipefail
out=$1
shift
here=$(dirname "$0")
blocks=$(mktemp -d)
trap 'rm -rf "$blocks"' EXIT
functions= calls= count=0
echo "#undef NDEBUG" >"$out"
for header; do
  echo "#include <graze/${header##*/graze/}>" >>"$out"
  rm -f "$blocks"/*
  awk -v begin='^@code$' -v end='^@endcode$' -v to="$blocks/" -f "$here/blocks.awk" "$header"
  for block in "$blocks"/*; do
    [[ -f $block ]] || continue
    name=example_$((++count))
    functions+="// ${header##*/graze/}"$'\n'"void $name() {"$'\n'"$(<"$block")"$'\n'"}"$'\n'
    calls+="  $name();"$'\n'
  done
done
((count >= 30)) || { echo "only $count examples in the headers: were they read?"; exit 1; }
{
  printf '#include <%s>\n' cassert cmath cstdio string vector
  printf 'namespace {\n%s}  // namespace\nint main() {\n%s  std::puts("%d examples");\n}\n' "$functions" "$calls" "$count"
} >>"$out"
