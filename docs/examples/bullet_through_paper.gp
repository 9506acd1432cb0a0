# gnuplot -e "run = '…/example_bullet_through_paper'" docs/examples/bullet_through_paper.gp > docs/examples/bullet_through_paper.svg
# The flight of both bullets, the sheets at the time when the bullets are there, and the contacts: examples/bullet_through_paper.cpp.
set terminal svg size 640,320 font "sans-serif,13" background "white"
set xrange [-0.6:16]
set yrange [0:3.6]
set border 3
set tics nomirror
set xlabel "x, metres"
set ylabel "height, metres"
unset key
do for [k = 0:3] { set arrow k + 1 from 2 + 2 * k, 0 to 2 + 2 * k, 3 nohead linewidth 2 linecolor "#2b62ad" }
set arrow 5 from 10, 0 to 10, 3 - 200 * 10 / 900.0 nohead linewidth 2 linecolor "#2b62ad"
set arrow 6 from 10, 3 to 10, 3 - 200 * 10 / 900.0 linewidth 1 dashtype 2 linecolor "#2b62ad"
set arrow 7 from 0, 1.5 to 15, 1.5 linewidth 2 linecolor "#d9651f"
set arrow 8 from 0, 3.006 to 15, 3.006 linewidth 2 linecolor "#d9651f"
set label "sheet 4 has dropped" at 10.15, 0.5
set label "high bullet" at 12, 3.25
set label "bullet" at 12, 1.75
contacts = "< " . run . " | grep meets | tr -d ','"
plot contacts using 5:(1.5):(sprintf("%.2f ms", $1)) with labels offset -3.5, -1 notitle, \
     contacts using 5:(1.5) with points pointtype 7 pointsize 0.8 linecolor "#0b7a3b" notitle
