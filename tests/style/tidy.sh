#!/usr/bin/env bash
# clang-tidy on every source that includes neither CGAL nor RapidCheck, nor other people's engines (engines/zoo), and on
# each public header by itself: without our precompiled headers, so that what a file uses and does not include is an error.
# usage: tidy.sh SOURCE_DIR BUILD_DIR
set -euo pipefail
cd "$1"
command -v clang-tidy-14 >/dev/null || { echo "clang-tidy-14 is missing: packages.txt lists it"; exit 1; }
plain=$2/without_precompiled_headers
python3 -B - "$2/compile_commands.json" "$plain" core/graze/*.hpp <<'EOF'
import json, os, pathlib, re, sys

database, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
(folder / "headers").mkdir(parents=True, exist_ok=True)
entries = json.loads(database.read_text())
for entry in entries:
    entry["command"] = re.sub(r" -include \S*cmake_pch\.hxx| -Winvalid-pch| -fpch-preprocess", "", entry["command"])
library = next(e for e in entries if e["file"].endswith("core/src/shapes.cpp"))
for header in sys.argv[3:]:
    alone = folder / "headers" / (pathlib.Path(header).stem + ".cpp")
    alone.write_text(f"#include <graze/{pathlib.Path(header).name}>\n")
    command = re.sub(r" -o \S+ -c \S+$", f" -o {alone}.o -c {alone}", library["command"])
    entries.append({"directory": library["directory"], "file": os.fspath(alone), "command": command})
for template in pathlib.Path("adapter/templates").glob("*.cpp"):  # Built by its users, and by a test, not by our build.
    file = template.resolve()
    entries.append({"directory": library["directory"], "file": os.fspath(file),
                    "command": f"c++ -std=c++17 -Wall -Wextra -I {file.parent.parent} -o {folder}/template.o -c {file}"})
(folder / "compile_commands.json").write_text(json.dumps(entries))
EOF
mapfile -t files < <(grep -LE 'CGAL|rapidcheck|properties/generate/generators' $(find adapter certify corpus draw engines external fuzz price properties report scene show tools viewer examples \
  -path engines/zoo -prune -o -path viewer/node_modules -prune -o -name '*.cpp' -print | sort); ls "$plain"/headers/*.cpp)
((${#files[@]} > 10)) || { echo "found only ${#files[@]} sources: wrong folder?"; exit 1; }
said=$(printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P 2 clang-tidy-14 --quiet --extra-arg=-Wno-unknown-warning-option -p "$plain" 2>&1) && failed=0 || failed=1
grep -vE 'warnings generated|^$' <<<"$said" || true
((failed)) || echo "${#files[@]} sources are tidy"
exit $failed
