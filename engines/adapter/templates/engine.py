#!/usr/bin/env python3
"""An engine in Python: casts of balls. graze certify --engine "python3 engine.py"

To change: 1. `cast` calls your engine, 2. `SAYS` names your shapes and what you promise. docs/reference/protocol.md has every field.
"""
import itertools
import json
import math
import sys

# 2. "shapes": ["sphere", "capsule", "box", "hull"]
SAYS = {
    "schema": "graze.engine/1", "name": "balls-python", "scalar": "double", "shapes": ["sphere"],
    "queries": {"cast": {"answers": ["time", "normal"], "relative_tolerance": 1e-7}},
}


def cross(x, y):
    return [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]


def turned(q, x):
    """x turned by the quaternion w, x, y, z."""
    side = [2 * c for c in cross(q[1:], x)]
    return [p + q[0] * s + r for p, s, r in zip(x, side, cross(q[1:], side))]


def form_of(body):
    """A body at t = 0, in world axes: the hull of points, rounded by a radius. Cylinders, cones and ellipsoids are not of
    this form, and come with radius and half_height (their axis is z) or with radii."""
    shape = body["shape"]
    points = {
        "sphere": lambda: [[0, 0, 0]],
        "capsule": lambda: [[0, 0, -shape["half_height"]], [0, 0, shape["half_height"]]],
        "box": lambda: [list(p) for p in itertools.product(*((-h, h) for h in shape["half_extents"]))],
        "hull": lambda: shape["vertices"],
    }.get(shape["type"], lambda: [])()
    placed = [[p + x for p, x in zip(body["position"], turned(body["orientation"], point))] for point in points]
    return placed, shape.get("radius", 0)


def cast(a, b, t_max):
    """The outcome of b moving past a, lengths in the question's unit, times in its t."""
    (points_a, radius_a), (points_b, radius_b) = form_of(a), form_of(b)
    # 1. Your engine, by these, a["displacement"], b["displacement"] and t_max. What follows casts balls.
    if len(points_a) != 1 or len(points_b) != 1:
        return {"outcome": "unsupported"}
    reach = radius_a + radius_b
    gap = [y - x for x, y in zip(points_a[0], points_b[0])]
    motion = [y - x for x, y in zip(a["displacement"], b["displacement"])]
    along = sum(x * v for x, v in zip(gap, motion))
    speed = sum(v * v for v in motion)
    apart = math.hypot(*gap)
    if apart <= reach:
        return {"outcome": "initially_overlapping"}
    # The squared distance of the centres is least at t = -along / speed; rest is what remains of the gap there.
    if along >= 0:
        return {"outcome": "miss"}
    rest = [x - v * (along / speed) for x, v in zip(gap, motion)]
    aside = math.hypot(*rest)
    if aside > reach:
        return {"outcome": "miss"}
    half_chord = math.sqrt((reach - aside) * (reach + aside) * speed)
    time = (apart - reach) * (apart + reach) / (half_chord - along)
    if time > t_max:
        return {"outcome": "miss"}
    # The gap at `time`, of two perpendicular parts: gap + time * motion would cancel where the bodies come from afar.
    touching = [x - v * (half_chord / speed) for x, v in zip(rest, motion)]
    normal = touching if any(touching) else [-v for v in motion]  # points that meet leave no gap
    length = math.hypot(*normal)
    return {"outcome": "hit", "time": time, "normal": [x / length for x in normal]}


print(json.dumps(SAYS), flush=True)
for line in sys.stdin:
    question = json.loads(line)
    answer = {"schema": "graze.answer/1", "id": question["id"]}
    answer.update(cast(question["a"], question["b"], question["t_max"]))
    print(json.dumps(answer), flush=True)
