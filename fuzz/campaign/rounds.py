"""The loop of a campaign. A round gives every target a slice of time, the least served first, over so many jobs; at its
end the pools that grew are minimised."""

import os
import queue
import shutil
import signal
import subprocess
import threading
import time
from dataclasses import replace
from pathlib import Path

import state as states
from board import Board
from engines import Programs, Seen, copy_inputs, count
from findings import Findings
from state import State
from targets import Target

GROWN = 1.25  # a pool is minimised again when it has so many times the inputs that it was left with
MOST_CRASHES = 20  # in a slice: more of the same teach nothing
STOP_SECONDS = 20  # that a program has to end after it was asked to
LOADING_SECONDS = 300  # that a program may take to read its pool, before its time begins
MERGE_SECONDS = 1800


class Campaign:
    def __init__(self, directory: Path, programs: Programs, findings: Findings, targets: list[Target], state: State,
                 board: Board, slice_seconds: int, jobs: int, budget: float):
        self.directory = directory
        self.programs = programs
        self.findings = findings
        self.targets = targets
        self.state = state
        self.board = board
        self.slice_seconds = slice_seconds
        self.jobs = jobs
        self.budget = budget
        self.stopping = threading.Event()
        self.lock = threading.Lock()  # of the state
        self.broken: list[str] = []  # targets that end without a crash file: no fuzzing happens

    def pool(self, target: Target) -> Path:
        return self.directory / target.pool

    def work(self, target: Target) -> Path:
        """Where a target's program leaves its crash files and its log."""
        return self.directory / ".work" / self.programs.engine / target.name

    def save(self) -> None:
        with self.lock:
            states.save(self.directory / "state.json", self.state)

    def prepare(self) -> None:
        """Seeds, and findings that fail no more, go into the pools."""
        for target in self.targets:
            self.work(target).mkdir(parents=True, exist_ok=True)
            copy_inputs(self.programs.source / "fuzz" / "seeds" / target.pool, self.pool(target))
            failing = self.findings.replay_saved(target)
            if failing:
                self.board.say(f"{target.name}: {failing} saved findings still fail")
            for file in self.findings.saved(target):
                if file.name not in self.findings.failing[target.name]:
                    shutil.copy(file, self.pool(target) / f"mended-{file.name}")
            if not count(self.pool(target)):
                (self.pool(target) / "empty").write_bytes(b"\n")

    def run(self) -> None:
        """Until the budget is spent, or `stopping` is set."""
        while self.state.seconds() < self.budget and not self.stopping.is_set() and len(self.broken) < len(self.targets):
            order = sorted((target for target in self.targets if target.name not in self.broken),
                           key=lambda target: self.state.of(target.name).seconds)
            self._share_out(order, self._fuzz)
            if self.stopping.is_set():
                return
            self.state.rounds += 1
            spent = self.state.seconds() >= self.budget
            pools = [pool for pool in dict.fromkeys(target.pool for target in self.targets)
                     if spent or count(self.directory / pool) > GROWN * self.state.minimised.get(pool, 0)]
            self._share_out(pools, self._minimise)
            self.save()

    def _share_out(self, what: list, do) -> None:
        todo: queue.Queue = queue.Queue()
        for one in what:
            todo.put(one)

        def worker() -> None:
            while not self.stopping.is_set():
                try:
                    one = todo.get_nowait()
                except queue.Empty:
                    return
                do(one)

        threads = [threading.Thread(target=worker) for _ in range(min(self.jobs, len(what)))]
        for thread in threads:
            thread.start()
        while any(thread.is_alive() for thread in threads):
            self.board.draw()
            time.sleep(1)

    def _fuzz(self, target: Target) -> None:
        """A slice: the target's program, again after each crash until its time is over."""
        done = self.state.of(target.name)
        end = time.monotonic() + min(self.slice_seconds, max(3.0, self.budget - self.state.seconds()))
        crashes = 0
        while time.monotonic() < end - 1 and not self.stopping.is_set() and crashes < MOST_CRASHES:
            begin = time.monotonic()
            seen = Seen()
            self.board.doing(target, "fuzzes", seen)
            command = self.programs.slice(target, self.pool(target), self.work(target), max(1, int(end - begin)))
            code, spent = self._run(command, self.work(target) / "log", seen, (end - begin) * 2 + LOADING_SECONDS)
            found = self.programs.crashes(self.work(target))
            self.programs.collect(self.work(target), self.pool(target))
            with self.lock:
                done.seconds += spent
                self.state.total_seconds += spent
                done.executions += seen.executions
                done.coverage = max(done.coverage, seen.coverage)
                done.corpus = seen.corpus or done.corpus
                done.reached += seen.reached
                done.counted += seen.counted
            self.board.doing(target, "looks at a failure", replace(seen, executions=0))
            for crash in found:
                crashes += 1
                self._found(target, crash)
            if code not in (0, self.programs.interrupted) and not found and not self.stopping.is_set():
                self.board.say(f"{target.name} ended with {code} and left no crash file; see {self.work(target)}/log")
                self.broken.append(target.name)
                break
        with self.lock:
            done.slices += 1
        self.save()
        self.board.ended(target)

    def _found(self, target: Target, crash: Path) -> None:
        finding = self.findings.add(target, crash)
        done = self.state.of(target.name)
        with self.lock:
            done.crashes += 1
            if finding is not None:
                name, new = finding
                names = done.new if new else done.known
                if name not in done.new and name not in done.known:
                    names.append(name)
        if finding is None:
            kept = self.directory / ".work" / "unrepeated" / f"{target.name}-{crash.name}"
            kept.parent.mkdir(parents=True, exist_ok=True)
            shutil.move(crash, kept)
            self.board.say(f"{target.name}: a failure that does not happen again on {kept}")
            return
        crash.unlink()
        if finding[1]:
            self.board.say(f"{target.name}/{finding[0]}: {self.findings.mechanism_of(target, finding[0])}")

    def _minimise(self, pool: str) -> None:
        """Replaces a pool by inputs that show as much, for every target that reads it."""
        whole, least = self.directory / pool, self.directory / ".work" / f"{pool}.least"
        shutil.rmtree(least, ignore_errors=True)
        least.mkdir()
        before = count(whole)
        for target in [one for one in self.targets if one.pool == pool and one.name not in self.broken]:
            into = least
            if self.programs.merges_into_empty:
                into = self.directory / ".work" / f"{pool}.{target.name}"
                shutil.rmtree(into, ignore_errors=True)
            self.board.doing(target, "minimises", Seen())
            code, _ = self._run(self.programs.merge(target, whole, into), self.work(target) / "merge.log", Seen(),
                                MERGE_SECONDS)
            with self.board.lock:
                self.board.now.pop(target.name, None)
            if code != 0:
                if not self.stopping.is_set():
                    self.board.say(f"{pool}: not minimised, {target.name} ended with {code}; see {self.work(target)}/merge.log")
                return
            if into != least:
                copy_inputs(into, least)
        if not count(least):
            return
        old = self.directory / ".work" / f"{pool}.old"
        shutil.rmtree(old, ignore_errors=True)
        os.rename(whole, old)
        os.rename(least, whole)
        shutil.rmtree(old)
        self.state.minimised[pool] = count(whole)
        self.board.say(f"{pool}: {before} inputs minimised to {count(whole)}")

    def _run(self, command: list[str], log: Path, seen: Seen, most_seconds: float) -> tuple[int, float]:
        """Runs a program in a session of its own, so that Ctrl-C reaches it through us alone. Its exit code,
        and the seconds of a core that it used: on a busy machine fewer than have passed."""
        begin = time.monotonic()
        asked = 0.0
        with log.open("wb") as out:
            program = subprocess.Popen(command, stdout=out, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                       env=self.programs.environment(), start_new_session=True, cwd=log.parent)
        at = 0
        while True:
            time.sleep(0.5)
            ended, status, used = os.wait4(program.pid, os.WNOHANG)
            with log.open("rb") as text:
                text.seek(at)
                new = text.read()
            complete = new.rfind(b"\n") + 1
            at += complete
            for line in new[:complete].decode(errors="replace").splitlines():
                self.programs.read_line(line, seen)
            self.programs.read_files(log.parent, seen)
            if ended:
                program.returncode = os.waitstatus_to_exitcode(status)  # the program is waited for: tell its Popen
                return program.returncode, used.ru_utime + used.ru_stime
            if self.stopping.is_set() or time.monotonic() - begin > most_seconds:
                if not asked:
                    asked = time.monotonic()
                    os.killpg(program.pid, signal.SIGINT)
                elif time.monotonic() - asked > STOP_SECONDS:
                    os.killpg(program.pid, signal.SIGKILL)
