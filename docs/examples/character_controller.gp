# gnuplot -e "run = '…/example_character_controller'" docs/examples/character_controller.gp > docs/examples/character_controller.svg
# Where the character stands after each step, from above, and what it walks around: examples/character_controller.cpp.
set terminal svg size 640,400 font "sans-serif,13" background "white"
set size ratio -1
set xrange [-0.6:6.3]
set yrange [-0.7:3.5]
set border 3
set tics nomirror
set xlabel "x, metres"
set ylabel "y, metres"
unset key
c = cos(2 * atan(0.1))
s = -sin(2 * atan(0.1))
x(a, b) = 4 + c * a - s * b
y(a, b) = 3 + s * a + c * b
set object 1 circle at 2, 0.8 size 0.5 fillcolor "#9fbadb" fillstyle solid border linecolor "#2b62ad"
set object 2 polygon from x(-4, -0.1), y(-4, -0.1) to x(4, -0.1), y(4, -0.1) to x(4, 0.1), y(4, 0.1) \
    to x(-4, 0.1), y(-4, 0.1) to x(-4, -0.1), y(-4, -0.1) fillcolor "#9fbadb" fillstyle solid border linecolor "#2b62ad"
set object 3 rectangle from 5.9, -4 to 6.1, 4 fillcolor "#9fbadb" fillstyle solid border linecolor "#2b62ad"
set label "pillar" at 2, 0.8 center
set label "north wall" at 2.3, 2.75 center
set label "east wall" at 6, 0.6 center rotate by 90
steps = "< " . run . " | grep '^ *[0-9]' | tr -d '(),'"
plot steps every 3 using 2:3:(0.3) with circles linecolor "#d9651f", \
     steps using 2:3 with linespoints pointtype 7 pointsize 0.4 linewidth 2 linecolor "#d9651f"
