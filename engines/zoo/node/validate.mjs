// Validates an adapter: asks an engine, by the protocol, easy questions whose answers are known in closed form.
//
//   node engines/zoo/node/validate.mjs [--show N] -- COMMAND...
//   node engines/zoo/node/validate.mjs [--show N] --zoo engines/zoo/node/zoo.json
//
// What a case holds is far from every limit: sizes near 1, gaps and depths of 0.1 and more. Each is asked in several
// frames (shifted, turned, mirrored), with its bodies swapped, and with A, B or both of them moving, so that a
// convention that is mistaken in an adapter shows as a wrong answer here, and not as a finding about an engine. What
// is wrong by more than kLength is reported; exit code 1 says that something was.

import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import { add, dot, negated, norm, product, rotated, scaled, subtract, to_world, unrotated } from "./geometry.mjs";

// Of lengths and of the components of unit vectors.
const kLength = 1e-2;
const kFirstLineMs = 10000;
const kAnswerMs = 5000;

// ---- The cases -----------------------------------------------------------------------------------------------------

const still = (shape, position = [0, 0, 0], orientation = [1, 0, 0, 0]) => ({
  shape, position, orientation, displacement: [0, 0, 0],
});
const moved = (body, displacement) => ({ ...body, displacement });

const sphere = (radius) => ({ type: "sphere", radius });
const capsule = (radius, half_height) => ({ type: "capsule", radius, half_height });
const box = (...half_extents) => ({ type: "box", half_extents });
const cylinder = (radius, half_height) => ({ type: "cylinder", radius, half_height });
const cone = (radius, half_height) => ({ type: "cone", radius, half_height });
const ellipsoid = (...radii) => ({ type: "ellipsoid", radii });
const hull = (...vertices) => ({ type: "hull", vertices });
const rounded = (shape, radius) => ({ type: "rounded", shape, radius });

// Corners of a box, some of them twice, with points in its faces, its edges and its inside.
function crowded_box(x, y, z) {
  const corners = [-x, x].flatMap((a) => [-y, y].flatMap((b) => [-z, z].map((c) => [a, b, c])));
  return hull(...corners, corners[0], corners[7], [x, 0, 0], [0, y, 0], [0, 0, z], [x, y, 0], [0, 0, 0]);
}

const kTetrahedron = hull([1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]);
const kEighth = Math.SQRT1_2;
const about_x = (turn) => [Math.cos(turn / 2), Math.sin(turn / 2), 0, 0];
const about_y = (turn) => [Math.cos(turn / 2), 0, Math.sin(turn / 2), 0];
const kUprightToX = about_y(Math.PI / 2);

// A cast: A stands still, B moves by `displacement` a unit of t. `expect.point` is the contact, where it is one point.
function cast(name, a, b, displacement, t_max, expect, target_distance = 0) {
  return { name, query: "cast", a, b: moved(b, displacement), t_max, target_distance, start_policy: "report", expect };
}

const hit = (time, normal, point) => ({ outcome: "hit", time, normal, point });
const kMiss = { outcome: "miss" };
const inside = (normal) => ({ outcome: "initially_overlapping", normal });

// Spheres whose centres are `apart` at first contact, on a path that passes `aside` beside the centre of A.
function sphere_cast() {
  const along = Math.sqrt(1.5 * 1.5 - 0.9 * 0.9);
  const normal = [0.9 / 1.5, 0, along / 1.5];
  return cast("sphere on sphere, off its centre", still(sphere(1)), still(sphere(0.5), [0.9, 0, 4]), [0, 0, -5], 1,
              hit((4 - along) / 5, normal, normal));
}

const kCasts = [
  cast("sphere on sphere", still(sphere(1)), still(sphere(0.5), [0, 0, 4]), [0, 0, -5], 1, hit(0.5, [0, 0, 1], [0, 0, 1])),
  cast("slowly, t_max 8", still(sphere(1)), still(sphere(0.5), [0, 0, 4]), [0, 0, -0.5], 8, hit(5, [0, 0, 1], [0, 0, 1])),
  cast("fast, t_max 1/8", still(sphere(1)), still(sphere(0.5), [0, 0, 4]), [0, 0, -40], 0.125, hit(1 / 16, [0, 0, 1], [0, 0, 1])),
  cast("ends before", still(sphere(1)), still(sphere(0.5), [0, 0, 4]), [0, 0, -5], 0.4, kMiss),
  cast("leaves", still(sphere(1)), still(sphere(0.5), [0, 0, 4]), [0, 0, 5], 1, kMiss),
  cast("stands still", still(sphere(1)), still(sphere(0.5), [0, 0, 4]), [0, 0, 0], 1, kMiss),
  cast("passes by", still(sphere(1)), still(sphere(0.5), [2, 0, 4]), [0, 0, -8], 1, kMiss),
  cast("starts inside", still(sphere(1)), still(sphere(0.5), [0, 0, 1.2]), [0, 0, -1], 1, inside([0, 0, 1])),
  cast("starts inside, leaves", still(sphere(1)), still(sphere(0.5), [0, 0, 1.2]), [0, 0, 4], 1, inside([0, 0, 1])),
  sphere_cast(),
  cast("sphere on the face of a box", still(box(1, 2, 3)), still(sphere(0.5), [0.5, 1, 6]), [0, 0, -5], 1,
       hit(0.5, [0, 0, 1], [0.5, 1, 3])),
  cast("sphere on the edge of a box", still(box(1, 2, 3)), still(sphere(0.5), [4, 1, 6]), [-4, 0, -4], 1,
       hit((3 - 0.5 * kEighth) / 4, [kEighth, 0, kEighth], [1, 1, 3])),
  cast("sphere on the corner of a box", still(box(1, 2, 3)), still(sphere(0.5), [3, 4, 5]), [-3, -3, -3], 1,
       hit((2 - 0.5 / Math.sqrt(3)) / 3, [1 / Math.sqrt(3), 1 / Math.sqrt(3), 1 / Math.sqrt(3)], [1, 2, 3])),
  cast("sphere past the side of a box", still(box(1, 2, 3)), still(sphere(0.5), [1.8, 0, 6]), [0, 0, -12], 1, kMiss),
  cast("box on box", still(box(1, 2, 3)), still(box(0.5, 0.25, 0.75), [0.5, 0.5, 6]), [0, 0, -5], 1, hit(0.45, [0, 0, 1])),
  cast("edge of a box on a box", still(box(1, 2, 3)), still(box(0.5, 0.25, 0.5), [0.25, 0, 6], about_y(Math.PI / 4)),
       [0, 0, -5], 1, hit((3 - kEighth) / 5, [0, 0, 1])),
  cast("box in a box", still(box(1, 2, 3)), still(box(0.5, 0.5, 0.5), [1.2, 0, 0]), [0, 0, -5], 1, inside([1, 0, 0])),
  cast("end of a capsule", still(capsule(0.5, 2)), still(sphere(0.5), [0, 0, 6]), [0, 0, -5], 1,
       hit(0.6, [0, 0, 1], [0, 0, 2.5])),
  cast("side of a capsule", still(capsule(0.5, 2)), still(sphere(0.5), [6, 0, 1]), [-8, 0, 0], 1,
       hit(5 / 8, [1, 0, 0], [0.5, 0, 1])),
  cast("past a capsule", still(capsule(0.5, 2)), still(sphere(0.5), [6, 1.4, 1]), [-12, 0, 0], 1, kMiss),
  cast("capsule across a capsule", still(capsule(0.5, 2)), still(capsule(0.25, 2), [6, 0, 1], about_x(Math.PI / 2)),
       [-8, 0, 0], 1, hit(5.25 / 8, [1, 0, 0], [0.5, 0, 1])),
  cast("capsule on a box", still(box(1, 2, 3)), still(capsule(0.5, 1), [0, 0, 7]), [0, 0, -5], 1, hit(0.5, [0, 0, 1], [0, 0, 3])),
  cast("capsule along x, end on a box", still(box(1, 2, 3)), still(capsule(0.5, 1), [6, 0, 0], kUprightToX), [-5, 0, 0], 1,
       hit(0.7, [1, 0, 0], [1, 0, 0])),
  cast("top of a cylinder", still(cylinder(0.5, 2)), still(sphere(0.5), [0.25, 0, 6]), [0, 0, -5], 1,
       hit(0.7, [0, 0, 1], [0.25, 0, 2])),
  cast("side of a cylinder", still(cylinder(0.5, 2)), still(sphere(0.5), [6, 0, 1]), [-8, 0, 0], 1,
       hit(5 / 8, [1, 0, 0], [0.5, 0, 1])),
  cast("cylinder on a box", still(box(1, 2, 3)), still(cylinder(0.5, 1), [0, 0, 7]), [0, 0, -5], 1, hit(0.6, [0, 0, 1])),
  cast("apex of a cone", still(cone(1, 1)), still(sphere(0.5), [0, 0, 4]), [0, 0, -4], 1, hit(0.625, [0, 0, 1], [0, 0, 1])),
  cast("base of a cone", still(cone(1, 1)), still(sphere(0.5), [0.5, 0, -4]), [0, 0, 4], 1,
       hit(0.625, [0, 0, -1], [0.5, 0, -1])),
  cast("above the slope of a cone", still(cone(1, 1)), still(sphere(0.25), [6, 0, 0.75]), [-5, 0, 0], 1, kMiss),
  cast("end of an ellipsoid", still(ellipsoid(1, 2, 3)), still(sphere(0.5), [0, 6, 0]), [0, -5, 0], 1,
       hit(0.7, [0, 1, 0], [0, 2, 0])),
  cast("vertex of a tetrahedron", still(kTetrahedron), still(sphere(0.5), [3, 3, 3]), [-3, -3, -3], 1,
       hit((2 - 0.5 / Math.sqrt(3)) / 3, [1 / Math.sqrt(3), 1 / Math.sqrt(3), 1 / Math.sqrt(3)], [1, 1, 1])),
  cast("face of a tetrahedron", still(kTetrahedron), still(sphere(0.5), [-3, -3, -3]), [3, 3, 3], 1,
       hit((3 - (0.5 + 1 / Math.sqrt(3)) / Math.sqrt(3)) / 3, [-1, -1, -1].map((x) => x / Math.sqrt(3)), [-1 / 3, -1 / 3, -1 / 3])),
  cast("hull with points to spare", still(crowded_box(1, 2, 3)), still(sphere(0.5), [0.5, 1, 6]), [0, 0, -5], 1,
       hit(0.5, [0, 0, 1], [0.5, 1, 3])),
  cast("hull on hull", still(crowded_box(1, 2, 3)), still(kTetrahedron, [0, 1, 8]), [0, 0, -5], 1, hit(0.8, [0, 0, 1])),
  cast("hull on a box", still(kTetrahedron), still(box(0.5, 0.5, 0.5), [3, 1, 1]), [-3, 0, 0], 1, hit(0.5, [1, 0, 0])),
  cast("rounded box", still(rounded(box(1, 2, 3), 0.5)), still(sphere(0.5), [0.5, 1, 6]), [0, 0, -5], 1,
       hit(0.4, [0, 0, 1], [0.5, 1, 3.5])),
  cast("triangle", still({ type: "triangle", a: [-2, -2, 0], b: [2, -2, 0], c: [0, 3, 0] }), still(sphere(0.5), [0, 0, 4]),
       [0, 0, -5], 1, hit(0.7, [0, 0, 1], [0, 0, 0])),
  cast("segment", still({ type: "segment", a: [-2, 0, 0], b: [2, 0, 0] }), still(sphere(0.5), [1, 0, 4]), [0, 0, -5], 1,
       hit(0.7, [0, 0, 1], [1, 0, 0])),
  cast("to a distance", still(sphere(1)), still(sphere(0.5), [0, 0, 4]), [0, 0, -5], 1, hit(0.4, [0, 0, 1]), 0.5),
];

// Of bodies at rest: `gap` above 0 is a distance, below 0 a depth.
const rest = (name, a, b, gap, normal, points) => ({ name, a, b, gap, normal, points });

const kRests = [
  rest("spheres apart", still(sphere(1)), still(sphere(0.5), [0, 0, 4]), 2.5, [0, 0, 1], [[0, 0, 1], [0, 0, 3.5]]),
  rest("spheres, one in the other", still(sphere(1)), still(sphere(0.5), [0, 0, 1.2]), -0.3, [0, 0, 1], [[0, 0, 1], [0, 0, 0.7]]),
  rest("sphere over a face", still(box(1, 2, 3)), still(sphere(0.5), [0.5, 1, 6]), 2.5, [0, 0, 1], [[0.5, 1, 3], [0.5, 1, 5.5]]),
  rest("sphere in a face", still(box(1, 2, 3)), still(sphere(0.5), [0.5, 1, 3.2]), -0.3, [0, 0, 1], [[0.5, 1, 3], [0.5, 1, 2.7]]),
  rest("sphere over a corner", still(box(1, 2, 3)), still(sphere(0.5), [2, 4, 5]), 2.5, [1 / 3, 2 / 3, 2 / 3], [[1, 2, 3]]),
  rest("boxes apart", still(box(1, 2, 3)), still(box(0.5, 0.5, 0.5), [3, 0, 0]), 1.5, [1, 0, 0]),
  rest("boxes, one in the other", still(box(1, 2, 3)), still(box(0.5, 0.5, 0.5), [1.2, 0, 0]), -0.3, [1, 0, 0]),
  rest("edges of boxes", still(box(1, 2, 3)), still(box(0.5, 0.25, 0.5), [3, 0, 0], about_y(Math.PI / 4)), 2 - kEighth, [1, 0, 0]),
  rest("capsules across", still(capsule(0.5, 2)), still(capsule(0.25, 2), [3, 0, 1], about_x(Math.PI / 2)), 2.25, [1, 0, 0],
       [[0.5, 0, 1], [2.75, 0, 1]]),
  rest("capsule in a box", still(box(1, 2, 3)), still(capsule(0.5, 1), [0, 0, 4.2]), -0.3, [0, 0, 1], [[0, 0, 3], [0, 0, 2.7]]),
  rest("over a cone", still(cone(1, 1)), still(sphere(0.5), [0, 0, 4]), 2.5, [0, 0, 1], [[0, 0, 1], [0, 0, 3.5]]),
  rest("beside a cylinder", still(cylinder(0.5, 2)), still(sphere(0.5), [3, 0, 1]), 2, [1, 0, 0], [[0.5, 0, 1], [2.5, 0, 1]]),
  rest("in a cylinder", still(cylinder(0.5, 2)), still(sphere(0.5), [0.8, 0, 1]), -0.2, [1, 0, 0], [[0.5, 0, 1], [0.3, 0, 1]]),
  rest("over a hull", still(crowded_box(1, 2, 3)), still(sphere(0.5), [0.5, 1, 6]), 2.5, [0, 0, 1], [[0.5, 1, 3], [0.5, 1, 5.5]]),
  rest("in a hull", still(crowded_box(1, 2, 3)), still(kTetrahedron, [0, 1, 3.7]), -0.3, [0, 0, 1]),
  rest("beside an ellipsoid", still(ellipsoid(1, 2, 3)), still(sphere(0.5), [0, 6, 0]), 3.5, [0, 1, 0], [[0, 2, 0], [0, 5.5, 0]]),
];

const ray = (name, a, origin, direction, t_max, expect) => ({ name, query: "ray", a, origin, direction, t_max, expect });

const kRays = [
  ray("at a sphere", still(sphere(1)), [0.6, 0, 4], [0, 0, -5], 1, hit(0.64, [0.6, 0, 0.8])),
  ray("at a sphere, slowly", still(sphere(1)), [0.6, 0, 4], [0, 0, -0.5], 8, hit(6.4, [0.6, 0, 0.8])),
  ray("ends before a sphere", still(sphere(1)), [0.6, 0, 4], [0, 0, -5], 0.6, kMiss),
  ray("past a sphere", still(sphere(1)), [1.2, 0, 4], [0, 0, -8], 1, kMiss),
  ray("at a box", still(box(1, 2, 3)), [0.5, 1, 6], [0, 0, -5], 1, hit(0.6, [0, 0, 1])),
  ray("in a box", still(box(1, 2, 3)), [0.5, 1, 1], [0, 0, -5], 1, { outcome: "initially_overlapping" }),
  ray("at the side of a capsule", still(capsule(0.5, 2)), [6, 0, 1], [-8, 0, 0], 1, hit(5.5 / 8, [1, 0, 0])),
  ray("at a cylinder", still(cylinder(0.5, 2)), [0.25, 0, 6], [0, 0, -5], 1, hit(0.8, [0, 0, 1])),
  ray("at the base of a cone", still(cone(1, 1)), [0.5, 0, -4], [0, 0, 4], 1, hit(0.75, [0, 0, -1])),
  ray("over the slope of a cone", still(cone(1, 1)), [6, 0, 0.75], [-5, 0, 0], 1, kMiss),
  ray("at a hull", still(crowded_box(1, 2, 3)), [0.5, 1, 6], [0, 0, -5], 1, hit(0.6, [0, 0, 1])),
];

function questions_at_rest({ name, a, b, gap, normal, points = [] }) {
  const apart = gap > 0;
  const fields = { normal, points: points.length === 2 ? points : undefined };
  return [
    { name, query: "overlap", a, b, expect: { outcome: apart ? "miss" : "initially_overlapping" } },
    { name, query: "distance", a, b,
      expect: apart ? { outcome: "miss", distance: gap, ...fields } : { outcome: "initially_overlapping", distance: 0 } },
    { name, query: "penetration", a, b, expect: apart ? kMiss : { outcome: "initially_overlapping", depth: -gap, ...fields } },
  ];
}

const kCases = [...kCasts, ...kRests.flatMap(questions_at_rest), ...kRays];

// ---- The frames ----------------------------------------------------------------------------------------------------

const float = (x) => (typeof x === "number" ? Math.fround(x) : Array.isArray(x) ? x.map(float) : x);

// Applies `point` to what lies somewhere, `vector` to what has a direction, `turn` to orientations, `shape` to shapes.
function in_frame(kase, { name, point, vector, turn, shape = (x) => x }) {
  const body = (b) => ({
    shape: shape(b.shape), position: point(b.position), orientation: turn(b.orientation), displacement: vector(b.displacement),
  });
  const expect = { ...kase.expect };
  if (expect.normal) expect.normal = vector(expect.normal);
  if (expect.point) expect.point = point(expect.point);
  if (expect.points) expect.points = expect.points.map(point);
  const made = { ...kase, name: `${kase.name}; ${name}`, a: body(kase.a), expect };
  if (kase.b) made.b = body(kase.b);
  if (kase.origin) Object.assign(made, { origin: point(kase.origin), direction: vector(kase.direction) });
  return made;
}

const mirror = ([x, y, z]) => [-x, y, z];

function mirrored_shape(shape) {
  const made = { ...shape };
  for (const corner of ["a", "b", "c"]) if (made[corner]) made[corner] = mirror(made[corner]);
  if (made.vertices) made.vertices = made.vertices.map(mirror);
  if (made.shape) made.shape = mirrored_shape(made.shape);
  return made;
}

function turned(name, q, offset) {
  return { name, point: (x) => add(rotated(q, x), offset), vector: (x) => rotated(q, x), turn: (p) => product(q, p) };
}

const kFrames = [
  { name: "as it is", point: (x) => x, vector: (x) => x, turn: (q) => q },
  { name: "shifted", point: (x) => add(x, [3, -2, 5]), vector: (x) => x, turn: (q) => q },
  turned("axes permuted", [0.5, 0.5, 0.5, 0.5], [0, 0, 0]),
  turned("turned", [0.8, 0.36, 0.48, 0], [-1, 2, 0.5]),
  turned("upside down", [0, 0, 1, 0], [0, 0, 0]),
  { name: "mirrored", point: mirror, vector: mirror, turn: ([w, x, y, z]) => [w, x, -y, -z], shape: mirrored_shape },
];

function with_motion(kase) {
  if (kase.query !== "cast") return [kase];
  const common = [0.75, -0.5, 0.25];
  const v = kase.b.displacement;
  const shifted_with_a = (x, t, drift) => (x ? add(x, scaled(t, drift)) : x);
  const moving = (name, drift) => ({
    ...kase,
    name: `${kase.name}; ${name}`,
    a: moved(kase.a, drift),
    b: moved(kase.b, add(v, drift)),
    expect: { ...kase.expect, point: shifted_with_a(kase.expect.point, kase.expect.time ?? 0, drift) },
  });
  return [kase, moving("A moves", negated(v)), moving("both move", common)];
}

function swapped(kase) {
  if (!kase.b) return [kase];
  const { normal, points } = kase.expect;
  const expect = { ...kase.expect, normal: normal && negated(normal), points: points && [points[1], points[0]] };
  return [kase, { ...kase, name: `${kase.name}; swapped`, a: kase.b, b: kase.a, expect }];
}

const rounded_to_float = (x) =>
  Array.isArray(x) ? x.map(rounded_to_float)
    : typeof x === "object" && x !== null ? Object.fromEntries(Object.entries(x).map(([k, v]) => [k, rounded_to_float(v)]))
      : float(x);

function all_questions() {
  const list = [];
  for (const kase of kCases) {
    for (const frame of kFrames) {
      for (const moving of with_motion(in_frame(kase, frame))) list.push(...swapped(moving));
    }
  }
  return list.map(({ name, expect, ...question }, k) => ({
    name, expect, question: { schema: "graze.question/1", id: `v${k}`, ...rounded_to_float(question) },
  }));
}

// ---- What can be asked, and what is wrong --------------------------------------------------------------------------

const kAsHull = new Set(["point", "segment", "triangle", "box"]);

function vertices_of(shape) {
  if (shape.type === "segment") return [shape.a, shape.b];
  if (shape.type === "triangle") return [shape.a, shape.b, shape.c];
  const [x, y, z] = shape.half_extents;
  return [-x, x].flatMap((a) => [-y, y].flatMap((b) => [-z, z].map((c) => [a, b, c])));
}

// The body as the engine can take it, or null.
function taken(body, shapes) {
  if (body.shape.type === "rounded" && shapes.includes("rounded")) return body;
  if (shapes.includes(body.shape.type)) return body;
  if (!kAsHull.has(body.shape.type) || !shapes.includes("hull")) return null;
  return { ...body, shape: { type: "hull", vertices: vertices_of(body.shape) } };
}

// The question in the engine's own terms, or null if the engine does not support it.
function in_its_terms(question, expect, engine) {
  const query = engine.queries[question.query];
  if (!query) return null;
  if (question.target_distance > 0 && !query.target_distance) return null;
  if (query.starts === false && expect.outcome === "initially_overlapping") return null;
  const asked = { ...question, a: taken(question.a, engine.shapes) };
  if (question.b) asked.b = taken(question.b, engine.shapes);
  if (asked.a === null || asked.b === null) return null;
  if (engine.motion === "relative" && question.query === "cast") {
    const v = subtract(question.b.displacement, question.a.displacement);
    asked.a = moved(asked.a, [0, 0, 0]);
    asked.b = moved(asked.b, v.map(float));
  }
  return asked;
}

const numbers = (x) => (Array.isArray(x) ? x.every(Number.isFinite) : Number.isFinite(x));
const middle = (x) => (typeof x === "object" && x !== null ? (x.lower + x.upper) / 2 : x);

// The distance of a world point from a body at time t, for the shapes that have it in a closed form; else 0.
function outside(body, point, t) {
  const p = unrotated(body.orientation, subtract(point, add(body.position, scaled(t, body.displacement))));
  const { shape } = body;
  if (shape.type === "sphere") return Math.max(0, norm(p) - shape.radius);
  if (shape.type === "box") return norm(p.map((x, k) => Math.max(0, Math.abs(x) - shape.half_extents[k])));
  if (shape.type === "capsule") {
    const z = Math.max(-shape.half_height, Math.min(shape.half_height, p[2]));
    return Math.max(0, norm([p[0], p[1], p[2] - z]) - shape.radius);
  }
  return 0;
}

function complaints(question, expect, answer, engine) {
  const { answers, early = 0 } = engine.queries[question.query];
  const limit = kLength + (engine.margin ?? 0) + early;
  const found = [];
  const near = (what, got, want, allowed) => {
    if (got === undefined) found.push(`${what}: none`);
    else if (!numbers(got)) found.push(`${what}: ${JSON.stringify(got)}`);
    else {
      const error = Array.isArray(got) ? norm(subtract(got, want)) : Math.abs(got - want);
      if (!(error <= allowed)) found.push(`${what}: ${JSON.stringify(got)}, not ${JSON.stringify(want)}`);
    }
  };
  if (answer.outcome !== expect.outcome) return [`outcome: ${answer.outcome}, not ${expect.outcome}`];

  const speed = question.b ? norm(subtract(question.b.displacement, question.a.displacement))
    : question.direction ? norm(question.direction) : 0;
  const has = (field) => answers.includes(field);
  if (has("time") && expect.time !== undefined) near("time", middle(answer.time), expect.time, limit / speed);
  if (has("normal") && expect.normal && !(expect.outcome === "miss" && question.query !== "distance")) {
    near("normal", answer.normal, expect.normal, kLength);
  }
  if (has("distance") && expect.distance !== undefined) near("distance", middle(answer.distance), expect.distance, limit);
  if (has("depth") && expect.depth !== undefined) near("depth", middle(answer.depth), expect.depth, limit);
  if (has("witnesses") && (expect.outcome === "hit" || expect.points)) {
    const t = expect.time ?? 0;
    const points = [answer.point_a, answer.point_b];
    const wanted = expect.points ?? (expect.point ? [expect.point, expect.point] : []);
    const bodies = [question.a, question.b];
    points.forEach((point, k) => {
      const what = k === 0 ? "point_a" : "point_b";
      if (wanted[k]) near(what, point, wanted[k], 3 * limit);
      else if (!point || !numbers(point)) found.push(`${what}: ${JSON.stringify(point)}`);
      else if (outside(bodies[k], point, t) > limit) found.push(`${what}: ${JSON.stringify(point)} lies outside of its body`);
    });
    if (found.length === 0 && expect.outcome === "hit") {
      near("gap of the witnesses", norm(subtract(points[0], points[1])), question.target_distance ?? 0, 2 * limit);
    }
  }
  return found;
}

// ---- The engine's process ------------------------------------------------------------------------------------------

class Engine {
  constructor(command) {
    this.command = command;
  }

  async start() {
    this.process = spawn(this.command[0], this.command.slice(1), { stdio: ["pipe", "pipe", "pipe"] });
    this.errors = "";
    this.process.stderr.on("data", (data) => { this.errors = (this.errors + data).slice(-2000); });
    this.process.stdin.on("error", () => {});
    this.lines = createInterface({ input: this.process.stdout })[Symbol.asyncIterator]();
    this.ended = new Promise((resolve) => this.process.on("close", (code, signal) => resolve(signal ?? code)));
    const first = await this.line(kFirstLineMs);
    if (first === null) throw new Error(`the engine says nothing: ${this.errors}`);
    return JSON.parse(first);
  }

  async line(limit_ms) {
    let timer;
    const late = new Promise((resolve) => { timer = setTimeout(() => resolve({ done: true }), limit_ms); });
    const { value, done } = await Promise.race([this.lines.next(), late]);
    clearTimeout(timer);
    return done ? null : value;
  }

  // The answer, or what became of the engine.
  async ask(question) {
    this.process.stdin.write(`${JSON.stringify(question)}\n`);
    const line = await this.line(kAnswerMs);
    if (line !== null) return JSON.parse(line);
    this.process.kill("SIGKILL");
    const end = await this.ended;
    await this.start();
    return { outcome: `crashed or hung (${end})` };
  }

  async stop() {
    this.process.stdin.end();
    const end = await this.ended;
    if (end !== 0) throw new Error(`the engine ended with ${end}: ${this.errors}`);
  }
}

async function validate(command, show) {
  const engine = new Engine(command);
  const says = await engine.start();
  const counts = { asked: 0, unsupported: 0, wrong: 0 };
  const by_query = {};
  const wrong = new Map();  // kind of case -> how many, and the first of them
  for (const { name, question, expect } of all_questions()) {
    const asked = in_its_terms(question, expect, says);
    if (asked === null) continue;
    const answer = await engine.ask(asked);
    if (answer.outcome === "unsupported") {
      ++counts.unsupported;
      continue;
    }
    ++counts.asked;
    by_query[asked.query] = (by_query[asked.query] ?? 0) + 1;
    // Where A's motion is taken away, contacts are not where they were.
    const frame = says.motion === "relative" && asked.query === "cast"
      ? { ...expect, point: expect.point && subtract(expect.point, scaled(expect.time, question.a.displacement)) } : expect;
    const found = answer.id === asked.id || answer.id === undefined ? complaints(asked, frame, answer, says) : ["another's answer"];
    if (found.length === 0) continue;
    ++counts.wrong;
    const kind = `${asked.query}, ${name.split(";")[0]}`;
    const others = wrong.get(kind);
    wrong.set(kind, others ? { ...others, count: others.count + 1 } : { count: 1, name, found, asked, answer });
  }
  for (const [kind, { count, name, found, asked, answer }] of [...wrong].slice(0, show)) {
    console.log(`${says.name}: ${kind}: ${count} wrong, as of: ${name}`);
    console.log([...found, JSON.stringify(asked), JSON.stringify(answer)].map((line) => `    ${line}`).join("\n"));
  }
  await engine.stop();
  const asked = Object.entries(by_query).map(([query, count]) => `${count} ${query}`).join(", ");
  console.log(`${says.name} ${says.version ?? ""}: ${counts.wrong} wrong of ${counts.asked} (${asked}), ${counts.unsupported} unsupported`);
  return counts.asked > 0 && counts.wrong === 0;
}

const args = process.argv.slice(2);
const value_of = (name) => (args.includes(name) ? args[args.indexOf(name) + 1] : undefined);
const show = Number(value_of("--show") ?? 5);
const zoo = value_of("--zoo");
const commands = zoo ? JSON.parse(readFileSync(zoo, "utf8")).engines.map((entry) => entry.command)
  : [args.slice(args.indexOf("--") + 1)];
let good = true;
for (const command of commands) good = (await validate(command, show)) && good;
process.exit(good ? 0 : 1);
