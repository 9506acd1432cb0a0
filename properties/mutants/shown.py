"""What showed a mutant in an earlier run, so that the next one tries it first: law and case by line and mutation.

Only the order of a run depends on it: a mutant counts as noticed when a law breaks in this run.
"""
import json


def sites_of(folder):
    """The key of each mutant of a run: its file, the text of its line, and the mutation."""
    out = {}
    for line in (folder / "mutants.jsonl").read_text().splitlines():
        site = json.loads(line)
        text = (folder / "original" / site["file"]).read_text().splitlines()[site["line"] - 1].strip()
        out[site["mutant"]] = (site["file"], text, site["original"], site["mutated"])
    return out


class Shown:
    def __init__(self, path):
        self.path = path
        self.by_site = {}
        if path.exists():
            for line in path.read_text().splitlines():
                one = json.loads(line)
                self.by_site[tuple(one["site"])] = (one["law"], one["case"])

    def save_for(self, folder):
        lines = []
        for mutant, site in sites_of(folder).items():
            if site in self.by_site:
                lines.append("%d %s %s\n" % (mutant, *self.by_site[site]))
        (folder / "first").write_text("".join(lines))

    def learn(self, folder):
        sites = sites_of(folder)
        for line in (folder / "results").read_text().splitlines():
            words = line.split("\t")
            if words[1] == "killed":
                self.by_site[sites[int(words[0])]] = (words[2], words[10])
        self.path.write_text("".join(json.dumps({"site": site, "law": law, "case": case}) + "\n"
                                     for site, (law, case) in sorted(self.by_site.items())))
