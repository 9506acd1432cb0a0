"""schemas_test.py SOURCE_DIR GRAZE READ_DOCUMENTS: the JSON Schemas of docs/schemas/ against everything that they describe.

- Every case of corpus/, every whole document in docs/, and every question that the host writes is valid.
- Every change of a sound document (a field left out, one too many, a value of another kind) is refused by the schema where
  the reader in C++ refuses it, and the reverse, except for what a schema cannot say, which stands below.
"""
import copy
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import warnings

import jsonschema

warnings.simplefilter("ignore", DeprecationWarning)

KINDS = ("case", "engine", "question", "answer", "proof", "certification", "price", "scene", "events")


def no_number(word):
    raise ValueError(word + " is no JSON")


def load(text):
    return json.loads(text, parse_constant=no_number)


def validators(folder):
    schemas = {kind: load((folder / f"graze.{kind}.schema.json").read_text()) for kind in KINDS}
    store = {schema["$id"]: schema for schema in schemas.values()}
    for schema in schemas.values():
        jsonschema.Draft202012Validator.check_schema(schema)
    try:  # jsonschema 4.18 and later
        from referencing import Registry, Resource

        registry = Registry().with_resources((name, Resource.from_contents(schema)) for name, schema in store.items())
        return {kind: jsonschema.Draft202012Validator(schema, registry=registry) for kind, schema in schemas.items()}
    except ImportError:
        return {
            kind: jsonschema.Draft202012Validator(
                schema, resolver=jsonschema.RefResolver(base_uri=schema["$id"], referrer=schema, store=store))
            for kind, schema in schemas.items()
        }


class Check:
    def __init__(self, folder):
        self.validators = validators(folder)
        self.faults = []
        self.count = 0

    def valid(self, kind, document):
        return self.validators[kind].is_valid(document)

    def expect_valid(self, kind, document, where):
        self.count += 1
        error = next(self.validators[kind].iter_errors(document), None)
        if error is not None:
            self.faults.append(f"{where}: {list(error.absolute_path)}: {error.message[:300]}")

    def expect(self, holds, what):
        if not holds:
            self.faults.append(what)


def kind_of(document):
    match = re.fullmatch(r"graze\.([a-z]+)/[0-9]+", document.get("schema", ""))
    return match.group(1) if match else None


def corpus(check, folder):
    count = 0
    for file in sorted(folder.rglob("*.json*")):
        text = file.read_text()
        lines = text.splitlines() if file.suffix == ".jsonl" else [text]
        for number, line in enumerate(lines, 1):
            if not line.strip():
                continue
            document = load(line)
            if not isinstance(document, dict) or kind_of(document) != "case":
                continue
            check.expect_valid("case", document, f"{file}:{number}")
            count += 1
    check.expect(count > 500, f"{folder}: only {count} cases")


def examples(check, file, wanted):
    """The documents in a page that are whole: from each {"schema" on, as far as one object goes."""
    text = file.read_text()
    decoder = json.JSONDecoder(parse_constant=no_number)
    seen = set()
    for match in re.finditer(r'\{"schema"', text):
        try:
            document, _ = decoder.raw_decode(text[match.start():])
        except ValueError:
            continue  # it has an ellipsis
        seen.add(kind_of(document))
        check.expect_valid(kind_of(document), document, f"{file.name}: {kind_of(document)}")
    check.expect(wanted <= seen, f"{file.name}: whole examples of {seen}, and not of {wanted - seen}")


def questions(check, graze, here):
    with tempfile.TemporaryDirectory() as folder:
        record, report = pathlib.Path(folder) / "questions.jsonl", pathlib.Path(folder) / "report.json"
        command = [graze, "certify", "--engine", f"'{sys.executable}' '{here / 'recording_engine.py'}' '{record}'",
                   "--time-limit", "60", "--count", "24", "--rotating", "2", "--queries", "2", "--threads", "1",
                   "--json", str(report)]
        for family in ("random", "mixed_magnitudes", "grazing_edge", "fast_spin"):
            command += ["--family", family]
        ran = subprocess.run(command, capture_output=True, text=True)
        # The recorder takes nothing, and an engine that is judged by nothing is an error.
        check.expect(ran.returncode == 2 and "it takes none" in ran.stderr,
                     f"graze certify ends with {ran.returncode}: {ran.stderr}")
        asked, forms = set(), set()
        for number, line in enumerate(record.read_text().splitlines() if record.exists() else [], 1):
            document = load(line)
            check.expect_valid("question", document, f"question {number}")
            asked.add(document["query"])
            form = (document["query"], *sorted(document))
            if form in forms:
                continue
            forms.add(form)
            for field in document:
                less = {key: value for key, value in document.items() if key != field}
                check.expect(not check.valid("question", less), f"question {number} is valid without {field}")
            check.expect(not check.valid("question", {**document, "more": 1}), f"question {number} is valid with more")
        wanted = {"cast", "rotating_cast", "ray", "overlap", "distance", "penetration"}
        check.expect(wanted <= asked, f"the host asked {asked} alone")
        if report.exists() and report.stat().st_size > 0:
            check.expect_valid("certification", load(report.read_text()), "certification")


def price_list(check, graze):
    """A run of a few tables, one of each part, is valid; without any field, with one more, it is not, and the command that
    reads it says so, too."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "price.json"
        command = [graze, "price", "--rounds", "1", "--threads", "1", "--json", str(file)]
        for name in ("smooth_sphere", "face gap 2", "requests smooth", "swept 8"):
            command += ["--only", name]
        ran = subprocess.run(command, capture_output=True, text=True)
        check.expect(ran.returncode == 0, f"graze price ends with {ran.returncode}: {ran.stderr}")
        if not file.exists():
            return
        document = load(file.read_text())
        check.expect_valid("price", document, "price list")
        check.expect({table["part"] for table in document["tables"]} == {"family", "growth", "request", "query"},
                     "a price list lacks a part")
        document["tables"] = document["tables"][:1]  # one is enough to change
        table, row = document["tables"][0], document["tables"][0]["rows"][0]
        advice = document["advice"][0]
        for where, fields in (("", document), ("table", table), ("row", row), ("advice", advice)):
            for field in list(fields):
                kept = fields.pop(field)
                if field == "advice":  # which version 0.2.0 did not write
                    file.write_text(json.dumps(document))
                    read = subprocess.run([graze, "compare", str(file), str(file)], capture_output=True, text=True)
                    check.expect(read.returncode == 0, f"graze compare, without advice: {read.stderr!r}")
                    check.expect_valid("price", document, "price list without advice")
                    fields[field] = kept
                    continue
                check.expect(not check.valid("price", document), f"a price list is valid without {where} {field}")
                file.write_text(json.dumps(document))
                read = subprocess.run([graze, "compare", str(file), str(file)], capture_output=True, text=True)
                check.expect(read.returncode == 2 and field in read.stderr,
                             f"graze compare, without {where} {field}: {read.returncode}, {read.stderr!r}")
                fields[field] = kept
            check.expect(not check.valid("price", {**document, "more": 1}), "a price list is valid with more")


POSE = {"position": [1, 2, 3], "orientation": [1, 0, "0x1p-3", 0]}
SHAPES = [{"type": "point"}, {"type": "segment", "a": [0, 0, 0], "b": [1, 0, 0]},
          {"type": "triangle", "a": [0, 0, 0], "b": [1, 0, 0], "c": [0, 1, 0]}, {"type": "sphere", "radius": 1},
          {"type": "capsule", "radius": 1, "half_height": 2}, {"type": "box", "half_extents": [1, 0, 3]},
          {"type": "ellipsoid", "radii": [1, 2, "0x1.8p+1"]}, {"type": "cylinder", "radius": 1, "half_height": 0},
          {"type": "cone", "radius": 1, "half_height": 1},
          {"type": "hull", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "faces": [[0, 1, 2]]},
          {"type": "rounded", "shape": {"type": "point"}, "radius": 1},
          {"type": "sum", "shapes": [{"type": "point"}, {"type": "sphere", "radius": 1}]},
          {"type": "hull_of", "shapes": [{"type": "posed", "shape": {"type": "point"}, **POSE}]}]
CASE = {"schema": "graze.case/1", "id": "a/b", "family": "a", "hardness": 2.5, "comment": "why", "source": "where",
        "flags": ["Graze"], "t_max": 2, "target_distance": 0.5, "start_policy": "report", "query": "cast",
        "a": {"shape": SHAPES[3], **POSE, "displacement": [0, 0, 0]},
        "b": {"shape": SHAPES[0], "rotation": [0, 0, 1], "pivot": [1, 0, 0]}}
LITTLE = {"schema": "graze.case/1", "id": "s", "a": {"shape": SHAPES[3]}, "b": {"shape": SHAPES[0]}}
FIRST = {"by": "oracle", "outcome": "hit", "toi": {"lower": 0.25, "upper": 0.5, "exact": "-1/3"}, "t_in": "-inf",
         "t_out": "inf", "distance": 0, "depth": 1, "normal": [0, 0, 1]}
SECOND = {"by": "oracle", "outcome": "miss", "clearance": 0.25, "path_depth": 0, "scale": 4}
ALONG = {"query": "penetration_along", "direction": [0, 0, 1]}
PAIR = {"a": {"vertex": 0, "offset": [0, 1, 0]}, "b": {"vertex": 3, "curved": [[0, 0, 1]]}}
LINEAR = {"toi_lower": "inf", "axis": [0, -1, 0], "toi_upper": 0.25, "portal": [PAIR]}
SYMBOLIC = {**LINEAR, "axis": {"sign": -1, "cross": [{"from": PAIR, "to": PAIR}, "motion"]}}
NEAREST = {"toi_lower": 0.25, "toi_upper": 0.25, "cores": [PAIR],
           "axis": {"nearest": [PAIR, PAIR], "time": 0.25, "motion": True, "then": {"from": PAIR, "to": PAIR}}}
ROTATING = {"toi_lower": 0.25, "chain": [{"end": 0.25, "axis": [0, 0, 1], "frame": "a"}], "toi_upper": 0.5,
            "contact": [{**PAIR, "weight": 1}]}
CROSSING = {**ROTATING, "contact_from": 0.375, "contact": [PAIR]}
RECORD = {"schema": "graze.proof/1", "case": CASE, "method": "mpr", "scalar": "double", "tier": "exact",
          "outcome": "hit", "toi": {"lower": 0.25, "upper": 0.5}, "proof": LINEAR}
OFFER = {"answers": ["time", "normal"], "tolerance": 1e-4, "relative_tolerance": 0, "kappa": 8, "touching": "miss",
         "early": 0.01, "starts": False, "stalls": 0.1, "target_distance": True, "pass_over": True,
         "start_normal": "least_penetration", "own_frames": 1e-20}
ENGINE = {"schema": "graze.engine/1", "name": "mine", "version": "1", "about": "a cast", "scalar": "float",
          "shapes": ["box", "hull"], "margin": 0.04, "lengths": [0.1, 100], "infinite_t_max": True,
          "motion": "relative", "pivots": False, "most_turn": 3.1, "most_vertices": 64, "most_aspect": 100,
          "timed": True, "queries": {"cast": OFFER, "distance": {"answers": ["distance"]},
                                     "penetration": {"answers": ["depth"]}}}
HEAD = {"schema": "graze.answer/1", "id": "q1"}
HIT = {**HEAD, "outcome": "hit", "time": 0.25, "normal": [0, 1, 0], "point_a": [0, 0, 0], "point_b": [0, 0, "0x1p-20"],
       "proof": LINEAR, "ns": 120.5, "native": True, "message": "fine", "iterations": 3, "supports": 8}
SOUND = {
    "case": [{**CASE, "expect": FIRST}, {**CASE, **ALONG}, {**CASE, "schema": "graze.case/2", "expect": SECOND}]
            + [{"schema": "graze.case/1", "id": "s", "a": {"shape": shape}, "b": {"shape": SHAPES[0]}} for shape in SHAPES],
    "proof": [RECORD, *({**RECORD, "case": LITTLE, "proof": proof} for proof in (SYMBOLIC, NEAREST, ROTATING, CROSSING))],
    "engine": [ENGINE],
    "cast": [HIT, {**HIT, "time": {"lower": 0.25, "upper": 0.5}}, {**HEAD, "outcome": "miss"},
             {**HEAD, "outcome": "initially_overlapping", "normal": [0, 1, 0], "point_a": [0, 0, 0], "point_b": [0, 0, 0]}],
    "distance": [{**HEAD, "outcome": "miss", "distance": 2, "normal": [1, 0, 0], "point_a": [0, 0, 0],
                  "point_b": [2, 0, 0]}],
    "penetration": [{**HEAD, "outcome": "initially_overlapping", "depth": {"lower": 1, "upper": 2}, "normal": [1, 0, 0],
                     "point_a": [0, 0, 0], "point_b": [2, 0, 0]}],
}
SCENE = {"schema": "graze.scene/1", "id": "s", "comment": "why", "tier": "certified", "ask": "body",
         "request": ["normal", "proof"], "t_max": 2, "target_distance": 0.5, "tolerance": 0,
         "shapes": [{"name": "ball", "shape": SHAPES[3]}],
         "bodies": [{"name": "a", "shape": SHAPES[5], **POSE, "displacement": [1, 0, 0], "rotation": [0, 0, 1],
                     "pivot": [0, 1, 0], "group": 2, "mask": 3},
                    {"name": "b", "shape": "ball", "position": [9, 0, 0]}],
         "rays": [{"name": "sight", "origin": [0, 0, 0], "displacement": [1, 0, 0], "t_max": "inf", "ask": "all",
                   "group": 1, "mask": 7}],
         "casts": [{"name": "drone", "shape": "ball", **POSE, "displacement": [1, 0, 0], "rotation": [0, 0, 1],
                    "pivot": [0, 0, 0], "t_max": 2, "ask": "first"}]}
SOUND["scene"] = [SCENE, {"schema": "graze.scene/1", "id": "nothing"}]
# In the place of any value.
OTHERS = [None, True, "x", "", -1, 0, 1.5, "inf", "-inf", "nan", "0x1p+2", [], {}, [1, 2], [0, 0, 0], [0, 0, 0, 0]]

# What a schema cannot say, or the reader does not look at: of answers which fields the outcome and the engine ask for, and
# what they hold where they are not looked at.
UNSAID = [
    r"lower is above upper", r"upside down", r"no vertex [0-9]+", r"it answers ", r"has length", r"is not between 0", r"^time is infinite",
    r"unknown shape", r"already; each has its own name", r"is infinite, and it rotates",
    r"0 < least <= most", r"\.(pi|time)?: missing; (normal|point_a|point_b|distance|depth|time) ",
    r"^(normal|point_a|point_b|distance|depth|time): missing", r"a fraction of a family is at most 1",
]


def changes(document):
    """Every document that differs from it in one place, and what was changed."""
    def places(value, path):
        yield path, value
        items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
        for key, item in items:
            yield from places(item, path + [key])

    def changed(path, edit):
        other = copy.deepcopy(document)
        if not path:
            return edit(None, None, other)
        parent = other
        for key in path[:-1]:
            parent = parent[key]
        return edit(parent, path[-1], other)

    def without(parent, key, other):
        del parent[key]
        return other

    def instead(value):
        def edit(parent, key, other):
            parent[key] = copy.deepcopy(value)
            return other
        return edit

    for path, value in list(places(document, [])):
        if path:
            yield f"{path} left out", changed(path, without)
            for other in OTHERS:
                yield f"{path} = {other!r}", changed(path, instead(other))
        if isinstance(value, dict):
            yield f"{path} with one more", changed(path + ["unheard_of"], instead(1))
        if isinstance(value, list) and value:
            yield f"{path} with one more", changed(path + [slice(len(value), None)], instead([value[-1]]))


def looked_at(kind, what, document):
    """Whether the reader of answers looks at what was changed: at nothing of a miss of a cast, nor at what other queries hold."""
    outcome = document.get("outcome")
    fields = {"cast": {"hit": ("time", "normal", "point_a", "point_b", "proof"), "not_converged": ("time", "proof"),
                       "miss": ("proof",),
                       "initially_overlapping": ("normal", "point_a", "point_b", "proof")},
              "distance": {"miss": ("distance", "normal", "point_a", "point_b")},
              "penetration": {"initially_overlapping": ("depth", "normal", "point_a", "point_b"),
                              "hit": ("depth", "normal", "point_a", "point_b")}}
    always = ("schema", "id", "outcome", "message", "unheard_of")
    counted = ("ns", "native", "iterations", "supports")
    changed = re.match(r"\[(?:'(\w+)')?", what).group(1) or "unheard_of"
    if changed in always:
        # Another outcome is another form: it is not the changed field that is refused.
        return True
    if outcome == "unsupported":
        return False
    return changed in counted or changed in fields[kind].get(outcome, ())


def agreement(check, reader):
    refused = unsaid = 0
    for kind, documents in SOUND.items():
        schema = kind if kind in KINDS else "answer"
        tried = []
        for document in documents:
            check.expect_valid(schema, document, f"{kind}: a sound document")
            tried.append(("as it is", document))
            tried += changes(document)
        lines = "".join(json.dumps(document) + "\n" for _, document in tried)
        said = subprocess.run([reader, kind], input=lines, capture_output=True, text=True, check=True).stdout.splitlines()
        check.expect(len(said) == len(tried), f"{kind}: {len(tried)} documents, {len(said)} verdicts")
        for (what, document), verdict in zip(tried, said):
            accepted, valid = verdict == "ok", check.valid(schema, document)
            refused += not accepted
            if accepted == valid:
                continue
            if not accepted and any(re.search(pattern, verdict) for pattern in UNSAID):
                unsaid += 1
                continue
            if accepted and schema == "answer" and not looked_at(kind, what, document):
                continue
            check.faults.append(f"{kind}, {what}: the reader says {verdict[:160]!r}, the schema {valid}")
    check.expect(refused > 1000, f"only {refused} documents were refused")
    return refused, unsaid


def scenes(check, folder, graze):
    files = sorted(folder.glob("*.json"))
    check.expect(len(files) >= 6, f"{folder}: only {len(files)} scenes")
    for file in files:
        check.expect_valid("scene", load(file.read_text()), file.name)
        ran = subprocess.run([graze, "scene", "--json", file], capture_output=True, text=True)
        check.expect(ran.returncode == 0, f"graze scene {file.name}: {ran.stderr}")
        if ran.returncode == 0:
            check.expect_valid("events", load(ran.stdout), f"the events of {file.name}")


def main():
    source, graze, reader = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    check = Check(source / "docs/schemas")
    corpus(check, source / "corpus")
    examples(check, source / "docs/reference/protocol.md", {"engine", "answer"})
    examples(check, source / "docs/reference/case-format.md", {"case"})
    scenes(check, source / "examples" / "scenes", graze)
    examples(check, source / "docs/reference/scenes.md", {"scene"})
    refused, unsaid = agreement(check, reader)
    questions(check, graze, pathlib.Path(__file__).resolve().parent)
    price_list(check, graze)
    for fault in check.faults[:40]:
        print(fault)
    print(f"{check.count} sound documents, {refused} refused by the readers ({unsaid} of them for what no schema says), "
          f"{len(check.faults)} faults")
    return 1 if check.faults else 0


sys.exit(main())
