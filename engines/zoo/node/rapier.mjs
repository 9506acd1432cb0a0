// Rapier (parry), as the package @dimforge/rapier3d-compat gives it to a program in JavaScript.
//
//   cast          Shape.castShape(..., target distance, max toi, stopAtPenetration = true)
//   ray           Shape.castRayAndGetNormal(..., solid = true)
//   overlap       Shape.intersectsShape
//   distance      Shape.contactShape, with a prediction that no two points of the shapes can exceed
//   penetration   Shape.contactShape, with a prediction of 0
//
// No call takes a tolerance or a count of iterations, so that the default is the tightest setting, too.
//
// What is documented (docs.rs, parry3d): of ShapeCastOptions.target_distance, that shapes impact "as soon as their
// distance is smaller or equal" to it, so that touching is contact; of ShapeCastStatus, that a cast that runs out of
// iterations, or fails, hands back a conservative time, which the package does not tell from others. No error is bounded.
//
// Witnesses and normals of castShape lie in the frame of their own shape; those of contactShape in world axes.
// Capsules, cylinders and cones lie along y.

import RAPIER from "@dimforge/rapier3d-compat";
import { add, bounding_radius, kYToZ, norm, product, rotated, scaled, subtract } from "./geometry.mjs";
import { option, serve, Unsupported } from "./protocol.mjs";

const call = option("call", ["castShape"]);
const setting = option("setting", ["default"]);
await RAPIER.init();

// -> { shape, turn }: turn takes the axes of Rapier's shape to ours.
function shape_of(shape, rounding = 0) {
  const upright = (made) => ({ shape: made, turn: kYToZ });
  const plain = (made) => ({ shape: made, turn: null });
  const r = rounding;
  switch (shape.type) {
    case "sphere":
      return plain(new RAPIER.Ball(shape.radius + r));
    case "point":
      return plain(new RAPIER.Ball(r));
    case "capsule":
      return upright(new RAPIER.Capsule(shape.half_height, shape.radius + r));
    case "box": {
      const h = shape.half_extents;
      return plain(r > 0 ? new RAPIER.RoundCuboid(...h, r) : new RAPIER.Cuboid(...h));
    }
    case "cylinder": {
      const { half_height, radius } = shape;
      return upright(r > 0 ? new RAPIER.RoundCylinder(half_height, radius, r) : new RAPIER.Cylinder(half_height, radius));
    }
    case "cone": {
      const { half_height, radius } = shape;
      return upright(r > 0 ? new RAPIER.RoundCone(half_height, radius, r) : new RAPIER.Cone(half_height, radius));
    }
    case "segment":
      if (r > 0) throw new Unsupported("no rounded segment that lies anyhow");
      return plain(new RAPIER.Segment(vector(shape.a), vector(shape.b)));
    case "triangle": {
      const corners = [shape.a, shape.b, shape.c].map(vector);
      return plain(r > 0 ? new RAPIER.RoundTriangle(...corners, r) : new RAPIER.Triangle(...corners));
    }
    case "hull": {
      const [p, q, s] = shape.vertices;
      if (shape.vertices.length === 1) throw new Unsupported("no hull of one point");
      if (shape.vertices.length === 2) return shape_of({ type: "segment", a: p, b: q }, r);
      if (shape.vertices.length === 3) return shape_of({ type: "triangle", a: p, b: q, c: s }, r);
      const points = new Float32Array(shape.vertices.flat());
      return plain(r > 0 ? new RAPIER.RoundConvexPolyhedron(points, null, r) : new RAPIER.ConvexPolyhedron(points));
    }
    case "rounded":
      return shape_of(shape.shape, r + shape.radius);
    default:
      throw new Unsupported(`no shape ${shape.type}`);
  }
}

const vector = (a) => ({ x: a[0], y: a[1], z: a[2] });
const array = (a) => [a.x, a.y, a.z];

// A body as Rapier sees it: its shape made once, since each call of the class Shape makes it anew.
class Placed {
  constructor(body) {
    this.body = body;
    const { shape, turn } = shape_of(body.shape);
    this.shape = prebuilt(shape);
    const q = turn ? product(body.orientation, turn) : body.orientation;
    this.orientation = q.map(Math.fround);
    this.position = vector(body.position);
    this.rotation = { w: q[0], x: q[1], y: q[2], z: q[3] };
    this.velocity = vector(body.displacement ?? [0, 0, 0]);
  }

  point(local, t) {
    return add(add(rotated(this.orientation, array(local)), this.body.position), scaled(t, this.body.displacement));
  }

  direction(local) {
    return rotated(this.orientation, array(local));
  }

  release() {
    this.shape.discard();
  }
}

// The class Shape makes its WASM object at each call and frees it after; here it makes it once, and hands out that one.
function prebuilt(shape) {
  let raw;
  try {
    raw = shape.intoRaw();
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) throw error;
    throw new Unsupported(String(error?.message ?? error));
  }
  if (raw === undefined || raw === null) throw new Unsupported("Rapier makes no convex hull of these points");
  const free = raw.free.bind(raw);
  raw.free = () => {};
  shape.intoRaw = () => raw;
  shape.discard = free;
  return shape;
}

const pair = (question, run, read) => {
  const a = new Placed(question.a);
  const b = new Placed(question.b);
  return {
    run: () => run(a, b),
    read: (raw) => read(raw, a, b),
    release: () => {
      a.release();
      b.release();
    },
  };
};

function cast(question) {
  const t_max = Math.min(question.t_max, kMostFloat);
  return pair(
    question,
    (a, b) =>
      a.shape.castShape(a.position, a.rotation, a.velocity, b.shape, b.position, b.rotation, b.velocity,
                        question.target_distance, t_max, true),
    (hit, a, b) => {
      if (hit === null) return { outcome: "miss" };
      const t = hit.time_of_impact;
      return {
        outcome: t === 0 ? "initially_overlapping" : "hit",
        time: t,
        normal: a.direction(hit.normal1),
        point_a: a.point(hit.witness1, t),
        point_b: b.point(hit.witness2, t),
      };
    });
}

function ray(question) {
  const a = new Placed(question.a);
  const line = new RAPIER.Ray(vector(question.origin), vector(question.direction));
  const t_max = Math.min(question.t_max, kMostFloat);
  return {
    run: () => a.shape.castRayAndGetNormal(line, a.position, a.rotation, t_max, true),
    read: (hit) => {
      if (hit === null) return { outcome: "miss" };
      // A ray that starts inside has a normal of zeros.
      if (hit.timeOfImpact === 0) return { outcome: "initially_overlapping" };
      return { outcome: "hit", time: hit.timeOfImpact, normal: array(hit.normal) };
    },
    release: () => a.release(),
  };
}

function overlap(question) {
  return pair(
    question,
    (a, b) => a.shape.intersectsShape(a.position, a.rotation, b.shape, b.position, b.rotation),
    (touch) => ({ outcome: touch ? "initially_overlapping" : "miss" }));
}

const contact = (prediction) => (a, b) =>
  a.shape.contactShape(a.position, a.rotation, b.shape, b.position, b.rotation, prediction);

function distance(question) {
  const { a, b } = question;
  const most = norm(subtract(b.position, a.position)) + bounding_radius(a.shape) + bounding_radius(b.shape);
  return pair(question, contact(Math.min(2 * most, kMostFloat)), (found) => {
    if (found === null) return { outcome: "not_converged", message: "no contact within a prediction beyond reach" };
    const fields = { normal: array(found.normal1), point_a: array(found.point1), point_b: array(found.point2) };
    if (found.distance <= 0) return { outcome: "initially_overlapping", distance: 0, ...fields };
    return { outcome: "miss", distance: found.distance, ...fields };
  });
}

function penetration(question) {
  return pair(question, contact(0), (found) => {
    if (found === null || found.distance > 0) return { outcome: "miss" };
    return {
      outcome: "initially_overlapping",
      depth: -found.distance,
      normal: array(found.normal1),
      point_a: array(found.point1),
      point_b: array(found.point2),
    };
  });
}

const kMostFloat = 3.4028234663852886e38;

serve(
  {
    name: `rapier-${call}-${setting}`,
    version: "0.21.0",
    about: "parry by @dimforge/rapier3d-compat: Shape.castShape, castRayAndGetNormal, intersectsShape, contactShape",
    scalar: "float",
    shapes: ["point", "segment", "triangle", "sphere", "capsule", "box", "cylinder", "cone", "hull", "rounded"],
    infinite_t_max: true,
  },
  {
    cast: {
      declares: { answers: ["time", "normal", "witnesses"], touching: "contact", target_distance: true },
      ask: cast,
    },
    ray: { declares: { answers: ["time", "normal"] }, ask: ray },
    overlap: { declares: { answers: [] }, ask: overlap },
    distance: { declares: { answers: ["distance", "normal", "witnesses"] }, ask: distance },
    penetration: { declares: { answers: ["depth", "normal", "witnesses"] }, ask: penetration },
  });
