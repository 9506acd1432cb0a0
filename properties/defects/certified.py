"""What `graze certify` says of planted defects: by default, and, where that convicts nobody, with --thorough.

`graze certify` is a function of the cases, of the methods' answers, and of its judges. A defect in core is compiled
into the methods of one kind, and into nothing else. So what their answers came to without the defect is kept, once
for a state of the sources (certify/answers.hpp), and of a defect those answers alone are judged that differ: a
minute, where a verdict from nothing takes five. A defect in a judge is met with every answer of every kind.
"""
import re
import signal
import subprocess
import threading

from planted import Fault, compile_objects, enclose, kind_of, link_defect, plant
from tried import TIME_LIMIT, Results, clear, state_of, try_each

# What the command judges by default, and what it judged before a verdict came in a minute.
RUNS = ("default", "thorough")
KINDS = ("linear", "query", "rotating")
ROOMS = ("corpus", "oracles", "engines", "properties", "certify", "reports")


class Kept:
    """The files of answers without a defect, made when they are first needed."""

    def __init__(self, config, state):
        self.config = config
        self.folder = config.work / "answers" / state[:16]
        self.folder.mkdir(parents=True, exist_ok=True)
        self.locks = {}
        self.lock = threading.Lock()

    def find(self, kind, run):
        with self.lock:
            lock = self.locks.setdefault((kind, run), threading.Lock())
        with lock:
            path = self.folder / f"{kind}_{run}.txt"
            if not path.exists():
                done = subprocess.run([self.config.certify, "keep", kind, run, path.with_suffix(".new")],
                                      capture_output=True, text=True, check=False)
                if done.returncode:
                    raise Fault(f"certify without a defect ({kind}, {run}): {(done.stdout + done.stderr)[-300:]}")
                path.with_suffix(".new").replace(path)
            return path


def ask(root, words):
    """{"broken": row or "", "differing": N or None} of one run of root/driver, and an error or nothing."""
    try:
        done = subprocess.run([root / "driver", *words], capture_output=True, text=True, check=False,
                              timeout=TIME_LIMIT)
    except subprocess.TimeoutExpired:  # a defect that hangs has been ended by its own limit
        return {}, f"no verdict in {TIME_LIMIT} s of {words[1]}, {words[2]}"
    differing = re.search(r"^differing (\d+) of", done.stdout, re.M)
    said = {"broken": "", "differing": int(differing[1]) if differing else None}
    broken = re.search(r"^broken: (.+)$", done.stdout, re.M)
    if done.returncode < 0:
        said["broken"] = "hangs" if done.returncode == -signal.SIGXCPU else f"killed by signal {-done.returncode}"
    elif done.returncode == 1 and broken:
        said["broken"] = broken[1]
    elif done.returncode:
        return {}, f"certify failed, exit {done.returncode}: {done.stderr[-200:]}"
    return said, ""


def certify_defect(config, kept, run, patch):
    """What one run says of one defect."""
    kind = kind_of(config, patch)
    root = config.work / f"certify_{patch.name}"
    root.mkdir(parents=True, exist_ok=True)
    said, error = {}, plant(config, patch, root)
    if not error:
        objects, error = compile_objects(config, patch, kind, root)
        if not error and patch.in_core:
            error = enclose(config, kind, objects[-1], root / "log")
        error = error or link_defect(config, objects, root, config.certify_link)
    if not error and patch.compiled:  # a judge has the defect, of whichever kinds ask it
        for one in (kind, *(other for other in KINDS if other != kind)):
            said, error = ask(root, ["whole", one, run])
            if error or said["broken"]:
                break
    elif not error:
        said, error = ask(root, ["differ", kind, run, kept.find(kind, run)])
    clear(root)
    return {"kind": kind, "error": error, **said}


def outcome(result):
    """In words, with how many cases have another answer than without the defect."""
    if result["error"] or result["broken"]:
        return result["error"] or result["broken"]
    return "convicts nobody" if result["differing"] is None else f"convicts nobody, {result['differing']} cases differ"


def certify_all(config, patches, jobs, runs=RUNS):
    """{name: {run: result}}: what each run says of the defects that those before it do not convict."""
    state = state_of(config, ROOMS, ("*.?pp", "*.json", "*.jsonl"))
    kept = Kept(config, state)
    all_said = {patch.name: {} for patch in patches}
    left = sorted(patches, key=lambda patch: bool(patch.compiled))  # judges take the longest
    for run in runs:
        results = Results(config.work / f"certified_{run}", state, run)
        said = try_each(results, left, jobs, lambda patch, run=run: certify_defect(config, kept, run, patch), outcome)
        for name, result in said.items():
            all_said[name][run] = result
        left = [patch for patch in left if not said[patch.name]["error"] and not said[patch.name]["broken"]]
    return all_said


def faults_of_certify(all_said):
    """What could not be tried, and what a thorough run alone convicts."""
    faults, convicted = [], 0
    for name, said in all_said.items():
        print(f"{name}: {'; '.join(f'{run}: {outcome(result)}' for run, result in said.items())}")
        faults += [f"{name}: {result['error']}" for result in said.values() if result["error"]]
        default, *later = said.values()
        convicted += bool(not default["error"] and default["broken"])
        if any(not result["error"] and result["broken"] for result in later):
            faults.append(f"{name}: convicted by --thorough alone")
    print(f"{convicted} of {len(all_said)} defects are convicted by default")
    return faults
