"""Which programs exercise core, and with what: the unit tests, the laws on fewer cases than ctest draws, and the replay
of every fuzz seed and finding, and of a campaign's corpora if there are any."""

from dataclasses import dataclass, field
from pathlib import Path

CASES = 200  # that RapidCheck draws for a law


@dataclass(frozen=True)
class Program:
    target: str
    path: str  # in the build directory
    arguments: list[str] = field(default_factory=list)


def test(room: str, name: str, *arguments: str) -> Program:
    return Program(name, f"tests/{room}/{name}", ["--gtest_brief=1", *arguments])


def programs(source: Path) -> list[Program]:
    laws = "--gtest_filter=-*Families*"
    known = [
        *(test("core", name) for name in ("core_test", "hull_graph_test", "rotating_test", "queries_test", "exact_tier_test",
                                          "certified_tier_test")),
        test("lecture", "lecture_test"),
        test("pairs", "pairs_test"),
        test("properties", "properties_exact_tier_test"),
        test("properties", "properties_laws_test", laws),
        test("properties", "properties_rotating_laws_test", laws),
    ]
    for line in (source / "fuzz" / "targets.txt").read_text(encoding="utf-8").splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        name, pool = line.split()[:2]
        inputs = [source / "fuzz" / "seeds" / pool, source / "fuzz" / "findings" / name,
                  source / "build" / "fuzz-corpora" / pool]
        given = [str(folder) for folder in inputs if folder.is_dir() and any(folder.iterdir())]
        if given:
            known.append(Program(f"graze_replay_{name}", f"fuzz/graze_replay_{name}", given))
    return known
