#!/usr/bin/env bash
# bench/plot_support.sh RESULTS.json PLOT.svg
#
# Draws what a support costs against the number of vertices, log-log: by the scan and by the map of directions, as
# doubles round it and as floats guess it; sphere, double, ns of processor time. RESULTS.json is what support_bench writes with
# --benchmark_out; of repetitions the median counts. Needs gnuplot and awk.
set -euo pipefail
(($# == 2)) || { sed -n '2s/^# /usage: /p' "$0" >&2; exit 2; }
results=$1 plot=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Lines "vertices ns" of one benchmark. Google Benchmark writes one field a line, the name before the time, and
# the median after the runs that it is of.
curve() {
  awk -v wanted="$1/sphere/double/" '
    {value = $2; gsub(/[",]/, "", value)}
    $1 == "\"name\":" {
      vertices = 0
      if (index(value, wanted) == 1) {
        rest = substr(value, length(wanted) + 1)
        if (rest ~ /^[0-9]+(_median)?$/) vertices = rest + 0
      }
    }
    $1 == "\"cpu_time\":" && vertices {ns[vertices] = value}
    END {for (v in ns) print v, ns[v]}
  ' "$results" | sort -n >"$work/$1"
  [[ -s $work/$1 ]] || { printf '%s: no results of %s/sphere/double in it\n' "$results" "$1" >&2; exit 2; }
}
curve scan_rounded
curve map_rounded
curve scan_guessed
curve map_guessed

gnuplot >"$work/plot.svg" <<END
set terminal svg size 640,400 font "sans-serif,13" background "white"
set logscale xy
set xrange [7:4700]
set yrange [8:4000]
set xtics (8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096)
set grid xtics ytics linecolor "#dddddd"
set border 3
set tics nomirror
set key top left reverse Left
set xlabel "vertices"
set ylabel "ns a support"
plot "$work/scan_rounded" with linespoints linewidth 2 pointtype 7 pointsize 0.5 linecolor "#0072b2" title "scan, double", \
     "$work/scan_guessed" with linespoints linewidth 2 pointtype 5 pointsize 0.5 linecolor "#d55e00" title "scan, guess", \
     "$work/map_rounded" with linespoints linewidth 2 pointtype 9 pointsize 0.7 linecolor "#009e73" title "map, double", \
     "$work/map_guessed" with linespoints linewidth 2 pointtype 11 pointsize 0.7 linecolor "#cc79a7" title "map, guess"
END
mv "$work/plot.svg" "$plot"
