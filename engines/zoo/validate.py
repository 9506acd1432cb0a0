#!/usr/bin/env python3
"""Tries an adapter on easy questions whose answers are known in closed form, so that no later finding is the adapter's.

    validate.py [--tolerance LENGTH] [--verbose] PROGRAM [ARGUMENT…]

Pairs of shapes approach each other along a known normal with a known gap: the first contact is where the gap is used
up. Each pair is asked in turned, shifted and mirrored scenes, with A, B or both in motion, over paths of several
lengths. Held against the truth, loosely: outcome, time, normal, witnesses, distance, depth. Exit code 0 if all agree,
1 if not, 2 if the program does not speak the protocol.
"""
import argparse
import itertools
import json
import math
import subprocess
import sys

# --- Vectors and unit quaternions (w, x, y, z), as tuples --------------------------------------------------------------


def add(x, y):
    return tuple(a + b for a, b in zip(x, y))


def sub(x, y):
    return tuple(a - b for a, b in zip(x, y))


def scaled(s, x):
    return tuple(s * a for a in x)


def dot(x, y):
    return sum(a * b for a, b in zip(x, y))


def cross(x, y):
    return (x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0])


def length(x):
    return math.sqrt(dot(x, x))


def product(p, q):
    w = p[0] * q[0] - dot(p[1:], q[1:])
    return (w,) + add(add(scaled(p[0], q[1:]), scaled(q[0], p[1:])), cross(p[1:], q[1:]))


def conjugate(q):
    return (q[0], -q[1], -q[2], -q[3])


def rotate(q, x):
    return product(product(q, (0.0,) + tuple(x)), conjugate(q))[1:]


def turn(axis, angle):
    return (math.cos(angle / 2),) + scaled(math.sin(angle / 2) / length(axis), axis)


IDENTITY = (1.0, 0.0, 0.0, 0.0)

# --- Shapes: what the protocol calls them, and their support -----------------------------------------------------------


def box(x, y, z):
    return {"type": "box", "half_extents": [x, y, z]}


def sphere(r):
    return {"type": "sphere", "radius": r}


def round_shape(kind, r, h):
    return {"type": kind, "radius": r, "half_height": h}


def octahedron(r):
    return {"type": "hull", "vertices": [[s * r if i == k else 0.0 for k in range(3)] for i in range(3) for s in (1, -1)]}


def prism(r, h):
    """Upright, on a square that stands on its corner."""
    return {"type": "hull", "vertices": [[x, y, z] for x, y in ((r, 0.0), (0.0, r), (-r, 0.0), (0.0, -r)) for z in (-h, h)]}


def vertices(shape):
    if shape["type"] == "hull":
        return shape["vertices"]
    if shape["type"] == "box":
        return [list(p) for p in itertools.product(*[(-h, h) for h in shape["half_extents"]])]
    return None


def support(shape, d):
    """The farthest point of a shape in direction d, both in its own frame."""
    points = vertices(shape)
    if points:
        return max(points, key=lambda p: dot(p, d))
    r, across = shape.get("radius", 0.0), math.hypot(d[0], d[1])
    if shape["type"] == "sphere":
        return scaled(r / length(d), d)
    if shape["type"] == "ellipsoid":
        radii = shape["radii"]
        norm = math.sqrt(sum((a * b) ** 2 for a, b in zip(radii, d)))
        return tuple(a * a * b / norm for a, b in zip(radii, d))
    h = shape["half_height"]
    side = (d[0] / across, d[1] / across) if across > 0 else (0.0, 0.0)
    if shape["type"] == "capsule":
        return add(scaled(r / length(d), d), (0.0, 0.0, math.copysign(h, d[2])))
    rim = (r * side[0], r * side[1], math.copysign(h, d[2]))
    if shape["type"] == "cylinder":
        return rim
    base = (r * side[0], r * side[1], -h)  # a cone
    return (0.0, 0.0, h) if h * d[2] > dot(base, d) else base


def world_support(body, d):
    return add(body["position"], rotate(body["orientation"], support(body["shape"], rotate(conjugate(body["orientation"]), d))))


def body(shape, position=(0.0, 0.0, 0.0), orientation=IDENTITY):
    return {"shape": shape, "position": tuple(position), "orientation": orientation, "displacement": (0.0, 0.0, 0.0)}


# --- Scenes -----------------------------------------------------------------------------------------------------------

NORMAL_TOLERANCE = 0.25  # radians: a depth that is right to 1e-4 leaves the normal of a ball so free; a flip is 2
AXES = [(1.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, -1.0)]
WALL = box(2.0, 1.5, 1.75)
# A pair is centrally symmetric about its normal, or one of the two is flat and larger there: then the gap along the
# normal is the distance.
PAIRS = [
    (sphere(0.5), sphere(0.75)),
    (WALL, sphere(0.5)),
    (WALL, box(0.5, 0.25, 0.375)),
    (WALL, octahedron(0.5)),
    (octahedron(0.75), octahedron(0.5)),
    (box(0.5, 0.5, 0.5), box(0.25, 0.75, 0.5)),
    (box(0.5, 0.75, 1.0), box(0.25, 0.375, 0.5)),
    (box(0.75, 0.5, 0.625), prism(0.5, 0.25)),
    (round_shape("capsule", 0.25, 0.5), sphere(0.5)),
    (WALL, round_shape("capsule", 0.25, 0.5)),
    (round_shape("capsule", 0.25, 0.5), round_shape("capsule", 0.375, 0.25)),
    (WALL, round_shape("cylinder", 0.5, 0.375)),
    (round_shape("cylinder", 0.5, 0.375), round_shape("cylinder", 0.25, 0.5)),
    (round_shape("cylinder", 0.5, 0.375), sphere(0.5)),
    (WALL, round_shape("cone", 0.5, 0.375)),
    (WALL, {"type": "ellipsoid", "radii": [0.5, 0.25, 0.75]}),
    ({"type": "ellipsoid", "radii": [0.5, 0.25, 0.75]}, sphere(0.5)),
]
SCENE_TURNS = [IDENTITY, turn((0.0, 0.0, 1.0), math.pi / 2), turn((1.0, 2.0, -2.0), 0.7), turn((-2.0, 1.0, 0.5), 2.1)]
PLANE_TURNS = [IDENTITY, turn((0.0, 0.0, 1.0), math.pi / 2), turn((0.0, 0.0, 1.0), -0.7)]
SCENE_SHIFTS = [(0.0, 0.0, 0.0), (1.5, -2.0, 0.75), (-0.5, 0.25, 3.0)]


def as_asked(shape, known):
    """A shape as one that the engine takes, or None."""
    if shape["type"] in known:
        return shape
    return {"type": "hull", "vertices": vertices(shape)} if vertices(shape) and "hull" in known else None


class Scene:
    """A and B with a gap along a unit normal from A to B, in a scene that is turned and shifted."""

    def __init__(self, a, b, axis, gap, k, swapped, planar=False):
        if swapped:
            a, b = b, a
        whole, shift = SCENE_TURNS[k % len(SCENE_TURNS)], SCENE_SHIFTS[k % len(SCENE_SHIFTS)]
        if planar:
            whole = PLANE_TURNS[k % len(PLANE_TURNS)]
        self.gap = gap
        self.normal = rotate(whole, axis)
        self.a = body(a, shift, whole)
        self.b = body(b, (0.0, 0.0, 0.0), whole)
        reach = dot(world_support(self.a, self.normal), self.normal) - dot(world_support(self.b, scaled(-1, self.normal)), self.normal)
        self.b["position"] = add(shift, scaled(reach + gap - dot(shift, self.normal), self.normal))
        self.tangent = rotate(whole, (-axis[1], axis[0], 0.0) if planar else (axis[1], axis[2], axis[0]))

    def moved(self, which, relative):
        """The same with displacements: of B relative to A it is `relative`."""
        common = scaled(0.75, self.tangent) if which == "both" else (0.0, 0.0, 0.0)
        share = {"a": 0.0, "b": 1.0, "both": 0.25}[which]
        self.a["displacement"] = add(common, scaled(share - 1, relative))
        self.b["displacement"] = add(common, scaled(share, relative))
        return self


def scenes(known, gap):
    """Each pair in four scenes that between them see every axis, swapped and not; upright prisms also in the plane."""
    k = 0
    for a, b in PAIRS:
        upright = all(s["type"] == "box" or (s["type"] == "hull" and len(s["vertices"]) == 8) for s in (a, b))
        here = (as_asked(a, known), as_asked(b, known))
        for i in range(4 if upright and here[0] and here[1] else 0):
            k += 1
            yield k, Scene(here[0], here[1], AXES[i], gap, k, k % 3 == 0, True)
    for a, b in PAIRS:
        for _ in range(4):
            axis, swapped = AXES[(k * 5 + k // 6) % 6], (k // 2) % 2 == 1
            here = (as_asked(a, known), as_asked(b, known))
            if here[0] and here[1]:
                yield k, Scene(here[0], here[1], axis, gap, k, swapped)
            k += 1


def question(query, scene, **more):
    return {"query": query, "a": scene.a, "b": scene.b, "t_max": 1.0, "target_distance": 0, "start_policy": "report", **more}


def cast_questions(says, query="cast"):
    known, margin = says["shapes"], says.get("margin", 0)
    for k, scene in scenes(known, 1.0):
        t_max, which = (1.0, 4.0, 0.5)[k % 3], ("a", "b", "both")[(k + k // 3) % 3]
        speed = 1.75 / t_max  # the gap of 1 is used up, and more
        scene.moved(which, scaled(-speed, scene.normal))
        yield question(query, scene, t_max=t_max), {
            "outcome": "hit", "time": (1.0 - margin) / speed, "speed": speed, "normal": scene.normal, "scene": scene}
    for k, scene in scenes(known, 1.0):
        t_max, which = (4.0, 1.0, 0.5)[k % 3], ("both", "a", "b")[k % 3]
        # Too short, away, and past each other.
        path = [scaled(-0.5, scene.normal), scaled(2.0, scene.normal), scaled(7.0, scene.tangent)][k % 3]
        scene.moved(which, scaled(1 / t_max, path))
        yield question(query, scene, t_max=t_max), {"outcome": "miss"}
    if says["queries"][query].get("starts", True):
        for k, scene in scenes(known, -0.125):
            scene.moved(("a", "b", "both")[k % 3], scaled(-0.5, scene.tangent))
            yield question(query, scene), {"outcome": "initially_overlapping"}


def rotating_questions(says):
    """A bar turns about z, from the x axis toward a ball or a bead at angle phi and distance rho."""
    for q, expected in cast_questions(says, "rotating_cast"):
        for side in "ab":
            still = q[side]["shape"]["type"] == "sphere"  # whose turn cannot be seen
            q[side] = {**q[side], "rotation": (0.1, -0.2, 0.3) if still else (0.0, 0.0, 0.0), "pivot": (0.0, 0.0, 0.0)}
        yield q, expected
    known, margin = says["shapes"], says.get("margin", 0)
    bars = [(box(1.5, 0.125, 0.25), IDENTITY, 0.125),
            (round_shape("capsule", 0.125, 1.5), turn((0.0, 1.0, 0.0), math.pi / 2), 0.125)]
    others = [(sphere(0.125), lambda n: 0.125), (octahedron(0.125), lambda n: 0.125 * max(map(abs, n))),
              (prism(0.125, 0.25), lambda n: 0.125 * max(map(abs, n)))]
    phi, rho, k = 0.75, 1.0, 0
    for (bar, lying, thick), (other, reach) in itertools.product(bars, others):
        shape_a, shape_b = as_asked(bar, known), as_asked(other, known)
        if not shape_a or not shape_b:
            continue

        def gap(theta):
            # The bead does not turn with the scene: its reach is looked up in its own frame.
            return rho * math.sin(phi - theta) - thick - reach((-math.sin(theta), math.cos(theta), 0.0)) - margin

        low, high = 0.0, phi
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if gap(middle) > 0 else (low, middle)
        for variant in range(4):
            whole, shift = SCENE_TURNS[variant], SCENE_SHIFTS[variant % 3]
            t_max, angle = (1.0, 2.0, 0.5, 1.0)[variant], 0.7
            common = [(0.0, 0.0, 0.0), (0.3, -0.2, 0.0), (0.3, -0.2, 0.1), (0.0, 0.0, 0.0)][variant]
            a, b = body(shape_a, shift, product(whole, lying)), body(shape_b, (0.0, 0.0, 0.0), whole)
            b["position"] = add(shift, rotate(whole, (rho * math.cos(phi), rho * math.sin(phi), 0.0)))
            axis = rotate(whole, (0.0, 0.0, angle / t_max))
            a = {**a, "displacement": common, "rotation": axis, "pivot": (0.0, 0.0, 0.0)}
            b = {**b, "displacement": common, "rotation": (0.0, 0.0, 0.0), "pivot": (0.0, 0.0, 0.0)}
            normal = rotate(whole, (-math.sin(low), math.cos(low), 0.0))
            if variant % 2 == 1:
                a, b, normal = b, a, scaled(-1, normal)
            yield {"query": "rotating_cast", "a": a, "b": b, "t_max": t_max, "target_distance": 0, "start_policy": "report"}, {
                "outcome": "hit", "time": low * t_max / angle, "speed": rho * angle / t_max, "normal": normal}
            k += 1


def still_questions(says, query):
    known, margin = says["shapes"], says.get("margin", 0)
    for gap in (0.75, -0.125):
        for _, scene in scenes(known, gap):
            pair = [scene.a["shape"], scene.b["shape"]]
            if gap < 0 and all(s["type"] == "hull" and len(s["vertices"]) == 6 for s in pair):
                continue  # two octahedra part soonest along a diagonal
            expected = {"outcome": "miss" if gap > margin else "initially_overlapping", "normal": scene.normal, "scene": scene}
            if gap > margin:
                expected["distance"] = gap - margin
                if query == "penetration":
                    expected = {"outcome": "miss"}
            else:
                expected["depth"] = margin - gap
                if query == "distance":
                    expected = {"outcome": "initially_overlapping"}
            yield question(query, scene), expected


def ray_questions(says):
    known, margin = says["shapes"], says.get("margin", 0)
    bodies = list(dict.fromkeys(json.dumps(shape) for pair in PAIRS for shape in pair))
    k = 0
    for text in bodies:
        shape = as_asked(json.loads(text), known)
        if not shape:
            continue
        for axis in AXES[k % 2:]:
            k += 1
            if shape["type"] == "cone" and axis[2] == 0:
                continue  # beside its base a ray along the axis ends at no vertex of known normal
            scene = Scene(shape, shape, axis, 0.0, k, False)
            surface, t_max = world_support(scene.a, scene.normal), (1.0, 3.0, 0.25)[k % 3]
            through = add(scene.a["position"], scaled(dot(sub(surface, scene.a["position"]), scene.normal), scene.normal))
            start = add(through, scaled(1.0 + margin, scene.normal))
            q = {"query": "ray", "a": scene.a, "origin": start, "direction": scaled(-1.6 / t_max, scene.normal), "t_max": t_max}
            yield q, {"outcome": "hit", "time": t_max / 1.6, "speed": 1.6 / t_max,
                      "normal": scene.normal if shape["type"] in ("box", "sphere", "ellipsoid", "cylinder") else None}
            yield {**q, "direction": scaled(-0.5 / t_max, scene.normal)}, {"outcome": "miss"}
            yield {**q, "direction": scaled(1.6 / t_max, scene.normal)}, {"outcome": "miss"}
            yield {**q, "origin": add(start, scaled(5.0, scene.tangent))}, {"outcome": "miss"}
            if says["queries"]["ray"].get("starts", True):
                yield {**q, "origin": scene.a["position"]}, {"outcome": "initially_overlapping"}


# --- Judging ----------------------------------------------------------------------------------------------------------


def number(value):
    if isinstance(value, dict):
        return (number(value["lower"]) + number(value["upper"])) / 2
    return float(value) if value is not None else math.nan


def complaints(query, expected, answer, says, tolerance):
    row, margin = says["queries"][query], says.get("margin", 0)
    if answer["outcome"] != expected["outcome"]:
        yield f"says {answer['outcome']}, not {expected['outcome']}"
        return
    holds, early = row["answers"], row.get("early", 0)
    if "time" in holds and "time" in expected:
        late = (number(answer.get("time")) - expected["time"]) * expected["speed"]
        if not -early - tolerance <= late <= tolerance:
            yield f"time {answer.get('time')}, not {expected['time']}: by a length of {late:.3g}"
    if "normal" in holds and expected.get("normal"):
        given = answer.get("normal")
        if not given or not length(sub(tuple(map(number, given)), expected["normal"])) <= NORMAL_TOLERANCE:
            yield f"normal {given}, not {list(expected['normal'])}"
    for value in ("distance", "depth"):
        if value in holds and value in expected and not abs(number(answer.get(value)) - expected[value]) <= tolerance:
            yield f"{value} {answer.get(value)}, not {expected[value]}"
    if "witnesses" in holds and "scene" in expected:
        scene, time = expected["scene"], expected.get("time", 0)
        for side, way in (("a", 1), ("b", -1)):
            point = answer.get("point_" + side)
            if not point or len(point) != 3:
                yield f"no point_{side}"
                continue
            body_, out = getattr(scene, side), scaled(way, scene.normal)
            here = sub(tuple(map(number, point)), scaled(time, body_["displacement"]))
            off = dot(sub(here, world_support(body_, out)), out)
            if not abs(off) <= tolerance + margin:
                yield f"point_{side} {point} is off its body's face by {off:.3g}"
            for way_ in (scene.tangent, scaled(-1, scene.tangent)):
                beyond = dot(sub(here, world_support(body_, way_)), way_)
                if not beyond <= tolerance + margin:
                    yield f"point_{side} {point} is beside its body by {beyond:.3g}"


def ask(program, says_only, questions):
    lines = "".join(json.dumps(q) + "\n" for q in questions)
    run = subprocess.run(program, input=lines, capture_output=True, text=True, timeout=300)
    answers = run.stdout.splitlines()
    if run.returncode != 0 or len(answers) != (1 if says_only else len(questions) + 1):
        print(f"{' '.join(program)}: exit code {run.returncode}, {len(answers) - 1} answers to {len(questions)} questions")
        print(run.stderr[-2000:])
        if says_only or not answers:
            sys.exit(2)
    return [json.loads(line) for line in answers]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--tolerance", type=float, default=1e-2)
    options.add_argument("--verbose", action="store_true", help="every complaint, with its question and answer")
    options.add_argument("program", nargs=argparse.REMAINDER)
    arguments = options.parse_args()
    says = ask(arguments.program, True, [])[0]
    if says.get("schema") != "graze.engine/1":
        print(f"not graze.engine/1: {says}")
        return 2
    asked = []
    for query in says["queries"]:
        if query == "cast":
            asked += cast_questions(says)
        elif query == "rotating_cast":
            asked += rotating_questions(says)
        elif query == "ray":
            asked += ray_questions(says)
        else:
            asked += still_questions(says, query)
    for i, (q, _) in enumerate(asked):
        q.update(schema="graze.question/1", id=f"{q['query']}-{i}")
    answers = ask(arguments.program, False, [q for q, _ in asked])[1:]
    wrong = [0, 0]
    for (q, expected), answer in zip(asked, answers):
        if answer.get("schema") != "graze.answer/1" or answer.get("id") != q["id"]:
            print(f"{q['id']}: not its answer: {answer}")
            return 2
        if answer["outcome"] == "unsupported":
            wrong[1] += 1
            continue
        found = list(complaints(q["query"], expected, answer, says, arguments.tolerance))
        wrong[0] += bool(found)
        if found and (arguments.verbose or wrong[0] <= 10):
            pair = "/".join(q[side]["shape"]["type"] for side in "ab" if side in q)
            print(f"  {q['id']} ({pair}): " + "; ".join(found))
            if arguments.verbose:
                print("    " + json.dumps(q) + "\n    " + json.dumps(answer))
    missing = len(asked) - len(answers)
    print(f"{says['name']}: {len(asked)} asked, {wrong[0]} wrong, {wrong[1]} unsupported" + (f", {missing} lost" if missing else ""))
    return 1 if wrong[0] or missing else 0


if __name__ == "__main__":
    sys.exit(main())
