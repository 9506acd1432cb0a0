"""A patch of the catalogue, planted in a copy of the sources and compiled."""
import pathlib
import re
import shutil
import subprocess
import sys

METHODS = {"linear": "engines/linear.cpp", "query": "engines/queries.cpp", "rotating": "engines/rotating.cpp"}
# The functions by which the others know those methods.
ADDED_BY = {"linear": "add_linear_methods", "query": "add_query_methods", "rotating": "add_rotating_methods"}
# Entries of core in double, by the header that defines them. One whose header does not include, however deep,
# what a patch changes is the same with the defect, and is taken from the library.
ENTRIES = {
    "graze/detail/casts/ladder.hpp": ("Cast", ["cast", "cast_certified", "cast_exact"]),
    "graze/detail/queries/distance_query.hpp": ("Distance", ["distance"]),
    "graze/detail/queries/line_query.hpp": ("Line", ["line"]),
    "graze/detail/queries/penetration_query.hpp": ("Penetration", ["penetration"]),
    "graze/detail/queries/swept_overlap_query.hpp": ("SweptOverlap", ["swept_overlap"]),
}
CLASS_LETTERS = "ABCDEFGHIJKL"


class Fault(Exception):
    """Something is wrong with the input; one line says what."""


class Config:
    def __init__(self, path, work):
        try:
            lines = pathlib.Path(path).read_text().splitlines()
        except OSError as error:
            raise Fault(f"{path}: {error.strerror}; give the file that CMake writes, defects-Release.conf")
        fields = dict(line.split(" = ", 1) if " = " in line else (line.rstrip(" ="), "") for line in lines if line)
        missing = {"source", "driver", "launcher", "compiler", "flags", "includes", "link"} - fields.keys()
        if missing:
            raise Fault(f"{path}: no field {sorted(missing)[0]}; give the file that CMake writes")
        self.source = pathlib.Path(fields["source"])
        self.driver = fields["driver"]
        self.compiler = [word for word in (fields["launcher"], fields["compiler"]) if word]
        self.flags = fields["flags"].split(";")
        self.includes = fields["includes"].split(";")
        self.link = fields["link"].split(";")
        self.linker, self.nm, self.objcopy = (fields.get(tool) for tool in ("linker", "nm", "objcopy"))
        self.certify, self.certify_link = fields.get("certify"), fields.get("certify_link", "").split(";")
        self.work = pathlib.Path(work).resolve()
        self.defects = self.source / "properties/defects/patches"
        self.law_kind, self.law_needs = {}, {}

    def learn_laws(self):
        out = subprocess.run([self.driver, "--laws"], capture_output=True, text=True, check=True).stdout
        for line in out.splitlines():
            name, kind, needs = line.split()
            if name in self.law_kind:
                raise Fault(f"two laws are called {name}; a law has a name of its own")
            self.law_kind[name], self.law_needs[name] = kind, needs


class Patch:
    FOLDER = "properties/defects/patches"
    ROOMS = ("core", "oracles")  # what a patch may change
    KEYS = ("Defect", "Law", "Report", "Class", "Compile")
    NAMES = "Law"  # the header line that says who has to notice

    def __init__(self, path):
        self.path = path
        self.name = path.stem
        try:
            self.text = path.read_text()
        except OSError as error:
            raise Fault(f"{path}: {error.strerror}; give a .patch of {self.FOLDER}")
        head = self.text.split("\n--- ", 1)[0]
        self.headers = re.findall(r"^([A-Z][a-z]+): (.+)$", head, re.M)
        unknown = [key for key, _ in self.headers if key not in self.KEYS]
        if unknown:
            raise Fault(f"{path}: {unknown[0]} is no header line; known are {', '.join(self.KEYS)}")
        self.defect, self.law = self.one("Defect"), self.one(self.NAMES)
        self.reports, self.classes = self.all("Report"), self.all("Class")
        if any(letter not in CLASS_LETTERS for letter in self.classes):
            raise Fault(f"{path}: Class is one of the letters A to L")
        self.files = re.findall(r"^\+\+\+ b/(\S+)", self.text, re.M)
        self.in_core = any(name.startswith("core/") for name in self.files)
        self.compiled = [name for name in self.files if name.endswith(".cpp") and not name.startswith("core/")]
        self.compiled += self.compiled_besides()
        if not self.in_core and not self.compiled:
            raise Fault(f"{path}: nothing to compile: patch core/, a .cpp of {self.ROOMS[1]}/, or name one by Compile")

    def compiled_besides(self):
        """The .cpp files that it changes by a header."""
        return self.all("Compile")

    def all(self, key):
        return [word for k, value in self.headers if k == key for word in value.split(", ")] if key != "Defect" \
            else [value for k, value in self.headers if k == key]

    def one(self, key):
        values = self.all(key)
        if len(values) != 1:
            raise Fault(f"{self.path}: {len(values)} lines \"{key}: ...\"; one is right")
        return values[0]


def named_patches(folder, names, of):
    """of(path) of the patches that the command line names: by name in the folder, or by path. All if it names none."""
    paths = [pathlib.Path(name).resolve() if name.endswith(".patch") else folder / f"{name}.patch" for name in names]
    return [of(path) for path in paths or sorted(folder.glob("*.patch"))]


def end(main, stopped=""):
    """Runs main, which returns what is wrong, and ends the program."""
    try:
        faults = main()
    except Fault as fault:
        print(f"graze: {fault}", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        print(stopped, end="", file=sys.stderr)
        sys.exit(130)
    for fault in faults:
        print(f"FAIL: {fault}")
    sys.exit(1 if faults else 0)


def run(words, log, **more):
    with open(log, "a") as out:
        return subprocess.run(words, stdout=out, stderr=out, check=False, **more).returncode


def headers_under(core, path):
    """All headers of core that a file includes, however deep."""
    seen, left = set(), [path]
    while left:
        for name in re.findall(r"^#include <(graze/[^>]+)>", left.pop().read_text(), re.M):
            if name not in seen:
                seen.add(name)
                left.append(core / name)
    return seen


def known_entries(config, patch, source):
    """The headers of the entries that a source needs and that the patch cannot change."""
    core, changed = config.source / "core", {name.removeprefix("core/") for name in patch.files}
    return [header for header in ENTRIES if header in headers_under(core, source)
            and not changed & {header, *headers_under(core, core / header)}]


def instantiated_elsewhere(headers):
    """C++ that says of the entries of these headers that they are instantiated elsewhere."""
    lines = [f"#include <{header}>" for header in headers] + ["namespace graze {"]
    for header in headers:
        kind, names = ENTRIES[header]
        body = "const Body<double>&"
        lines += [f"extern template {kind}Result<double> {name}({body}, {body}, const {kind}Options<double>&);"
                  for name in names]
    return "\n".join([*lines, "}", ""])


def remove_copies(patch, root):
    for room in patch.ROOMS:
        shutil.rmtree(root / room, ignore_errors=True)


def plant(config, patch, root):
    """The sources that the patch can change, with the defect, under root. An error, or nothing."""
    remove_copies(patch, root)
    for room in patch.ROOMS:
        if room == "core" or patch.compiled:
            shutil.copytree(config.source / room, root / room)
    log = root / "log"
    log.write_text("")
    if run(["patch", "--quiet", "--strip=1", "--fuzz=1", "--directory", root, "--input", patch.path], log):
        return "does not apply any more; make it again: " + " ".join(log.read_text().split())
    return ""


def compile_objects(config, patch, kind, root):
    """The objects under root that carry the defect, and an error or nothing."""
    objects = []
    alone = [] if "float" in patch.text else ["-DGRAZE_DOUBLE_ALONE"]
    files = [str(root / name) for name in patch.compiled]
    if patch.in_core:
        files.append(str(config.source / METHODS[kind]))
        known = known_entries(config, patch, config.source / METHODS[kind])
        (root / "known.hpp").write_text(instantiated_elsewhere(known))
        alone += ["-include", str(root / "known.hpp"), "-include", "properties/defects/whole_core.hpp"]
    include = [f"-I{root}/core", f"-I{root}", f"-I{config.source}"]
    include += [word for path in config.includes for word in ("-isystem", path)]
    log = root / "log"
    for name in files:
        objects.append(str(root / (pathlib.Path(name).stem + ".o")))
        if run([*config.compiler, *config.flags, *alone, *include, "-c", name, "-o", objects[-1]], log):
            return objects, f"does not compile, see {log}"
    return objects, ""


def enclose(config, kind, name, log):
    """Makes all that the methods' object defines its own, but the function that hands the methods out. Of a function
    in a header the linker takes the first that it meets, for everybody: judges would get core's with the defect."""
    listed = subprocess.run([config.nm, "--defined-only", "--format=posix", name], capture_output=True, text=True,
                            check=True).stdout
    symbols = [line.split()[:2] for line in listed.splitlines()]
    kept = [symbol for symbol, _ in symbols if ADDED_BY[kind] in symbol]
    if len(kept) != 1:
        return f"{name} has {len(kept)} functions {ADDED_BY[kind]}"
    # Symbols that are unique in a program have to be weak before they can be an object's own.
    weak = [f"--weaken-symbol={symbol}" for symbol, what in symbols if what == "u"]
    if run([config.linker, "-r", "--force-group-allocation", name, "-o", f"{name}.one"], log) or \
            run([config.objcopy, *weak, f"{name}.one", f"{name}.weak"], log) or \
            run([config.objcopy, f"--keep-global-symbol={kept[0]}", f"{name}.weak", name], log):
        return f"cannot be enclosed, see {log}"
    return ""


def link_defect(config, objects, root, link):
    """root/driver. An error, or nothing."""
    if run([config.compiler[-1], *objects, *link, "-o", root / "driver"], root / "log"):
        return f"does not link, see {root / 'log'}"
    return ""


def compile_defect(config, patch, kind, root):
    """root/driver, whose methods, or whose oracle, carry the defect. An error, or nothing."""
    objects, error = compile_objects(config, patch, kind, root)
    return error or link_defect(config, objects, root, config.link)


def kind_of(config, patch):
    if patch.law not in config.law_kind:
        raise Fault(f"{patch.path}: no law {patch.law}; `{config.driver} --laws` lists them")
    return config.law_kind[patch.law]
