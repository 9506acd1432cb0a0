#!/usr/bin/env python3
"""Follows a tutorial from its start to its end, in an empty folder: writes the files that it shows, runs its commands, and
looks for the lines that it shows of their output.   tutorial.py PAGE GRAZE SOURCE PREFIX FOLDER

A block with title="FILE" is a file. With replace="TEXT" it replaces the file's lines from the one that has TEXT to the end, or
to the line that has until="...". A block of sh is run by bash. A block of text behind it is what its output shows: the
beginnings of lines, or parts of them, in this order.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

page, graze, source, prefix, folder = (pathlib.Path(arg).resolve() for arg in sys.argv[1:])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
environment = os.environ | {"GRAZE": str(source), "CMAKE_PREFIX_PATH": str(prefix), "PATH": f"{graze.parent}:{os.environ['PATH']}"}
output, commands, compared = "", 0, 0


def line_of(lines, text, start=0):
    for number in range(start, len(lines)):
        if text in lines[number]:
            return number
    sys.exit(f"{page.name}: the file has no line with {text}")


def write(name, given, content):
    path = folder / name
    if "replace" in given:
        lines = path.read_text().splitlines(keepends=True)
        begin = line_of(lines, given["replace"])
        end = line_of(lines, given["until"], begin) if "until" in given else len(lines)
        content = "".join(lines[:begin]) + content + "".join(lines[end:])
    path.write_text(content)


def show(expected):
    """Each expected line must be in the output, behind the one before."""
    global compared
    at = 0
    for line in expected.splitlines():
        found = output.find(line, at)
        if found < 0:
            sys.exit(f"{page.name}: after the last command this line is missing:\n{line}\nIt printed:\n{output}")
        at = found + len(line)
        compared += 1


for info, content in re.findall(r"^```(\S.*)\n((?:.*\n)*?)```$", page.read_text(), re.M):
    language = info.split()[0]
    given = dict(re.findall(r'(\w+)="([^"]*)"', info))
    if "title" in given:
        write(given["title"], given, content)
    elif language == "sh":
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", content], cwd=folder, env=environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        output = done.stdout
        commands += 1
        if done.returncode != 0:
            sys.exit(f"{page.name}: exit code {done.returncode} of\n{content}\n{output}")
    elif language == "text":
        show(content)
if commands < 3 or compared < 3:
    sys.exit(f"{page.name}: {commands} commands and {compared} lines of output only: was it read?")
print(f"{commands} blocks of commands run, {compared} lines of output seen")
