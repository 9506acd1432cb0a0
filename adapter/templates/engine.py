#!/usr/bin/env python3
"""An engine in Python: casts of balls. graze certify --engine "python3 engine.py"

Put your own cast in the place of `cast`, and your shapes into `SAYS`; docs/engines.md has every field.
"""
import json
import math
import sys

SAYS = {
    "schema": "graze.engine/1", "name": "balls-python", "scalar": "double", "shapes": ["sphere"],
    "queries": {"cast": {"answers": ["time", "normal"], "relative_tolerance": 1e-7}},
}


def cast(a, b, t_max):
    """The outcome of b moving past a, lengths in the question's unit, times in its t."""
    reach = a["shape"]["radius"] + b["shape"]["radius"]
    gap = [y - x for x, y in zip(a["position"], b["position"])]
    motion = [y - x for x, y in zip(a["displacement"], b["displacement"])]
    along = sum(x * v for x, v in zip(gap, motion))
    speed = sum(v * v for v in motion)
    apart = math.hypot(*gap)
    if apart <= reach:
        return {"outcome": "initially_overlapping"}
    # The squared distance of the centres is least at t = -along / speed; aside is what remains of the gap there.
    if along >= 0:
        return {"outcome": "miss"}
    aside = math.hypot(*(x - v * (along / speed) for x, v in zip(gap, motion)))
    if aside > reach:
        return {"outcome": "miss"}
    half_chord = math.sqrt((reach - aside) * (reach + aside) * speed)
    time = (apart - reach) * (apart + reach) / (half_chord - along)
    if time > t_max:
        return {"outcome": "miss"}
    normal = [x + time * v for x, v in zip(gap, motion)]
    length = math.hypot(*normal)
    return {"outcome": "hit", "time": time, "normal": [x / length for x in normal]}


print(json.dumps(SAYS), flush=True)
for line in sys.stdin:
    question = json.loads(line)
    answer = {"schema": "graze.answer/1", "id": question["id"]}
    answer.update(cast(question["a"], question["b"], question["t_max"]))
    print(json.dumps(answer), flush=True)
