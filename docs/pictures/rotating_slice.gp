# gnuplot docs/pictures/rotating_slice.gp > docs/pictures/rotating_slice.svg
# The gap along y between a box of half extents 1, 1/8 that turns by 20 radians a unit of t about its centre, and
# one whose lower side is at y = 1; chords and bounds of the slices [0, 0.0434] and [0, 0.125].
set terminal svg size 640,360 font "sans-serif,13" background "white"
s(t) = 1 - abs(sin(20 * t)) - abs(cos(20 * t)) / 8
bend = 20 ** 2 * sqrt(1 + 1.0 / 64)
chord(t, h) = t <= h ? s(0) + (s(h) - s(0)) * t / h : 1 / 0
bound(t, h) = chord(t, h) - bend * t * (h - t) / 2
set samples 131
set xrange [0:0.13]
set yrange [-0.25:0.95]
set border 3
set tics nomirror
set xzeroaxis linetype 1 linecolor "#888888"
set key outside bottom center horizontal reverse Left width 2
set xlabel "t"
set xtics 0.02
set ylabel "gap along y"
plot s(x) * (x <= 0.125 ? 1 : 1 / 0) linewidth 2 linecolor "#000000" title "gap", \
     chord(x, 0.125) linewidth 1 dashtype 2 linecolor "#d55e00" title "chord of the step", \
     bound(x, 0.125) linewidth 2 linecolor "#d55e00" title "bound: nothing proved", \
     chord(x, 0.0434) linewidth 1 dashtype 2 linecolor "#009e73" title "chord of a slice", \
     bound(x, 0.0434) linewidth 2 linecolor "#009e73" title "bound: apart"
