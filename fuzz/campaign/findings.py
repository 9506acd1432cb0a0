"""Crash files become findings: replayed, told apart by mechanism, minimised, saved.

fuzz/findings/TARGET/ID            the input; ctest replays it
fuzz/findings/reports/TARGET.ID.txt   the mechanism, and the report
fuzz/findings/reports/TARGET.ID.json  the case, ready for `graze cast` and `graze corpus add`, if the input is one
ID is a hash of target and mechanism, so that a mechanism has one finding, whatever found it and wherever."""

import subprocess
import threading
from dataclasses import dataclass
from pathlib import Path

from engines import Programs
from mechanism import finding_id, mechanism
from targets import Target

REPLAY_SECONDS = 600  # of one input, slow oracles under sanitizers on a busy machine included
MINIMISE_SECONDS = 60


@dataclass(frozen=True)
class Run:
    failed: bool
    mechanism: str
    report: str


class Findings:
    def __init__(self, root: Path, programs: Programs):
        self.root = root
        self.programs = programs
        self.lock = threading.Lock()
        self.failing: dict[str, set[str]] = {}  # target -> ids of saved findings that still fail

    def run(self, target: Target, file: Path) -> Run:
        """One input by the target's own program, which says all that it knows of an allocation."""
        ours = self.programs.environment()
        ours["ASAN_OPTIONS"] = ":".join(filter(None, [ours.get("ASAN_OPTIONS"), "malloc_context_size=30"]))
        try:
            done = subprocess.run([self.programs.fuzzer(target), str(file)], capture_output=True, text=True,
                                  errors="replace", timeout=REPLAY_SECONDS, env=ours, check=False, start_new_session=True)
        except subprocess.TimeoutExpired:
            return Run(True, f"runs longer than {REPLAY_SECONDS} s", "")
        text = done.stderr + done.stdout
        if done.returncode == 0:
            return Run(False, "", text)
        return Run(True, mechanism(text, done.returncode), text)

    def saved(self, target: Target) -> list[Path]:
        folder = self.root / target.name
        return sorted(file for file in folder.iterdir() if file.is_file()) if folder.is_dir() else []

    def replay_saved(self, target: Target) -> int:
        """How many saved findings still fail; one that does not is as good a seed as any."""
        self.failing[target.name] = set()
        for file in self.saved(target):
            if self.run(target, file).failed:
                self.failing[target.name].add(file.name)
        return len(self.failing[target.name])

    def add(self, target: Target, crash: Path) -> tuple[str, bool] | None:
        """The finding that a crash file is, and whether it is new; None if it does not fail again."""
        run = self.run(target, crash)
        if not run.failed:
            return None
        name = finding_id(target.name, run.mechanism)
        with self.lock:
            failing = self.failing.setdefault(target.name, set())
            if name in failing:
                return name, False
            failing.add(name)
        self._save(target, name, crash.read_bytes(), run)
        small = self._minimised(target, crash)
        if small is not None:
            again = self.run(target, small)
            if again.failed and again.mechanism == run.mechanism:
                self._save(target, name, small.read_bytes(), again)
            small.unlink()
        self._save_case(target, name)
        return name, True

    def report(self, target: Target, name: str) -> Path:
        return self.root / "reports" / f"{target.name}.{name}.txt"

    def mechanism_of(self, target: Target, name: str) -> str:
        file = self.report(target, name)
        return file.read_text(encoding="utf-8").partition("\n")[0] if file.exists() else "its files are gone"

    def _save(self, target: Target, name: str, data: bytes, run: Run) -> None:
        file = self.root / target.name / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(data)
        report = self.report(target, name)
        report.parent.mkdir(parents=True, exist_ok=True)
        # Of a long report the two ends.
        text = run.report if len(run.report) < 20000 else run.report[:10000] + "\n...\n" + run.report[-10000:]
        # Paths as from the project's root: a report is the same on every machine.
        text = text.replace(f"{self.programs.source}/", "")
        report.write_text(f"{run.mechanism}\n\n{text}", encoding="utf-8")

    def _minimised(self, target: Target, crash: Path) -> Path | None:
        """By the law's own shrinking, which knows geometry; by the engine where no law is at fault."""
        small = crash.with_name(crash.name + ".small")
        shrinks = [self.programs.replay(target), "--minimise", str(crash), str(small)]
        for command in (shrinks, self.programs.minimise(target, crash, small, MINIMISE_SECONDS)):
            self._call(command)
            if small.exists() and small.stat().st_size > 0:
                return small
        return None

    def _call(self, command: list[str]) -> str:
        """Its output, if it ended well and in time."""
        try:
            done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=REPLAY_SECONDS,
                                  env=self.programs.environment(), check=False, start_new_session=True)
        except subprocess.TimeoutExpired:
            return ""
        return done.stdout if done.returncode == 0 else ""

    def _save_case(self, target: Target, name: str) -> None:
        text = self._call([self.programs.replay(target), "--print", str(self.root / target.name / name)])
        if text.lstrip().startswith("{"):
            file = self.root / "reports" / f"{target.name}.{name}.json"
            file.write_text(text, encoding="utf-8")
            with self.report(target, name).open("a", encoding="utf-8") as report:
                report.write(f"\nlook: graze show {self._shown(file)} --method all --out case.html\n")

    def _shown(self, file: Path) -> Path:
        """As from the project's root, if it lies there."""
        return file.relative_to(self.programs.source) if file.is_relative_to(self.programs.source) else file
