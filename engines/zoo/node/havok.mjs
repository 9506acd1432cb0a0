// Havok, as the package @babylonjs/havok gives it to a program in JavaScript: A is the one body of a world.
//
//   cast                    HP_World_ShapeCastWithCollector; B is cast, its displacement relative to A's
//   ray                     HP_World_CastRayWithCollector
//   distance, penetration   HP_World_ShapeProximityWithCollector, with a maxDistance that no two points can exceed;
//                           of penetration with 0
//   overlap                 HP_World_ShapeProximityWithCollector with a maxDistance of 0
//
// No call takes a tolerance, so that the default is the tightest setting, too.
//
// What is documented (doc.babylonjs.com, Shape cast): that the result of a shape cast "will not be correct for
// intersecting shapes", so that starts in contact are not asked; that a maxDistance of 0 checks for overlaps. No error is
// bounded, and nothing is said of touching, nor of rays that start inside (they hit nothing).
//
// What lies on the shape of the query is given in that shape's frame, what lies on the body in world axes.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import initialize from "@babylonjs/havok";
import { add, bounding_radius, norm, scaled, subtract, to_world } from "./geometry.mjs";
import { option, serve, Unsupported } from "./protocol.mjs";

const call = option("call", ["ShapeCast"]);
const setting = option("setting", ["default"]);

const wasm = join(dirname(createRequire(import.meta.url).resolve("@babylonjs/havok")), "HavokPhysics.wasm");
const print = (line) => console.error(line);
const havok = await initialize({ wasmBinary: readFileSync(wasm), print, printErr: print });
const kOk = havok.Result.RESULT_OK;
const kEverything = [-1, -1];
const kNoBody = [0n];
const kFloatBytes = 4;

const world = made("world", havok.HP_World_Create());
const collector = made("collector", havok.HP_QueryCollector_Create(1));

function made(what, [result, id]) {
  if (result !== kOk) throw new Unsupported(`Havok makes no ${what} of this`);
  return id;
}

function done(what, result) {
  if (result !== kOk) throw new Unsupported(`Havok refuses: ${what}`);
}

const quaternion = ([w, x, y, z]) => [x, y, z, w];
const kIdentity = [0, 0, 0, 1];

function shape_of(shape) {
  switch (shape.type) {
    case "sphere":
      return made("sphere", havok.HP_Shape_CreateSphere([0, 0, 0], shape.radius));
    case "capsule":
      return made("capsule", havok.HP_Shape_CreateCapsule(...ends(shape), shape.radius));
    case "cylinder":
      return made("cylinder", havok.HP_Shape_CreateCylinder(...ends(shape), shape.radius));
    case "box":
      return made("box", havok.HP_Shape_CreateBox([0, 0, 0], kIdentity, scaled(2, shape.half_extents)));
    case "hull": {
      const numbers = shape.vertices.flat();
      const at = havok._malloc(numbers.length * kFloatBytes);
      new Float32Array(havok.HEAPU8.buffer, at, numbers.length).set(numbers);
      const result = havok.HP_Shape_CreateConvexHull(at, shape.vertices.length);
      havok._free(at);
      return made("hull", result);
    }
    default:
      throw new Unsupported(`no shape ${shape.type}`);
  }
}

const ends = ({ half_height }) => [[0, 0, -half_height], [0, 0, half_height]];

// A stands in the world as a static body, B is the shape of the query, if there is one.
function placed(a, b) {
  const given_back = [];
  const release = () => {
    while (given_back.length > 0) given_back.pop()();
  };
  const shape = (body) => {
    const id = shape_of(body.shape);
    given_back.push(() => havok.HP_Shape_Release(id));
    return id;
  };
  try {
    const shape_a = shape(a);
    const body = made("body", havok.HP_Body_Create());
    given_back.push(() => havok.HP_Body_Release(body));
    done("HP_Body_SetShape", havok.HP_Body_SetShape(body, shape_a));
    done("HP_Body_SetMotionType", havok.HP_Body_SetMotionType(body, havok.MotionType.STATIC));
    done("HP_Body_SetQTransform", havok.HP_Body_SetQTransform(body, [a.position, quaternion(a.orientation)]));
    done("HP_World_AddBody", havok.HP_World_AddBody(world, body, false));
    given_back.push(() => havok.HP_World_RemoveBody(world, body));
    return { shape_b: b ? shape(b) : null, release };
  } catch (error) {
    if (error instanceof Unsupported) release();
    throw error;
  }
}

// The one hit of the last query, or null.
function found(get) {
  const [counted, count] = havok.HP_QueryCollector_GetNumHits(collector);
  done("HP_QueryCollector_GetNumHits", counted);
  return count === 0 ? null : made("result", get(collector, 0));
}

const kPosition = 3;
const kNormal = 4;

function cast({ a, b, t_max }) {
  const { shape_b, release } = placed(a, b);
  const end = add(b.position, scaled(t_max, subtract(b.displacement, a.displacement)));
  const query = [shape_b, quaternion(b.orientation), b.position, end, false, kNoBody];
  return {
    release,
    run: () => havok.HP_World_ShapeCastWithCollector(world, collector, query),
    read: (result) => {
      done("HP_World_ShapeCastWithCollector", result);
      const hit = found(havok.HP_QueryCollector_GetShapeCastResult);
      if (hit === null) return { outcome: "miss" };
      const [fraction, on_b, on_a] = hit;
      const time = fraction * t_max;
      return {
        outcome: fraction <= 0 ? "initially_overlapping" : "hit",
        time,
        normal: on_a[kNormal],
        point_a: add(on_a[kPosition], scaled(time, a.displacement)),
        point_b: to_world(b, on_b[kPosition], time),
      };
    },
  };
}

function ray({ a, origin, direction, t_max }) {
  const { release } = placed(a);
  const query = [origin, add(origin, scaled(t_max, direction)), kEverything, false, kNoBody];
  return {
    release,
    run: () => havok.HP_World_CastRayWithCollector(world, collector, query),
    read: (result) => {
      done("HP_World_CastRayWithCollector", result);
      const hit = found(havok.HP_QueryCollector_GetCastRayResult);
      if (hit === null) return { outcome: "miss" };
      const [fraction, contact] = hit;
      if (fraction === 0) return { outcome: "initially_overlapping" };
      return { outcome: "hit", time: fraction * t_max, normal: contact[kNormal] };
    },
  };
}

const proximity = (most, read) => ({ a, b }) => {
  const { shape_b, release } = placed(a, b);
  const query = [shape_b, b.position, quaternion(b.orientation), most(a, b), false, kNoBody];
  return {
    release,
    run: () => havok.HP_World_ShapeProximityWithCollector(world, collector, query),
    read: (result) => {
      done("HP_World_ShapeProximityWithCollector", result);
      const near = found(havok.HP_QueryCollector_GetShapeProximityResult);
      if (near === null) return read(null);
      const [gap, on_b, on_a] = near;
      return read(gap, { normal: on_a[kNormal], point_a: on_a[kPosition], point_b: to_world(b, on_b[kPosition]) });
    },
  };
};

const reach = (a, b) => norm(subtract(b.position, a.position)) + bounding_radius(a.shape) + bounding_radius(b.shape);

const overlap = proximity(() => 0, (gap) => ({ outcome: gap === null || gap > 0 ? "miss" : "initially_overlapping" }));

const penetration = proximity(() => 0, (gap, contact) =>
  gap === null || gap > 0 ? { outcome: "miss" } : { outcome: "initially_overlapping", depth: -gap, ...contact });

const distance = proximity(reach, (gap, contact) => {
  if (gap === null) return { outcome: "not_converged", message: "nothing within a distance beyond reach" };
  if (gap <= 0) return { outcome: "initially_overlapping", distance: 0, ...contact };
  return { outcome: "miss", distance: gap, ...contact };
});

serve(
  {
    name: `havok-${call}-${setting}`,
    version: "1.3.14",
    about: "Havok by @babylonjs/havok: HP_World_ShapeCast, ShapeProximity, CastRay of a world with one body",
    scalar: "float",
    shapes: ["sphere", "capsule", "box", "cylinder", "hull"],
    motion: "relative",
  },
  {
    cast: { declares: { answers: ["time", "normal", "witnesses"], starts: false, touching: "either" }, ask: cast },
    ray: { declares: { answers: ["time", "normal"], starts: false, touching: "either" }, ask: ray },
    overlap: { declares: { answers: [], touching: "either" }, ask: overlap },
    distance: { declares: { answers: ["distance", "normal", "witnesses"], touching: "either" }, ask: distance },
    penetration: { declares: { answers: ["depth", "normal", "witnesses"], touching: "either" }, ask: penetration },
  });
