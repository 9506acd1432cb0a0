"""The findings of findings.json, each shown again: the engine is asked the case, and the judge must still convict it."""
import datetime
import json
import re
import subprocess
import sys

PAGE = "docs/reports/bugs_shrunk.md"
KINDS = ("wrong", "late", "early", "off", "contact off", "failed")

HEAD = """# More findings in other engines, made small

For authors of these engines, and for readers who want to see small cases. [bugs_found.md](bugs_found.md) has the findings
that were worked out by hand. The cases here were made small by the engine's own answers, often down to bodies without
extent. `./run zoo --findings --write` shows each of them again and makes this page, last on {date}.
Some may share their cause with a finding there.

The cases are in `corpus/found/`, with the answer by an oracle. An engine is called as its users call it, with the settings
of its name (`engines/zoo`). *Tightest* means the smallest tolerances and the most iterations that it accepts. Errors are
measured against the question as the engine saw it, with numbers rounded to its scalar. Documented limits are granted. If a
mechanism is described *by its behaviour*, its source was not read.

To show one of them, take the engine's command from `engines/zoo/zoo.json` or `engines/zoo/node/zoo.json`:

    graze certify --engine "COMMAND" --relative-tolerance 1e-3 corpus/found/ID.json
    graze cast --tier exact --proof proof.jsonl corpus/found/ID.json && graze check proof.jsonl

The second line gives the right answer with its proof, for casts of polytopes without rotation. Use `--tier certified` for
the others.

"""


def convicted(options, engines, finding):
    """What certify says of a finding: (faults of the kind, version, the reason), or a word why it was not asked."""
    command = engines.get(finding["engine"])
    if command is None:
        return None
    path = options.results / "finding.json"
    words = [options.graze, "certify", "--engine", command, "--relative-tolerance", finding["relative_tolerance"],
             "--json", path, f"corpus/found/{finding['id']}.json"]
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        print(f"graze: {finding['id']}: {(done.stderr.strip().splitlines() or ['no answer'])[-1]}", file=sys.stderr)
        return None
    for method in json.loads(path.read_text())["methods"]:
        for kind, fault in method["total"]["faults"].items():
            if kind == finding["fault"]:
                return fault["because"]
    return ""


def capital(text):
    return text[0].upper() + text[1:]


def section(finding, reason, version):
    because = re.sub(r"(file://)?/\S*?/engines/zoo", "engines/zoo", " ".join(reason.split()))  # of no machine
    because = re.sub(r"; (\w)", lambda match: ". " + match.group(1).upper(), because)
    if len(because) > 330:
        because = because[:327] + "..."
    lines = [f"## {finding['id']}", "", f"**{capital(finding['title'])}.** "
             f"{finding['engine']} {version}. {capital(finding['kind'])}.", "",
             f"- *True:* {finding['truth']}", f"- *The judge:* {finding['fault']}: {because}",
             f"- *Mechanism:* {finding['mechanism']}"]
    if finding["upstream"]:
        lines.append(f"- *Upstream:* {finding['upstream']}.")
    return "\n".join(lines) + "\n"


def show(options, root, engines, versions):
    """Shows each again. The ids of those that are not convicted any more."""
    findings = json.loads((root / "engines/zoo/findings.json").read_text())["findings"]
    gone, parts, rows = [], [], []
    for finding in findings:
        reason = convicted(options, engines, finding)
        if reason is None:
            print(f"{finding['id']}: not asked, its engine is not here")
            continue
        print(f"{finding['id']}: {finding['engine']} " + (f"{finding['fault']}: {reason[:100]}" if reason
                                                          else "IS NOT CONVICTED ANY MORE"), flush=True)
        if not reason:
            gone.append(finding["id"])
            continue
        version = versions(finding["engine"])
        rows.append(f"| [{finding['id']}](#{finding['id']}) | {finding['engine']} {version} | {finding['fault']} | "
                    f"{re.split('[:.]', finding['kind'])[0]} |")
        parts.append(section(finding, reason, version))
    if options.write and not gone:
        table = "| finding | engine | fault | |\n|---|---|---|---|\n" + "\n".join(rows) + "\n\n"
        head = HEAD.format(date=f"{datetime.date.today():%-d %B %Y}")
        (root / PAGE).write_text(head + table + "\n".join(parts))
        print(f"{PAGE} is written")
    return gone
