"""The list of fuzz targets, fuzz/targets.txt: one a line, `name pool question`."""

import re
from dataclasses import dataclass
from pathlib import Path


class BadInput(Exception):
    """One clear line for the user; exit code 2."""


@dataclass(frozen=True)
class Target:
    name: str
    pool: str  # targets of one pool share a corpus
    question: str


def read_targets(file: Path) -> list[Target]:
    targets: list[Target] = []
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        words = line.split(maxsplit=2)
        if len(words) != 3 or not all(re.fullmatch(r"[a-z][a-z0-9_]*", word) for word in words[:2]):
            raise BadInput(f"{file}:{number}: want `name pool question`, names in snake_case; got: {line}")
        if any(target.name == words[0] for target in targets):
            raise BadInput(f"{file}:{number}: the target {words[0]} is listed twice")
        targets.append(Target(*words))
    if not targets:
        raise BadInput(f"{file}: no targets")
    return targets


def chosen(targets: list[Target], names: str) -> list[Target]:
    """Those named in a list with commas; all for an empty one."""
    wanted = [name for name in names.split(",") if name]
    for name in wanted:
        if all(target.name != name for target in targets):
            known = ", ".join(target.name for target in targets)
            raise BadInput(f"--targets: there is no target {name}; there are {known}")
    return [target for target in targets if not wanted or target.name in wanted]
