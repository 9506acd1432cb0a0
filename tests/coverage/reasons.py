"""Why lines and conditions of core are not covered: tests/coverage/reasons.txt.

    file                 the name of a file of core, unique there, then its entries
      code | reason      a piece of the source line, and why nothing reaches it

An entry covers the missed lines and conditions on source lines that hold that piece of code; `*` all of the file, and
the file `*` stands for every file. An entry that covers nothing is stale, and reported."""

from dataclasses import dataclass
from pathlib import Path


@dataclass
class Reason:
    code: str
    reason: str
    used: bool = False


def read_reasons(file: Path) -> dict[str, list[Reason]]:
    reasons: dict[str, list[Reason]] = {}
    current = None
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        if not line.startswith(" "):
            current = reasons.setdefault(line.strip(), [])
            continue
        code, bar, reason = line.strip().rpartition(" | ")
        if not bar or current is None:
            raise SystemExit(f"graze: {file}:{number}: want `code | reason` under the name of a file; got: {line.strip()}")
        current.append(Reason(code, reason))
    return reasons


def reason_for(reasons: dict[str, list[Reason]], file: str, text: str) -> str | None:
    for one in [*reasons.get(Path(file).name, []), *reasons.get("*", [])]:
        if one.code == "*" or one.code in text:
            one.used = True
            return one.reason
    return None
