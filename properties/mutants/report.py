"""The page of a run of mutants: counts by kind and by file, and every survivor with what is known of it."""
import json
import pathlib
from dataclasses import dataclass, field

# Kinds in explained.txt. Those that change no answer are taken out of the share that the laws must notice.
NO_FAULT = ("equivalent", "cost")
KINDS = NO_FAULT + ("within", "missing")


@dataclass
class Mutant:
    number: int
    file: str
    line: int
    operator: str
    original: str
    mutated: str
    verdict: str = ""   # killed, survived, unreached
    law: str = ""
    how: str = ""
    trials: int = 0
    seconds: float = 0
    asked: int = 0
    answers: int = 0
    costs: int = 0
    executed: int = 0
    kind: str = ""      # of explained.txt
    why: str = ""

    def seen(self):
        """What the comparison of answers says of a survivor."""
        if self.verdict == "unreached":
            return "no generated case executes it"
        if self.answers:
            return f"{self.answers} of {self.asked} answers differ in a bit, all within their guarantee"
        if self.costs:
            return f"no answer of {self.asked} differs, {self.costs} cost more or less"
        if self.executed:
            return f"no answer of {self.asked} differs, though {self.executed} values did"
        return f"no answer of {self.asked} differs"


@dataclass
class Outcome:
    mutants: list
    places: int = 0
    dropped: int = 0
    broken: list = field(default_factory=list)

    def of(self, *verdicts):
        return [m for m in self.mutants if m.verdict in verdicts]

    def judged(self):
        """Reached, and not explained as changing no answer."""
        return [m for m in self.of("killed", "survived") if m.kind not in NO_FAULT]

    def share(self):
        judged = self.judged()
        return 100.0 * len([m for m in judged if m.verdict == "killed"]) / len(judged) if judged else 100.0


def read_explained(path):
    out = {}
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        words = [w.strip() for w in line.split("\t") if w.strip()]
        if len(words) != 5 or words[3] not in KINDS:
            raise SystemExit(f"graze: {path}:{number}: wanted file, original, mutated, one of {', '.join(KINDS)}, "
                             "and a sentence, with tabs between them")
        out[tuple(words[:3])] = (words[3], words[4])
    return out


def read(folder, source):
    explained = read_explained(source / "properties/mutants/explained.txt")
    mutants = []
    for line in (folder / "mutants.jsonl").read_text().splitlines():
        site = json.loads(line)
        mutants.append(Mutant(site["mutant"], site["file"], site["line"], site["operator"], site["original"],
                              site["mutated"]))
    for line in (folder / "results").read_text().splitlines():
        words = line.split("\t")
        one = mutants[int(words[0])]
        one.verdict, one.law, one.how = words[1:4]
        one.trials, one.seconds = int(words[4]), float(words[5])
        one.asked, one.answers, one.costs, one.executed = map(int, words[6:10])
    for one in mutants:
        one.kind, one.why = explained.get((one.file, one.original, one.mutated), ("", ""))
    places, dropped = map(int, (folder / "sites").read_text().split())
    broken = pathlib.Path(folder / "broken")
    lines = [x for x in broken.read_text().splitlines() if x and x[0] not in "{} "] if broken.exists() else []
    return Outcome(mutants, places, dropped, lines)


def table(mutants, name_of):
    rows = {}
    for one in mutants:
        row = rows.setdefault(name_of(one), [0, 0, 0, 0, 0])
        row[0] += 1
        row[{"killed": 1, "survived": 2, "unreached": 3}.get(one.verdict, 3)] += 1
        row[4] += one.verdict == "survived" and one.kind in NO_FAULT
    lines = ["| | mutants | noticed | not noticed | of these no fault | not reached |", "|---|---|---|---|---|---|"]
    for name, row in sorted(rows.items()):
        lines.append(f"| {name} | {row[0]} | {row[1]} | {row[2]} | {row[4]} | {row[3]} |")
    return lines


def code(text):
    short = text if len(text) <= 90 else text[:87] + "..."
    return "`" + short.replace("|", "\\|") + "`"


def item(one):
    said = f"{one.kind}: {one.why}" if one.kind else "not explained" if one.verdict == "survived" else "-"
    return f"- {one.file}:{one.line}, {one.operator}: {code(one.original)} becomes {code(one.mutated)}: " \
           f"{one.seen()}. **{said}**"


def page(outcome, options):
    killed, survived, unreached = outcome.of("killed"), outcome.of("survived"), outcome.of("unreached")
    judged = outcome.judged()
    by_law, by_end = {}, {}
    for one in killed:
        by_law[one.law] = by_law.get(one.law, 0) + 1
        end = one.how if one.how.startswith(("crashed", "does not end")) else "a law breaks"
        by_end[end] = by_end.get(end, 0) + 1
    lines = ["# Mutants of core",
             "",
             "`./run mutants` takes a seeded sample of lines of core, changes one operator, constant, condition or "
             "statement in each, and runs the laws on generated cases (none of them curated) until one breaks. This "
             f"page is its report: seed {options.seed}, {len(outcome.mutants)} mutants of {outcome.places} places "
             f"({outcome.dropped} that do not compile were replaced), {options.linear} linear cases and as many "
             f"near-ties, {options.query} of the other queries, {options.rotating} rotating, {options.seconds} s of "
             "processor time for a mutant. A crash and an endless loop are noticed, too.",
             "",
             f"Reached by the laws: {len(killed) + len(survived)} of {len(outcome.mutants)}. Noticed: {len(killed)}. "
             f"Not noticed: {len(survived)}, of which {len([m for m in survived if m.kind in NO_FAULT])} change no "
             f"answer. **Noticed of those that are reached and can be noticed: {outcome.share():.1f} %** "
             f"({len([m for m in judged if m.verdict == 'killed'])} of {len(judged)})."]
    if outcome.broken:
        lines += ["", f"{len(outcome.broken)} trials broke with no mutant alive, and were left out."]
    lines += ["", "How: " + ", ".join(f"{end} {n}" for end, n in sorted(by_end.items(), key=lambda x: -x[1])) + ".",
              "", "## By kind of mutation", ""] + table(outcome.mutants, lambda m: m.operator)
    lines += ["", "## By file", ""] + table(outcome.mutants, lambda m: m.file)
    lines += ["", "## Which law came first", "",
              "The first of a mutant, in an order that takes cheap trials first: no measure of a law's worth.", "",
              "| law | mutants |", "|---|---|"]
    lines += [f"| {law} | {n} |" for law, n in sorted(by_law.items(), key=lambda x: (-x[1], x[0]))]
    lines += ["", "## Not noticed", "",
              "Kinds: *equivalent*, no input is answered otherwise; *cost*, answers are the same or as good, at "
              "another price; *within*, answers differ and keep every guarantee; *missing*, a law that is wanted."]
    if survived:
        lines += [""] + [item(m) for m in sorted(survived, key=lambda m: (m.file, m.line))]
    lines += ["", "## Not reached", ""]
    lines += [item(m) for m in sorted(unreached, key=lambda m: (m.file, m.line))] or ["None."]
    return "\n".join(lines) + "\n"
