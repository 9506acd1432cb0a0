#!/usr/bin/env python3
"""Machine-made mutants of core, and whether the laws notice them.

    mutants.py CONFIG --work FOLDER [--count 300] [--seed S] [--jobs J] [--write] [--double]

CONFIG is written by CMake (tests/mutants): the compiler, and what to link. All mutants stand in one copy of
core, which is compiled once; then each is run by itself (driver.cpp). What is done is kept in FOLDER: stopped,
the next run continues from there; an edit of core, of the laws or of the options begins anew. Without a command
that changes files the report goes to the standard output; --write makes it build/reports/mutants.md.
"""
import argparse
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import mutate  # noqa: E402
import report  # noqa: E402
import shown  # noqa: E402
import sites  # noqa: E402
import unit_tests  # noqa: E402

# The translation units of the methods, the headers of core that they stand on, and the laws that ask them.
METHODS = {"casts": ["cast.hpp"],
           "queries": ["overlap.hpp", "penetration.hpp", "swept_overlap.hpp", "detail/queries/exact_queries.hpp"],
           "rotating": ["rotating_cast.hpp"]}


LISTS = ("flags", "includes", "link", "objects", "unit_tests", "unit_link")


class Fault(Exception):
    pass


def say(text):
    print("graze: " + text, file=sys.stderr, flush=True)


def read_config(path):
    out = {}
    for line in pathlib.Path(path).read_text().splitlines():
        name, _, value = line.partition(" = ")
        out[name] = value.split(";") if name in LISTS else value
    return out


def digest(*paths):
    out = hashlib.sha256()
    for path in sorted(map(pathlib.Path, paths)):
        out.update(path.name.encode() + path.read_bytes())
    return out.hexdigest()[:16]


class Build:
    def __init__(self, options):
        self.options = options
        self.config = read_config(options.config)
        self.source = pathlib.Path(self.config["source"])
        self.methods = options.methods or list(METHODS)
        core = sorted((self.source / "core/graze").rglob("*.hpp"))
        here = [self.source / "properties/mutants" / name for name in ("sites.py", "mutate.py", "mutants.hpp")]
        engines = [self.source / "engines" / name
                   for name in (*(f"{m}.cpp" for m in self.methods), "convert.hpp", "own_hull.hpp")]
        key = f"{options.seed}-{options.count}" + ("-double" if options.double else "")
        if len(self.methods) < len(METHODS):
            key += "-" + "-".join(self.methods)
        self.made = digest(*core, *here, *engines)
        self.folder = pathlib.Path(options.work).absolute() / key
        self.folder.mkdir(parents=True, exist_ok=True)
        self.copy = self.folder / "core"
        self.flags = self.config["flags"] + (["-DGRAZE_DOUBLE_ALONE"] if options.double else [])
        self.system = [f"-isystem{i}" for i in self.config["includes"]]
        self.files = [str(self.source / f"engines/{m}.cpp") for m in self.methods]

    def compiler(self):
        return [self.config["compiler"], *self.flags, "-w", "-fmax-errors=0", f"-I{self.copy}", f"-I{self.source}",
                *self.system, "-include", "properties/defects/whole_core.hpp"]

    def is_fresh(self, name, stamp):
        path = self.folder / name
        return path.exists() and path.read_text() == stamp

    def generate(self):
        """The copy of core that holds all mutants."""
        if self.is_fresh("made", self.made):
            return
        for name in ("made", "compiled", "linked"):
            (self.folder / name).unlink(missing_ok=True)
        # A copy, so that an edit meanwhile does no harm.
        original = self.folder / "original"
        mutate.copy_of(original)
        shutil.copytree(self.source / "core/graze", original / "graze")
        say("finding the places that can be mutated")
        headers = [h for m in self.methods for h in METHODS[m]] if self.options.methods else []
        found = sites.find_sites(str(original), self.system, headers)
        known = mutate.Known(str(self.folder.parent / ("uncompilable" + ("-double" if self.options.double else ""))))
        sample = mutate.Sample(found, self.options.seed, str(original), self.options.count, known)
        say(f"{self.options.count} mutants of {len(found)}; compiling them without code, to drop what does not")
        mutate.copy_of(self.copy)
        mutate.settle(sample, str(self.copy), self.compiler(), self.files, say, self.only_object())
        sample.save(str(self.folder / "mutants.jsonl"))
        (self.folder / "sites").write_text(f"{len(found)} {sample.dropped}")
        (self.folder / "made").write_text(self.made)

    def only_object(self):
        """Of one file the attempt that compiles is the object."""
        return str(self.folder / f"{self.methods[0]}.o") if len(self.methods) == 1 else None

    def compile(self):
        """Objects of the methods."""
        if self.is_fresh("compiled", self.made):
            return
        objects = [str(self.folder / f"{name}.o") for name in self.methods]
        for name, file, target in zip(self.methods, self.files, objects):
            if not self.only_object():
                say(f"compiling {name} with {self.options.count} mutants")
                subprocess.run([*self.compiler(), "-c", file, "-o", target], check=True)
        self.join(objects, self.folder / "methods.o")
        (self.folder / "compiled").write_text(self.made)

    def join(self, objects, whole):
        """One object. What the judge and its oracles use of core under the same names must stay as it is there:
        what these share with them by name becomes their own."""
        subprocess.run(["ld", "-r", "--force-group-allocation", "-o", str(whole), *objects], check=True)
        names = subprocess.run(["nm", "--defined-only", str(whole)], check=True, capture_output=True, text=True)
        shared = [line.split()[-1] for line in names.stdout.splitlines() if line.split()[-2] in "WVu"]
        own = [f"{name} mutated_{name}" for name in shared if not name.startswith(("DW.", "_ZT"))]
        listed = whole.with_suffix(".names")
        listed.write_text("\n".join(own) + "\n")
        subprocess.run(["objcopy", f"--redefine-syms={listed}", str(whole)], check=True)

    def unit_tests(self):
        """The program of core's unit tests, with all mutants in it."""
        sources = [self.source / "tests/core" / name for name in self.config["unit_tests"]]
        program = self.folder / "unit_tests"
        stamp = self.made + digest(*(self.source / "tests/core").rglob("*.?pp"))
        if not self.is_fresh("unit_made", stamp):
            for name in ("unit_survey.json", "unit_results"):
                (self.folder / name).unlink(missing_ok=True)
            self.compile_unit_tests(program, sources)
            (self.folder / "unit_made").write_text(stamp)
        return unit_tests.UnitTests(self.folder, program, say)

    def compile_unit_tests(self, program, sources):
        say(f"compiling unit tests with {self.options.count} mutants")
        objects = []
        for source in sources:
            objects.append(str(self.folder / f"unit_{source.stem}.o"))
            launcher = [self.config["launcher"]] if self.config.get("launcher") else []
            subprocess.run([*launcher, *self.compiler(), f'-DGRAZE_SOURCE_DIR="{self.source}"', "-c", str(source),
                            "-o", objects[-1]], check=True)
        whole = self.folder / "unit_all.o"
        self.join(objects, whole)
        alive = [o for o in self.config["objects"] if "alive.cpp" in o]
        subprocess.run([self.config["compiler"], str(whole), *alive, *self.config["link"],
                        *self.config["unit_link"], "-o", str(program)], check=True)

    def link(self):
        libraries = [item for item in self.config["link"] if os.path.exists(item)]
        stamp = self.made + digest(*[p for p in libraries if p.endswith(".a")], *self.config["objects"])
        if self.is_fresh("linked", stamp):
            return
        subprocess.run([self.config["compiler"], str(self.folder / "methods.o"), *self.config["objects"],
                        *self.config["link"], "-o", str(self.folder / "driver")], check=True)
        for name in ("survey", "results", "broken"):
            (self.folder / name).unlink(missing_ok=True)
        (self.folder / "linked").write_text(stamp)

    def run(self):
        options = self.options
        cases = {"casts": options.linear, "queries": options.query, "rotating": options.rotating}
        linear, query, rotating = (cases[m] if m in self.methods else 0 for m in METHODS)
        counts = f"{linear} {query} {rotating} {options.seconds}"
        if not self.is_fresh("counts", counts):
            for name in ("survey", "results", "broken"):
                (self.folder / name).unlink(missing_ok=True)
            (self.folder / "counts").write_text(counts)
        first = shown.Shown(self.folder.parent / "shown.jsonl")
        first.save_for(self.folder)
        subprocess.run([str(self.folder / "driver"), str(options.count), str(self.folder), "--seconds",
                        str(options.seconds), "--jobs", str(options.jobs), "--linear", str(linear),
                        "--query", str(query), "--rotating", str(rotating)], check=True)
        first.learn(self.folder)


def positive(text):
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{text} is not 1 or more")
    return number


def arguments():
    parser = argparse.ArgumentParser(prog="./run mutants", description=__doc__.split("\n")[0])
    parser.add_argument("config", help=argparse.SUPPRESS)
    parser.add_argument("--work", default="build/mutants", help="where the copy of core and the results are kept")
    parser.add_argument("--count", type=positive, default=300, help="how many mutants (at most 1000)")
    parser.add_argument("--seed", type=int, default=1, help="of the sample")
    parser.add_argument("--jobs", type=positive, default=1, help="mutants run at once")
    parser.add_argument("--seconds", type=positive, default=6, help="processor time for a mutant")
    parser.add_argument("--linear", type=positive, default=240, help="linear cases, and as many near-ties")
    parser.add_argument("--query", type=positive, default=120, help="cases of the other queries")
    parser.add_argument("--rotating", type=positive, default=40, help="rotating cases")
    parser.add_argument("--methods", nargs="+", choices=list(METHODS), help="only these, and what they stand on")
    parser.add_argument("--laws-alone", action="store_true", help="what no law notices meets no unit test either")
    parser.add_argument("--double", action="store_true", help="methods in double alone: half the compilation")
    parser.add_argument("--page", action="store_true", help="run nothing: the page of what has been run")
    parser.add_argument("--at-least", type=float, metavar="PERCENT",
                        help="exit 1 if less is noticed of those that change an answer of this run")
    parser.add_argument("--write", action="store_true", help="write build/reports/mutants.md")
    options = parser.parse_args()
    if options.count > 1000:
        parser.error("--count is 1000 at most")
    return options


def main():
    options = arguments()
    build = Build(options)
    by_unit_tests = {}
    if options.page:
        by_unit_tests = unit_tests.noticed_before(build.folder)
    else:
        build.generate()
        build.compile()
        build.link()
        build.run()
        if not options.laws_alone:
            left = report.read(build.folder, build.source, {})
            by_unit_tests = build.unit_tests().notice([m.number for m in left.mutants if m.verdict != "killed"])
    outcome = report.read(build.folder, build.source, by_unit_tests)
    text = report.page(outcome, options)
    if options.write:
        reports = build.source / "build/reports"
        reports.mkdir(parents=True, exist_ok=True)
        (reports / "mutants.md").write_text(text)
    else:
        print(text)
    if options.at_least is not None:
        share, changing = outcome.of_changes()
        if share < options.at_least:
            raise Fault(f"{share:.1f} % noticed of the {changing} mutants that change an answer, less than "
                        f"{options.at_least} %")


if __name__ == "__main__":
    try:
        main()
    except Fault as fault:
        print(f"FAIL: {fault}")
        sys.exit(1)
    except subprocess.CalledProcessError as error:
        print(f"graze: {error.cmd[0]} failed (exit {error.returncode}); its message is above", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        print("\ngraze: stopped; what is done is kept, and the next run continues from there", file=sys.stderr)
        sys.exit(130)
