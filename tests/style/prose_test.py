#!/usr/bin/env python3
"""Plain English: counts four habits in the pages and in the comments of each folder, and fails above their caps. It prints
the worst ten sentences. usage: prose_test.py SOURCE_DIR

A sentence opens with the topic ("Of bodies …"), holds a semicolon, or has more than 35 words. A phrase is one of the list
below, for which the field has a word. Code blocks, headings and pictures do not count. A cell of a table is a sentence."""
import pathlib
import re
import sys

CAPS = {"topic openings": 0.01, "semicolons": 0.04, "over 35 words": 0.02}  # of the sentences
PHRASES = re.compile(
    r"bodies that turn|turning bod|turning cast|engines? of others|\b(?:is|are) none\b|for who\b|who asks|\bbut for\b"
    r"|as far as|hand(?:s|ed)? out|held against no|in the place of|goes on\b")
COMMENT = re.compile(r"^\s*///?<?\s?(.*)$|\s{2,}///?<?\s(.*)$")


def sentences(text):
    text = re.sub(r"```.*?```", "", text, flags=re.S)
    text = re.sub(r"@code.*?@endcode", "", text, flags=re.S)
    blocks, block = [], []
    for line in re.sub(r"(?m)^ {4,}.*$", "", text).split("\n") + [""]:
        line = line.strip()
        item = re.match(r"([-*]|\d+\.) ", line)
        if not line or line[0] in "#|" or line.startswith("![") or item:
            blocks.append(" ".join(block))
            block = [line[item.end():]] if item else []
            if line.startswith("|"):
                blocks += [cell.strip() for cell in line.strip("|").split("|")]
        else:
            block.append(line)
    for block in blocks:
        for sentence in re.split(r"(?<=[.!?])\s+(?=[A-Z`(\[])", block.replace("*", "")):
            if len(sentence.split()) > 3:
                yield sentence


def habits(sentence):
    words = len(sentence.split())
    return [bool(re.match(r"(Of|What|Who|Where|That|Which|Whether)\b", sentence)), ";" in sentence, words > 35], words


def comments(path):
    found = (COMMENT.search(line) for line in path.read_text(encoding="utf-8").split("\n"))
    lines = ((match[1] or match[2] or "") if match else "" for match in found)
    # Two spaces or more begin a row of a table or a list.
    return "\n".join(f"\n{line.strip()}\n" if line.startswith("  ") else line for line in lines)


source = pathlib.Path(sys.argv[1])
places = {"pages": {page: page.read_text(encoding="utf-8")
                    for page in [*source.glob("*.md"), *source.glob("docs/**/*.md"), *source.glob("examples/**/*.md")]}}
for kind in ("hpp", "cpp", "h"):
    for file in source.glob(f"*/**/*.{kind}"):
        folder = file.relative_to(source).parts[0]
        if folder != "build" and not folder.startswith(".") and "node_modules" not in file.parts:
            places.setdefault(f"comments in {folder}/", {})[file] = comments(file)

failed, worst = False, []
for place, texts in sorted(places.items()):
    count, hits, phrases = 0, [0, 0, 0], []
    for file, text in texts.items():
        phrases += [f"{file.relative_to(source)}: {match[0]}" for match in PHRASES.finditer(text)]
        for sentence in sentences(text):
            has, words = habits(sentence)
            count += 1
            hits = [before + one for before, one in zip(hits, has)]
            if any(has):
                worst.append((sum(has), words, f"{file.relative_to(source)}: {sentence}"))
    shares = [hit / max(count, 1) for hit in hits]
    above = [name for (name, cap), share in zip(CAPS.items(), shares) if share > cap] + (["phrases"] if phrases else [])
    failed |= bool(above)
    print(f"{place}: {count} sentences, " + ", ".join(f"{100 * s:.1f} % {name}" for name, s in zip(CAPS, shares)) +
          f", {len(phrases)} phrases" + (f"  ABOVE THE CAP: {', '.join(above)}" if above else ""))
    print("".join(f"  {phrase}\n" for phrase in phrases[:5]), end="")
if len(places) < 8 or len(places["pages"]) < 30:
    sys.exit("found too few folders or pages: wrong folder?")
print("the worst ten:\n" + "\n".join(f"  {text[:200]}" for _, _, text in sorted(worst, reverse=True)[:10]))
sys.exit(failed)
