"""What a failing run's report says went wrong, without the numbers: two inputs of one mechanism are one finding.

A law's fault is its sentence, with the method's name; a sanitizer's is its kind and the first frame in our sources."""

import hashlib
import re

NUMBER = re.compile(r"(?<![\w.])[-+]?(0x[0-9a-f.]+(p[-+]?\d+)?|\d+(\.\d+)?(e[-+]?\d+)?|inf|nan)(?![\w])", re.IGNORECASE)
LONGEST = 160
ROOMS = "(?:core|corpus|oracles|engines|properties|reports|certify|fuzz|tools)"
# The inline namespace of the compiled library, or of the headers alone, tells no fault from another.
LINKAGE = re.compile(r"graze::(?:compiled|header_only(?:_asserting)?)::")


def _own_frame(report: str) -> str:
    """The first function of ours on the stack, with its file where there are debug symbols."""
    for match in re.finditer(r"^\s*#\d+ 0x[0-9a-f]+ in (.+?) (\S+)$", report, re.MULTILINE):
        function, place = match.groups()
        function = LINKAGE.sub("graze::", function)
        if not re.match(r"(.* )?graze::", function) and not re.search(f"/{ROOMS}/", place):
            continue
        file = re.search(f"/({ROOMS}/[^:]+)", place)
        name = re.sub(r"\(.*|<.*", "", re.sub(r"^.* (?=graze::)", "", function))
        return f"{name} {file.group(1)}" if file else name
    return ""


def mechanism(report: str, exit_code: int) -> str:
    """One line. `report` is what the run wrote, `exit_code` how it ended (negative: a signal)."""
    law = re.search(r"^law: *(\S+)", report, re.MULTILINE)
    method = re.search(r"^method: *(\S+)", report, re.MULTILINE)
    fault = re.search(r"^fault: *(.+)$", report, re.MULTILINE)
    if fault:
        named = [found.group(1) for found in (law, method) if found]
        return ": ".join([*named, NUMBER.sub("#", fault.group(1))])[:LONGEST]
    undefined = re.search(r"(\S+?):(\d+):\d+: runtime error: (.+)$", report, re.MULTILINE)
    if undefined:
        file = re.sub(f"^.*/(?={ROOMS}/)", "", undefined.group(1))
        return f"undefined behaviour: {NUMBER.sub('#', undefined.group(3))}, {file}:{undefined.group(2)}"[:LONGEST]
    error = re.search(r"ERROR: (\w+): ([\w-]+)", report)
    if error:
        frame = _own_frame(report)
        return f"{error.group(1)}: {error.group(2)}{', ' if frame else ''}{frame}"[:LONGEST]
    thrown = re.search(r"^terminate called .*?'(.+)'", report, re.MULTILINE)
    if thrown:
        return f"uncaught {thrown.group(1)}"[:LONGEST]
    return f"ended by signal {-exit_code}" if exit_code < 0 else f"ended with exit code {exit_code}"


def finding_id(target: str, what: str) -> str:
    return hashlib.sha1(f"{target} {what}".encode()).hexdigest()[:10]
