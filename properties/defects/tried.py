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
# What `graze certify` judges by default, and what it judged before a verdict came in a minute.
CERTIFICATIONS = {"default": [], "thorough": ["--thorough"]}


# The rooms beside core that the driver of laws is built from, and those of the command.
ROOMS = {"results": ("corpus", "oracles", "engines", "properties"),
         "certified": ("corpus", "oracles", "engines", "properties", "certify", "report", "draw", "tools")}


def state_of(config, rooms):
    """A hash of all that a result depends on beside its patch: the sources that a driver is built from."""
    state = hashlib.sha256(repr((CASES, CASES_OF_ALL, config.flags, config.includes)).encode())
    paths = list((config.source / "core").rglob("*.hpp"))
    for room in rooms:
        paths += (config.source / room).rglob("*.?pp")
    for path in sorted(paths):
        state.update(path.read_bytes())
    return state.hexdigest()


class Results:
    """What became of each defect, kept on disk."""

    def __init__(self, config, name):
        self.config = config
        self.state = state_of(config, ROOMS[name])
        self.folder = config.work / name
        self.folder.mkdir(parents=True, exist_ok=True)

    def key(self, patch, only_own_law):
        return hashlib.sha256((self.state + patch.text + repr(only_own_law)).encode()).hexdigest()

    def find(self, patch, only_own_law):
        try:
            kept = json.loads((self.folder / f"{patch.name}.json").read_text())
            return kept["result"] if kept["key"] == self.key(patch, only_own_law) else None
        except (OSError, ValueError, KeyError):
            return None

    def keep(self, patch, only_own_law, result):
        path = self.folder / f"{patch.name}.json"
        path.with_suffix(".new").write_text(json.dumps({"key": self.key(patch, only_own_law), "result": result}))
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


def certify_defect(config, patch):
    """What `graze certify` says of one defect: by default, and, if that convicts nobody, with --thorough."""
    kind = kind_of(config, patch)
    root = config.work / f"certify_{patch.name}"
    root.mkdir(parents=True, exist_ok=True)
    error = plant(config, patch, root) or compile_defect(config, patch, kind, root, config.command_link)
    said = {}
    for name, options in CERTIFICATIONS.items():
        if error or any(said.values()):
            break
        try:
            done = subprocess.run([root / "driver", "certify", "--fail-fast", "--threads", "1", *options],
                                  capture_output=True, text=True, check=False, timeout=TIME_LIMIT)
        except subprocess.TimeoutExpired:  # a thorough run may take as long; by default it is the defect's doing
            if name == "default":
                said[name] = "hangs"
            else:
                error = f"no verdict in {TIME_LIMIT} s with {' '.join(options)}"
            break
        broken = [line for line in done.stdout.splitlines() if line.startswith("broken: ")]
        if done.returncode < 0:
            said[name] = f"killed by signal {-done.returncode}"
        elif done.returncode == 1 and broken:
            said[name] = broken[0].removeprefix("broken: ")
        elif done.returncode == 0:
            said[name] = ""
        else:
            error = f"certify failed, exit {done.returncode}: {done.stderr[-200:]}"
    clear(root)
    return {"kind": kind, "error": error, "said": said}


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
    if result["error"]:
        return result["error"]
    if "laws" in result:
        return f"noticed by {sum(1 for how in result['laws'].values() if how)} laws"
    return next((f"{name}: {how}" for name, how in result["said"].items() if how), "convicts nobody")


def try_all(config, patches, jobs, only_own_law, certifies=False):
    results = Results(config, "certified" if certifies else "results")
    progress = Progress(len(patches))

    def one(patch):
        result = results.find(patch, only_own_law)
        if result is None:
            result = certify_defect(config, patch) if certifies else try_defect(config, patch, only_own_law)
            if not result["error"]:
                results.keep(patch, only_own_law, result)
        progress.step(f"{patch.name}: {outcome(result)}")
        return patch.name, result

    pool = concurrent.futures.ThreadPoolExecutor(jobs)
    try:
        return dict(pool.map(one, patches))
    except KeyboardInterrupt:
        pool.shutdown(wait=False, cancel_futures=True)
        raise
    finally:
        progress.end()
