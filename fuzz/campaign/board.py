"""One line a target: on a terminal redrawn in place every second, else printed when a slice ends."""

import sys
import threading
import time

from engines import Seen
from state import State
from targets import Target

HEAD = f"{'target':<22}{'core-hours':>11}{'executions':>13}{'exec/s':>8}{'coverage':>10}{'corpus':>8}{'new':>5}{'known':>7}  now"


def spoken(seconds: float) -> str:
    minutes = int(seconds) // 60
    return f"{minutes // 60} h {minutes % 60:02} min" if minutes >= 60 else f"{minutes} min {int(seconds) % 60:02} s"


class Board:
    def __init__(self, targets: list[Target], state: State, budget: float, jobs: int):
        self.targets = targets
        self.state = state
        self.budget = budget  # core-seconds
        self.jobs = jobs
        self.lock = threading.Lock()
        self.now: dict[str, tuple[str, float, Seen]] = {}  # what a target does, since when, and what it shows
        self.terminal = sys.stderr.isatty()
        self.drawn = 0

    def doing(self, target: Target, what: str, seen: Seen) -> None:
        with self.lock:
            self.now[target.name] = (what, time.monotonic(), seen)

    def ended(self, target: Target) -> None:
        with self.lock:
            self.now.pop(target.name, None)
        if not self.terminal:
            print(self.line(target), self.left(), file=sys.stderr, flush=True)

    def say(self, text: str) -> None:
        with self.lock:
            self._clear()
            print(f"graze: {text}", file=sys.stderr, flush=True)

    def left(self) -> str:
        done = self.state.seconds() + sum(time.monotonic() - since for _, since, _ in self.now.values())
        return f"({100 * min(1.0, done / self.budget):.0f} %, {spoken(max(0.0, self.budget - done) / self.jobs)} left)"

    def line(self, target: Target) -> str:
        done = self.state.of(target.name)
        what, since, seen = self.now.get(target.name, ("", 0.0, Seen()))
        seconds = done.seconds + (time.monotonic() - since if what else 0)
        executions = done.executions + seen.executions
        rate = seen.per_second or int(executions / max(1.0, seconds))
        return (f"{target.name:<22}{seconds / 3600:>11.2f}{executions:>13}{rate:>8}{seen.coverage or done.coverage:>10}"
                f"{seen.corpus or done.corpus:>8}{len(done.new):>5}{len(done.known):>7}  {what}")

    def _clear(self) -> None:
        if self.drawn:
            print(f"\x1b[{self.drawn}A\x1b[J", end="", file=sys.stderr)
            self.drawn = 0

    def draw(self) -> None:
        if not self.terminal:
            return
        with self.lock:
            self._clear()
            lines = [HEAD, *(self.line(target) for target in self.targets), f"round {self.state.rounds + 1} {self.left()}"]
            print("\n".join(lines), file=sys.stderr, flush=True)
            self.drawn = len(lines)


def summary(targets: list[Target], state: State, mechanism_of) -> str:
    """Markdown: a table, then the findings. `mechanism_of(target, id)` names one."""
    named = "finished" if state.finished else "unfinished, the same command continues"
    lines = [f"Fuzz campaign by {state.engine}: {state.seconds() / 3600:.2f} core-hours, {state.rounds} rounds ({named}).",
             "",
             "| target | core-hours | executions | a second | reach a law | coverage, edges | corpus | failing inputs | new findings | known |",
             "|---|---|---|---|---|---|---|---|---|---|"]
    listed = []
    for target in targets:
        done = state.of(target.name)
        share = f"{100 * done.reached / done.counted:.1f} %" if done.counted else "not counted"
        lines.append(f"| {target.name} | {done.seconds / 3600:.2f} | {done.executions} | "
                     f"{done.executions / max(1.0, done.seconds):.0f} | {share} | {done.coverage} | {done.corpus} | "
                     f"{done.crashes} | {len(done.new)} | {len(done.known)} |")
        for kind, names in (("new", done.new), ("known", done.known)):
            listed += [f"- {kind}: {target.name}/{name}: {mechanism_of(target, name)}" for name in names]
    return "\n".join([*lines, "", *(listed or ["No findings."])]) + "\n"
