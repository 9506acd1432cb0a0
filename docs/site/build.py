"""Builds the site of graze: the pages by mkdocs, the API by Doxygen, the live pages by the command.

usage: build.py --graze COMMAND --work FOLDER --out FOLDER

The pages live in docs/ with links that work in the repository. A link from a page to a file outside of docs/ becomes one to
the file's page in the site (README, API of a public header), or to a copy of it. Every link and anchor of the result is
then checked, and a broken one is an error.
"""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

SOURCE = Path(__file__).resolve().parents[2]
SITE = Path(__file__).resolve().parent
# Pages of the repository's root, and where the site has them.
ROOT_PAGES = {"README.md": "index.md"} | {f"{name}.md": f"project/{name}.md" for name in ("CHANGELOG", "CONTRIBUTING", "SECURITY")}
PUBLIC_HEADERS = ("core/graze", "scene/graze", "scene/graze/scene")


def run(command, **more):
    """Runs a command silently, and shows what it printed if it fails."""
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **more)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}\nfailed with exit code {done.returncode}")
    return done.stdout


def headers():
    """The public headers. Others in their folders do not describe themselves as files."""
    found = [path for folder in PUBLIC_HEADERS for path in sorted((SOURCE / folder).glob("*.hpp"))]
    return [path for path in found if "/// @file" in path.read_text()]


def api_page(header):
    """Doxygen's name for the page of a header."""
    return "api/" + re.sub(r"[A-Z]", lambda m: "_" + m.group().lower(), header.name.replace("_", "__").replace(".", "_8")) + ".html"


def place(target, pages):
    """The place in the site of a file of the repository. None: a folder, which has none."""
    relative = target.relative_to(SOURCE).as_posix()
    if relative in ROOT_PAGES:
        return ROOT_PAGES[relative]
    if relative.startswith("docs/"):
        return "api/index.html" if target == SITE / "api.md" else relative[len("docs/"):]
    if target in headers():
        return api_page(target)
    if target.is_dir():
        return None
    copy = f"source/{relative}.txt"
    (pages / copy).parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(target, pages / copy)
    return copy


def stage(page, to, pages):
    """Copies a page, its links led to their places in the site."""
    def lead(match):
        text, link = match.groups()
        path, _, anchor = link.partition("#")
        if not path or urlsplit(link).scheme:
            return match.group()
        target = (page.parent / path).resolve()
        if not target.exists():
            sys.exit(f"{page.relative_to(SOURCE)}: {link} does not exist")
        at = place(target, pages)
        if at is None:
            return text
        if text == target.name and target.suffix == ".md":  # in a site, a page is known by its title
            text = re.search(r"^# (.+)$", target.read_text(), re.M).group(1)
        return f"[{text}]({os.path.relpath(at, Path(to).parent)}{'#' + anchor if anchor else ''})"

    (pages / to).parent.mkdir(parents=True, exist_ok=True)
    parts = re.split(r"(^```.*?^```$)", page.read_text(), flags=re.M | re.S)  # every other one is a block of code
    text = "".join(part if i % 2 else re.sub(r"\[([^\]\[]*)\]\(([^)\s]+)\)", lead, part) for i, part in enumerate(parts))
    # What a test of the tutorials reads beside a title (tests/docs/tutorial.py) is no option of a block of code.
    (pages / to).write_text(re.sub(r"^(```\w+ title=\"[^\"]*\").*$", r"\1", text, flags=re.M))


def copy_pages(pages):
    nobodys = []
    for path in sorted((SOURCE / "docs").rglob("*")):
        relative = path.relative_to(SOURCE / "docs")
        if path.is_dir() or relative.parts[0] == "site":
            continue
        if path.suffix == ".md":
            first = re.search(r"^(?!#|<!--|$).*", path.read_text(), re.M).group()
            if not first.startswith(("For ", "A report for ")):
                nobodys.append(relative.as_posix())
            stage(path, relative.as_posix(), pages)
        else:
            (pages / relative).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, pages / relative)
    if nobodys:
        sys.exit(f"a page begins with who it is for; these do not: {', '.join(nobodys)}")
    for name, to in ROOT_PAGES.items():
        stage(SOURCE / name, to, pages)
    shutil.copytree(SITE / "live", pages / "live")
    shutil.copy(SITE / "site.css", pages)


def make_api(pages, work):
    """Doxygen's pages. A filter hides the inline namespace, which no caller names."""
    version = re.search(r"VERSION (\d+\.\d+\.\d+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)
    given = (SITE / "Doxyfile").read_text()
    given += f"PROJECT_NUMBER = {version}\nOUTPUT_DIRECTORY = {pages}\nHTML_OUTPUT = api\n"
    given += r"""INPUT_FILTER = "sed -E 's/^namespace graze \{ inline namespace GRAZE_LINKAGE/namespace graze/; s/^\}\}/}/'"
"""
    given += f"USE_MDFILE_AS_MAINPAGE = {SITE / 'api.md'}\nEXAMPLE_PATH = {SOURCE / 'examples'}\n"
    given += f"INPUT = {SITE / 'api.md'} {' '.join(map(str, headers()))}\n"
    given += "".join(f"{key} = {SOURCE / 'core'} {SOURCE / 'scene'}\n" for key in ("STRIP_FROM_PATH", "STRIP_FROM_INC_PATH"))
    given += f"STRIP_FROM_PATH += {SOURCE}\n"  # of the folder of the API's first page
    # A tab that leads back to the manual.
    run(["doxygen", "-l", work / "layout.xml"])
    layout = (work / "layout.xml").read_text()
    back = '<navindex>\n    <tab type="user" visible="yes" url="../index.html" title="Manual"/>'
    layout = layout.replace("<navindex>", back, 1).replace('<tab type="mainpage" visible="yes" title=""', '<tab type="mainpage" visible="yes" title="API"')
    (work / "layout.xml").write_text(layout)
    given += f"LAYOUT_FILE = {work / 'layout.xml'}\n"
    (work / "Doxyfile").write_text(given)
    run(["doxygen", work / "Doxyfile"], cwd=work)


def make_live(graze, pages):
    """A case, a report and scenes, as the command writes them."""
    live = pages / "live"
    # From the sources' folder: a page shows the command that made it.
    run([graze, "show", "tests/reports/viewer/pair.json", "--method", "mpr/float", "--answers", "tests/reports/viewer/pair_answers.jsonl",
         "--out", live / "case.html"], cwd=SOURCE)
    run([graze, "scene", *(f"examples/scenes/{name}.json" for name in ("fan", "crowd")), "--report", live / "scene"], cwd=SOURCE)
    run([graze, "certify", "--family", "random", "--family", "slow_spin", "--count", "6", "--rotating", "2", "--queries", "4",
         "--report-cases", "4", "--report", live / "report"])


class Links(HTMLParser):
    """The links of a page, and the names that links may lead to."""

    def __init__(self, text):
        super().__init__()
        self.links, self.names = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.names |= {values[key] for key in ("id", "name") if values.get(key)}
        self.links += [values[key] for key in ("href", "src") if values.get(key)]


def broken_links(out):
    parsed = {}

    def of(path):
        if path not in parsed:
            parsed[path] = Links(path.read_text(errors="replace"))
        return parsed[path]

    broken, count = [], 0
    pages = [path for path in sorted(out.rglob("*.html")) if path.name != "404.html" and "live" not in path.relative_to(out).parts[:-1]]
    for page in pages + [out / "live/index.html"]:
        for link in of(page).links:
            url = urlsplit(link)
            if url.scheme or url.netloc:
                continue
            # Doxygen links to this section also if all nested classes are private, and leaves it out then.
            if link == "#nested-classes" and page.parent.name == "api":
                continue
            count += 1
            target = (page.parent / unquote(url.path)).resolve() if url.path else page
            if target.is_dir() and not url.fragment and target == out.resolve():
                target = target / "index.html"
            if not target.is_file():
                broken.append(f"{page.relative_to(out)}: {link}")
            elif url.fragment and target.suffix == ".html" and unquote(url.fragment) not in of(target).names:
                broken.append(f"{page.relative_to(out)}: {link}: no such anchor")
    return count, broken


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--graze", required=True, type=Path, help="the command, built with the viewer")
    parser.add_argument("--work", required=True, type=Path, help="a folder that is emptied and used")
    parser.add_argument("--out", required=True, type=Path, help="the folder of the site, emptied first")
    given = parser.parse_args()
    work, out = given.work.resolve(), given.out.resolve()
    shutil.rmtree(work, ignore_errors=True)
    pages = work / "pages"
    pages.mkdir(parents=True)
    copy_pages(pages)
    make_api(pages, work)
    make_live(given.graze.resolve(), pages)
    for name in ("mkdocs.yml", "nav.py"):
        shutil.copy(SITE / name, work)
    shutil.copytree(SITE / "theme", work / "theme")
    printed = run(["mkdocs", "build", "--strict", "--clean", "--config-file", work / "mkdocs.yml", "--site-dir", out])
    forgotten = re.search(r"following pages exist in the docs directory, but are not included in the \"nav\".*?((?:\n  - .*)+)", printed)
    if forgotten:
        sys.exit(f"docs/site/mkdocs.yml does not name these pages:{forgotten.group(1)}")
    # The index as a script: a page that is opened from a disk may load scripts, and no other files.
    index = json.loads((out / "search/search_index.json").read_text())
    (out / "search/index.js").write_text(f"var __search = {{index: Promise.resolve({json.dumps(index)})}};\n")
    count, broken = broken_links(out)
    if broken:
        sys.exit("\n".join([f"{len(broken)} of {count} links are broken:", *broken]))
    print(f"{out}/index.html: {len(list(out.rglob('*.html')))} pages, {count} links checked")


main()
