#!/usr/bin/env python3
"""Plants defects in a copy of a scene's plan, bounds and tree, and lets the law of scenes look for them.

A patch of tests/scene/defects begins with header lines, then a diff that `patch --strip=1 --fuzz=1` applies to the root:
  Defect: what is wrong, in one sentence
  Compile: the .cpp files that the patch changes by a header

Those files alone are compiled again, and linked before the libraries. The law is tried on random scenes until it breaks.
With --apply nothing is compiled: does each patch apply to the sources as they are?
"""
import argparse
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "properties/defects"))
from planted import Config, Fault, Patch, end, named_patches, plant, remove_copies, run  # noqa: E402


class SceneDefect(Patch):
    FOLDER = "tests/scene/defects"
    ROOMS = ("core", "scene")
    KEYS = ("Defect", "Compile")
    NAMES = "Defect"  # the law of scenes has to notice

    def __init__(self, path):
        super().__init__(path)
        if not self.compiled:
            raise Fault(f"{path}: nothing to compile; name a .cpp by Compile")


def what_is_wrong(config, defect, scenes):
    """What is wrong with a planted defect, or nothing: the law breaks. Without scenes it only has to apply."""
    root = config.work / defect.name
    root.mkdir(parents=True, exist_ok=True)
    error = plant(config, defect, root)
    if error or not scenes:
        remove_copies(defect, root)
        return error
    log, program = root / "log", root / "scene_law"
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
    remove_copies(defect, root)
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
    faults = []
    for defect in named_patches(HERE / "defects", options.name, SceneDefect):
        fault = what_is_wrong(config, defect, 0 if options.apply else options.scenes)
        print(f"{defect.name}: {fault or ('applies' if options.apply else 'found')}", flush=True)
        faults += [f"{defect.name} {fault}"] if fault else []
    return faults


if __name__ == "__main__":
    end(main)
