#!/usr/bin/env bash
# bench/plot_rotating.sh RESULTS.md PLOT.svg
#
# Draws what a rotating cast costs against what it leaves open, log-log: conservative and bilateral advancement by
# their tolerance, time steps by the motion that could hide between two. RESULTS.md is what rotating_bench prints.
# Needs gnuplot and awk.
set -euo pipefail
(($# == 2)) || { sed -n '2s/^# /usage: /p' "$0" >&2; exit 2; }
results=$1 plot=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Lines "open microseconds" of one curve.
for kind in ordinary fast; do
  for method in steps conservative bilateral; do
    awk -F ' *[|] *' -v curve="$kind/$method" '$2 == curve {print $3, $4}' "$results" >"$work/$kind-$method"
    [[ -s $work/$kind-$method ]] || { printf '%s: no curve %s in it\n' "$results" "$kind/$method" >&2; exit 2; }
  done
done

gnuplot >"$work/plot.svg" <<END_OF_PLOT
set terminal svg size 680,400 font "sans-serif,13" background "white"
set logscale xy
set xrange [10:5e-13]
set xtics ("1" 1, "10^{-2}" 1e-2, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, "10^{-10}" 1e-10, "10^{-12}" 1e-12)
set grid xtics ytics linecolor "#dddddd"
set border 3
set tics nomirror
set key outside bottom center horizontal reverse Left width 2
set xlabel "what is left open, over scale"
set ylabel "microseconds a cast"
set style data linespoints
plot "$work/ordinary-steps" linewidth 2 pointtype 7 pointsize 0.5 linecolor "#0072b2" title "steps", \
     "$work/ordinary-conservative" linewidth 2 pointtype 5 pointsize 0.5 linecolor "#d55e00" title "conservative", \
     "$work/ordinary-bilateral" linewidth 2 pointtype 9 pointsize 0.7 linecolor "#009e73" title "bilateral", \
     "$work/fast-steps" dashtype 2 linewidth 2 pointtype 6 pointsize 0.5 linecolor "#0072b2" \
       title "steps, fast spin", \
     "$work/fast-conservative" dashtype 2 linewidth 2 pointtype 4 pointsize 0.5 linecolor "#d55e00" \
       title "conservative, fast spin", \
     "$work/fast-bilateral" dashtype 2 linewidth 2 pointtype 8 pointsize 0.7 linecolor "#009e73" \
       title "bilateral, fast spin"
END_OF_PLOT
mv "$work/plot.svg" "$plot"
