#!/usr/bin/env python3
"""Makes price.json, a small price list with the form of graze.price/1 and numbers that nobody measured, for the test of
its page: make_price.py CASES.jsonl > price.json. Each kind of row that the page must cope with is in it."""
import json, sys

cases = [json.loads(line) for line in open(sys.argv[1])]


def errors(median):
    return {"median": median, "p99": None if median is None else 3 * median, "worst": None if median is None else 8 * median}


def row(label, method, scalar="double", tier="standard", tolerance=0, ns=1000.0, error=1e-15, wrong=0, late=0, front=False, request="normal, witnesses"):
    return {
        "label": label, "question": "cast", "method": method, "scalar": scalar, "tier": tier, "tolerance": tolerance,
        "request": request, "ours": True, "asked": 24,
        "time": None if ns is None else {"median": ns, "mean": 1.1 * ns, "p95": 1.7 * ns, "p99": 2.4 * ns, "worst": 3 * ns},
        "ratio": None if ns is None else {"median": ns / 1000, "low": 0.95 * ns / 1000, "high": 1.06 * ns / 1000},
        "backward": errors(error), "forward": errors(error), "width": errors(error),
        "failures": {"not_converged": 0, "no_time": 1 if method == "ca" else 0, "refused": 0},
        "wrong": wrong, "denied": 1e-4 if wrong else None, "late": late, "late_by": 1e-4 if late else None, "proved": 0,
        "iterations": {"mean": 7.5, "worst": 20}, "supports": {"mean": 9.25, "worst": 24}, "on_front": front,
        "worst_case": cases[0]["id"], "slowest_case": cases[1]["id"]}


def table(part, name, title, rows, group="", series="", x=None, x_name=""):
    return {"part": part, "series": series, "x": x, "x_name": x_name, "name": name, "group": group, "kind": "linear", "title": title,
            "sentence": "Made up, so that the page has something to draw.", "cases": 24,
            "truth": {"exact": 24, "bracket": 0, "proof": 0, "open": 0}, "baseline": "gjk/double", "rows": rows,
            "shown": [{"id": c["id"], "outcome": "hit", "toi": None, "case": c} for c in cases]}


def advice(user, bodies, label):
    return {"user": user, "wants": "whatever is made up", "bodies": bodies, "label": label,
            "call": label and f"// {label}\ngraze::cast(a, b)", "baseline": "gjk/double", "cost": label and {"median": 0.5, "low": 0.25, "high": 1},
            "worst": 3e-4 if label else None, "denied": 6e-8 if label == "mpr/float" else None, "tables": 3, "asked": 72, "wrong": 1 if label == "mpr/float" else 0, "because": "no other is cheaper"}


def family(name, title, group, steps):
    rows = []
    for method, ns in (("gjk", 900), ("mpr", 700), ("ca", 1500)):
        for k, tolerance in enumerate([1e-1, 1e-3, 1e-6, 1e-9, 0]):
            rows.append(row(f"{method}/double {tolerance:g}", method, tolerance=tolerance, ns=ns * (1 + steps * k),
                            error=max(tolerance / 5, 2e-16), late=2 if method == "mpr" and tolerance == 1e-1 else 0,
                            front=method == "gjk" and k != 1))
    rows.append(row("mpr/float", "mpr", scalar="float", ns=500, error=3e-8, wrong=1, front=True))
    rows.append(row("exact/double", "exact", tier="exact", ns=2200, error=0.0, front=True))
    rows.append(row("slow engine", "slow", ns=None, error=1e-3))
    return table("family", name, title, rows, group)


tables = [family("smooth_sphere", "A sphere against smooth shapes", "smooth", 0.4), family("slow_turn", "Both bodies turn slowly", "rotation", 0.9),
          family("boxes", "Boxes", "polytopes", 0)]
for n in (8, 64, 512, 4096):
    tables.append(table("growth", f"vertices_{n}", f"Hulls of {n} vertices", [row("gjk/double", "gjk", ns=300 * n**0.3), row("mpr/double", "mpr", ns=250 * n**0.4)],
                        series="vertices", x=n, x_name="vertices"))
tables.append(table("request", "requests", "What each request adds", [row(f"gjk/double {r}", "gjk", ns=ns, request=r) for r, ns in
                                                                      (("verdict", 600), ("normal", 640), ("witnesses", 700), ("proof", 1100))]))
tables.append(table("query", "overlap", "Do they overlap?", [row("overlap gjk/double", "gjk", ns=200, error=None), row("overlap mpr/double", "mpr", ns=180, error=None)], series="overlap"))
print(json.dumps({
    "schema": "graze.price/1", "version": "0.0.0", "effort": "quick", "seed": 1, "rounds": 3, "finished": True, "seconds": 1.5,
    "machine": {"processor": "none: these numbers are made up", "cores": 1, "compiler": "none", "build": "none", "load": None},
    "tables": tables,
    "advice": [advice("a game", "that do not rotate", "mpr/float"), advice("a game", "that rotate", "gjk/double 0.001"), advice("a robot", "that rotate", None)],
    "sentences": [{"topic": "never_late", "text": "The cheapest that is never late is gjk."}, {"topic": "one_digit", "text": "One more digit costs 40 % on smooth shapes."}]},
    indent=None, separators=(",", ":")))
