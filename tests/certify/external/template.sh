#!/usr/bin/env bash
# A template of engines/adapter/templates, built as its first lines say, keeps its word on casts of balls. 77: there is nothing to
# build or run it with.
# usage: template.sh GRAZE SOURCE_DIR LANGUAGE
set -euo pipefail
graze=$1 adapter=$2/engines/adapter scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
needs() { command -v "$1" >/dev/null || { echo "no $1: skipped"; exit 77; }; }
case $3 in
cpp) needs c++; c++ -std=c++17 -I"$adapter" "$adapter/templates/engine.cpp" -o "$scratch/engine"; engine=$scratch/engine ;;
c) needs cc; cc -shared -fPIC -I"$adapter" "$adapter/templates/engine.c" -o "$scratch/engine.so" -lm; engine=$scratch/engine.so ;;
rust) needs rustc; rustc --edition 2021 -O "$adapter/templates/engine.rs" -o "$scratch/engine"; engine=$scratch/engine ;;
python) needs python3; engine="python3 '$adapter/templates/engine.py'" ;;
javascript) needs node; engine="node '$adapter/templates/engine.mjs'" ;;
esac
"$graze" certify --engine "$engine" --family random --count 40 --time-limit 10 --needs-shape sphere --needs-answer normal
# Bodies that come from so far away that their gap at the time of contact, computed from its ends, is 0; and points.
"$graze" generate mixed_magnitudes --hardness 50 --seed 6659650559527815310 --count 1 >"$scratch/far.jsonl"
cat >>"$scratch/far.jsonl" <<'EOF'
{"schema": "graze.case/1", "id": "points", "family": "points", "a": {"shape": {"type": "sphere", "radius": 0}}, "b": {"shape": {"type": "sphere", "radius": 0}, "position": [2, 0, 0], "displacement": [-4, 0, 0]}}
EOF
"$graze" certify "$scratch/far.jsonl" --engine "$engine" --time-limit 10
# What it lacks is said in a line.
if "$graze" certify --engine "$engine" --family random --count 40 --needs-shape cone 2>"$scratch/error"; then exit 1; fi
grep -q "does not take the shape cone" "$scratch/error"
