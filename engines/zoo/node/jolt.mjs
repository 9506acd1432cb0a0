// Jolt Physics, as the package jolt-physics gives it to a program in JavaScript: A is the one body of a PhysicsSystem.
//
//   cast          NarrowPhaseQuery.CastShape; B is cast, its displacement relative to A's
//   ray           NarrowPhaseQuery.CastRay
//   overlap       NarrowPhaseQuery.CollideShape
//   distance      NarrowPhaseQuery.CollideShape, with an mMaxSeparationDistance that no two points can exceed
//   penetration   NarrowPhaseQuery.CollideShape
//
// --setting default    the settings as they are made, except for what the protocol needs of a cast: mReturnDeepestPoint, so
//                      that there is a direction of least penetration, and back faces, so that starts in contact that
//                      move apart are reported. Casts and rays alone: CollideShape sees shapes with corners rounded by
//                      the default convex radius of 0.05.
// --setting tightest   convex radii 0, mHullTolerance 0, mCollisionTolerance kLeastTolerance, mPenetrationTolerance
//                      FLT_EPSILON, results relative to the place of the cast
//
// What is documented: PhysicsSettings.h, cDefaultCollisionTolerance: objects that are closer than this, 1e-4 m, "are
// considered to be colliding"; CollideShape.h: mPenetrationTolerance, of the squared depth, 1e-4 and, in
// EPAPenetrationDepth.h, at least FLT_EPSILON; ConvexHullShape.h: mHullTolerance, 1e-3 m, by which points may lie
// outside of a hull, and cMaxPointsInHull, 256; Architecture.md: static objects of 0.1 to 2000 m; ShapeCast.h: a cast does
// not shrink shapes by their convex radius unless it is told to.
//
// Capsules, cylinders and cones lie along y. Shapes are placed by their centres of mass. In results shape 1 is B.

import initialize from "jolt-physics/wasm-compat";
import { add, bounding_radius, kYToZ, kZero, negated, norm, normalized, product, rotated, scaled, subtract } from "./geometry.mjs";
import { option, serve, Unsupported } from "./protocol.mjs";

const call = option("call", ["CastShape"]);
const setting = option("setting", ["default", "tightest"]);
const tightest = setting === "tightest";

const kLayer = 0;
const kLeastTolerance = 1e-6;
const kCollisionTolerance = 1e-4;
const kHullTolerance = 1e-3;
const kFloatEpsilon = 2 ** -23;

const print = (line) => console.error(line);
const Jolt = await initialize({ print, printErr: print });
const { system, jolt } = start();
const bodies = system.GetBodyInterface();
const narrow = system.GetNarrowPhaseQuery();

const kScale = new Jolt.Vec3(1, 1, 1);
const filters = [
  new Jolt.DefaultBroadPhaseLayerFilter(jolt.GetObjectVsBroadPhaseLayerFilter(), kLayer),
  new Jolt.DefaultObjectLayerFilter(jolt.GetObjectLayerPairFilter(), kLayer),
  new Jolt.BodyFilter(),
  new Jolt.ShapeFilter(),
];

// A system with one layer, whose bodies all collide.
function start() {
  const settings = new Jolt.JoltSettings();
  settings.mMaxWorkerThreads = 0;
  const pairs = new Jolt.ObjectLayerPairFilterTable(1);
  pairs.EnableCollision(kLayer, kLayer);
  const layers = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
  layers.MapObjectToBroadPhaseLayer(kLayer, new Jolt.BroadPhaseLayer(0));
  settings.mObjectLayerPairFilter = pairs;
  settings.mBroadPhaseLayerInterface = layers;
  settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 1, pairs, 1);
  const made = new Jolt.JoltInterface(settings);
  Jolt.destroy(settings);
  return { jolt: made, system: made.GetPhysicsSystem() };
}

// What a question allocates on the heap of WASM, given back when it is answered.
class Arena {
  #held = [];

  hold(thing) {
    this.#held.push(() => Jolt.destroy(thing));
    return thing;
  }

  later(give_back) {
    this.#held.push(give_back);
  }

  vec3 = (a) => this.hold(new Jolt.Vec3(...a));
  rvec3 = (a) => this.hold(new Jolt.RVec3(...a));
  quat = (q) => this.hold(new Jolt.Quat(q[1], q[2], q[3], q[0]));

  release() {
    while (this.#held.length > 0) this.#held.pop()();
  }
}

const array = (v) => [v.GetX(), v.GetY(), v.GetZ()];

// Convex radii are 0 with the tightest settings; else Jolt's own, which undefined leaves to it.
const kRadius = tightest ? [0] : [];

function settings_of(shape, arena) {
  switch (shape.type) {
    case "sphere":
      return { made: new Jolt.SphereShapeSettings(shape.radius) };
    case "capsule":
      return { made: new Jolt.CapsuleShapeSettings(shape.half_height, shape.radius), turn: kYToZ };
    case "box":
      return { made: new Jolt.BoxShapeSettings(arena.vec3(shape.half_extents), ...kRadius) };
    case "cylinder":
      return { made: new Jolt.CylinderShapeSettings(shape.half_height, shape.radius, ...kRadius), turn: kYToZ };
    case "cone":
      return { made: new Jolt.TaperedCylinderShapeSettings(shape.half_height, 0, shape.radius, ...kRadius), turn: kYToZ };
    case "hull": {
      const made = new Jolt.ConvexHullShapeSettings();
      const point = arena.vec3(kZero);
      for (const vertex of shape.vertices) {
        point.Set(...vertex);
        made.mPoints.push_back(point);
      }
      if (tightest) Object.assign(made, { mMaxConvexRadius: 0, mHullTolerance: 0 });
      return { made };
    }
    default:
      throw new Unsupported(`no shape ${shape.type}`);
  }
}

// A body's shape, and where its centre of mass is.
class Placed {
  constructor(body, arena) {
    const { made, turn } = settings_of(body.shape, arena);
    made.AddRef();
    arena.later(() => made.Release());
    const result = made.Create();
    if (result.HasError()) throw new Unsupported(result.GetError().c_str());
    this.shape = result.Get();
    this.shape.AddRef();
    arena.later(() => this.shape.Release());
    this.q = turn ? product(body.orientation, turn) : body.orientation;
    this.position = body.position;
    this.centre = add(body.position, rotated(this.q, array(this.shape.GetCenterOfMass())));
  }

  transform(arena) {
    const rotation = arena.quat(this.q);
    const matrix = Jolt.RMat44.prototype.sRotationTranslation(rotation, arena.rvec3(this.centre));
    return arena.hold(copied(matrix));
  }
}

// Values that functions return lie in a static of the bindings, until the next such call.
function copied(matrix) {
  const made = new Jolt.RMat44();
  for (let k = 0; k < 4; ++k) made.SetColumn4(k, matrix.GetColumn4(k));
  return made;
}

function add_static(body, arena) {
  const a = new Placed(body, arena);
  const settings = arena.hold(
    new Jolt.BodyCreationSettings(a.shape, arena.rvec3(body.position), arena.quat(a.q), Jolt.EMotionType_Static, kLayer));
  const made = bodies.CreateBody(settings);
  bodies.AddBody(made.GetID(), Jolt.EActivation_DontActivate);
  arena.later(() => {
    bodies.RemoveBody(made.GetID());
    bodies.DestroyBody(made.GetID());
  });
  return made;
}

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

const offset_at = (position) => (tightest ? position : kZero);

function contact_of(hit, offset) {
  return {
    normal: normalized(negated(array(hit.mPenetrationAxis))),
    point_a: add(array(hit.mContactPointOn2), offset),
    point_b: add(array(hit.mContactPointOn1), offset),
  };
}

const cast = with_arena(({ a, b, t_max }, arena) => {
  add_static(a, arena);
  const placed = new Placed(b, arena);
  const path = scaled(t_max, subtract(b.displacement, a.displacement));
  const offset = offset_at(b.position);
  const ray = arena.hold(new Jolt.RShapeCast(placed.shape, kScale, placed.transform(arena), arena.vec3(path)));
  const settings = arena.hold(new Jolt.ShapeCastSettings());
  settings.mReturnDeepestPoint = true;
  settings.mBackFaceModeConvex = Jolt.EBackFaceMode_CollideWithBackFaces;
  tighten(settings);
  const base = arena.rvec3(offset);
  const collector = arena.hold(new Jolt.CastShapeClosestHitCollisionCollector());
  return {
    run: () => {
      collector.Reset();
      narrow.CastShape(ray, settings, base, collector, ...filters);
      return collector;
    },
    read: () => {
      if (!collector.HadHit()) return { outcome: "miss" };
      const hit = collector.mHit;
      const time = hit.mFraction * t_max;
      const moved = add(offset, scaled(time, a.displacement));
      return { outcome: hit.mFraction === 0 ? "initially_overlapping" : "hit", time, ...contact_of(hit, moved) };
    },
  };
});

function tighten(settings) {
  if (!tightest) return;
  settings.mCollisionTolerance = kLeastTolerance;
  settings.mPenetrationTolerance = kFloatEpsilon;
}

const ray = with_arena(({ a, origin, direction, t_max }, arena) => {
  const body = add_static(a, arena);
  const line = arena.hold(new Jolt.RRayCast(arena.rvec3(origin), arena.vec3(scaled(t_max, direction))));
  const settings = arena.hold(new Jolt.RayCastSettings());
  const collector = arena.hold(new Jolt.CastRayClosestHitCollisionCollector());
  return {
    run: () => {
      collector.Reset();
      narrow.CastRay(line, settings, collector, ...filters);
      return collector;
    },
    read: () => {
      if (!collector.HadHit()) return { outcome: "miss" };
      const { mFraction, mSubShapeID2 } = collector.mHit;
      if (mFraction === 0) return { outcome: "initially_overlapping" };
      const time = mFraction * t_max;
      const at = arena.rvec3(add(origin, scaled(time, direction)));
      return { outcome: "hit", time, normal: array(body.GetWorldSpaceSurfaceNormal(mSubShapeID2, at)) };
    },
  };
});

// `most` is the distance up to which pairs that are apart are found.
const collide = (most, read) => with_arena(({ a, b }, arena) => {
  add_static(a, arena);
  const placed = new Placed(b, arena);
  const settings = arena.hold(new Jolt.CollideShapeSettings());
  settings.mMaxSeparationDistance = most(a, b);
  tighten(settings);
  const offset = offset_at(b.position);
  const base = arena.rvec3(offset);
  const place = placed.transform(arena);
  const collector = arena.hold(new Jolt.CollideShapeClosestHitCollisionCollector());
  return {
    run: () => {
      collector.Reset();
      narrow.CollideShape(placed.shape, kScale, place, settings, base, collector, ...filters);
      return collector;
    },
    read: () => read(collector.HadHit() ? collector.mHit : null, offset),
  };
});

const overlap = collide(() => 0, (hit) => ({ outcome: hit === null ? "miss" : "initially_overlapping" }));

const penetration = collide(() => 0, (hit, offset) =>
  hit === null ? { outcome: "miss" }
    : { outcome: "initially_overlapping", depth: Math.max(0, hit.mPenetrationDepth), ...contact_of(hit, offset) });

const reach = (a, b) => norm(subtract(b.position, a.position)) + bounding_radius(a.shape) + bounding_radius(b.shape);

const distance = collide(reach, (hit, offset) => {
  if (hit === null) return { outcome: "not_converged", message: "no contact within a distance beyond reach" };
  const contact = contact_of(hit, offset);
  if (hit.mPenetrationDepth >= 0) return { outcome: "initially_overlapping", distance: 0, ...contact };
  return { outcome: "miss", distance: -hit.mPenetrationDepth, ...contact };
});

// The promise of the tightest settings is the documented default, too: it leaves room for the rounding of floats up to
// 2000 m, of which nothing is said.
const tolerance = kCollisionTolerance + (tightest ? 0 : kHullTolerance);
// Bodies nearer than mCollisionTolerance are "considered to be colliding", so those that touch are.
const touching = "contact";
const declares = (...answers) => ({ answers, tolerance, touching });
const tight_queries = {
  overlap: { declares: declares(), ask: overlap },
  distance: { declares: declares("distance", "normal", "witnesses"), ask: distance },
  penetration: { declares: declares("depth", "normal", "witnesses"), ask: penetration },
};

serve(
  {
    name: `jolt-${call}-${setting}`,
    version: "1.1.0",
    about: "Jolt by jolt-physics: NarrowPhaseQuery.CastShape, CastRay, CollideShape of a body and a shape",
    scalar: "float",
    shapes: ["sphere", "capsule", "box", "cylinder", "cone", "hull"],
    motion: "relative",
    lengths: [0.1, 2000],
    most_vertices: 256,
  },
  {
    cast: { declares: declares("time", "normal", "witnesses"), ask: cast },
    ray: { declares: { answers: ["time", "normal"] }, ask: ray },
    ...(tightest ? tight_queries : {}),
  });
