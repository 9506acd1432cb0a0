"""What queries that are no linear cast of polytopes cost beside Debian's engines, a row a question: ./run bench --all

Runs cast_bench (rotation, curved) and pair_bench one after the other, and prints, in Markdown, the medians of the
rounds' ratios: rotating casts over Bullet's continuous collision, curved casts over its subsimplex cast, overlap over
libccd's MPR, distance and penetration over Bullet's pair detector; the goal behind each; the rival's time, and its wrong
answers, late contacts among them. Ours are counted alike: a wrong one ends the run with exit code 1.
"""
import argparse
import csv
import pathlib
import subprocess
import sys

# Of a set: our contestants by the columns of the table, the rival, and the goals; a goal of one family comes first.
ROTATING = {"columns": ("standard/double", "certified/double"), "rival": "bullet/float", "goals": {"": (0.5, 0.7)}}
CURVED = {"columns": ("standard/double", "certified/double"), "rival": "bullet/float",
          "goals": {"cylinder - box": (0.8, 1.0), "": (0.25, 1.0)}}
OVERLAP = {"columns": ("graze mpr", "graze mpr prepared"), "rival": "libccd MPR", "goals": {"apart": (2.0, 1.0), "": ()}}
DISTANCE = {"columns": ("graze", "graze prepared"), "rival": "Bullet", "goals": {"": (0.5, 0.5)}}
PENETRATION = {"columns": ("graze", "graze prepared"), "rival": "Bullet EPA", "goals": {"": (0.5, 0.5)}}
TABLES = (
    ("rotation", "Rotating bodies, over Bullet's continuous collision", ("standard", "certified"), ROTATING),
    ("curved", "Curved casts, over Bullet's subsimplex cast", ("standard", "certified"), CURVED),
    ("distance", "Distance, over Bullet's pair detector", ("as they come", "prepared"), DISTANCE),
    ("penetration", "Penetration, over Bullet's pair detector with EPA", ("as they come", "prepared"), PENETRATION),
    ("overlap", "Overlap by MPR, over libccd's MPR", ("as they come", "prepared"), OVERLAP),
)


def rows_of(program, *words):
    """What a benchmark printed, a dictionary a line."""
    print(f"graze: {program.name} {' '.join(words)}", file=sys.stderr)
    done = subprocess.run([program, "--csv", *words], stdout=subprocess.PIPE, text=True, check=True)
    return list(csv.DictReader(done.stdout.splitlines()))


def goals_of(asked, family):
    return next(goals for part, goals in asked["goals"].items() if part in family)


def print_table(title, names, asked, rows):
    """One table; how many of our answers are wrong."""
    print(f"\n| {title} | {names[0]} | {names[1]} | goals | rival, ns | rival's wrong |\n|---|---|---|---|---|---|")
    ours_wrong = 0
    for family in dict.fromkeys(row["family"] for row in rows):
        by_name = {row["contestant"]: row for row in rows if row["family"] == family}
        ours = [by_name[name] for name in asked["columns"]]
        rival = by_name.get(asked["rival"])
        goals = goals_of(asked, family)
        cells = [f"{float(row['over_rival']):.2f}" for row in ours]
        for i, (row, goal) in enumerate(zip(ours, goals)):
            if not float(row["over_rival"]) <= goal:
                cells[i] += " (missed)"
        told = [f"{float(rival['ns']):,.0f}", f"{rival['wrong']} of {rival['cases']}"] if rival else ["-", "-"]
        goals_text = ", ".join(f"{goal:g}" for goal in goals) or "none"
        print(f"| {family} | {cells[0]} | {cells[1]} | {goals_text} | {told[0]} | {told[1]} |")
        ours_wrong += sum(int(row["wrong"]) for row in ours)
    return ours_wrong


def main():
    parser = argparse.ArgumentParser(prog="./run bench --all", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--rounds", default="21", help="rounds that the medians are taken over")
    asked = parser.parse_args()
    cast_bench, pair_bench = (asked.programs / name for name in ("cast_bench", "pair_bench"))
    if not pair_bench.exists():
        sys.exit("graze: no pair_bench: it needs Bullet and libccd (Debian: libbullet-dev, libccd-dev)")
    rows = []
    for set_name in ("rotation", "curved"):
        rows += rows_of(cast_bench, "--set", set_name, "--rounds", asked.rounds)
    rows += rows_of(pair_bench, "--rounds", asked.rounds)
    wrong = 0
    for set_name, title, names, table in TABLES:
        wrong += print_table(title, names, table, [row for row in rows if row["set"] == set_name])
    print(f"\nOur wrong answers: {wrong}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
