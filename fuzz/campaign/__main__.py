"""./run fuzz: a fuzz campaign. docs/howto/fuzz.md says how to run one for days, and what becomes of findings."""

import argparse
import fcntl
import signal
import sys
from pathlib import Path

import state as states
from board import Board, summary
from engines import Afl, Programs
from findings import Findings
from rounds import Campaign
from targets import BadInput, chosen, read_targets

SOURCE = Path(__file__).resolve().parent.parent.parent
ENGINES = {"libfuzzer": (Programs, "fuzz"), "afl": (Afl, "fuzz-afl")}


def positive(text: str) -> float:
    value = float(text)
    if not 0 < value < 1e6:
        raise argparse.ArgumentTypeError(f"want a number above 0, got {text}")
    return value


def whole(text: str) -> int:
    if not text.isdecimal() or not 1 <= int(text) <= 100000:
        raise argparse.ArgumentTypeError(f"want a whole number of 1 or more, got {text}")
    return int(text)


def options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="./run fuzz", description="Runs the fuzz targets in turns; stop it by Ctrl-C, "
                                     "the same command continues. Exit code 1: there are new findings.")
    parser.add_argument("--hours", type=positive, default=1, help="of this machine's time (default: 1)")
    parser.add_argument("--jobs", type=whole, default=1, help="targets at a time (default: 1)")
    parser.add_argument("--targets", default="", metavar="A,B", help="only these (default: all of fuzz/targets.txt)")
    parser.add_argument("--engine", choices=ENGINES, default="libfuzzer")
    parser.add_argument("--slice", type=whole, default=600, metavar="S",
                        help="seconds that a target runs at a time, at most (default: 600)")
    parser.add_argument("--corpora", type=Path, default=SOURCE / "build" / "fuzz-corpora", metavar="DIR",
                        help="corpora and state (default: build/fuzz-corpora)")
    parser.add_argument("--findings", type=Path, default=SOURCE / "fuzz" / "findings", metavar="DIR",
                        help="where findings are saved (default: fuzz/findings)")
    parser.add_argument("--list", action="store_true", help="list the targets, and end")
    return parser.parse_args()


def campaign(given: argparse.Namespace) -> int:
    targets = chosen(read_targets(SOURCE / "fuzz" / "targets.txt"), given.targets)
    if given.list:
        for target in targets:
            print(f"{target.name:<22}{target.question}")
        return 0
    given.corpora.mkdir(parents=True, exist_ok=True)
    lock = (given.corpora / ".lock").open("w")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        raise BadInput(f"{given.corpora}: another campaign runs here; --corpora names another folder") from error

    state = states.load(given.corpora / "state.json", given.engine)
    kind, build = ENGINES[given.engine]
    programs = kind(SOURCE, SOURCE / "build" / build)
    programs.build(targets, given.jobs)
    findings = Findings(given.findings, programs)
    budget = given.hours * 3600 * given.jobs
    board = Board(targets, state, budget, given.jobs)
    # Every target has its turn, in short campaigns too.
    slice_seconds = max(10, min(given.slice, int(budget / len(targets))))
    work = Campaign(given.corpora.resolve(), programs, findings, targets, state, board, slice_seconds, given.jobs, budget)

    def stop(name: int, _frame) -> None:
        work.stopping.set()
        signal.signal(name, signal.SIG_DFL)  # a second one ends it at once

    for name in (signal.SIGINT, signal.SIGTERM):
        signal.signal(name, stop)
    if state.seconds() > 0:
        board.say(f"continues after {state.seconds() / 3600:.2f} core-hours of {budget / 3600:.2f}")
    work.prepare()
    work.run()
    board.draw()
    state.finished = state.seconds() >= budget and not work.broken
    work.save()
    text = summary(targets, state, findings.mechanism_of)
    print(text, end="")
    (given.corpora / "summary.md").write_text(text, encoding="utf-8")
    if work.stopping.is_set():
        board.say("stopped; the same command continues")
        return 130
    if work.broken:
        raise BadInput(f"these targets did not run: {', '.join(work.broken)}")
    return 1 if any(state.of(target.name).new for target in targets) else 0


def main() -> int:
    try:
        return campaign(options())
    except BadInput as error:
        print(f"graze: {error}", file=sys.stderr)
        return 2


sys.exit(main())
