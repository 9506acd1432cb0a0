"""What llvm-cov says of core, read from its export and joined by source line: the instantiations of a template, in
float and in double and in every program, are one line and one condition.

A line counts if some region begins or goes on in it. A branch is one of the two outcomes of a condition; a condition
that the compiler folded (in an instantiation it is constant) has no outcomes there."""

import json
from bisect import bisect_right
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

Place = tuple[int, int, int, int]  # of a condition: line and column of its begin, of its end


@dataclass
class FileCoverage:
    lines: dict[int, int] = field(default_factory=lambda: defaultdict(int))  # line -> times
    conditions: dict[Place, list[int]] = field(default_factory=dict)  # condition -> [times true, times false]
    folded: set[Place] = field(default_factory=set)  # evaluated somewhere, and yet with neither outcome there

    @property
    def branches(self) -> dict[Place, list[int]]:
        return {place: counts for place, counts in self.conditions.items() if any(counts) or place not in self.folded}

    def missed_lines(self) -> list[int]:
        return sorted(line for line, times in self.lines.items() if times == 0)

    def missed_branches(self) -> list[tuple[Place, bool]]:
        """The outcomes that never were: (condition, outcome)."""
        return sorted((place, side == 0) for place, counts in self.branches.items()
                      for side in (0, 1) if counts[side] == 0)


def _line_counts(segments: list) -> dict[int, int]:
    """As llvm-cov counts lines: the largest count of the regions that begin in the line, or of the one that it goes on
    with. A segment is [line, column, count, has count, is region entry, is gap]."""
    starts: dict[int, list] = defaultdict(list)
    for segment in segments:
        starts[segment[0]].append(segment)
    counts: dict[int, int] = {}
    wrapped = None
    for line in range(segments[0][0], segments[-1][0] + 1) if segments else ():
        here = starts.get(line, [])
        entries = [s for s in here if s[4] and not s[5]]
        skipped = bool(here) and not here[0][3] and here[0][4]
        if not skipped and (entries or (wrapped is not None and wrapped[3])):
            counts[line] = max([s[2] for s in entries] + ([wrapped[2]] if wrapped is not None and wrapped[3] else [0]))
        if here:
            wrapped = here[-1]
    return counts


def _count_at(segments: list, line: int, column: int) -> int:
    at = bisect_right(segments, [line, column, float("inf")]) - 1
    return segments[at][2] if at >= 0 else 0


def drop_what_is_no_code(files: dict[str, FileCoverage], root: Path) -> None:
    """Blank lines and comments between two regions, which llvm-cov counts with the one before."""
    for name, one in files.items():
        source = (root / name).read_text(encoding="utf-8").splitlines()
        for line in [number for number in one.lines if not source[number - 1].partition("//")[0].strip()]:
            del one.lines[line]


def add_export(text: str, root: str, into: dict[str, FileCoverage]) -> None:
    """Adds one program's `llvm-cov export`. Files outside of `root` are left out."""
    for file in json.loads(text)["data"][0]["files"]:
        if not file["filename"].startswith(root):
            continue
        one = into.setdefault(file["filename"][len(root):], FileCoverage())
        for line, times in _line_counts(file["segments"]).items():
            one.lines[line] += times
        sums: dict[Place, list[int]] = defaultdict(lambda: [0, 0])
        for branch in file["branches"]:
            place = tuple(branch[:4])
            sums[place][0] += branch[4]
            sums[place][1] += branch[5]
        for place, counts in sums.items():
            if counts == [0, 0] and _count_at(file["segments"], place[0], place[1]) > 0:
                one.folded.add(place)
            known = one.conditions.setdefault(place, [0, 0])
            known[0] += counts[0]
            known[1] += counts[1]
