#!/usr/bin/env python3
"""The findings in other engines: each has its case and its section, the oracles give its answer again, and our own methods
answer it within their guarantees.   found_test.py SOURCE GRAZE"""
import json
import pathlib
import re
import subprocess
import sys

source, graze = pathlib.Path(sys.argv[1]), sys.argv[2]
findings = json.loads((source / "engines/zoo/findings.json").read_text())["findings"]
cases = {path.stem for path in (source / "corpus/found").glob("*.json")}
page = (source / "docs/reports/bugs_shrunk.md").read_text()
worked_out = set(re.findall(r"^## (\S+)$", (source / "docs/reports/bugs_found.md").read_text(), re.M))
ids = [finding["id"] for finding in findings]
faults = [f"{name} has no finding" for name in sorted(cases - set(ids) - worked_out)]
faults += [f"{name} has no case" for name in [*ids, *worked_out] if name not in cases]
faults += [f"{name} stands twice" for name in set(ids) if ids.count(name) > 1]
faults += [f"{name} has no section in docs/reports/bugs_shrunk.md" for name in ids if f"## {name}\n" not in page]
named = {engine["name"] for name in ("engines/zoo/zoo.json", "engines/zoo/node/zoo.json")
         for engine in json.loads((source / name).read_text())["engines"]}
faults += [f"{finding['id']} is of no engine of the zoo" for finding in findings if finding["engine"] not in named]
if not ids:
    faults.append("there is no finding")
files = [str(source / "corpus/found" / f"{name}.json") for name in sorted(cases)]
for words in (["corpus", "verify", str(source / "corpus/found")], ["certify", *files]):
    done = subprocess.run([graze, *words], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        faults.append(f"graze {words[0]} exits with {done.returncode}: {done.stdout[:500]}{done.stderr[:500]}")
for fault in faults:
    print(fault)
sys.exit(1 if faults else 0)
