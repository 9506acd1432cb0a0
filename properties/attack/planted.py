#!/usr/bin/env python3
"""Plants each defect of the checker in a copy of the sources, and lets the attack look for it.

A patch is one of the catalogue's (properties/defects/catalogue.py): header lines, then a diff. Its law is none of
the laws: that what the checker accepts of a mutated proof is true. Of the header lines two mean:
  Compile: for a defect in a header, the .cpp files to compile; without it all of oracles/ that include it
  Run: an option that the attack needs to meet the defect

Each is found if a round of the attack, of those from 0 on, has an accepted mutant that the judge contradicts. What
no defect is planted in has to stand as many rounds as the latest of them took, and no fewer than 500.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "defects"))
from planted import Config, Fault, Patch, compile_defect, end, named_patches, plant, remove_copies  # noqa: E402

ROUNDS = 4000
# Without a defect: also where all are found sooner.
LEAST_ROUNDS = 500
# More mutants than the rounds have, so that the rounds are the end.
NO_END = 10**15


def included(root, path):
    """All headers of the oracles that a file includes, however deep."""
    seen, left = set(), [path]
    while left:
        for name in re.findall(r'^#include "(oracles/[^"]+)"', left.pop().read_text(), re.M):
            if name not in seen:
                seen.add(name)
                left.append(root / name)
    return seen


class CheckerDefect(Patch):
    FOLDER = "properties/attack/defects"
    KEYS = (*Patch.KEYS, "Run")

    def __init__(self, path, source):
        self.source = source
        super().__init__(path)
        self.options = self.all("Run")

    def compiled_besides(self):
        named = super().compiled_besides()
        if named:
            return named
        headers = {name for name in self.files if name.endswith(".hpp")}
        paths = sorted((self.source / "oracles").rglob("*.cpp"))
        return [str(path.relative_to(self.source)) for path in paths if headers & included(self.source, path)]


def attack(program, root, options, rounds, seed):
    """(round, classes, error): of the first finding, or no round; an error or nothing."""
    findings = root / "findings.jsonl"
    findings.unlink(missing_ok=True)
    words = [program, "--first", "--mutants", NO_END, "--rounds", rounds, "--seed", seed, "--findings", findings]
    done = subprocess.run([*map(str, words), *options], capture_output=True, text=True, check=False)
    if done.returncode == 0:
        return None, "", ""
    if done.returncode != 1:
        return None, "", f"the attack failed, exit {done.returncode}: {done.stderr[-200:]}"
    said = json.loads(findings.read_text().splitlines()[0])["case"]
    return int(said["id"].rsplit("/", 1)[1]), said["comment"].split(";")[0].removeprefix("changed: "), ""


def try_defect(config, patch, rounds, seed):
    root = config.work / patch.name
    root.mkdir(parents=True, exist_ok=True)
    error = plant(config, patch, root) or compile_defect(config, patch, None, root)
    result = (None, "", error) if error else attack(root / "driver", root, patch.options, rounds, seed)
    remove_copies(patch, root)
    return result


def try_none(config, options, rounds, seed):
    root = config.work / "-".join(["none", *(word.strip("-") for word in options)])
    root.mkdir(parents=True, exist_ok=True)
    return attack(config.driver, root, options, rounds, seed)


def fault_of(patch, result, rounds):
    """Says what became of a defect; a fault, or nothing."""
    number, classes, error = result
    if error:
        return f"{patch.name} {error}"
    if number is None:
        return f"{patch.name} survives {rounds} rounds"
    print(f"{patch.name}: found in round {number} ({classes})", flush=True)
    return ""


def all_of(pool, work, jobs):
    """work of each of the jobs at the same time; in their order."""
    try:
        yield from pool.map(work, jobs)
    except KeyboardInterrupt:
        pool.shutdown(wait=False, cancel_futures=True)
        raise


def arguments():
    parser = argparse.ArgumentParser(prog="./run attack --planted", description=__doc__.split("\n\n")[0])
    parser.add_argument("config", help="written by CMake: attack-Release.conf")
    parser.add_argument("--work", required=True, help="where copies are kept")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="defects at a time")
    parser.add_argument("--rounds", type=int, default=ROUNDS, help="a defect that they do not find survives")
    parser.add_argument("--seed", type=int, default=1, help="of the rounds")
    parser.add_argument("name", nargs="*", help="defects of properties/attack/defects, or paths; all if none is given")
    return parser.parse_intermixed_args()


def main():
    options = arguments()
    if options.jobs < 1 or options.rounds < 1:
        raise Fault("--jobs and --rounds are 1 or more")
    config = Config(options.config, options.work)
    patches = named_patches(HERE / "defects", options.name, lambda path: CheckerDefect(path, config.source))
    latest, faults = {}, []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        results = all_of(pool, lambda patch: try_defect(config, patch, options.rounds, options.seed), patches)
        for patch, result in zip(patches, results):
            fault = fault_of(patch, result, options.rounds)
            faults += [fault] if fault else []
            kind = tuple(patch.options)
            latest[kind] = max(latest.get(kind, LEAST_ROUNDS), (result[0] or 0) + 1)
        results = all_of(pool, lambda job: try_none(config, *job, options.seed), latest.items())
        for (kind, rounds), (number, classes, error) in zip(latest.items(), results):
            what = " ".join(["without a defect", *kind])
            if error:
                faults.append(f"{what} {error}")
            elif number is not None:
                faults.append(f"{what} round {number} has a finding ({classes})")
            else:
                print(f"{what}: nothing found in {rounds} rounds")
    return faults


if __name__ == "__main__":
    end(main)
