#!/usr/bin/env python3
"""Judges the engines of the zoo, and ours beside them, on the same families, and prints how they compare.

  ./run zoo                 all that are installed, a minute or two for each; what is judged is kept, and a run that was
                            stopped continues; --write makes docs/reports/engines_compared.md of it
  ./run zoo jolt rapier     only engines whose name begins so
  ./run zoo --findings      asks each engine the cases that it was convicted on, and says whether it still is;
                            --write makes docs/reports/bugs_shrunk.md of it

Every engine is held to one length, --relative-tolerance R over the scale of each question (1e-3 unless given): a
contact deeper than that must not be missed or passed, nor one claimed of bodies that stay farther apart. A list,
zoo.json, says how each engine is started; one whose program or package is not there is left out, with a word.
"""
import argparse
import datetime
import json
import os
import pathlib
import shlex
import shutil
import signal
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import findings  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
LISTS = ("engines/zoo/zoo.json", "engines/zoo/node/zoo.json")
OURS = ("gjk", "mpr", "ca", "certified", "exact", "plan", "bilateral", "epa")
TIME_LIMIT = 0.25  # seconds for an answer; the slowest engine that answers at all takes a hundredth of it
QUESTIONS = ("cast", "ray", "rotating_cast", "overlap", "distance", "penetration")
WORDS = {"cast": "Casts", "ray": "Rays", "rotating_cast": "Casts of rotating bodies", "overlap": "Overlap",
         "distance": "Distance", "penetration": "Penetration"}


class Fault(Exception):
    """One line says what was wrong."""


def engines_of(options):
    """[(name, command, native)], and what is left out and why."""
    out, left = [], []
    for name in LISTS:
        for engine in json.loads((ROOT / name).read_text())["engines"]:
            words = [word.replace("{zoo}", str(options.zoo)) for word in engine["command"]]
            program = shutil.which(words[0])
            script = next((word for word in words if word.endswith(".mjs")), None)
            modules = ROOT / "engines/zoo/node/node_modules" / engine["package"]
            if program is None or (script and not modules.exists()):
                left.append((engine["name"], engine["package"]))
            else:
                out.append((engine["name"], shlex.join(words), engine["native"]))
    for method in OURS:
        for scalar in ("double", "float"):
            out.append((f"graze-{method}-{scalar}",
                        shlex.join([str(options.graze), "serve", "--method", method, "--scalar", scalar]), True))
    return out, left


def version_of(engines):
    """A function: the version that an engine says it has."""
    commands, known = {name: command for name, command, _ in engines}, {}

    def version(name):
        if name not in known:
            with subprocess.Popen(shlex.split(commands[name]), cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                  stderr=subprocess.DEVNULL, text=True) as process:
                known[name] = json.loads(process.stdout.readline()).get("version", "")
                process.stdin.close()
                process.stdout.read()
        return known[name]

    return version


def key_of(options, command):
    return [options.relative_tolerance, options.count, options.rotating, options.queries, options.seed, command]


def judge(options, name, command):
    """What certify counts of one engine; kept on disk."""
    path = options.results / f"{name}.json"
    try:
        kept = json.loads(path.read_text())
        if kept["key"] == key_of(options, command):
            return kept["result"]
    except (OSError, ValueError, KeyError):
        pass
    print(f"graze: {name}", file=sys.stderr, flush=True)
    counted = path.with_suffix(".new")
    words = [options.graze, "certify", "--engine", command, "--relative-tolerance", options.relative_tolerance,
             "--count", options.count, "--rotating", options.rotating, "--queries", options.queries, "--seed",
             options.seed, "--time-limit", TIME_LIMIT, "--json", counted]
    with subprocess.Popen([str(word) for word in words], cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                          text=True, start_new_session=True) as process:
        try:
            said = process.communicate(timeout=options.seconds)[1]
        except subprocess.TimeoutExpired:  # what is judged by then is written
            process.send_signal(signal.SIGINT)
            said = process.communicate()[1]
    if process.returncode not in (0, 1, 130) or not counted.exists():
        lines = said.strip().splitlines() or [f"exit {process.returncode}"]
        print(f"graze: {name} is left out: {lines[-1]}", file=sys.stderr)
        return None
    if process.returncode == 130:
        print(f"graze: {name} was stopped after {options.seconds} s; what was judged by then counts", file=sys.stderr)
    result = json.loads(counted.read_text())
    path.write_text(json.dumps({"key": key_of(options, command), "result": result}))
    counted.unlink()
    return result


def question_of(method):
    return "ray" if method["question"] == "cast" and method["name"].endswith("-ray") else method["question"]


def count(tally, *names):
    return sum(tally["faults"].get(name, {"count": 0})["count"] for name in names)


def failures(tally):
    return ", ".join(f"{name} {number}" for name, number in tally["failures"].items()) or "-"


def dash(number):
    return str(number) if number else "-"


def short(number):
    return "-" if number is None else "0" if number == 0 else f"{number:.1e}"


def worst_family(method):
    worst = max(method["families"], key=lambda t: t["least_over_scale"] or 0, default=None)
    return worst["family"] if worst and worst["least_over_scale"] else "-"


def table(rows):
    """A table of markdown, aligned, so that it is read as text, too."""
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    lines = ["| " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths)) + " |" for row in rows]
    lines.insert(1, "|" + "|".join("-" * (width + 2) for width in widths) + "|")
    return "\n".join(lines) + "\n"


def overview(methods):
    rows = [["engine", "asked", "not asked", "wrong", "late", "early, off", "contact off", "no answer",
             "least over scale", "where", "least kappa"]]
    for method in methods:
        total = method["total"]
        rows.append([method["name"] + ("" if method["scalar"] == "double" else " (float)"), str(total["cases"]),
                     dash(total["not_asked"]), dash(count(total, "wrong")), dash(count(total, "late")),
                     dash(count(total, "early", "off")), dash(count(total, "contact off")), failures(total),
                     short(total["least_over_scale"]), worst_family(method), short(total["least_kappa"])])
    return table(rows)


def by_family(methods):
    """Family by family: wrong and late answers and those that are none, and the least limit over scale."""
    families = sorted({tally["family"] for method in methods for tally in method["families"] if tally["cases"]})
    rows = [["family", *[method["name"] for method in methods]]]
    for family in families:
        row = [family]
        for method in methods:
            tally = next((t for t in method["families"] if t["family"] == family), None)
            if tally is None or not tally["cases"]:
                row.append("")
                continue
            failed = sum(tally["failures"].values())
            row.append(f"{count(tally, 'wrong')} {count(tally, 'late')} {failed} {short(tally['least_over_scale'])}")
        rows.append(row)
    return table(rows)


def page(options, results, left):
    methods = [(question_of(method), method) for result in results.values() if result for method in result["methods"]]
    parts = [f"""# Engines compared

A report for authors and users of the engines, made on {datetime.date.today():%-d %B %Y} by

    ./run zoo --write --count {options.count} --rotating {options.rotating} --queries {options.queries}

It has every engine that is installed, called as its users call it, by default and in its tightest settings, and our own
methods through the same protocol ([protocol.md](../reference/protocol.md)). All got the same corpus and families:
{options.count} cases of each, {options.rotating} of each rotating family, and queries about the bodies of {options.queries}.

The limit is {options.relative_tolerance} of the scale of each question. *Wrong* is a contact deeper than that denied, or one
claimed of bodies that stay farther apart. *Late* is a time by which the bodies are deeper in each other. *Early* and *off*
are times at which they are farther apart. *No answer* counts everything else that came back. *Least over scale* and *least
kappa* (in units of u · scale) are the limits with which every verdict and time would have passed: the engine's certificate.

- The error of a float engine is measured against the numbers that its floats held.
- Unsupported questions were not asked.
- The witnesses of engines with a margin are compared with the bodies as the margin rounds them.
- The cases include scenes of every size. An engine that states the lengths it is made for is asked in those.

[bugs_found.md](bugs_found.md) has the findings, each with its case.
"""]
    for question in QUESTIONS:
        chosen = sorted((method for q, method in methods if q == question), key=lambda m: m["name"])
        if chosen:
            parts.append(f"## {WORDS[question]}\n\n{overview(chosen)}")
    for question in ("cast", "rotating_cast"):
        chosen = sorted((m for q, m in methods if q == question), key=lambda m: m["name"])
        for i in range(0, len(chosen), 6):
            part = "" if i else (f"## {WORDS[question]}, family by family\n\nEach cell: wrong, late, no answer, and the "
                                 "least limit over scale.\n\n")
            parts.append(part + by_family(chosen[i:i + 6]))
    if left:
        parts.append("Not installed, and left out: " + ", ".join(f"{name} ({package})" for name, package in left) + ".\n")
    return "\n".join(parts)


def arguments():
    parser = argparse.ArgumentParser(prog="./run zoo", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", help="engines whose names begin so; all if none is given")
    parser.add_argument("--graze", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--zoo", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--results", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--relative-tolerance", default="1e-3", metavar="R")
    parser.add_argument("--count", type=int, default=60, metavar="N", help="cases a family (60)")
    parser.add_argument("--rotating", type=int, default=8, metavar="N", help="cases a rotating family (8)")
    parser.add_argument("--queries", type=int, default=6, metavar="N", help="cases whose bodies are asked queries (6)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=int, default=600, metavar="S",
                        help="for one engine; what is judged by then counts (600)")
    parser.add_argument("--findings", action="store_true", help="show the findings of docs/reports/bugs_shrunk.md again")
    parser.add_argument("--write", action="store_true", help="write docs/reports/engines_compared.md")
    return parser.parse_args()


def main():
    options = arguments()
    options.graze, options.zoo = options.graze.resolve(), options.zoo.resolve()
    options.results.mkdir(parents=True, exist_ok=True)
    engines, left = engines_of(options)
    if options.findings:
        if options.names:
            raise Fault("--findings is about all of them: leave the names away")
        gone = findings.show(options, ROOT, {name: command for name, command, _ in engines}, version_of(engines))
        if gone:
            print(f"graze: not convicted any more: {', '.join(gone)}", file=sys.stderr)
        sys.exit(1 if gone else 0)
    if options.names:
        engines = [e for e in engines if any(e[0].startswith(name) for name in options.names)]
        if not engines:
            raise Fault(f"no engine's name begins with {' or '.join(options.names)}; zoo.json lists them")
        if options.write:
            raise Fault("--write is for a run of all engines")
    for name, package in left:
        print(f"graze: {name} is left out: {package} is not installed, or its adapter not built", file=sys.stderr)
    results = {name: judge(options, name, command) for name, command, _ in engines}
    text = page(options, results, left)
    if options.write:
        (ROOT / "docs/reports/engines_compared.md").write_text(text)
        print("docs/reports/engines_compared.md is written")
    else:
        print(text[text.index("\n## "):] if "\n## " in text else "no engine was judged")


if __name__ == "__main__":
    try:
        main()
    except Fault as fault:
        print(f"graze: {fault}", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        print("\ngraze: stopped; what is judged is kept, and the next run continues from there", file=sys.stderr)
        sys.exit(130)
    except BrokenPipeError:
        os._exit(0)
