"""The unit tests of core against the mutants that no law notices: tests/core, compiled once with all mutants.

Every test is first run by itself with no mutant alive: whether it passes, its time, and which mutants' places it
executes (alive.cpp). A mutant then meets the tests that execute its place, cheap ones first.
"""
import json
import os
import re
import resource
import subprocess
import time

SECONDS = 20       # of tests, for a mutant
MEMORY = 4 << 30   # bytes
SLOWER = 20        # times a test's usual time, and at least LEAST seconds: it does not end
LEAST = 5


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(program, test, seconds, **environment):
    """Exit code of one test, None if it does not end; and its time."""
    begin = time.monotonic()
    try:
        done = subprocess.run([program, f"--gtest_filter={test}", "--gtest_brief=1"], timeout=seconds, check=False,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=limit_memory,
                              env={**os.environ, **environment})
        return done.returncode, time.monotonic() - begin
    except subprocess.TimeoutExpired:
        return None, time.monotonic() - begin


def tests_of(program):
    listed = subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True, check=True).stdout
    suite, tests = "", []
    for line in listed.splitlines():
        name = line.split("#")[0].strip()
        if re.match(r"\S+\.$", name) and not line.startswith(" "):
            suite = name
        elif line.startswith("  "):
            tests.append(suite + name)
    return tests


def noticed_before(folder):
    """What unit_results says: the first test that fails of each mutant, or ""."""
    path = folder / "unit_results"
    if not path.exists():
        return {}
    return {int(n): test for n, test in (line.split("\t") for line in path.read_text().splitlines())}


class UnitTests:
    def __init__(self, folder, program, say):
        self.folder, self.program, self.say = folder, str(program), say

    def survey(self):
        """What each test executes; a test that fails with no mutant alive is left out."""
        path = self.folder / "unit_survey.json"
        if path.exists():
            return json.loads(path.read_text())
        out = []
        reached = self.folder / "unit_reached"
        self.say("unit tests: which mutants each executes")
        for test in tests_of(self.program):
            reached.unlink(missing_ok=True)
            code, seconds = run(self.program, test, 120, GRAZE_MUTANT_REACHED=str(reached))
            if code == 0 and reached.exists():
                out.append({"test": test, "seconds": seconds,
                            "reached": [int(n) for n in reached.read_text().split()]})
        path.write_text(json.dumps(out))
        return out

    def notice(self, mutants):
        """Numbers of mutants; the first test that fails of each, or "" where all pass. Kept in unit_results."""
        path = self.folder / "unit_results"
        done = noticed_before(self.folder)
        surveyed = sorted(self.survey(), key=lambda t: t["seconds"])
        for number in mutants:
            if number in done:
                continue
            done[number] = self.first_failing([t for t in surveyed if number in t["reached"]], number)
            with open(path, "a", encoding="utf-8") as file:
                file.write(f"{number}\t{done[number]}\n")
        return {n: done[n] for n in mutants}

    def first_failing(self, tests, number):
        spent = 0
        for test in tests:
            code, seconds = run(self.program, test["test"], max(LEAST, SLOWER * test["seconds"]),
                                GRAZE_MUTANT=str(number))
            if code != 0:
                return test["test"]
            spent += seconds
            if spent > SECONDS:
                break
        return ""
