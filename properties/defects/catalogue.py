#!/usr/bin/env python3
"""Plants each defect of the catalogue in a copy of the sources, and lets the laws look for it.

A patch begins with header lines, then a diff that `patch --strip=1 --fuzz=3` applies to the root:
  Defect: what is wrong, in one sentence
  Law: the law that has to notice; its kind says which methods are compiled with the defect
  Report: an id of the list of reported failures that the mechanism is known from, if there is one
  Class: the letter of that failure's class
  Compile: for a defect in a header of oracles/, the .cpp files that include it

A defect in core is compiled into the methods of the law's kind alone (linear, query, rotating; in double,
unless the patch speaks of float), one in an oracle into that oracle. All laws of the kind see generated cases
(driver.cpp), none of the curated ones. What a defect came to is kept in the work directory under a hash of
all that it depends on, so that a run that was stopped goes on where it was.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import threading
import time

# How many cases the law that a patch names sees, and all the others.
CASES = {"linear": 2000, "query": 1000, "rotating": 240}
CASES_OF_ALL = {"linear": 120, "query": 80, "rotating": 60}
METHODS = {"linear": "engines/casts.cpp", "query": "engines/queries.cpp", "rotating": "engines/rotating.cpp"}
NEEDS = ("metamorphic", "proof", "oracle")
# Of one class: how many laws may kill a defect that is to speak for each of them.
FEW = 5
# Seconds for all laws on one defect: fifty times what they take.
TIME_LIMIT = 3600
CLASS_LETTERS = "ABCDEFGHIJKL"


class Fault(Exception):
    """Something is wrong with the input; one line says what."""


class Config:
    def __init__(self, path, work):
        try:
            lines = pathlib.Path(path).read_text().splitlines()
        except OSError as error:
            raise Fault(f"{path}: {error.strerror}; give the file that CMake writes, defects-Release.conf")
        fields = dict(line.split(" = ", 1) if " = " in line else (line.rstrip(" ="), "") for line in lines if line)
        missing = {"source", "driver", "launcher", "compiler", "flags", "includes", "link"} - fields.keys()
        if missing:
            raise Fault(f"{path}: no field {sorted(missing)[0]}; give the file that CMake writes")
        self.source = pathlib.Path(fields["source"])
        self.driver = fields["driver"]
        self.compiler = [word for word in (fields["launcher"], fields["compiler"]) if word]
        self.flags = fields["flags"].split(";")
        self.includes = fields["includes"].split(";")
        self.link = fields["link"].split(";")
        self.work = pathlib.Path(work).resolve()
        self.defects = self.source / "properties/defects"
        self.law_kind, self.law_needs = {}, {}

    def learn_laws(self):
        out = subprocess.run([self.driver, "--laws"], capture_output=True, text=True, check=True).stdout
        for line in out.splitlines():
            name, kind, needs = line.split()
            if name in self.law_kind:
                raise Fault(f"two laws are called {name}; a law has a name of its own")
            self.law_kind[name], self.law_needs[name] = kind, needs


class Patch:
    def __init__(self, path):
        self.path = path
        self.name = path.stem
        try:
            self.text = path.read_text()
        except OSError as error:
            raise Fault(f"{path}: {error.strerror}; give a .patch of properties/defects")
        head = self.text.split("\n--- ", 1)[0]
        self.headers = re.findall(r"^([A-Z][a-z]+): (.+)$", head, re.M)
        unknown = [key for key, _ in self.headers if key not in ("Defect", "Law", "Report", "Class", "Compile")]
        if unknown:
            raise Fault(f"{path}: {unknown[0]} is no header line; known are Defect, Law, Report, Class, Compile")
        self.defect, self.law = self.one("Defect"), self.one("Law")
        self.reports, self.classes = self.all("Report"), self.all("Class")
        if any(letter not in CLASS_LETTERS for letter in self.classes):
            raise Fault(f"{path}: Class is one of the letters A to L")
        self.files = re.findall(r"^\+\+\+ b/(\S+)", self.text, re.M)
        self.in_core = any(name.startswith("core/") for name in self.files)
        self.compiled = [name for name in self.files if name.startswith("oracles/") and name.endswith(".cpp")]
        self.compiled += self.all("Compile")
        if not self.in_core and not self.compiled:
            raise Fault(f"{path}: nothing to compile: patch core/, a .cpp of oracles/, or name one by Compile")

    def all(self, key):
        return [word for k, value in self.headers if k == key for word in value.split(", ")] if key != "Defect" \
            else [value for k, value in self.headers if k == key]

    def one(self, key):
        values = self.all(key)
        if len(values) != 1:
            raise Fault(f"{self.path}: {len(values)} lines \"{key}: ...\"; one is right")
        return values[0]


def run(words, log, **more):
    with open(log, "a") as out:
        return subprocess.run(words, stdout=out, stderr=out, check=False, **more).returncode


def plant(config, patch, root):
    """The sources that the patch can change, with the defect, under root. An error, or nothing."""
    for room in ("core", "oracles"):
        shutil.rmtree(root / room, ignore_errors=True)
        if room == "core" or patch.compiled:
            shutil.copytree(config.source / room, root / room)
    log = root / "log"
    log.write_text("")
    if run(["patch", "--quiet", "--strip=1", "--fuzz=3", "--directory", root, "--input", patch.path], log):
        return "does not apply any more; make it again: " + " ".join(log.read_text().split())
    return ""


def compile_defect(config, patch, kind, root):
    """A driver whose methods, or whose oracle, carry the defect. An error, or nothing."""
    objects = []
    alone = [] if "float" in patch.text else ["-DGRAZE_DOUBLE_ALONE"]
    files = [str(root / name) for name in patch.compiled]
    if patch.in_core:
        files.append(str(config.source / METHODS[kind]))
    include = [f"-I{root}/core", f"-I{root}", f"-I{config.source}"]
    include += [word for path in config.includes for word in ("-isystem", path)]
    log = root / "log"
    for name in files:
        objects.append(str(root / (pathlib.Path(name).stem + ".o")))
        if run([*config.compiler, *config.flags, *alone, *include, "-c", name, "-o", objects[-1]], log):
            return f"does not compile, see {log}"
    if run([config.compiler[-1], *objects, *config.link, "-o", root / "driver"], log):
        return f"does not link, see {log}"
    return ""


def state_of(config):
    """A hash of all that a result depends on beside its patch: the driver has everything in it but core."""
    state = hashlib.sha256(repr((CASES, CASES_OF_ALL, config.flags, config.includes)).encode())
    state.update(pathlib.Path(config.driver).read_bytes())
    for path in sorted([*(config.source / "core").rglob("*.hpp"), *(config.source / "oracles").glob("*.?pp"),
                        *(config.source / "engines").glob("*.?pp")]):
        state.update(path.read_bytes())
    return state.hexdigest()


class Results:
    """What became of each defect, kept on disk."""

    def __init__(self, config):
        self.config = config
        self.state = state_of(config)
        self.folder = config.work / "results"
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


def kind_of(config, patch):
    if patch.law not in config.law_kind:
        raise Fault(f"{patch.path}: no law {patch.law}; `{config.driver} --laws` lists them")
    return config.law_kind[patch.law]


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
    for room in ("core", "oracles", "driver"):
        path = root / room
        shutil.rmtree(path, ignore_errors=True) if path.is_dir() else path.unlink(missing_ok=True)
    return {"kind": kind, "error": error, "laws": killers}


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


def try_all(config, patches, jobs, only_own_law):
    results = Results(config)
    progress = Progress(len(patches))

    def one(patch):
        result = results.find(patch, only_own_law)
        if result is None:
            result = try_defect(config, patch, only_own_law)
            if not result["error"]:
                results.keep(patch, only_own_law, result)
        noticed = sum(1 for how in result["laws"].values() if how)
        progress.step(f"{patch.name}: {result['error'] or f'noticed by {noticed} laws'}")
        return patch.name, result

    pool = concurrent.futures.ThreadPoolExecutor(jobs)
    try:
        return dict(pool.map(one, patches))
    except KeyboardInterrupt:
        pool.shutdown(wait=False, cancel_futures=True)
        raise
    finally:
        progress.end()


def killers_of(config, result, needs):
    return [law for law in result["laws"] if result["laws"][law] and config.law_needs[law] == needs]


def faults_of_patches(config, patches, results):
    """A defect that survives, or that the law named for it does not notice."""
    out = []
    for patch in patches:
        result = results[patch.name]
        if result["error"]:
            out.append(f"{patch.name}: {result['error']}")
        elif not any(result["laws"].values()):
            out.append(f"{patch.name} survives: no law notices that {patch.defect}")
        elif not result["laws"].get(patch.law):
            seen = ", ".join(law for law, how in result["laws"].items() if how)
            out.append(f"{patch.name}: {patch.law}, which it names, does not notice; these do: {seen}")
    return out


def sharpest(config, results):
    """{law: (number of defects that it kills, the least number of killers in its class, that defect)}."""
    out = {law: (0, 0, "") for law in config.law_kind}
    for name in sorted(results):
        for needs in NEEDS:
            killers = killers_of(config, results[name], needs)
            for law in killers:
                kills, least, where = out[law]
                if not where or len(killers) < least:
                    least, where = len(killers), name
                out[law] = (kills + 1, least, where)
    return out


def faults_of_laws(config, results):
    out = []
    for law, (kills, least, _) in sharpest(config, results).items():
        if kills == 0:
            out.append(f"{law} kills no defect")
        elif least > FEW:
            out.append(f"{law} is never among {FEW} killers of its class: {least} at the least")
    return out


def page(config, patches, results):
    """docs/defects.md: by defect who notices, by law what it notices. Nothing in it depends on the machine."""
    tied = sum(1 for patch in patches if patch.reports or patch.classes)
    lines = [
        "# Planted defects", "",
        f"{len(patches)} small patches to the library, its oracles and its checker, and the laws that notice them; "
        f"{tied} are mechanisms of reported failures or of their classes. Written by `./run defects --write`: each "
        "defect is planted in a copy, and all laws of its kind see generated cases, none of them curated: "
        f"{CASES_OF_ALL['linear']:,} linear ones and ten times as many near-ties, {CASES_OF_ALL['query']:,} for the "
        f"other queries, {CASES_OF_ALL['rotating']:,} rotating ones; the law that a patch names sees "
        f"{CASES['linear']:,}, {CASES['query']:,} and {CASES['rotating']:,}. The first broken case is in brackets; "
        "`crashed` and `hangs` are what the defect did to the method.", "",
        "A law is listed under what it needs. Of each law some defect is noticed by at most "
        f"{FEW} laws of its class.", ""]
    for kind in CASES:
        chosen = [patch for patch in patches if results[patch.name]["kind"] == kind]
        if not chosen:
            continue
        lines += [f"## {kind.capitalize()}: by defect", "",
                  "| defect | what is wrong | known from | metamorphic | proof | oracle |", "|---|---|---|---|---|---|"]
        for patch in chosen:
            result = results[patch.name]
            cells = [", ".join(f"{law} ({how(result, law)})" for law in killers_of(config, result, needs)) or "-"
                     for needs in NEEDS]
            known = ", ".join([*patch.reports, *(f"class {letter}" for letter in patch.classes)]) or "-"
            lines.append(f"| {patch.name} | {patch.defect} | {known} | " + " | ".join(cells) + " |")
        lines += ["", f"## {kind.capitalize()}: by law", "",
                  "| law | class | defects noticed | fewest killers | of the defect |", "|---|---|---|---|---|"]
        for law, (kills, least, where) in sharpest(config, results).items():
            if config.law_kind[law] == kind:
                lines.append(f"| {law} | {config.law_needs[law]} | {kills} | {least} | {where or '-'} |")
        lines.append("")
    return "\n".join(lines)


def how(result, law):
    return result["laws"][law].replace("broken ", "")


def matrix(config, patches, results):
    """Law x defect as lines of comma-separated values: the first broken case, nothing where the law holds, a dash
    where it is of another kind."""
    names = [patch.name for patch in patches]
    lines = [",".join(["law", "kind", "class", *names])]
    for law, kind in config.law_kind.items():
        cells = [how(results[name], law) if law in results[name]["laws"] else "-" for name in names]
        lines.append(",".join([law, kind, config.law_needs[law], *cells]))
    return "\n".join(lines) + "\n"


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
    parser.add_argument("--write", action="store_true", help="write docs/defects.md and docs/defects.csv")
    parser.add_argument("patch", nargs="*", help="patches, by name or path; all if none is given")
    return parser.parse_intermixed_args()


def chosen_patches(config, names):
    if not names:
        return [Patch(path) for path in sorted(config.defects.glob("*.patch"))]
    out = []
    for name in names:
        path = pathlib.Path(name)
        out.append(Patch(path.resolve() if path.suffix == ".patch" else config.defects / f"{name}.patch"))
    return out


def main():
    options = arguments()
    config = Config(options.config, options.work)
    config.learn_laws()
    if options.none:
        return check_none(config)
    patches = chosen_patches(config, options.patch)
    if options.apply:
        return check_apply(config, patches)
    if options.write and (options.patch or options.own or options.sample):
        raise Fault("--write is for a run of all defects and all laws")
    if options.jobs < 1:
        raise Fault("--jobs is 1 or more")
    if options.sample:
        patches = spread(config, patches, options.sample, options.seed)
    own = bool(options.own or options.sample)
    results = try_all(config, patches, options.jobs, own)
    for patch in patches:
        laws = results[patch.name]["laws"]
        print(f"{patch.name}: " + (", ".join(f"{law} ({how(results[patch.name], law)})" for law in laws if laws[law]) or "-"))
    faults = faults_of_patches(config, patches, results)
    if not (own or options.patch):
        faults += faults_of_laws(config, results)
        if options.write:
            (config.source / "docs/defects.md").write_text(page(config, patches, results))
            (config.source / "docs/defects.csv").write_text(matrix(config, patches, results))
    return faults


if __name__ == "__main__":
    try:
        found = main()
    except Fault as fault:
        print(f"graze: {fault}", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        print("\ngraze: stopped; what is done is kept, and the next run goes on from there", file=sys.stderr)
        sys.exit(130)
    for fault in found:
        print(f"FAIL: {fault}")
    sys.exit(1 if found else 0)
