"""The page of a run of mutants: counts by kind and by file, and every survivor with what is known of it."""
import json
import pathlib
from dataclasses import dataclass, field

import shown

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
    unit: str = ""      # the unit test that notices what no law does
    kind: str = ""      # of explained.txt
    why: str = ""

    def noticed(self):
        return self.verdict == "killed" or self.unit != ""

    def can_be(self):
        """Not explained as changing no answer. One that is noticed changes some, whatever was said of it."""
        return self.noticed() or self.kind not in NO_FAULT

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
    pending: int = 0    # not run yet, and not among the mutants

    def of(self, *verdicts):
        return [m for m in self.mutants if m.verdict in verdicts]

    def judged(self):
        return [m for m in self.mutants if m.can_be()]

    def beyond_guarantees(self):
        """Per cent noticed where those that keep every guarantee are left out, too."""
        judged = [m for m in self.judged() if m.noticed() or m.kind != "within"]
        return 100.0 * len([m for m in judged if m.noticed()]) / len(judged) if judged else 100.0

    def of_changes(self):
        """Per cent noticed of those that changed an answer of this run, and how many these are: the measure of a small
        run, where most of what it does not notice changed nothing that it asked."""
        judged = [m for m in self.judged() if m.noticed() or m.answers]
        share = 100.0 * len([m for m in judged if m.noticed()]) / len(judged) if judged else 100.0
        return share, len(judged)

    def share(self, noticed=Mutant.noticed):
        """Per cent of those that can be noticed."""
        judged = self.judged()
        return 100.0 * len([m for m in judged if noticed(m)]) / len(judged) if judged else 100.0


def read_explained(path):
    out = {}
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        words = [w.strip() for w in line.split("\t") if w.strip()]
        if len(words) != 6 or words[4] not in KINDS:
            raise SystemExit(f"graze: {path}:{number}: wanted file, line, original, mutated, one of "
                             f"{', '.join(KINDS)}, and a sentence, with tabs between them")
        out[tuple(words[:4])] = (words[4], words[5])
    return out


def read(folder, source, by_unit_tests):
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
    places_of = shown.sites_of(folder)
    for one in mutants:
        one.kind, one.why = explained.get(places_of[one.number], ("", ""))
        one.unit = by_unit_tests.get(one.number, "")
    places, dropped = map(int, (folder / "sites").read_text().split())
    broken = pathlib.Path(folder / "broken")
    lines = [x for x in broken.read_text().splitlines() if x and x[0] not in "{} "] if broken.exists() else []
    done = [m for m in mutants if m.verdict]
    return Outcome(done, places, dropped, lines, len(mutants) - len(done))


def table(mutants, name_of):
    rows = {}
    for one in mutants:
        row = rows.setdefault(name_of(one), [0, 0, 0, 0, 0])
        row[0] += 1
        if one.verdict == "killed":
            row[1] += 1
        elif one.unit:
            row[2] += 1
        else:
            row[3 if one.can_be() else 4] += 1
    lines = ["| | mutants | by a law | by a unit test | not noticed | no fault |", "|---|---|---|---|---|---|"]
    for name, row in sorted(rows.items()):
        lines.append(f"| {name} | " + " | ".join(map(str, row)) + " |")
    return lines


def code(text):
    short = text if len(text) <= 90 else text[:87] + "..."
    return "`" + short.replace("|", "\\|") + "`"


def item(one):
    said = f"{one.kind}: {one.why}" if one.kind else "not explained"
    return f"- {one.file}:{one.line}, {one.operator}: {code(one.original)} becomes {code(one.mutated)}: " \
           f"{one.seen()}. **{said}**"


def counted(lines, title, rows):
    return lines + ["", f"| {title} | mutants |", "|---|---|"] + [
        f"| {name} | {n} |" for name, n in sorted(rows.items(), key=lambda x: (-x[1], x[0]))]


def page(outcome, options):
    killed = outcome.of("killed")
    unit = [m for m in outcome.mutants if m.verdict != "killed" and m.unit]
    left = [m for m in outcome.mutants if not m.noticed()]
    harmless = [m for m in left if not m.can_be()]
    judged = outcome.judged()
    by_law, by_end, by_test = {}, {}, {}
    for one in killed:
        by_law[one.law] = by_law.get(one.law, 0) + 1
        end = one.how if one.how.startswith(("crashed", "does not end")) else "a law breaks"
        by_end[end] = by_end.get(end, 0) + 1
    for one in unit:
        by_test[one.unit] = by_test.get(one.unit, 0) + 1
    scalars = "double" if options.double else "float and double"
    lines = ["# Mutants of core",
             "",
             "`./run mutants` takes a seeded sample of lines of core, changes one operator, constant, condition or "
             "statement in each, and runs the laws on generated cases (none of them curated) until one breaks. The "
             "mutants that no law notices meet the unit tests of core (`tests/mutants` says which). This page is its report: "
             f"seed {options.seed}, {len(outcome.mutants) + outcome.pending} mutants of {outcome.places} places ({outcome.dropped} that "
             f"do not compile were replaced), methods in {scalars}, {options.linear} linear cases and as many "
             f"near-ties, {options.query} of the other queries, {options.rotating} rotating, some aimed at what is "
             f"rare, {options.seconds} s of processor time for a mutant. A crash and an endless loop are noticed, too.",
             "",
             *([f"**The run was stopped: {outcome.pending} more mutants wait.**", ""] if outcome.pending else []),
             f"The laws notice {len(killed)} of {len(outcome.mutants)} mutants, and unit tests {len(unit)} more. "
             f"{len(left)} are left. {len(harmless)} of them change no answer, or none that is worse, as each says "
             f"below. **Noticed of those that can be: {outcome.share():.1f} %** "
             f"({len([m for m in judged if m.noticed()])} of {len(judged)}); by the laws alone "
             f"{outcome.share(lambda m: m.verdict == 'killed'):.1f} %. Without those that change answers within their "
             f"guarantees, which no law may object to: {outcome.beyond_guarantees():.1f} %."]
    if outcome.broken:
        lines += ["", f"{len(outcome.broken)} trials broke with no mutant alive, and were left out."]
    lines += ["", "How: " + ", ".join(f"{end} {n}" for end, n in sorted(by_end.items(), key=lambda x: -x[1])) + ".",
              "", "## By kind of mutation", ""] + table(outcome.mutants, lambda m: m.operator)
    lines += ["", "## By file", ""] + table(outcome.mutants, lambda m: m.file)
    lines += ["", "## The first to notice", "",
              "The first of a mutant, in an order that takes cheap trials first: no measure of a law's worth."]
    lines = counted(lines, "law", by_law)
    if by_test:
        lines = counted(lines, "unit test", by_test)
    lines += ["", "## Not noticed", "",
              "Kinds: *equivalent* (no input has another answer), *cost* (answers are the same or as good, at another "
              "price), *within* (answers differ and keep every guarantee), *missing* (a law or a case is needed). The first "
              "two cannot be noticed, and do not count.", ""]
    lines += [item(m) for m in sorted(left, key=lambda m: (m.file, m.line))] or ["None."]
    return "\n".join(lines) + "\n"
