"""A campaign on made-up programs: its turns, its findings, a stop, and going on."""

import os
import stat
import sys
import tempfile
import threading
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "fuzz" / "campaign"))
import state as states  # noqa: E402
from board import Board, summary  # noqa: E402
from engines import Programs, count  # noqa: E402
from findings import Findings  # noqa: E402
from rounds import Campaign  # noqa: E402
from state import State  # noqa: E402
from targets import BadInput, Target, chosen, read_targets  # noqa: E402

# Stands for a fuzzer: keeps a core busy for as long as it is told to, adds an input to its pool, and now and then leaves a crash
# file; an input that begins with "bad" fails, by the mechanism that its fourth letter names.
FUZZER = """#!{python} -B
import os, sys, time
options = dict(word[1:].split("=", 1) for word in sys.argv[1:] if word.startswith("-"))
rest = [word for word in sys.argv[1:] if not word.startswith("-")]
if "merge" in options:
    into, pool = rest
    for name in sorted(os.listdir(pool))[:2]:
        open(os.path.join(into, name), "wb").write(open(os.path.join(pool, name), "rb").read())
elif "minimize_crash" in options:
    open(options["exact_artifact_path"], "wb").write(open(rest[0], "rb").read()[:4])
elif "max_total_time" in options:
    pool, crash = rest[0], {crash!r}
    open(os.path.join(pool, str(time.time_ns())), "w").write("fine")
    print("#1000 NEW    cov: 77 ft: 99 corp: 5/9b exec/s: 500 rss: 30Mb", file=sys.stderr, flush=True)
    end = time.process_time() + (float(options["max_total_time"]) if not crash else 0.4)
    while time.process_time() < end:
        pass
    print("955 of 1000 executions reached a law", file=sys.stderr)
    if crash:
        open(options["artifact_prefix"] + "crash-" + str(time.time_ns()), "w").write(crash + str(time.time_ns()))
        sys.exit(77)
else:
    text = open(rest[0]).read()
    if text.startswith("bad"):
        print("law: some_law\\nfault: wrong " + text[3] + " at " + str(len(text)), file=sys.stderr)
        os.abort()
"""
REPLAY = "#!/bin/sh\n[ \"$1\" = --print ] && echo '{\"id\": \"fuzz/one\"}'\n"


class MadeUp(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name)
        (self.root / "fuzz" / "seeds" / "shared").mkdir(parents=True)
        (self.root / "fuzz" / "seeds" / "shared" / "one").write_text("seed")
        self.targets = [Target("calm", "shared", "?"), Target("wild", "shared", "?")]
        self.crash("wild", "badx")
        self.crash("calm", "")

    def program(self, name: str, text: str) -> None:
        file = self.root / "fuzz" / name
        file.write_text(text)
        file.chmod(file.stat().st_mode | stat.S_IXUSR)

    def crash(self, name: str, crash: str) -> None:
        text = FUZZER.replace("{python}", sys.executable).replace("{crash!r}", repr(crash))
        self.program(f"graze_fuzz_{name}", text)
        self.program(f"graze_replay_{name}", REPLAY)

    def campaign(self, budget: float, state: State | None = None, slice_seconds: int = 2) -> Campaign:
        programs = Programs(self.root, self.root)
        findings = Findings(self.root / "findings", programs)
        state = state or State("libfuzzer")
        board = Board(self.targets, state, budget, 2)
        board.say = lambda _: None
        board.ended = lambda _: None
        work = Campaign(self.root / "corpora", programs, findings, self.targets, state, board, slice_seconds, 2, budget)
        work.prepare()
        return work

    def test_the_engine_gets_the_options_of_a_target(self):
        folder = self.root / "fuzz" / "options"
        folder.mkdir()
        (folder / "calm.options").write_text("[libfuzzer]\nmax_len = 77\n")
        programs = Programs(self.root, self.root / "build")
        asked = [programs.slice(target, Path("pool"), Path("work"), 5) for target in self.targets]
        self.assertEqual(["-max_len=77" in options for options in asked], [True, False])

    def test_every_target_has_its_turn_and_a_mechanism_one_finding(self):
        work = self.campaign(budget=6)
        work.run()
        calm, wild = work.state.of("calm"), work.state.of("wild")
        self.assertGreaterEqual(work.state.seconds(), 6)
        self.assertGreaterEqual(min(calm.slices, wild.slices), 1)
        self.assertEqual((calm.coverage, calm.crashes, calm.new), (77, 0, []))
        self.assertEqual((calm.reached, calm.counted), (955 * calm.slices, 1000 * calm.slices))
        self.assertGreater(wild.crashes, 1)
        self.assertEqual(len(wild.new), 1)
        name = wild.new[0]
        saved = self.root / "findings" / "wild" / name
        self.assertEqual(saved.read_text(), "badx", "the minimised input, since its mechanism is the same")
        self.assertEqual(work.findings.mechanism_of(self.targets[1], name), "some_law: wrong x at #")
        self.assertIn("fuzz/one", (self.root / "findings" / "reports" / f"wild.{name}.json").read_text())
        # The report names the command that shows it.
        said = (self.root / "findings" / "reports" / f"wild.{name}.txt").read_text()
        self.assertRegex(said, f"(?m)^look: graze show .*reports/wild.{name}.json --method all --out case.html$")
        self.assertIn(f"- new: wild/{name}: some_law: wrong x at #", summary(self.targets, work.state, work.findings.mechanism_of))
        self.assertLessEqual(count(self.root / "corpora" / "shared"), 5, "minimised at the end of the last round")

    def test_a_saved_finding_that_still_fails_is_known(self):
        self.campaign(budget=3).run()
        again = self.campaign(budget=3)
        again.run()
        wild = again.state.of("wild")
        self.assertEqual((len(wild.new), len(wild.known)), (0, 1))

    def test_a_mended_finding_becomes_a_seed_and_is_new_when_it_comes_back(self):
        self.campaign(budget=3).run()
        broken = (self.root / "fuzz" / "graze_fuzz_wild").read_text()
        self.program("graze_fuzz_wild", broken.replace('startswith("bad")', 'startswith("worse")'))
        mended = self.campaign(budget=3)
        self.assertEqual(mended.findings.failing["wild"], set())
        self.assertTrue(any(file.name.startswith("mended-") for file in (self.root / "corpora" / "shared").iterdir()))
        self.program("graze_fuzz_wild", broken)
        (self.root / "findings" / "wild" / next(iter(self.known()))).write_text("fine")
        again = self.campaign(budget=3)
        again.run()
        self.assertEqual(len(again.state.of("wild").new), 1)

    def known(self) -> list[str]:
        return [file.name for file in (self.root / "findings" / "wild").iterdir()]

    def test_stopped_it_goes_on_with_the_seconds_that_are_done(self):
        work = self.campaign(budget=1000, slice_seconds=500)
        threading.Timer(2.5, work.stopping.set).start()
        work.run()
        self.assertLess(work.state.seconds(), 60)
        state = states.load(self.root / "corpora" / "state.json", "libfuzzer")
        self.assertFalse(state.finished)
        self.assertEqual(state.seconds(), work.state.seconds())
        self.assertGreater(state.seconds(), 0)

    def test_a_finished_campaign_is_followed_by_a_new_one(self):
        file = self.root / "state.json"
        done = State("libfuzzer", finished=True, total_seconds=7, minimised={"shared": 3})
        done.of("calm").seconds = 7
        states.save(file, done)
        state = states.load(file, "libfuzzer")
        self.assertEqual((state.seconds(), state.total_seconds, state.minimised), (0, 7, {"shared": 3}))

    def test_a_program_that_does_not_run_is_no_silent_success(self):
        self.program("graze_fuzz_wild", "#!/bin/sh\nexit 3\n")
        self.crash("calm", "")
        self.targets = self.targets[1:]
        work = self.campaign(budget=100)
        work.run()
        self.assertEqual(work.broken, ["wild"])

    def test_bad_input_is_one_line_that_says_where(self):
        file = self.root / "targets.txt"
        for text, said in (("calm shared\n", "targets.txt:1: want"), ("", "no targets"),
                           ("a p Why?\na p Why?\n", "targets.txt:2: the target a is listed twice")):
            file.write_text(text)
            with self.assertRaisesRegex(BadInput, said):
                read_targets(file)
        with self.assertRaisesRegex(BadInput, "--targets: there is no target mild; there are calm, wild"):
            chosen(self.targets, "calm,mild")
        file.write_text("{}")
        with self.assertRaisesRegex(BadInput, "not a state of a fuzz campaign"):
            states.load(file, "libfuzzer")


if __name__ == "__main__":
    os.environ.pop("GRAZE_FUZZ_SHARE", None)
    unittest.main()
