#!/usr/bin/env python3
"""The rooms of core: no two include each other, no two files share a name, every header opens namespaces that tags see,
and the page of the architecture shows the ladder that the header states. In the command only engines/system has headers of
POSIX and calls of the system. usage: rooms_test.py SOURCE_DIR"""
import pathlib
import re
import sys

source = pathlib.Path(sys.argv[1])
detail = source / "core/graze/detail"
faults = []

includes, names = {}, {}
for header in sorted(detail.rglob("*.hpp")):
    room = header.parent.relative_to(detail).as_posix()
    text = header.read_text()
    for other in re.findall(r"#include <graze/detail/([\w/]+)/\w+\.hpp>", text):
        if other != room:
            includes.setdefault((room, other), header.name)
    if header.name in names:
        faults.append(f"{header.name} is in {names[header.name]} and in {room}: give one a name of its own")
    names[header.name] = room
    opens = "namespace graze { inline namespace GRAZE_LINKAGE {"
    if header.name != "flags.hpp" and opens not in text:
        faults.append(f"{room}/{header.name} does not open '{opens}', so tags and API pages do not see what it defines")
for (room, other), header in sorted(includes.items()):
    if room < other and (other, room) in includes:
        faults.append(f"{room}/{header} includes {other}, and {other}/{includes[other, room]} includes {room}")

lines = [line[3:].rstrip() for line in (detail / "casts/ladder.hpp").read_text().split("\n") if line.startswith("//   ")]
columns = [lines[0].index(name) for name in ("kind of pair", "MPR", "GJK ray", "certified", "exact")]
rows = []
for line in lines[1:]:
    cells = [line[begin:end].strip() for begin, end in zip(columns, columns[1:] + [None])]
    if cells[0]:
        rows.append([cells[0]] + [[] for _ in cells[1:]])
    for cell, rung in zip(rows[-1][1:], cells[1:]):
        cell.extend([rung] if rung else [])
code = (detail / "casts/ladder.hpp").read_text()
for column, table in enumerate(("Mpr", "Gjk", "Certified", "Exact"), 1):
    stated = [rung for row in rows for rung in row[column]]
    body = re.search(rf"k{table}Ladders\{{(.*?)\}};", code, re.S).group(1)
    held = re.findall(r"(\w+)<(?:true, |false, )?S>", body)
    if held != stated:
        faults.append(f"casts/ladder.hpp: k{table}Ladders holds {held}, and the table above it says {stated}")
page = (source / "docs/explanation/architecture.md").read_text()
for name, *cells in rows:
    row = f"| {name} | " + " | ".join(", ".join(f"`{rung}`" for rung in cell) or "–" for cell in cells) + " |"
    if row not in page:
        faults.append(f"docs/explanation/architecture.md lacks this row of casts/ladder.hpp: {row}")
if len(names) < 100 or len(rows) < 5:
    faults.append(f"found only {len(names)} headers and {len(rows)} rows: wrong folder?")

posix = re.compile(r"#include <(?:(?:sys|linux|arpa|netinet|net)/\w+\.h|(?:dirent|dlfcn|fcntl|glob|poll|pthread|sched|signal|spawn|"
                   r"termios|unistd)\.h|csignal)>|\"/(?:proc|dev)/|\bclock_gettime\b|\bstd::system\(")
apart = ("engines/system/", "engines/adapter/graze_adapter.hpp", "engines/zoo/", "reports/viewer/node_modules/",
         "properties/attack/", "properties/defects/", "properties/mutants/")  # not the command, except the first
for room in ("core", "certify", "corpus", "engines", "oracles", "properties", "reports", "scene", "tools"):
    for file in (source / room).rglob("*.[hc]pp"):
        name = file.relative_to(source).as_posix()
        for call in posix.findall(file.read_text()) if not name.startswith(apart) else ():
            faults.append(f"{name} has {call}: engines/system/system.hpp is the command's way to the system")

print("\n".join(faults) or f"{len(names)} headers in rooms, {len(rows)} rows of the ladder")
sys.exit(bool(faults))
