#!/usr/bin/env python3
"""Plants defects in a copy of a scene's plan, bounds and tree, and lets the law of scenes look for them.

A patch of tests/scene/defects begins with header lines, then a diff that `patch --strip=1 --fuzz=1` applies to the root:
  Defect: what is wrong, in one sentence
  Compile: the .cpp files that the patch changes by a header

Those files alone are compiled again, and linked before the libraries. The law is tried on random scenes until it breaks.
With --apply nothing is compiled: does each patch apply to the sources as they are?
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "properties/defects"))
from planted import Config, Fault, run  # noqa: E402

ROOMS = ("core", "scene")


class Defect:
    def __init__(self, path):
        self.path, self.name = path, path.stem
        try:
            text = path.read_text()
        except OSError as error:
            raise Fault(f"{path}: {error.strerror}; give a .patch of tests/scene/defects")
        head, _, diff = text.partition("\n--- ")
        self.headers = dict(line.split(": ", 1) for line in head.splitlines() if ": " in line)
        if "Defect" not in self.headers or self.headers.keys() - {"Defect", "Compile"}:
            raise Fault(f"{path}: its header lines are Defect and Compile")
        files = [line[6:] for line in diff.splitlines() if line.startswith("+++ b/")]
        self.compiled = [name for name in files if name.endswith(".cpp")]
        self.compiled += self.headers.get("Compile", "").split(", ") if "Compile" in self.headers else []
        if not self.compiled:
            raise Fault(f"{path}: nothing to compile; name a .cpp by Compile")


def why_not_applied(source, defect):
    """Why the patch does not apply, or nothing; changes nothing."""
    words = ["patch", "--dry-run", "--batch", "--strip=1", "--fuzz=1", "--directory", source, "--input", defect.path]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    return "does not apply any more; make it again: " + " ".join(done.stdout.split()) if done.returncode else ""


def what_is_wrong(config, defect, scenes):
    """What is wrong with a planted defect, or nothing: the law breaks."""
    root = config.work / defect.name
    shutil.rmtree(root, ignore_errors=True)
    for room in ROOMS:
        shutil.copytree(config.source / room, root / room)
    log, program = root / "log", root / "scene_law"
    log.write_text("")
    if run(["patch", "--quiet", "--strip=1", "--fuzz=1", "--directory", root, "--input", defect.path], log):
        return "does not apply any more; make it again: " + " ".join(log.read_text().split())
    include = [f"-I{root}/scene", f"-I{root}/core", f"-I{root}", f"-I{config.source}"]
    include += [word for path in config.includes for word in ("-isystem", path)]
    objects = []
    for name in ["tests/scene/scene_law.cpp", *defect.compiled]:
        objects.append(root / f"{len(objects)}.o")
        at = root if (root / name).is_file() else config.source
        if run([*config.compiler, *config.flags, *include, "-c", at / name, "-o", objects[-1]], log):
            return f"does not compile, see {log}"
    if run([config.compiler[-1], *objects, *config.link, "-o", program], log):
        return f"does not link, see {log}"
    for room in ROOMS:
        shutil.rmtree(root / room)
    done = subprocess.run([program, "1", str(scenes)], capture_output=True, text=True, check=False, timeout=600)
    broken = [line for line in done.stdout.splitlines() if line.startswith("broken: ")]
    if done.returncode < 0:
        return ""  # an assertion, or a crash, is a way to be noticed
    return "" if broken else f"survives {scenes} scenes"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("config", help="written by CMake: scene-Release.conf")
    parser.add_argument("--work", required=True, help="where copies are kept")
    parser.add_argument("--apply", action="store_true", help="only see whether the patches apply")
    parser.add_argument("--scenes", type=int, default=4000, help="random scenes to try each on")
    parser.add_argument("name", nargs="*", help="defects of tests/scene/defects; all if none is given")
    options = parser.parse_intermixed_args()
    config = Config(options.config, options.work)
    os.makedirs(config.work, exist_ok=True)
    paths = [HERE / "defects" / f"{name}.patch" for name in options.name]
    faults = []
    for defect in map(Defect, paths or sorted((HERE / "defects").glob("*.patch"))):
        if options.apply:
            fault = why_not_applied(config.source, defect)
        else:
            fault = what_is_wrong(config, defect, options.scenes)
        print(f"{defect.name}: {fault or ('applies' if options.apply else 'found')}", flush=True)
        faults += [defect.name] if fault else []
    return 1 if faults else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Fault as fault:
        print(f"graze: {fault}", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        sys.exit(130)
