#!/usr/bin/env python3
"""What a user's file costs to compile: seconds and memory, beside <Eigen/Core> alone and a Bullet cast.

    compile_cost.py [--rounds 5] [--compiler g++] [--eigen /usr/include/eigen3] [--bullet /usr/include/bullet]

Each file is compiled at -O2 once a round, one after the other, so that what else the machine does meets all alike; the
median of the rounds is shown. Bullet is left out where its headers are not there (Debian: libbullet-dev).
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

CORE = pathlib.Path(__file__).resolve().parent.parent / "core"
CAST = """#include <graze/cast.hpp>
double toi(const graze::Body<double>& a, const graze::Body<double>& b) { return graze::cast(a, b).toi_lower; }
"""
ROTATING = """#include <graze/rotating_cast.hpp>
double toi(const graze::RotatingBody<double>& a, const graze::RotatingBody<double>& b) {
  return graze::cast(a, b).toi_lower;
}
"""
BULLET = """#include <btBulletCollisionCommon.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
double toi(const btConvexShape& a, const btConvexShape& b, const btTransform (&at)[4]) {
  btVoronoiSimplexSolver simplex;
  btSubsimplexConvexCast cast(&a, &b, &simplex);
  btConvexCast::CastResult result;
  return cast.calcTimeOfImpact(at[0], at[1], at[2], at[3], result) ? double(result.m_fraction) : 2;
}
"""


def files(options):
    core = [f"-I{CORE}", "-isystem", options.eigen]
    compiled = [*core, "-DGRAZE_COMPILED"]
    out = {
        "<Eigen/Core> alone": ("#include <Eigen/Core>\n", core),
        "cast, compiled library": (CAST, compiled),
        "rotating cast, compiled library": (ROTATING, compiled),
        "cast, header-only": (CAST, core),
        "rotating cast, header-only": (ROTATING, core),
    }
    if pathlib.Path(options.bullet, "btBulletCollisionCommon.h").exists():
        out["Bullet's subsimplex cast"] = (BULLET, ["-isystem", options.bullet])
    else:
        print("Bullet is left out: no headers in", options.bullet, file=sys.stderr)
    return out


def compile_once(command):
    """Processor seconds, and the peak of memory in MiB."""
    with tempfile.TemporaryFile("w+") as errors:
        process = subprocess.Popen(command, stderr=errors)
        _, status, used = os.wait4(process.pid, 0)  # with what its own children used
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            errors.seek(0)
            sys.exit(f"compile_cost: {' '.join(command)} failed: {errors.readline().strip() or 'no reason given'}")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--eigen", default="/usr/include/eigen3")
    parser.add_argument("--bullet", default="/usr/include/bullet")
    options = parser.parse_args()
    if options.rounds < 1:
        parser.error("--rounds is 1 or more")
    wanted = files(options)
    costs = {name: [] for name in wanted}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(options.rounds):
            for number, (name, (text, flags)) in enumerate(wanted.items()):
                source = pathlib.Path(folder, f"{number}.cpp")
                source.write_text(text)
                costs[name].append(compile_once([options.compiler, "-std=c++20", "-O2", *flags, "-c", str(source),
                                                 "-o", str(source.with_suffix(".o"))]))
    seconds = {name: statistics.median(s for s, _ in rounds) for name, rounds in costs.items()}
    unit = seconds["<Eigen/Core> alone"]
    print(f"{'file':<34}{'seconds':>9}{'of Eigen':>10}{'MiB':>7}")
    for name, rounds in costs.items():
        print(f"{name:<34}{seconds[name]:>9.2f}{seconds[name] / unit:>10.2f}{max(m for _, m in rounds):>7.0f}")


if __name__ == "__main__":
    main()
