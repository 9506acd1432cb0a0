#!/usr/bin/env python3
"""figures.py PRICE.json DIR [--format svg|pdf|png] [--statistic median|p99|worst] [--error backward|forward|width]

Draws every figure of a run of `graze price --json`, from that file alone:

    error_against_time_FAMILY   a work-precision diagram a family: log error against log time, a line a method, its tolerances
                                joined; the Pareto front is ringed
    growth_SERIES               time against vertices, gap or turn
    requests_TABLE              what each request adds to the time alone, a bar each
    queries_SERIES              EPA against MPR, the swept sum against before-and-after

Each function below draws one of them into an Axes; change one, or call them from elsewhere. Needs python3-matplotlib.
"""
import argparse
import json
import math
import pathlib
import sys

try:
    import matplotlib
except ImportError:
    sys.exit("figures.py: needs matplotlib: Debian's package python3-matplotlib")
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

# Okabe and Ito's colours, told apart by the colour-blind; one a method, in every figure.
COLOURS = {"ca": "#e69f00", "gjk": "#0072b2", "mpr": "#d55e00", "certified": "#009e73", "exact": "#000000",
           "bilateral": "#56b4e9", "bilateral_published": "#cc79a7", "plan": "#0072b2", "steps": "#999999",
           "spheres": "#d55e00", "epa": "#cc79a7", "before_after": "#e69f00"}
MARKS = {"ca": "v", "gjk": "o", "mpr": "s", "certified": "D", "exact": "*", "bilateral": "^", "bilateral_published": "<",
         "plan": "o", "steps": "x", "spheres": "s", "epa": "P", "before_after": "v"}
FLOOR = 1e-18  # an error of 0 is drawn here


def shown(error):
    return max(error, FLOOR)


def look(row):
    """Double is drawn full, float hollow and dashed; a third-party engine in a grey of its own."""
    colour = COLOURS.get(row["method"], "#777777")
    is_float = row["scalar"] == "float"
    return {"color": colour, "marker": MARKS.get(row["method"], "h"), "linestyle": "--" if is_float else "-",
            "markerfacecolor": "none" if is_float else colour, "markersize": 5, "linewidth": 1.2}


def error_against_time(axes, table, error="backward", statistic="median"):
    """A line a method and scalar, from its loosest tolerance to the least that it reaches."""
    lines = {}
    for row in table["rows"]:
        value = row[error][statistic]
        if row["time"] is None or value is None:
            continue
        name = f"{row['question']} {row['method']}/{row['scalar']}" if table["kind"] == "query" else f"{row['method']}/{row['scalar']}"
        lines.setdefault(name, []).append((row["time"]["median"], shown(value), row))
    for name, points in lines.items():
        axes.plot([t for t, _, _ in points], [e for _, e, _ in points], label=name, **look(points[0][2]))
    front = sorted((t, e) for points in lines.values() for t, e, row in points if row["on_front"])
    axes.plot([t for t, _ in front], [e for _, e in front], "o", markersize=11, markerfacecolor="none",
              markeredgecolor="#444444", markeredgewidth=0.8, linestyle="none", label="Pareto front")
    axes.set(xscale="log", yscale="log", xlabel="median time of a call (ns)",
             ylabel=f"{statistic} {error} error, over scale", title=table["name"])
    axes.grid(True, which="major", linewidth=0.4, color="#cccccc")


def curve(axes, tables, value, ylabel):
    """A line a contender over the points of a series."""
    labels = []
    for table in tables:
        labels += [row["label"] for row in table["rows"] if row["label"] not in labels]
    for label in labels:
        points = [(table["x"], value(row), row) for table in tables for row in table["rows"] if row["label"] == label]
        points = [(x, y, row) for x, y, row in points if y is not None]
        if points:
            axes.plot([x for x, _, _ in points], [y for _, y, _ in points], label=label, **look(points[0][2]))
    spread = [table["x"] for table in tables]
    axes.set(yscale="log", xlabel=tables[0]["x_name"], ylabel=ylabel, title=tables[0]["series"])
    if min(spread) > 0 and max(spread) / min(spread) > 50:
        axes.set_xscale("log")
    axes.grid(True, which="major", linewidth=0.4, color="#cccccc")


def median_time(row):
    return row["time"]["median"] if row["time"] else None


def mean_supports(row):
    return row["supports"]["mean"] or None


def requests(axes, table):
    """Bars: the ratio of each request to the same method's time alone."""
    methods = []
    for row in table["rows"]:
        name = f"{row['method']}/{row['scalar']}"
        if row["question"].endswith("cast") and name not in methods:
            methods.append(name)
    labels = {row["label"]: row for row in table["rows"]}

    def ratio(label):
        row = labels.get(label)
        return row["ratio"]["median"] if row and row["ratio"] else None

    wanted = ["verdict", "time", "normal", "witnesses", "normal, witnesses", "proof", "everything"]
    greys = ["#bbbbbb", "#0072b2", "#56b4e9", "#009e73", "#e69f00", "#d55e00", "#000000"]
    for k, (request, colour) in enumerate(zip(wanted, greys)):
        places, heights = [], []
        for m, method in enumerate(methods):
            alone = ratio(f"{method} time")
            this = ratio(f"swept_overlap {method} verdict" if request == "verdict" else f"{method} {request}")
            if alone and this:
                places.append(m + (k - 3) * 0.12)
                heights.append(this / alone)
        axes.bar(places, heights, width=0.11, color=colour, label=request)
    axes.axhline(1, color="#444444", linewidth=0.8)
    axes.set_xticks(range(len(methods)), methods)
    axes.set(ylabel="time over that of the time alone", title=table["name"], yscale="log")
    axes.grid(True, which="major", axis="y", linewidth=0.4, color="#cccccc")


def save(figure, folder, name, kind):
    file = folder / f"{name}.{kind}".replace(" ", "_").replace(",", "")
    figure.savefig(file, bbox_inches="tight", metadata={"Date": None} if kind == "svg" else None)
    plt.close(figure)
    print(file)


def legend(axes):
    axes.legend(fontsize=7, loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False)


def overview(tables, folder, kind, error, statistic):
    """All families in one page of small panels."""
    columns = 3
    lines = math.ceil(len(tables) / columns)
    figure, panels = plt.subplots(lines, columns, figsize=(4.2 * columns, 3.2 * lines), squeeze=False)
    for axes, table in zip(panels.flat, tables):
        error_against_time(axes, table, error, statistic)
    for axes in list(panels.flat)[len(tables):]:
        axes.axis("off")
    for axes in panels.flat[: len(tables) - 1 if len(tables) > columns else 0]:
        axes.set_xlabel("")
    handles = {}
    for axes in panels.flat:
        for handle, label in zip(*axes.get_legend_handles_labels()):
            handles.setdefault(label, handle)
    figure.tight_layout(rect=(0, 0.06, 1, 1))
    figure.legend(handles.values(), handles.keys(), loc="lower center", ncol=7, fontsize=8, frameon=False)
    save(figure, folder, "error_against_time", kind)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", type=pathlib.Path, metavar="PRICE.json")
    parser.add_argument("folder", type=pathlib.Path, metavar="DIR")
    parser.add_argument("--format", default="svg", choices=["svg", "pdf", "png"])
    parser.add_argument("--statistic", default="median", choices=["median", "p99", "worst"])
    parser.add_argument("--error", default="backward", choices=["backward", "forward", "width"])
    wanted = parser.parse_args()
    try:
        document = json.loads(wanted.file.read_text())
    except (OSError, ValueError) as error:
        sys.exit(f"figures.py: {wanted.file}: {error}")
    if not isinstance(document, dict) or document.get("schema") != "graze.price/1":
        sys.exit(f"figures.py: {wanted.file}: schema: is not graze.price/1; graze price --json writes one")
    wanted.folder.mkdir(parents=True, exist_ok=True)
    matplotlib.rcParams["svg.hashsalt"] = "graze"  # the same figure is the same file
    matplotlib.rcParams["svg.fonttype"] = "none"  # text stays text
    tables = document["tables"]

    families = [table for table in tables if table["part"] == "family"]
    measured = families + [table for table in tables if table["part"] == "query" and table["x"] is None]
    for table in measured:
        figure, axes = plt.subplots(figsize=(7, 4.5))
        error_against_time(axes, table, wanted.error, wanted.statistic)
        legend(axes)
        save(figure, wanted.folder, f"error_against_time_{table['name']}", wanted.format)
    if families:
        overview(families, wanted.folder, wanted.format, wanted.error, wanted.statistic)

    for part in ("growth", "query"):
        for series in dict.fromkeys(t["series"] for t in tables if t["part"] == part and t["x"] is not None):
            points = [t for t in tables if t["part"] == part and t["series"] == series]
            figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4))
            curve(left, points, median_time, "median time of a call (ns)")
            curve(right, points, mean_supports, "supports, mean")
            legend(right)
            figure.tight_layout()
            save(figure, wanted.folder, f"{'growth' if part == 'growth' else 'queries'}_{series}", wanted.format)

    for table in tables:
        if table["part"] == "request":
            figure, axes = plt.subplots(figsize=(8, 4))
            requests(axes, table)
            legend(axes)
            save(figure, wanted.folder, table["name"], wanted.format)


if __name__ == "__main__":
    main()
