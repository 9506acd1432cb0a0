#!/bin/sh
# Makes a page of a kind and looks at it in a browser: run.sh KIND GRAZE VIEWER-BUILT NODE CHROMIUM FOLDER.
set -eu
kind=$1 graze=$2 built=$3 node=$4 chromium=$5 folder=$6
here=$(dirname "$0")
skip() { echo "skipped: $1"; exit 77; }
[ "$built" = ON ] || skip "this build has no viewer (GRAZE_VIEWER)"
case $node in ''|*-NOTFOUND) skip "there is no Node (Debian: nodejs)";; esac
case $chromium in ''|*-NOTFOUND) skip "there is no chromium (Debian: chromium)";; esac
rm -rf "$folder"
mkdir -p "$folder"
case $kind in
  show)
    # A box and a cone, one answer right and one late: what differs is drawn.
    page=$folder/show.html
    "$graze" show "$here/pair.json" --method mpr/float --answers "$here/pair_answers.jsonl" --out "$page"
    grep -q '"faults":\["late"' "$page" || { echo "FAILED: the late answer is not said to be late"; exit 1; }
    ;;
  play)
    # One scene that turns, one of two on a page with rays and casts.
    page=$folder/index.html
    "$graze" scene "$here/../../../examples/scenes/fan.json" "$here/../../../examples/scenes/crowd.json" --report "$folder" > "$folder/out.txt"
    size=$(wc -c < "$page")
    [ "$size" -lt 2000000 ] || { echo "FAILED: the page has $size bytes"; exit 1; }
    ;;
  report)
    page=$folder/index.html
    "$graze" certify --family random --family slow_spin --count 6 --rotating 2 --queries 4 --report-cases 6 \
      --report "$folder" > "$folder/out.txt"
    # Without cases a report is to stay below 2 MB.
    "$graze" certify --family random --count 6 --queries 0 --report-cases 0 --report "$folder/none" > "$folder/none.txt"
    size=$(wc -c < "$folder/none/index.html")
    [ "$size" -lt 2000000 ] || { echo "FAILED: without cases the page has $size bytes"; exit 1; }
    "$node" "$here/page_test.mjs" "$chromium" other "$folder/none/index.html"
    ;;
  price)
    page=$folder/price.html
    "$graze" report "$here/price.json" --out "$page"
    ;;
esac
exec "$node" "$here/page_test.mjs" "$chromium" "$kind" "$page"
