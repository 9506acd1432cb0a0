// PhysX, as the package physx-js-webidl gives it to a program in JavaScript. Shapes are placed by hand; there is no scene.
//
// --call sweep     cast PxGeometryQuery.sweep, B is swept, its displacement relative to A's; ray PxGeometryQuery.raycast;
//                  overlap PxGeometryQuery.overlap; penetration, where there is an overlap, PxGeometryQuery.sweep with
//                  eMTD and no way to go
// --call gjk       cast PxGjkQuery.sweep, ray PxGjkQuery.raycast, overlap PxGjkQuery.overlap, distance
//                  PxGjkQuery.proximityInfo with a contactDistance that no two points can exceed, penetration
//                  proximityInfo with a contactDistance of 0
//
// --setting default    flags eDEFAULT; hulls are cooked as PxCookingParams are made
// --setting tightest   of sweep alone: ePRECISE_SWEEP; planeTolerance 0; eSHIFT_VERTICES. The GJK queries take no tolerance
//                      but toleranceLength, which is the unit of length: 1, as PxTolerancesScale is made.
// In contact at the start a second call gives the direction of least penetration: a sweep with eMTD, which does not go
// together with ePRECISE_SWEEP, or proximityInfo.
//
// What is documented: PxConvexMeshDesc.h: hulls of at most 255 vertices and 255 polygons, which any hull of kMostVertices
// keeps to; PxCookingParams.planeTolerance, 0.0007, and more
// for larger hulls: points that near to the hull are dropped, and with 0 none is; PxConvexFlag::eSHIFT_VERTICES for hulls
// far from their own origin; PxGeometryQuery.h, PX_MAX_SWEEP_DISTANCE, 1e8, for scenes. Of cores of PxConvexCoreGeometry
// overlap and sweep are not supported there; PxGjkQuery takes them. PxGjkQuery.h: separatingAxis is the way on which B
// has to move by separation until the bodies touch, from B to A. No error is bounded, and nothing is said of touching.
//
// A sweep names one point of contact, of the shape that is hit; it stands here for the other shape's, too, since they
// touch there. Capsules, cylinders and cones lie along x.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import initialize from "physx-js-webidl";
import { add, bounding_radius, kXToZ, negated, norm, product, scaled, subtract } from "./geometry.mjs";
import { option, serve, Unsupported } from "./protocol.mjs";

const call = option("call", ["sweep", "gjk"]);
const setting = option("setting", ["default", "tightest"]);
const tightest = setting === "tightest";

const kFloatBytes = 4;
const kUnitLength = 1;
const kMostVertices = 129;

const PhysX = await load();
const params = cooking_params();

// The package is built for browsers, and looks whether it is in one.
async function load() {
  const wasm = join(dirname(createRequire(import.meta.url).resolve("physx-js-webidl/package.json")), "physx-js-webidl.wasm");
  const wasmBinary = readFileSync(wasm);
  const print = (line) => console.error(line);
  const node = globalThis.process;
  globalThis.window = globalThis;
  globalThis.process = undefined;
  try {
    return await initialize({ wasmBinary, print, printErr: print });
  } finally {
    globalThis.process = node;
  }
}

function cooking_params() {
  const functions = PhysX.PxTopLevelFunctions.prototype;
  functions.CreateFoundation(functions.PHYSICS_VERSION, new PhysX.PxDefaultAllocator(), new PhysX.PxDefaultErrorCallback());
  const made = new PhysX.PxCookingParams(new PhysX.PxTolerancesScale());
  if (tightest) made.planeTolerance = 0;
  return made;
}

const kConvexFlags = PhysX.PxConvexFlagEnum.eCOMPUTE_CONVEX | (tightest ? PhysX.PxConvexFlagEnum.eSHIFT_VERTICES : 0);
const kSweepFlags = PhysX.PxHitFlagEnum.eDEFAULT | (tightest ? PhysX.PxHitFlagEnum.ePRECISE_SWEEP : 0);

// What a question allocates on the heap of WASM, given back when it is answered.
class Arena {
  #held = [];

  later(give_back) {
    this.#held.push(give_back);
  }

  hold(thing) {
    this.later(() => PhysX.destroy(thing));
    return thing;
  }

  vec3 = (a) => this.hold(new PhysX.PxVec3(...a));
  transform = (position, [w, x, y, z]) =>
    this.hold(new PhysX.PxTransform(this.vec3(position), this.hold(new PhysX.PxQuat(x, y, z, w))));

  release() {
    while (this.#held.length > 0) this.#held.pop()();
  }
}

const array = (v) => [v.x, v.y, v.z];

function cooked(shape, arena) {
  const points = arena.hold(new PhysX.PxArray_PxVec3());
  const point = arena.vec3([0, 0, 0]);
  for (const [x, y, z] of shape.vertices) {
    Object.assign(point, { x, y, z });
    points.pushBack(point);
  }
  const desc = arena.hold(new PhysX.PxConvexMeshDesc());
  desc.flags = arena.hold(new PhysX.PxConvexFlags(kConvexFlags));
  desc.points.data = points.begin();
  desc.points.count = shape.vertices.length;
  desc.points.stride = 3 * kFloatBytes;
  const mesh = PhysX.PxTopLevelFunctions.prototype.CreateConvexMesh(params, desc);
  if (!mesh || PhysX.getPointer(mesh) === 0) throw new Unsupported("PhysX cooks no convex mesh of these points");
  arena.later(() => mesh.release());
  return mesh;
}

// -> { made, turn }: turn takes the axes of PhysX's shape to ours.
function geometry_of(shape, arena) {
  switch (shape.type) {
    case "sphere":
      return { made: new PhysX.PxSphereGeometry(shape.radius) };
    case "capsule":
      return { made: new PhysX.PxCapsuleGeometry(shape.radius, shape.half_height), turn: kXToZ };
    case "box":
      return { made: new PhysX.PxBoxGeometry(...shape.half_extents) };
    case "hull":
      return { made: new PhysX.PxConvexMeshGeometry(cooked(shape, arena)) };
    default:
      throw new Unsupported(`no shape ${shape.type}`);
  }
}

const factory = PhysX.PxConvexCoreGeometryFactory.prototype;

function support_of(shape, arena, margin = 0) {
  const of_core = (made, turn) => ({ made: new PhysX.ConvexGeomSupport(made), turn });
  switch (shape.type) {
    case "sphere":
      return { made: new PhysX.SphereSupport(shape.radius + margin) };
    case "capsule":
      return { made: new PhysX.CapsuleSupport(shape.radius + margin, shape.half_height), turn: kXToZ };
    case "box":
      return { made: new PhysX.BoxSupport(arena.vec3(shape.half_extents), margin) };
    case "hull": {
      const scale = arena.vec3([1, 1, 1]);
      const unturned = arena.hold(new PhysX.PxQuat(0, 0, 0, 1));
      return { made: new PhysX.ConvexMeshSupport(cooked(shape, arena), scale, unturned, margin) };
    }
    case "cylinder": {
      const core = arena.hold(new PhysX.PxConvexCoreCylinder(2 * shape.half_height, shape.radius));
      return of_core(factory.createFromCylinder(core, margin), kXToZ);
    }
    case "cone": {
      const core = arena.hold(new PhysX.PxConvexCoreCone(2 * shape.half_height, shape.radius));
      return of_core(factory.createFromCone(core, margin), kXToZ);
    }
    case "ellipsoid": {
      const core = arena.hold(new PhysX.PxConvexCoreEllipsoid(...shape.radii));
      return of_core(factory.createFromEllipsoid(core, margin));
    }
    case "rounded":
      return support_of(shape.shape, arena, margin + shape.radius);
    default:
      throw new Unsupported(`no shape ${shape.type}`);
  }
}

function placed(body, arena, make) {
  const { made, turn } = make(body.shape, arena);
  arena.hold(made);
  const q = turn ? product(body.orientation, turn) : body.orientation;
  return { shape: made, pose: arena.transform(body.position, q) };
}

// The way of a motion: its unit vector, and the length of it over one unit of t.
function way(motion, arena) {
  const speed = norm(motion);
  return { speed, unit: arena.vec3(speed > 0 ? scaled(1 / speed, motion) : [1, 0, 0]) };
}

const time_of = (distance, speed) => (speed > 0 ? distance / speed : 0);
const relative = (a, b) => subtract(b.displacement, a.displacement);
const reach = (a, b) => norm(subtract(b.position, a.position)) + bounding_radius(a.shape) + bounding_radius(b.shape);

function with_arena(ask) {
  return (question) => {
    const arena = new Arena();
    try {
      return { ...ask(question, arena), release: () => arena.release() };
    } catch (error) {
      if (error instanceof Unsupported) arena.release();
      throw error;
    }
  };
}

// ---- PxGeometryQuery -----------------------------------------------------------------------------------------------

const geometry = PhysX.PxGeometryQuery.prototype;

function swept(question, arena, flags, speed, unit, t_max) {
  const a = placed(question.a, arena, geometry_of);
  const b = placed(question.b, arena, geometry_of);
  for (const { shape } of [a, b]) {
    if (!geometry.isValid(shape)) throw new Unsupported("PxGeometryQuery.isValid says no");
  }
  const hit = arena.hold(new PhysX.PxSweepHit());
  const hit_flags = arena.hold(new PhysX.PxHitFlags(flags));
  return { hit, run: () => geometry.sweep(unit, speed * t_max, b.shape, b.pose, a.shape, a.pose, hit, hit_flags, 0) };
}

function least_penetration(question, arena) {
  const unit = arena.vec3([1, 0, 0]);
  const { hit, run } = swept(question, arena, PhysX.PxHitFlagEnum.eDEFAULT | PhysX.PxHitFlagEnum.eMTD, 0, unit, 0);
  return () => (run() ? { depth: Math.max(0, -hit.distance), normal: array(hit.normal) } : null);
}

const sweep = with_arena((question, arena) => {
  const { speed, unit } = way(relative(question.a, question.b), arena);
  const { hit, run } = swept(question, arena, kSweepFlags, speed, unit, question.t_max);
  const read = (found) => {
    if (!found) return { outcome: "miss" };
    if (hit.hadInitialOverlap()) {
      return { outcome: "initially_overlapping", normal: least_penetration(question, arena)()?.normal };
    }
    const time = time_of(hit.distance, speed);
    const point = add(array(hit.position), scaled(time, question.a.displacement));
    return { outcome: "hit", time, normal: array(hit.normal), point_a: point, point_b: point };
  };
  return { run, read };
});

const sweep_penetration = with_arena((question, arena) => {
  const a = placed(question.a, arena, geometry_of);
  const b = placed(question.b, arena, geometry_of);
  const least = least_penetration(question, arena);
  return {
    run: () => (geometry.overlap(a.shape, a.pose, b.shape, b.pose) ? { least: least() } : null),
    read: (overlapping) => {
      if (overlapping === null) return { outcome: "miss" };
      if (overlapping.least === null) return { outcome: "not_converged", message: "overlap says yes, sweep with eMTD no" };
      return { outcome: "initially_overlapping", ...overlapping.least };
    },
  };
});

const raycast = with_arena(({ a, origin, direction, t_max }, arena) => {
  const { shape, pose } = placed(a, arena, geometry_of);
  if (!geometry.isValid(shape)) throw new Unsupported("PxGeometryQuery.isValid says no");
  const { speed, unit } = way(direction, arena);
  const hit = arena.hold(new PhysX.PxRaycastHit());
  const flags = arena.hold(new PhysX.PxHitFlags(PhysX.PxHitFlagEnum.eDEFAULT));
  const from = arena.vec3(origin);
  return {
    run: () => geometry.raycast(from, unit, shape, pose, speed * t_max, flags, 1, hit),
    read: (count) => {
      if (count === 0) return { outcome: "miss" };
      if (hit.hadInitialOverlap()) return { outcome: "initially_overlapping" };
      return { outcome: "hit", time: time_of(hit.distance, speed), normal: array(hit.normal) };
    },
  };
});

const overlaps = with_arena((question, arena) => {
  const a = placed(question.a, arena, geometry_of);
  const b = placed(question.b, arena, geometry_of);
  return {
    run: () => geometry.overlap(a.shape, a.pose, b.shape, b.pose),
    read: (touch) => ({ outcome: touch ? "initially_overlapping" : "miss" }),
  };
});

const kSweepQueries = {
  cast: { declares: { answers: ["time", "normal", "witnesses"], touching: "either" }, ask: sweep },
  ray: { declares: { answers: ["time", "normal"], touching: "either" }, ask: raycast },
  overlap: { declares: { answers: [], touching: "either" }, ask: overlaps },
  penetration: { declares: { answers: ["depth", "normal"], touching: "either" }, ask: sweep_penetration },
};

// ---- PxGjkQuery ----------------------------------------------------------------------------------------------------

const gjk = PhysX.PxGjkQuery.prototype;

const gjk_sweep = with_arena((question, arena) => {
  const a = placed(question.a, arena, support_of);
  const b = placed(question.b, arena, support_of);
  const { speed, unit } = way(relative(question.a, question.b), arena);
  const result = arena.hold(new PhysX.PxGjkQuerySweepResult());
  return {
    run: () => gjk.sweep(a.shape, b.shape, a.pose, b.pose, unit, speed * question.t_max, result),
    read: (found) => {
      if (!found) return { outcome: "miss" };
      if (result.t <= 0) return { outcome: "initially_overlapping", ...nearest(a, b, 0, arena)()?.contact };
      const time = time_of(result.t, speed);
      const point = add(array(result.p), scaled(time, question.a.displacement));
      return { outcome: "hit", time, normal: array(result.n), point_a: point, point_b: point };
    },
  };
});

const gjk_ray = with_arena(({ a, origin, direction, t_max }, arena) => {
  const { shape, pose } = placed(a, arena, support_of);
  const { speed, unit } = way(direction, arena);
  const result = arena.hold(new PhysX.PxGjkQueryRaycastResult());
  const from = arena.vec3(origin);
  return {
    run: () => gjk.raycast(shape, pose, from, unit, speed * t_max, result),
    read: (found) => {
      if (!found) return { outcome: "miss" };
      if (result.t <= 0) return { outcome: "initially_overlapping" };
      return { outcome: "hit", time: time_of(result.t, speed), normal: array(result.n) };
    },
  };
});

const gjk_overlap = with_arena((question, arena) => {
  const a = placed(question.a, arena, support_of);
  const b = placed(question.b, arena, support_of);
  return {
    run: () => gjk.overlap(a.shape, b.shape, a.pose, b.pose),
    read: (touch) => ({ outcome: touch ? "initially_overlapping" : "miss" }),
  };
});

function nearest(a, b, most, arena) {
  const result = arena.hold(new PhysX.PxGjkQueryProximityInfoResult());
  return () => {
    if (!gjk.proximityInfo(a.shape, b.shape, a.pose, b.pose, most, kUnitLength, result)) return null;
    const { separation, separatingAxis, pointA, pointB } = result;
    return { separation, contact: { normal: negated(array(separatingAxis)), point_a: array(pointA), point_b: array(pointB) } };
  };
}

const proximity = (most, read) => with_arena((question, arena) => {
  const a = placed(question.a, arena, support_of);
  const b = placed(question.b, arena, support_of);
  return { run: nearest(a, b, most(question.a, question.b), arena), read };
});

const gjk_distance = proximity(reach, (found) => {
  if (found === null) return { outcome: "not_converged", message: "nothing within a distance beyond reach" };
  if (found.separation <= 0) return { outcome: "initially_overlapping", distance: 0, ...found.contact };
  return { outcome: "miss", distance: found.separation, ...found.contact };
});

const gjk_penetration = proximity(() => 0, (found) =>
  found === null || found.separation > 0 ? { outcome: "miss" }
    : { outcome: "initially_overlapping", depth: -found.separation, ...found.contact });

const kGjkQueries = {
  cast: { declares: { answers: ["time", "normal", "witnesses"], touching: "either" }, ask: gjk_sweep },
  ray: { declares: { answers: ["time", "normal"], touching: "either" }, ask: gjk_ray },
  overlap: { declares: { answers: [], touching: "either" }, ask: gjk_overlap },
  distance: { declares: { answers: ["distance", "normal", "witnesses"], touching: "either" }, ask: gjk_distance },
  penetration: { declares: { answers: ["depth", "normal", "witnesses"], touching: "either" }, ask: gjk_penetration },
};

const shapes = ["sphere", "capsule", "box", "hull"];
serve(
  {
    name: `physx-${call}-${setting}`,
    version: "2.7.3",
    about: call === "gjk" ? "PhysX 5.6.1 by physx-js-webidl: PxGjkQuery" : "PhysX 5.6.1 by physx-js-webidl: PxGeometryQuery",
    scalar: "float",
    shapes: call === "gjk" ? [...shapes, "cylinder", "cone", "ellipsoid", "rounded"] : shapes,
    motion: "relative",
    most_vertices: kMostVertices,
  },
  call === "gjk" ? kGjkQueries : kSweepQueries);
