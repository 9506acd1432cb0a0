"""What the laws make of planted defects, kept on disk."""
import concurrent.futures
import hashlib
import json
import shutil
import subprocess
import sys
import threading
import time

from planted import compile_defect, kind_of, plant

# How many cases the law that a patch names sees, and all the others.
CASES = {"linear": 2000, "query": 1000, "rotating": 600}
CASES_OF_ALL = {"linear": 120, "query": 80, "rotating": 60}
# Seconds for all laws on one defect: fifty times what they take.
TIME_LIMIT = 3600


def state_of(config, rooms, patterns=("*.?pp",)):
    """A hash of all that a result depends on beside its patch: the sources that a driver is built from."""
    state = hashlib.sha256(repr((CASES, CASES_OF_ALL, config.flags, config.includes)).encode())
    paths = list((config.source / "core").rglob("*.hpp"))
    for room in rooms:
        for pattern in patterns:
            paths += (config.source / room).rglob(pattern)
    for path in sorted(paths):
        state.update(path.read_bytes())
    return state.hexdigest()


class Results:
    """What became of each defect, kept on disk. A key: what a result depends on beside the state and the patch."""

    def __init__(self, folder, state, key):
        self.state, self.key = state, key
        self.folder = folder
        self.folder.mkdir(parents=True, exist_ok=True)

    def hash_of(self, patch):
        return hashlib.sha256((self.state + patch.text + repr(self.key)).encode()).hexdigest()

    def find(self, patch):
        try:
            kept = json.loads((self.folder / f"{patch.name}.json").read_text())
            return kept["result"] if kept["key"] == self.hash_of(patch) else None
        except (OSError, ValueError, KeyError):
            return None

    def keep(self, patch, result):
        path = self.folder / f"{patch.name}.json"
        path.with_suffix(".new").write_text(json.dumps({"key": self.hash_of(patch), "result": result}))
        path.with_suffix(".new").replace(path)


def read_laws(text):
    """{law: "broken 12" | "crashed 12" | "hangs 12" | ""} from what the driver printed."""
    out = {}
    for line in text.splitlines():
        name, what, number = line.split()
        out[name] = "" if what == "holds" else f"{what} {number}"
    return out


def ask_laws(root, kind, count, laws):
    """What the driver under root says of the laws (of all of the kind if none are named), and an error or nothing."""
    try:
        done = subprocess.run([root / "driver", kind, str(count), *laws], capture_output=True, text=True,
                              check=False, timeout=TIME_LIMIT)
    except subprocess.TimeoutExpired:
        return {}, f"the laws did not end in {TIME_LIMIT} s"
    error = f"the driver failed, exit {done.returncode}: {done.stderr[-200:]}" if done.returncode not in (0, 1) else ""
    return read_laws(done.stdout), error


def try_defect(config, patch, only_own_law):
    """Compiles one defect, and runs the law that it names, then all of the kind on fewer cases."""
    kind = kind_of(config, patch)
    root = config.work / patch.name
    root.mkdir(parents=True, exist_ok=True)
    error = plant(config, patch, root) or compile_defect(config, patch, kind, root)
    killers = {}
    if not error:
        killers, error = ask_laws(root, kind, CASES[kind], [patch.law])
    if not error and not only_own_law:
        of_all, error = ask_laws(root, kind, CASES_OF_ALL[kind], [])
        killers = of_all | killers
    clear(root)
    return {"kind": kind, "error": error, "laws": killers}


def clear(root):
    for room in ("core", "oracles", "driver"):
        path = root / room
        shutil.rmtree(path, ignore_errors=True) if path.is_dir() else path.unlink(missing_ok=True)


class Progress:
    """One line on a terminal, a line a defect elsewhere."""

    def __init__(self, total):
        self.total, self.done, self.start = total, 0, time.monotonic()
        self.lock = threading.Lock()

    def step(self, text):
        with self.lock:
            self.done += 1
            line = f"[{self.done}/{self.total}] {text}"
            if sys.stderr.isatty():
                print(f"\r\033[K{line[:110]}", end="", file=sys.stderr, flush=True)
            else:
                print(line, file=sys.stderr, flush=True)

    def end(self):
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr)


def outcome(result):
    return result["error"] or f"noticed by {sum(1 for how in result['laws'].values() if how)} laws"


def try_each(results, patches, jobs, try_one, outcome_of):
    """try_one of each patch, unless its result is kept. What ends in an error is tried again the next time."""
    progress = Progress(len(patches))

    def one(patch):
        result = results.find(patch)
        if result is None:
            result = try_one(patch)
            if not result["error"]:
                results.keep(patch, result)
        progress.step(f"{patch.name}: {outcome_of(result)}")
        return patch.name, result

    pool = concurrent.futures.ThreadPoolExecutor(jobs)
    try:
        return dict(pool.map(one, patches))
    except KeyboardInterrupt:
        pool.shutdown(wait=False, cancel_futures=True)
        raise
    finally:
        progress.end()


def try_all(config, patches, jobs, only_own_law):
    state = state_of(config, ("corpus", "oracles", "engines", "properties"))
    results = Results(config.work / "results", state, only_own_law)
    return try_each(results, patches, jobs, lambda patch: try_defect(config, patch, only_own_law), outcome)
