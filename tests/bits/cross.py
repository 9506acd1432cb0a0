#!/usr/bin/env python3
"""Builds graze for other compilers, flags and processors, and compares the bits of its answers.

usage: cross.py [--bits] [TARGET...]   (all targets by default; --list names them)

Each target builds core, scene, three examples, the digests of all answers and unit tests of core. It runs them, under
an emulator where the processor is another one. With --bits it is the digests alone. The table at the end has a row for
each. Its last column counts the vector instructions of the digests for aarch64. Exit code 1: a row is not well.
"""
import argparse
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
WORK = ROOT / "build" / "cross"
# For a Node that is not Debian's: the modules of Debian's emscripten. For wine: no windows and no messages of its own.
ENVIRONMENT = {"NODE_PATH": "/usr/share/nodejs", "WINEDEBUG": "-all", "WINEDLLOVERRIDES": "mscoree,mshtml="}
MOST_SECONDS = 3600  # of a build or a run
FUSED = "-march=x86-64-v3 -ffp-contract=fast"
# Of NEON, on four floats or two doubles: what the scans of vertices are made of.
VECTORS = re.compile(r"\bf(mul|add|max|maxnm|cmeq|cmgt)\s+v\d+\.(4s|2d)")


class Target:
    def __init__(self, compiler, flags="", packages="", run="", system="", headers=False, link="", suffix="",
                 objdump=""):
        self.compiler, self.packages, self.run, self.objdump = compiler, packages, run, objdump
        self.flags = flags if "-O" in flags else f"-O2 {flags}".strip()
        self.system, self.headers, self.link, self.suffix = system, headers, link, suffix


def emulated(triple, qemu, flags="", objdump=""):
    return Target(f"{triple}-g++", flags, f"g++-{triple} qemu-user", f"qemu-{qemu} -L /usr/{triple}", "Linux",
                  objdump=objdump)


TARGETS = {
    "native": Target("g++", "-O2"),
    "o1": Target("g++", "-O1", headers=True),
    "fused": Target("g++", f"-O3 {FUSED}", headers=True),
    "scalar": Target("g++", "-O2 -DEIGEN_DONT_VECTORIZE", headers=True),
    "plain": Target("g++", "-O2 -DGRAZE_GNU=0", headers=True),  # without vector types and asm, as for MSVC
    "clang": Target("clang++-14", f"-O3 {FUSED}", "clang-14", headers=True),
    "libc++": Target("clang++-16", "-O2 -stdlib=libc++", "clang-16 libc++-16-dev libc++abi-16-dev",
                     link="-stdlib=libc++"),
    "aarch64": emulated("aarch64-linux-gnu", "aarch64", objdump="aarch64-linux-gnu-objdump"),
    "aarch64-headers": Target("aarch64-linux-gnu-g++", "-O3 -ffp-contract=fast", "g++-aarch64-linux-gnu qemu-user",
                              "qemu-aarch64 -L /usr/aarch64-linux-gnu", "Linux", headers=True),
    "aarch64-clang": Target("clang++-14", "-O3 --target=aarch64-linux-gnu -ffp-contract=fast",
                            "clang-14 g++-aarch64-linux-gnu qemu-user", "qemu-aarch64 -L /usr/aarch64-linux-gnu",
                            "Linux", headers=True),
    "armhf": emulated("arm-linux-gnueabihf", "arm", "-Wno-psabi"),
    "riscv64": emulated("riscv64-linux-gnu", "riscv64"),
    "s390x": emulated("s390x-linux-gnu", "s390x"),
    "mingw": Target("x86_64-w64-mingw32-g++-posix", "-O2 -Wa,-mbig-obj", "g++-mingw-w64-x86-64-posix wine64 wine",
                    "wine", "Windows", link="-static", suffix=".exe"),
    "wasm": Target("em++", "-O2 -msimd128 -fwasm-exceptions", "emscripten nodejs",
                   "node --stack-size=4000", "Emscripten",
                   link="-fwasm-exceptions -s SINGLE_FILE=1 -s ALLOW_MEMORY_GROWTH=1 -s TOTAL_STACK=4MB -s EXIT_RUNTIME=1",
                   suffix=".js"),
}


def install(packages):
    if not shutil.which("dpkg-query"):
        return
    missing = [p for p in packages if "install ok installed" not in subprocess.run(
        ["dpkg-query", "-W", "-f=${Status}", p], capture_output=True, text=True).stdout]
    if not missing:
        return
    print(f"graze: installing {len(missing)} Debian packages: {' '.join(missing)}", file=sys.stderr)
    root = [] if os.geteuid() == 0 else ["sudo"]
    subprocess.run(root + ["apt-get", "update", "-qq"], check=True)
    subprocess.run(root + ["env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "install", "-y", "-qq",
                           "--no-install-recommends", *missing], check=True, stdout=subprocess.DEVNULL)


def eigen():
    """The headers of Eigen, where a cross compiler looks for them: they hold no code of a processor's."""
    for prefix in os.environ.get("CMAKE_PREFIX_PATH", "").split(":") + ["/usr", "/usr/local", "/opt/homebrew"]:
        if prefix and (pathlib.Path(prefix) / "share/eigen3/cmake").exists():
            return pathlib.Path(prefix) / "share/eigen3/cmake"
    return None


def configure(target, build):
    options = {
        "CMAKE_CXX_COMPILER": target.compiler, "CMAKE_BUILD_TYPE": "None",
        "CMAKE_CXX_FLAGS": target.flags, "CMAKE_EXE_LINKER_FLAGS": target.link,
        "AS_HEADERS": "ON" if target.headers else "OFF",
    }
    if target.system:
        options |= {"CMAKE_SYSTEM_NAME": "Generic" if target.system == "Emscripten" else target.system,
                    "CMAKE_EXECUTABLE_SUFFIX_CXX": target.suffix}
    if target.system == "Emscripten":  # no threads: the scene runs in the one that there is
        options |= {"CMAKE_HAVE_LIBC_PTHREAD": "ON", "CMAKE_SYSTEM_PROCESSOR": "wasm32"}
    if eigen():
        options["Eigen3_DIR"] = str(eigen())
    googletest = pathlib.Path("/usr/src/googletest/googletest")  # the sources of Debian's libgtest-dev
    if googletest.exists():
        options["GTEST_SOURCES"] = str(googletest)
    return ["cmake", "-S", str(HERE / "elsewhere"), "-B", str(build), "-G", "Ninja"] + [
        f"-D{name}={value}" for name, value in options.items()]


def run(command, log):
    log.write(f"$ {shlex.join(command)}\n")
    log.flush()
    try:
        return subprocess.run(command, stdout=log, stderr=subprocess.STDOUT, timeout=MOST_SECONDS,
                              env=ENVIRONMENT | dict(os.environ)).returncode == 0
    except subprocess.TimeoutExpired:
        log.write(f"ended after {MOST_SECONDS} s\n")
        return False


def attempt(name, target, bits_only):
    build = WORK / name
    build.mkdir(parents=True, exist_ok=True)
    start = time.monotonic()
    row = {"target": name, "build": "failed", "bits": "-", "tests": "-", "examples": "-", "vectors": "-"}
    with open(build / "log.txt", "w", encoding="utf-8") as log:
        if not run(configure(target, build), log) or not run(
                ["cmake", "--build", str(build), *(["--target", "digests"] if bits_only else [])], log):
            return row
        row["build"] = f"{time.monotonic() - start:.0f} s"
        program = shlex.split(target.run) + [str(build / f"digests{target.suffix}")]
        if target.objdump:
            code = subprocess.run([target.objdump, "-d", program[-1]], capture_output=True, text=True, check=True).stdout
            row["vectors"] = str(len(VECTORS.findall(code)))
        row["bits"] = "same" if run([str(HERE / "compare.sh"), "usual", *program], log) else "OTHER"
        if bits_only:
            return row
        if (build / f"core_tests{target.suffix}").exists():
            command = shlex.split(target.run) + [str(build / f"core_tests{target.suffix}"), "--gtest_brief=1"]
            row["tests"] = "pass" if run(command, log) else "FAIL"
        good = all(run(shlex.split(target.run) + [str(build / f"{example}{target.suffix}")], log)
                   for example in ("ball_and_floor", "bat_and_ball", "rock_and_plate"))
        row["examples"] = "run" if good else "FAIL"
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("targets", nargs="*", metavar="TARGET")
    parser.add_argument("--bits", action="store_true", help="build and compare the digests alone")
    parser.add_argument("--list", action="store_true", help="name the targets")
    given = parser.parse_args()
    if given.list:
        print("\n".join(f"{name:16} {t.compiler} {t.flags}" for name, t in TARGETS.items()))
        return 0
    unknown = [name for name in given.targets if name not in TARGETS]
    if unknown:
        print(f"graze: no target {unknown[0]}. There are: {', '.join(TARGETS)}", file=sys.stderr)
        return 2
    rows = []
    for name in given.targets or TARGETS:
        target = TARGETS[name]
        install(["libeigen3-dev", "libgtest-dev", "ninja-build", "cmake", *target.packages.split()])
        print(f"graze: {name}: {target.compiler} {target.flags}", file=sys.stderr)
        rows.append(attempt(name, target, given.bits))
        if rows[-1]["bits"] != "same":
            print(f"graze: {name} is not well: {(WORK / name / 'log.txt').relative_to(ROOT)}", file=sys.stderr)
    columns = ("target", "build", "bits", "tests", "examples", "vectors")
    for row in [dict(zip(columns, columns)), *rows]:
        print("  ".join(f"{row[c]:16}" for c in columns).rstrip())
    well = all(r["bits"] == "same" and r["tests"] in ("pass", "-") and r["examples"] in ("run", "-") and r["vectors"] != "0" for r in rows)
    return 0 if well else 1


if __name__ == "__main__":
    sys.exit(main())
