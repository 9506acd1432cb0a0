"""./run coverage: which lines and branches of core the tests, laws and fuzz inputs reach.

Builds with clang's source-based coverage in build/coverage, runs, prints a table, writes build/reports/coverage.md. Exit code 1
if the share of lines or of branches is below the goal."""

import argparse
import os
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from lines import FileCoverage, add_export, drop_what_is_no_code
from page import below_goal, page, table
from programs import CASES, Program, programs
from reasons import read_reasons

SOURCE = Path(__file__).resolve().parent.parent.parent
BUILD = SOURCE / "build" / "coverage"
ELSEWHERE = "(^/usr|/tests/|/oracles/|/corpus/|/engines/|/properties/|/fuzz/|/reports/|/certify/|/tools/)"
MOST_SECONDS = 3600


def fail(what: str) -> None:
    print(f"graze: {what}", file=sys.stderr)
    sys.exit(2)


def tool(name: str) -> str:
    found = shutil.which(f"{name}-14") or shutil.which(name)
    if not found:
        fail(f"{name}-14 is missing; ./run packages lists what to install")
    return str(found)


def say(what: str) -> None:
    print(f"graze: {what}", file=sys.stderr, flush=True)


def build(wanted: list[Program], jobs: int) -> None:
    flags = "-fprofile-instr-generate -fcoverage-mapping"
    for step in (["cmake", "-S", str(SOURCE), "-B", str(BUILD), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                  f"-DCMAKE_CXX_COMPILER={tool('clang++')}", f"-DCMAKE_CXX_FLAGS={flags}"],
                 ["cmake", "--build", str(BUILD), f"-j{jobs}", "--target", *(program.target for program in wanted)]):
        if subprocess.run(step, stdout=2, check=False).returncode != 0:
            fail("the build failed: " + " ".join(step))


def run(program: Program) -> str:
    """Runs it and returns the export of its coverage."""
    raw, joined = (BUILD / f"{program.target}.{end}" for end in ("profraw", "profdata"))
    begin = time.monotonic()
    environment = {"RC_PARAMS": f"seed=1 max_success={CASES}", **os.environ, "LLVM_PROFILE_FILE": str(raw)}
    binary = str(BUILD / program.path)
    done = subprocess.run([binary, *program.arguments], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                          errors="replace", env=environment, timeout=MOST_SECONDS, check=False)
    failed = f", and failed: it ended with {done.returncode}" if done.returncode else ""
    say(f"{program.target} took {time.monotonic() - begin:.0f} s{failed}")
    if not raw.exists():
        fail(f"{program.target} left no profile: {done.stderr[-500:]}")
    subprocess.run([tool("llvm-profdata"), "merge", "-sparse", str(raw), "-o", str(joined)], check=True)
    return subprocess.run([tool("llvm-cov"), "export", binary, "-instr-profile", str(joined), "-format=text",
                           "-skip-functions", "-skip-expansions", f"-ignore-filename-regex={ELSEWHERE}"],
                          stdout=subprocess.PIPE, text=True, check=True).stdout


def main() -> int:
    parser = argparse.ArgumentParser(prog="./run coverage", description=__doc__.partition("\n")[2])
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="compilers and tests at a time")
    parser.add_argument("--only", default="", metavar="A,B", help="only these programs, and no page")
    given = parser.parse_args()
    if given.jobs < 1:
        fail(f"--jobs: want 1 or more, got {given.jobs}")
    known = programs(SOURCE)
    names = [name for name in given.only.split(",") if name]
    for name in names:
        if all(program.target != name for program in known):
            fail(f"--only: there is no {name}; there are {', '.join(program.target for program in known)}")
    wanted = [program for program in known if not names or program.target in names]
    began = time.time()
    build(wanted, given.jobs)
    files: dict[str, FileCoverage] = {}
    with ThreadPoolExecutor(given.jobs) as pool:
        for export in pool.map(run, wanted):
            add_export(export, f"{SOURCE}/core/graze/", files)
    for source in sorted((SOURCE / "core").rglob("*.hpp")):
        if source.stat().st_mtime > began:
            fail(f"{source.relative_to(SOURCE)} was changed while this ran: the lines counted are another's; run it again")
    drop_what_is_no_code(files, SOURCE / "core" / "graze")
    print(table(files))
    if not names:
        reasons = read_reasons(SOURCE / "tests" / "coverage" / "reasons.txt")
        to = SOURCE / "build" / "reports" / "coverage.md"
        to.parent.mkdir(parents=True, exist_ok=True)
        to.write_text(page(files, reasons, SOURCE / "core" / "graze", [program.target for program in wanted]),
                      encoding="utf-8")
        say(f"wrote {to}")
        for file, entries in reasons.items():
            for entry in entries:
                if not entry.used:
                    say(f"reasons.txt: {file}: `{entry.code}` excuses nothing")
    return 1 if below_goal(files) else 0


sys.exit(main())
