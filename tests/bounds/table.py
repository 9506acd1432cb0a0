#!/usr/bin/env python3
"""Runs the tests of bounds and writes their table into docs/reports/bounds.md, between its two markers.

    python3 tests/bounds/table.py build/test/tests/bounds

The argument is the folder of the built tests. With GRAZE_BOUNDS_TIMES=100 it is the long run. Exits with 1 where
a bound is below the truth: the table is written all the same.
"""

import datetime
import pathlib
import subprocess
import sys

PROGRAMS = ["bounds_motion_test", "bounds_rounding_test"]
BEGIN, END = "<!-- table: begin -->", "<!-- table: end -->"


def rows(folder):
    """The lines `bound | name | looked at | below | least | median | worst` of all programs, as lists."""
    out, failed = [], False
    for name in PROGRAMS:
        done = subprocess.run([folder / name], stdout=subprocess.PIPE, text=True, check=False)
        failed |= done.returncode != 0
        found = [line.split(" | ")[1:] for line in done.stdout.splitlines() if line.startswith("bound | ")]
        if not found:
            sys.exit(f"{name}: printed no bounds (exit {done.returncode})")
        out += found
    return out, failed


def number(text):
    value = float(text)
    if value >= 1e4 or 0 < value < 0.01:
        return f"{value:.0e}".replace("e+0", "e").replace("e+", "e").replace("e-0", "e-")
    return f"{value:.0f}" if value >= 1000 else f"{value:.3g}"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    found, failed = rows(pathlib.Path(sys.argv[1]))
    table = ["| bound | looked at | below the truth | least | median | worst |", "|---|---|---|---|---|---|"]
    for name, looked_at, below, *ratios in found:
        table.append("| " + " | ".join([name.replace("|", "\\|"), looked_at, below, *map(number, ratios)]) + " |")
    page = pathlib.Path(__file__).resolve().parents[2] / "docs/reports/bounds.md"
    text = page.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN, 1)
    after = rest.split(END, 1)[1]
    made = f"The table was made on {datetime.date.today():%-d %B %Y}."
    page.write_text("\n\n".join([before + BEGIN, made, "\n".join(table), END + after]), encoding="utf-8")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
