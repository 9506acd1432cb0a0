"""The table of coverage, and coverage.md with what is missed and why."""

from itertools import groupby
from pathlib import Path

from lines import FileCoverage
from reasons import Reason, reason_for

LINES_GOAL, BRANCHES_GOAL = 95.0, 85.0  # per cent of core


def _shares(files: dict[str, FileCoverage]) -> list[tuple[str, int, int, int, int]]:
    """File, lines reached, lines, branches reached, branches; the sum last."""
    rows = [(name, len(one.lines) - len(one.missed_lines()), len(one.lines),
             2 * len(one.branches) - len(one.missed_branches()), 2 * len(one.branches))
            for name, one in sorted(files.items()) if one.lines]
    sums = [sum(row[i] for row in rows) for i in range(1, 5)]
    return [*rows, ("all of core", sums[0], sums[1], sums[2], sums[3])]


def _percent(part: int, whole: int) -> float:
    return 100 * part / whole if whole else 100.0


def below_goal(files: dict[str, FileCoverage]) -> bool:
    _, lines, all_lines, branches, all_branches = _shares(files)[-1]
    return _percent(lines, all_lines) < LINES_GOAL or _percent(branches, all_branches) < BRANCHES_GOAL


def table(files: dict[str, FileCoverage]) -> str:
    text = ["| file | lines | % | branches | % |", "|---|---|---|---|---|"]
    for name, lines, all_lines, branches, all_branches in _shares(files):
        text.append(f"| {name} | {lines} of {all_lines} | {_percent(lines, all_lines):.1f} | "
                    f"{branches} of {all_branches} | {_percent(branches, all_branches):.1f} |")
    return "\n".join(text)


def _missed(name: str, one: FileCoverage, source: list[str], reasons: dict[str, list[Reason]]) -> list[str]:
    """One entry a source line, in order: never reached, or of a condition the outcome that never was."""
    entries: list[tuple[int, str, str | None]] = []
    unreached = set(one.missed_lines())
    for line in sorted(unreached):
        text = source[line - 1].strip()
        if text.strip("{};) "):
            entries.append((line, f"`{text}`", reason_for(reasons, name, text)))
    for place, outcome in one.missed_branches():
        line, column, end_line, end_column = place
        if line in unreached:
            continue
        text = source[line - 1]
        condition = text[column - 1:end_column - 1] if end_line == line else text[column - 1:].strip() + " …"
        entries.append((line, f"`{condition}` never {str(outcome).lower()}", reason_for(reasons, name, text)))
    entries.sort(key=lambda entry: entry[0])
    listed = []
    for reason, some in groupby(entries, key=lambda entry: entry[2]):
        group = list(some)
        numbers = sorted({line for line, _, _ in group})
        where = f"{numbers[0]}" if len(numbers) == 1 else f"{numbers[0]}-{numbers[-1]}"
        what = "; ".join(code for _, code, _ in group[:3]) + (f"; and {len(group) - 3} more" if len(group) > 3 else "")
        listed.append(f"- {where}: {what}. **{reason or 'No reason known: a test is missing.'}**")
    return listed


def page(files: dict[str, FileCoverage], reasons: dict[str, list[Reason]], root: Path, programs: list[str]) -> str:
    text = ["# Coverage of core", "",
            "Which lines and branches of `core/` the unit tests, the laws (on fewer cases than `ctest` draws) and the fuzz",
            "inputs reach, by clang's source-based coverage. `./run coverage` measures it again and writes this page. A line",
            "or a condition of a template counts once, whatever it is instantiated for; a condition that is constant in an",
            f"instantiation has no branches there. Goal: {LINES_GOAL:.0f} % of lines and {BRANCHES_GOAL:.0f} % of branches.", "",
            table(files), "", "Programs: " + ", ".join(programs) + ".", "", "## What is not reached, and why", "",
            "Reasons are in `tests/coverage/reasons.txt`, tied to a piece of the source line, so that an entry whose line",
            "is reached, or gone, is reported.", ""]
    for name, one in sorted(files.items()):
        source = (root / name).read_text(encoding="utf-8").splitlines()
        entries = _missed(name, one, source, reasons)
        if entries:
            text += [f"### {name}", "", *entries, ""]
    return "\n".join(text)
