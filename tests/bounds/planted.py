#!/usr/bin/env python3
"""Plants wrong bounds in a copy of core or of the oracles, and lets the tests of bounds look for them.

A patch of tests/bounds/defects begins with header lines, then a diff that `patch --strip=1 --fuzz=1` applies to the
root:
  Defect: what is wrong, in one sentence
  Test: a file of tests/ and the test in it that has to fail, "bounds/mobility_test.cpp MobilityBounds.Name"
  Compile: of oracles/, the .cpp files that the patch changes by a header

The file alone is compiled, with the defect, and the one test is run. The same file compiled without a defect has to
stand: every test that is named is run so as well.
"""
import argparse
import concurrent.futures
import os
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
TESTS = HERE.parent
sys.path.insert(0, str(HERE.parents[1] / "properties/defects"))
from planted import Config, Fault, Patch, end, named_patches, plant, remove_copies, run  # noqa: E402


class WrongBound(Patch):
    FOLDER = "tests/bounds/defects"
    KEYS = ("Defect", "Test", "Compile")
    NAMES = "Test"

    def __init__(self, path):
        super().__init__(path)
        self.source, self.test = (self.law.split() + [""])[:2]
        if not self.test or not (TESTS / self.source).is_file():
            raise Fault(f"{path}: \"Test: {self.law}\" is no file of tests and a test in it")

    def all(self, key):
        """The header line Test holds one test, the other lines lists."""
        return [value for k, value in self.headers if k == key] if key == self.NAMES else super().all(key)


def fails(config, root, at, source, test, besides=()):
    """(does the test fail, error): compiled against the sources under `at`, some of whose files besides."""
    log, program, objects = root / "log", root / "test", []
    include = [f"-I{at}/core", f"-I{at}", f"-I{config.source}"]
    include += [word for path in config.includes for word in ("-isystem", path)]
    include += ["-include", "properties/defects/whole_core.hpp"]
    for name in [TESTS / source, *(at / one for one in besides)]:
        objects.append(root / f"{len(objects)}.o")
        if run([*config.compiler, *config.flags, *include, "-c", name, "-o", objects[-1]], log):
            return False, f"does not compile, see {log}"
    if run([config.compiler[-1], *objects, *config.link, "-o", program], log):
        return False, f"does not link, see {log}"
    done = subprocess.run([program, f"--gtest_filter={test}"], capture_output=True, text=True, check=False)
    with open(log, "a") as out:
        out.write(done.stdout + done.stderr)
    if "[==========] 1 test " not in done.stdout:
        return False, f"{source} has no test {test}"
    return done.returncode != 0, ""


def try_defect(config, patch):
    """What is wrong with it, or nothing: it is found."""
    root = config.work / patch.name
    root.mkdir(parents=True, exist_ok=True)
    error = plant(config, patch, root)
    found = False
    if not error:
        found, error = fails(config, root, root, patch.source, patch.test, patch.compiled)
    remove_copies(patch, root)
    if error:
        return f"{patch.name} {error}"
    return "" if found else f"{patch.name} survives {patch.test}"


def try_none(config, source, tests):
    root = config.work / ("none-" + pathlib.Path(source).stem)
    root.mkdir(parents=True, exist_ok=True)
    (root / "log").write_text("")
    for test in tests:
        found, error = fails(config, root, config.source, source, test)
        if error or found:
            return error or f"{test} fails without a defect, see {root / 'log'}"
    return ""


def arguments():
    parser = argparse.ArgumentParser(prog="./run bounds --planted", description=__doc__.split("\n\n")[0])
    parser.add_argument("config", help="written by CMake: bounds-Release.conf")
    parser.add_argument("--work", required=True, help="where copies are kept")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="defects at a time")
    parser.add_argument("name", nargs="*", help="defects of tests/bounds/defects, or paths; all if none is given")
    return parser.parse_intermixed_args()


def main():
    options = arguments()
    if options.jobs < 1:
        raise Fault("--jobs is 1 or more")
    config = Config(options.config, options.work)
    every = named_patches(HERE / "defects", [], WrongBound)  # each names a test that is there
    patches = named_patches(HERE / "defects", options.name, WrongBound) if options.name else every
    without = {}
    for patch in patches:
        without.setdefault(patch.source, set()).add(patch.test)
    faults = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        jobs = [(patch.name, pool.submit(try_defect, config, patch)) for patch in patches]
        jobs += [(f"{source} without a defect", pool.submit(try_none, config, source, sorted(tests)))
                 for source, tests in without.items()]
        try:
            for name, job in jobs:
                fault = job.result()
                print(f"{name}: {fault or ('stands' if name.endswith('defect') else 'found')}", flush=True)
                faults += [fault] if fault else []
        except KeyboardInterrupt:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
    return faults


if __name__ == "__main__":
    end(main)
