"""A seeded sample of mutants, all in one copy of core, each behind a test of graze_mutants::active.

The sample takes lines of code, not sites, so that a dense line weighs no more than another: the lines come
in the order of a hash of seed, file and text, and of each line one class of mutation and one site of it by the
same hash. An edit of core elsewhere leaves them as they are. A mutation that does not compile is replaced by
another of its line, or else of the next line.
"""
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys


def order(*words):
    return hashlib.sha256("\0".join(map(str, words)).encode()).digest()


def queue(sites, seed, core):
    """Lines in the order of the sample, each a list of sites in the order of preference; and what lines say."""
    lines, texts, counts = {}, {}, {}
    for site in sites:
        lines.setdefault((site.file, site.line), []).append(site)
    for file in sorted({s.file for s in sites}):
        with open(os.path.join(core, file), encoding="utf-8") as source:
            for number, text in enumerate(source, 1):
                same = (file, text.strip())
                counts[same] = counts.get(same, 0) + 1
                texts[(file, number)] = "%s#%d" % (text.strip(), counts[same])

    def preference(line):
        def key(site):
            text = texts[line]
            return (order(seed, line[0], text, site.operator),
                    order(seed, line[0], text, site.operator, site.original, site.mutated))
        return key

    ordered = sorted(lines, key=lambda line: order(seed, line[0], texts[line]))
    return [sorted(lines[line], key=preference(line)) for line in ordered], texts


class Known:
    """Mutations that failed to compile, kept in a file: the next sample passes over them at once."""

    def __init__(self, path):
        self.path = path
        self.bad = set()
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                self.bad = {tuple(json.loads(line)) for line in file}

    def add(self, key):
        if key not in self.bad:
            self.bad.add(key)
            with open(self.path, "a", encoding="utf-8") as file:
                file.write(json.dumps(key) + "\n")


class Sample:
    """The mutants by number; a number whose mutation fails to compile is given to another."""

    def __init__(self, sites, seed, core, count, known):
        self.core = core
        self.known = known
        self.queue, self.texts = queue(sites, seed, core)
        self.next_line = 0
        self.rest = {}
        self.mutants = {}
        self.dropped = 0
        for number in range(count):
            self.fill(number)

    def key(self, site):
        return (site.file, self.texts[(site.file, site.line)], site.operator, site.original, site.mutated)

    def is_free(self, site):
        return all(s.file != site.file or s.end <= site.start or site.end <= s.start
                   for s in self.mutants.values())

    def fill(self, number):
        """Gives the number to the next site of its line, else to another line."""
        self.mutants.pop(number, None)
        while True:
            line = self.rest.setdefault(number, [])
            while line:
                site = line.pop(0)
                if self.key(site) in self.known.bad:
                    self.dropped += 1
                elif self.is_free(site):
                    self.mutants[number] = site
                    return
            if self.next_line == len(self.queue):
                sys.exit("graze: core has no more lines to mutate; ask for fewer mutants")
            self.rest[number] = list(self.queue[self.next_line])
            self.next_line += 1

    def drop(self, number):
        self.known.add(self.key(self.mutants[number]))
        self.dropped += 1
        self.fill(number)

    def generate(self, folder):
        """The copy of core; a file that has not changed keeps its date."""
        by_file = {}
        for number, site in self.mutants.items():
            by_file.setdefault(site.file, []).append((site, number))
        for parent, _, files in os.walk(os.path.join(self.core, "graze")):
            for name in files:
                path = os.path.join(parent, name)
                relative = os.path.relpath(path, self.core)
                with open(path, "rb") as file:
                    text = file.read()
                here = sorted(by_file.get(relative, []), key=lambda s: -s[0].start)
                for site, number in here:
                    lines = text[site.start:site.end].count(b"\n")
                    code = re.sub(r"\bID\b", str(number), site.code)
                    text = text[:site.start] + code.encode() + b"\n" * lines + text[site.end:]
                if here:
                    text = text.replace(b"#pragma once",
                                        b"#pragma once\n#include \"properties/mutants/mutants.hpp\"\n"
                                        b"#line %d" % (text[:text.index(b"#pragma once")].count(b"\n") + 2), 1)
                target = os.path.join(folder, relative)
                os.makedirs(os.path.dirname(target), exist_ok=True)
                if os.path.exists(target):
                    with open(target, "rb") as file:
                        if file.read() == text:
                            continue
                with open(target, "wb") as file:
                    file.write(text)

    def at(self, folder, message):
        """The mutants on the lines that a compiler's message names, first named first."""
        found = []
        for path, line in re.findall(r"(\S+?\.hpp):(\d+)", message):
            relative = os.path.relpath(path, folder)
            for number, site in self.mutants.items():
                lines = site.line + site.original.count("\n")
                if site.file == relative and site.line <= int(line) <= lines and number not in found:
                    found.append(number)
        return found

    def save(self, path):
        with open(path + ".new", "w", encoding="utf-8") as file:
            for number in sorted(self.mutants):
                json.dump({"mutant": number, **vars(self.mutants[number])}, file)
                file.write("\n")
        os.replace(path + ".new", path)


def messages(stderr):
    """A compiler's errors, each with the notes around it that say where it was instantiated from."""
    blocks, current = [], []
    for line in stderr.splitlines():
        starts = re.match(r"\S+: In |In file included from|\S+: *(required|In instantiation)", line)
        if starts and any(" error: " in text for text in current):
            blocks.append(current)
            current = []
        if " error: " in line and any(" error: " in text for text in current):
            blocks.append(current)
            current = []
        current.append(line)
    if any(" error: " in text for text in current):
        blocks.append(current)
    return blocks


def settle(sample, folder, command, files, say, only_object=None):
    """Drops what does not compile until all of it does. No object is made, except for a file that is the only one."""
    ends = {file: ["-c", file, "-o", only_object] if only_object else ["-fsyntax-only", file] for file in files}
    for turn in range(40):
        sample.generate(folder)
        failed = set()
        for file in files:
            run = subprocess.run(command + ends[file], capture_output=True, text=True, check=False)
            if run.returncode == 0:
                continue
            for block in messages(run.stderr):
                error = [line for line in block if " error: " in line]
                named = sample.at(folder, error[0]) or sample.at(folder, "\n".join(block))
                failed.update(named[:1])
            if not failed:
                sys.exit("graze: the mutated core does not compile, and no mutant explains it:\n"
                         + run.stderr[:4000])
        if not failed:
            return
        say("turn %d: %d mutations do not compile, others take their place" % (turn + 1, len(failed)))
        for number in failed:
            sample.drop(number)
    sys.exit("graze: the mutated core still does not compile after 40 turns")


def copy_of(folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
