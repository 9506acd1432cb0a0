#!/usr/bin/env python3
"""Plants each defect of the catalogue in a copy of the sources, and lets the laws look for it.

A patch begins with header lines, then a diff that `patch --strip=1 --fuzz=1` applies to the root:
  Defect: what is wrong, in one sentence
  Law: the law that has to notice; its kind says which methods are compiled with the defect
  Report: an id of the list of reported failures that the mechanism is known from, if there is one
  Class: the letter of that failure's class
  Compile: for a defect in a header of oracles/, the .cpp files that include it

A defect in core is compiled into the methods of the law's kind alone (linear, query, rotating; in double,
unless the patch speaks of float), one in an oracle into that oracle. All laws of the kind see generated cases
(driver.cpp), none of the curated ones. What a defect came to is kept in the work directory under a hash of
all that it depends on, so that a run that was stopped continues where it was.
"""
import argparse
import os
import pathlib
import random
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from certified import RUNS, certify_all, faults_of_certify  # noqa: E402
from planted import Config, Fault, Patch, end, kind_of, named_patches, plant  # noqa: E402
from report import faults_of_laws, faults_of_patches, how, matrix, page  # noqa: E402
from tried import CASES_OF_ALL, read_laws, try_all  # noqa: E402


def spread(config, patches, count, seed):
    """A sample that a seed fixes: in turn one of each kind of laws and of what they need."""
    groups = {}
    for patch in patches:
        groups.setdefault((kind_of(config, patch), config.law_needs[patch.law]), []).append(patch)
    shuffle = random.Random(seed)
    turns = [shuffle.sample(groups[key], len(groups[key])) for key in sorted(groups)]
    shuffle.shuffle(turns)
    out = []
    while turns and len(out) < count:
        for turn in list(turns):
            out.append(turn.pop())
            if not turn:
                turns.remove(turn)
    return out[:count]


def check_apply(config, patches):
    """Every patch applies and names a law; every law is named by a patch."""
    root = config.work / "apply"
    root.mkdir(parents=True, exist_ok=True)
    faults = []
    for patch in patches:
        kind_of(config, patch)
        error = plant(config, patch, root)
        if error:
            faults.append(f"{patch.name} {error}")
    shutil.rmtree(root)
    named = {patch.law for patch in patches}
    faults += [f"no planted defect names the law {law}" for law in config.law_kind if law not in named]
    tied = [patch for patch in patches if patch.reports or patch.classes]
    print(f"{len(patches)} defects, {len(tied)} of them known from reports, for {len(config.law_kind)} laws")
    return faults


def check_none(config):
    """Without a defect every law holds: the methods as the libraries have them."""
    faults = []
    for kind, count in CASES_OF_ALL.items():
        done = subprocess.run([config.driver, kind, str(count)], capture_output=True, text=True, check=False)
        broken = {law: what for law, what in read_laws(done.stdout).items() if what}
        faults += [f"{law} is broken without any defect: {what}" for law, what in broken.items()]
        if done.returncode not in (0, 1):
            faults.append(f"the driver failed: {done.stderr[-200:]}")
        print(f"{kind}: {len(read_laws(done.stdout)) - len(broken)} laws hold without a defect")
    return faults


def arguments():
    parser = argparse.ArgumentParser(prog="./run defects", description=__doc__.split("\n\n")[0])
    parser.add_argument("config", help="written by CMake: defects-Release.conf")
    parser.add_argument("--work", required=True, help="where copies and results are kept")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="defects at a time")
    parser.add_argument("--sample", type=int, metavar="N", help="N defects, each tried by the law that it names")
    parser.add_argument("--seed", type=int, default=1, help="of the sample")
    parser.add_argument("--own", action="store_true", help="each defect is tried by the law that it names alone")
    parser.add_argument("--apply", action="store_true", help="only check that all patches apply and are named")
    parser.add_argument("--none", action="store_true", help="only check that without a defect every law holds")
    parser.add_argument("--certify", action="store_true",
                        help="ask `graze certify` instead of the laws: what convicts with --thorough must by default")
    parser.add_argument("--counts", metavar="L,R,Q", help="--certify: of so many cases of a linear family, of a "
                        "rotating one, and for queries, instead of the default and of --thorough")
    parser.add_argument("--write", action="store_true", help="write build/reports/defects.md and defects.csv")
    parser.add_argument("patch", nargs="*", help="patches, by name or path; all if none is given")
    return parser.parse_intermixed_args()


def main():
    options = arguments()
    config = Config(options.config, options.work)
    config.learn_laws()
    if options.none:
        return check_none(config)
    patches = named_patches(config.defects, options.patch, Patch)
    if options.apply:
        return check_apply(config, patches)
    if options.write and (options.patch or options.own or options.sample):
        raise Fault("--write is for a run of all defects and all laws")
    if options.jobs < 1:
        raise Fault("--jobs is 1 or more")
    if options.certify and (options.write or options.own):
        raise Fault("--certify asks no law: leave --write and --own away")
    if options.sample:
        patches = spread(config, patches, options.sample, options.seed)
    if options.certify:
        runs = (options.counts,) if options.counts else RUNS
        return faults_of_certify(certify_all(config, patches, options.jobs, runs))
    own = bool(options.own or options.sample)
    results = try_all(config, patches, options.jobs, own)
    for patch in patches:
        result = results[patch.name]
        seen = [f"{law} ({how(result, law)})" for law in result["laws"] if result["laws"][law]]
        print(f"{patch.name}: {', '.join(seen) or '-'}")
    faults = faults_of_patches(config, patches, results)
    if not (own or options.patch):
        faults += faults_of_laws(config, results)
        if options.write:
            reports = config.source / "build/reports"
            reports.mkdir(parents=True, exist_ok=True)
            (reports / "defects.md").write_text(page(config, patches, results))
            (reports / "defects.csv").write_text(matrix(config, patches, results))
    return faults


if __name__ == "__main__":
    end(main, "\ngraze: stopped; what is done is kept, and the next run continues from there\n")
