#!/usr/bin/env python3
"""Writes the scenes of this folder. `python3 make.py` makes them again, to the same bits."""
import json
import math
import pathlib

HERE = pathlib.Path(__file__).resolve().parent


class Random:
    """Multiples of 2^-10 from a linear congruence, so that every number is short and the same everywhere."""

    def __init__(self, seed):
        self.state = seed

    def between(self, low, high):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return low + round((self.state >> 40) / 2**24 * (high - low) * 1024) / 1024

    def vector(self, size):
        return [self.between(-size, size) for _ in range(3)]

    def quaternion(self):
        q = [self.between(-1, 1) for _ in range(4)]
        return q if any(q) else [1, 0, 0, 0]


def write(name, comment, **fields):
    scene = {"schema": "graze.scene/1", "id": name, "comment": comment, **fields}
    lines = []
    for key, value in scene.items():
        text = json.dumps(value)
        if key in ("shapes", "bodies", "rays", "casts"):
            text = "[\n  " + ",\n  ".join(json.dumps(item) for item in value) + "]"
        lines.append(f"{json.dumps(key)}: {text}")
    (HERE / f"{name}.json").write_text("{" + ",\n ".join(lines) + "}\n")


def pile():
    """Layers of 6 x 6, 5 x 5, ... boxes, each on the corners of four."""
    bodies = [{"name": "floor", "shape": {"type": "box", "half_extents": [20, 20, 1]}, "position": [0, 0, -1]}]
    for layer in range(6):
        side = 6 - layer
        for i in range(side):
            for j in range(side):
                x, y = (2 * i - side + 1) * 0.5, (2 * j - side + 1) * 0.5
                bodies.append({"name": f"box-{layer}-{i}{j}", "shape": "crate", "position": [x, y, layer + 0.5]})
    write("pile", "A pyramid of 91 crates at rest on a floor: each touches its neighbours, and nothing moves.",
          tier="exact", ask="pair", request=[],
          shapes=[{"name": "crate", "shape": {"type": "box", "half_extents": [0.5, 0.5, 0.5]}}], bodies=bodies)


def boxes():
    random = Random(1)
    bodies = [{"name": "floor", "shape": {"type": "box", "half_extents": [30, 30, 1]}, "position": [0, 0, -1]}]
    for k in range(120):
        i, j, layer = k % 6, k // 6 % 5, k // 30
        position = [3 * i - 7.5 + random.between(-0.5, 0.5), 3 * j - 6 + random.between(-0.5, 0.5), 2.5 + 3 * layer]
        bodies.append({"name": f"box-{k:03}", "shape": "box" if k % 3 else "brick", "position": position,
                       "orientation": random.quaternion(),
                       "displacement": [random.between(-1, 1), random.between(-1, 1), -4 - layer],
                       "rotation": random.vector(1.5)})
    write("boxes", "120 boxes fall and tumble onto a floor: what does each of them touch first?", ask="body",
          shapes=[{"name": "box", "shape": {"type": "box", "half_extents": [0.5, 0.5, 0.5]}},
                  {"name": "brick", "shape": {"type": "box", "half_extents": [1, 0.5, 0.25]}}], bodies=bodies)


def bullets():
    random = Random(2)
    bodies = []
    for k in range(6):
        bodies.append({"name": f"paper-{k}", "shape": "sheet", "position": [10 + 4 * k, 0, 0],
                       "orientation": [1, 0, round(0.03 * (k - 2), 3), 0], "group": 1, "mask": 2})
    for row in range(14):
        for column in range(14):
            y, z = (column - 6.5) * 0.5, (row - 6.5) * 0.5
            bodies.append({"name": f"bullet-{row:02}-{column:02}", "shape": "bullet",
                           "position": [random.between(-1, 1), y, z], "orientation": [1, 0, 1, 0],
                           "displacement": [900, random.between(-4, 4), random.between(-4, 4)],
                           "rotation": [3000, 0, 0], "group": 2, "mask": 3})
    rays = [{"name": f"sight-{k}", "origin": [-20, 0.25 * k - 1, 0.5], "displacement": [1, 0.01 * k, 0], "group": 2, "mask": 1,
             "ask": "all"} for k in range(8)]
    write("bullets", "A curtain of 196 spinning bullets, 900 m/s, through six sheets of paper 0.1 mm thin, in a "
          "twentieth of a second; and eight lines of sight through the sheets.", tier="certified", ask="pair", t_max=0.05,
          shapes=[{"name": "sheet", "shape": {"type": "box", "half_extents": [0.00005, 3, 3]}},
                  {"name": "bullet", "shape": {"type": "capsule", "radius": 0.0045, "half_height": 0.008}}],
          bodies=bodies, rays=rays)


def fan():
    random = Random(3)
    bodies = [{"name": "hub", "shape": {"type": "cylinder", "radius": 0.25, "half_height": 0.2},
               "rotation": [0, 0, 12], "group": 1, "mask": 2}]
    for k, q in enumerate(([1, 0, 0, 0], [1, 0, 0, 1], [0, 0, 0, 1], [1, 0, 0, -1])):
        bodies.append({"name": f"blade-{k}", "shape": "blade", "orientation": q, "rotation": [0, 0, 12], "group": 1,
                       "mask": 2})
    bodies.append({"name": "post", "shape": {"type": "box", "half_extents": [0.1, 0.1, 2]}, "position": [0, 0, -2.5],
                   "group": 1, "mask": 2})
    for k in range(60):
        start = [random.between(-6, 6), random.between(-6, 6), 3 + random.between(0, 3)]
        bodies.append({"name": f"rod-{k:02}", "shape": "rod", "position": start, "orientation": random.quaternion(),
                       "displacement": [-start[0] / 2, -start[1] / 2, -5 - random.between(0, 3)],
                       "rotation": random.vector(4), "group": 2, "mask": 3})
    write("fan", "60 tumbling rods are thrown at a fan whose four blades turn by 12 radians in the step: what does each "
          "rod hit first?", ask="body",
          shapes=[{"name": "blade", "shape": {"type": "posed", "position": [1.2, 0, 0], "orientation": [10, 3, 0, 0],
                                              "shape": {"type": "box", "half_extents": [1, 0.3, 0.02]}}},
                  {"name": "rod", "shape": {"type": "capsule", "radius": 0.03, "half_height": 0.4}}],
          bodies=bodies)


def arm():
    random = Random(4)
    bodies = []
    sweep = {"rotation": [0, 0, 1.5], "displacement": [0, 0, 0.25], "group": 2, "mask": 1}
    for name, shape, at in (("column", {"type": "cylinder", "radius": 0.2, "half_height": 0.6}, [0, 0, 0.6]),
                            ("upper-arm", {"type": "capsule", "radius": 0.1, "half_height": 0.5}, [0.55, 0, 1.2]),
                            ("forearm", {"type": "capsule", "radius": 0.08, "half_height": 0.4}, [1.5, 0, 1.2]),
                            ("gripper", {"type": "box", "half_extents": [0.12, 0.1, 0.05]}, [2.05, 0, 1.2]),
                            ("parcel", {"type": "box", "half_extents": [0.15, 0.2, 0.1]}, [2.3, 0, 1.2])):
        body = {"name": name, "shape": shape, "position": at, "pivot": [-at[0], 0, 0], **sweep}
        if shape["type"] == "capsule":  # lies along x: the frame is turned, and the pivot with it
            body["orientation"] = [1, 0, 1, 0]
            body["pivot"] = [0, 0, -at[0]]
        bodies.append(body)
    for k in range(5):
        angle = 0.35 * k + 0.5
        c, s = round(math.cos(angle), 6), round(math.sin(angle), 6)
        q = [round(math.cos(angle / 2), 6), 0, 0, round(math.sin(angle / 2), 6)]
        for level in range(5):
            bodies.append({"name": f"shelf-{k}-board-{level}", "shape": "board", "position": [3 * c, 3 * s, 0.4 * level],
                           "orientation": q, "group": 1, "mask": 2})
            for item in range(3):
                out = 2.6 + random.between(-0.125, 0.125)
                aside = 0.35 * (item - 1)
                bodies.append({"name": f"shelf-{k}-item-{level}{item}", "shape": "item",
                               "position": [round(out * c - aside * s, 6), round(out * s + aside * c, 6),
                                            0.4 * level + 0.125], "orientation": q, "group": 1, "mask": 2})
    write("arm", "A robot's arm turns by 1.5 radians, lifting a parcel past five shelves: where does it come within "
          "5 mm first?", ask="first", target_distance=0.005, tolerance=0.0001, request=["normal", "witnesses", "proof"],
          shapes=[{"name": "board", "shape": {"type": "box", "half_extents": [0.3, 0.5, 0.01]}},
                  {"name": "item", "shape": {"type": "box", "half_extents": [0.08, 0.08, 0.1]}}],
          bodies=bodies)


def crowd():
    random = Random(5)
    bodies = []
    for k in range(400):
        i, j = k % 20, k // 20
        bodies.append({"name": f"person-{k:03}", "shape": "person",
                       "position": [1.5 * i + random.between(-0.25, 0.25), 1.5 * j + random.between(-0.25, 0.25), 0.9],
                       "displacement": [0, 0, 0] if k % 7 == 0 else
                       [random.between(-1.5, 1.5), random.between(-1.5, 1.5), 0],
                       "rotation": [0, 0, 0] if k % 3 else [0, 0, random.between(-2, 2)]})
    for k in range(4):
        bodies.append({"name": f"pillar-{k}", "shape": {"type": "cylinder", "radius": 0.4, "half_height": 2},
                       "position": [4.5 + 6.75 * k, 13.875, 2]})
    rays = [{"name": f"camera-{k:02}", "origin": [-5, -5, 3], "displacement": [1, 0.125 * k, -0.06]} for k in range(12)]
    casts = [{"name": f"drone-{k}", "shape": {"type": "sphere", "radius": 0.3}, "position": [-3, 6 * k + 3, 2],
              "displacement": [40, 0, -1]} for k in range(4)]
    write("crowd", "400 people, capsules that walk and turn about their own axes, among four pillars: who runs into "
          "whom? Twelve lines of sight and four drones among them.", tier="certified", ask="pair",
          shapes=[{"name": "person", "shape": {"type": "capsule", "radius": 0.3, "half_height": 0.6}}],
          bodies=bodies, rays=rays, casts=casts)


def line():
    random = Random(6)
    bodies = []
    for k in range(60):
        bodies.append({"name": f"roller-{k:02}", "shape": "roller", "position": [0.25 * k, 0, -0.1], "orientation": [1, 1, 0, 0],
                       "rotation": [0, 20, 0], "group": 1, "mask": 2})
    for k in range(30):
        bodies.append({"name": f"parcel-{k:02}", "shape": "parcel", "position": [0.5 * k, random.between(-0.25, 0.25), 0.1625],
                       "displacement": [2 + random.between(-0.0625, 0.0625), 0, 0],
                       "rotation": [0, 0, random.between(-0.0009765625, 0.0009765625)], "group": 2, "mask": 3})
    for k in range(24):
        angle = math.tau * k / 24
        x, y = round(2048 * math.cos(angle)) / 1024, round(2048 * math.sin(angle)) / 1024
        # About the table's centre to the bit: only so do bodies turn as one.
        bodies.append({"name": f"tray-{k:02}", "shape": "tray", "position": [18.5 + x, y, 0], "rotation": [0, 0, 0.75],
                       "pivot": [-x, -y, 0], "group": 1, "mask": 3})
    write("line", "A packing line: 30 parcels glide over 60 rollers, hardly turning, each catching up with another, towards a "
          "turntable of 24 trays. Rollers spin unseen, trays turn as one, and a parcel's turn is below the millimetre that is "
          "asked for.", ask="pair", tolerance=0.001,
          shapes=[{"name": "roller", "shape": {"type": "cylinder", "radius": 0.1, "half_height": 0.75}},
                  {"name": "parcel", "shape": {"type": "box", "half_extents": [0.234375, 0.3, 0.15]}},
                  {"name": "tray", "shape": {"type": "cylinder", "radius": 0.25, "half_height": 0.05}}],
          bodies=bodies)


if __name__ == "__main__":
    for one in (pile, boxes, bullets, fan, arm, crowd, line):
        one()
