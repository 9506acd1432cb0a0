"""What tidy.sh looks at: a compilation database without precompiled headers, and two lists.

Reads the names of sources from standard input. In FOLDER it writes compile_commands.json; united.txt, the files that
hold every source once (those that the build compiles several at once, then sources and headers that stand alone); and
parts.txt, a command to a line that parses a source, by itself, which united.txt holds together with others.

usage: tidy_files.py COMPILE_COMMANDS FOLDER HEADER..."""
import json
import os
import pathlib
import re
import shlex
import sys

database, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
wanted = {pathlib.Path(line.strip()).resolve() for line in sys.stdin}
(folder / "headers").mkdir(parents=True, exist_ok=True)


def compiling(command, source, object_file):
    return re.sub(r" -o \S+ -c \S+$", f" -o {object_file} -c {source}", command)


def parsing(command, source):
    """Clang's, which parses the soonest; what it would warn of is clang-tidy's."""
    words = iter(shlex.split(command))
    kept = []
    for word in words:
        if word == "-isystem":
            kept += [word, next(words)]
        elif word.startswith(("-std=", "-D", "-I")):
            kept.append(word)
    return shlex.join(["clang++-14", "-w", "-fsyntax-only"] + kept + [os.fspath(source)])


entries, united, parts, alone = [], [], {}, []
for entry in json.loads(database.read_text()):
    entry["command"] = re.sub(r" -include \S*cmake_pch\.hxx| -Winvalid-pch| -fpch-preprocess", "", entry["command"])
    file = pathlib.Path(entry["file"])
    included = []
    if file.suffix == ".cxx" and file.parent.name == "Unity":
        included = [pathlib.Path(name) for name in re.findall(r'#include "(\S+\.cpp)"', file.read_text())]
    entries.append(entry)
    if wanted & set(included):
        united.append(file)
        parts |= {part: parsing(entry["command"], part) for part in included}
    elif file in wanted:
        alone.append(file)
library = next(e for e in entries if e["file"].endswith("core/src/shapes.cpp"))
for header in sys.argv[3:]:
    file = folder / "headers" / (pathlib.Path(header).stem + ".cpp")
    file.write_text(f"#include <graze/{pathlib.Path(header).name}>\n")
    entries.append({"directory": library["directory"], "file": os.fspath(file),
                    "command": compiling(library["command"], file, f"{file}.o")})
    alone.append(file)
for template in sorted(pathlib.Path("engines/adapter/templates").glob("*.cpp")):  # Built by users, and by a test of its own.
    file = template.resolve()
    entries.append({"directory": library["directory"], "file": os.fspath(file),
                    "command": f"c++ -std=c++17 -Wall -Wextra -I {file.parent.parent} -o {folder}/template.o -c {file}"})
    alone.append(file)
alone += wanted - set(parts)  # Without a command (another compiler's fuzzers): clang-tidy takes a neighbour's.
(folder / "compile_commands.json").write_text(json.dumps(entries))
(folder / "united.txt").write_text("".join(f"{file}\n" for file in united + sorted(set(alone))))
(folder / "parts.txt").write_text("".join(f"{command}\n" for command in parts.values()))
