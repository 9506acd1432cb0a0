"""recording_engine.py FILE: an engine that takes every shape and query, appends each question to FILE, and answers none."""
import json
import sys

SHAPES = ["point", "segment", "triangle", "sphere", "capsule", "box", "ellipsoid", "cylinder", "cone", "hull", "posed",
          "rounded", "sum", "hull_of"]
CAST = {"answers": ["time"], "target_distance": True, "pass_over": True}


def say(document):
    print(json.dumps(document), flush=True)


def main():
    say({"schema": "graze.engine/1", "name": "recorder", "scalar": "double", "shapes": SHAPES, "infinite_t_max": True,
         "queries": {"cast": CAST, "rotating_cast": CAST, "ray": {"answers": ["time"]}, "overlap": {"answers": []},
                     "distance": {"answers": ["distance"]}, "penetration": {"answers": ["depth"]}}})
    with open(sys.argv[1], "a", encoding="utf-8") as record:
        for line in sys.stdin:
            record.write(line)
            record.flush()
            say({"schema": "graze.answer/1", "id": json.loads(line)["id"], "outcome": "unsupported"})


main()
