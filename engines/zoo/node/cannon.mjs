// cannon-es: contacts of two bodies, and rays. It casts no shapes.
//
//   overlap       Narrowphase.getContacts: whether there is a contact
//   penetration   Narrowphase.getContacts: the deepest of the contacts
//   ray           Ray.intersectBody
//
// No call takes a tolerance, so that the default is the tightest setting, too. Its convex polyhedra want faces, which a
// question does not give, and its cylinders are prisms; so it is asked about spheres and boxes alone. Nothing is promised
// of errors, of touching, nor of rays that start inside.
//
// The gap of a contact is (x_j + r_j - x_i - r_i) . n_i, of bodies at x_i and x_j, n_i from i to j; the narrow phase takes
// the bodies in an order of its own.

import { Body, Box, Quaternion, Ray, RaycastResult, Sphere, Vec3, World } from "cannon-es";
import { add, dot, negated, scaled, subtract } from "./geometry.mjs";
import { option, serve, Unsupported } from "./protocol.mjs";

const call = option("call", ["getContacts"]);
const setting = option("setting", ["default"]);

const world = new World();
const array = (v) => [v.x, v.y, v.z];

function shape_of(shape) {
  switch (shape.type) {
    case "sphere":
      return new Sphere(shape.radius);
    case "box":
      return new Box(new Vec3(...shape.half_extents));
    default:
      throw new Unsupported(`no shape ${shape.type}`);
  }
}

function body_of({ shape, position, orientation: [w, x, y, z] }) {
  return new Body({
    mass: 1, shape: shape_of(shape), position: new Vec3(...position), quaternion: new Quaternion(x, y, z, w),
  });
}

const contacts = (read) => ({ a, b }) => {
  const body_a = body_of(a);
  const body_b = body_of(b);
  return {
    run: () => {
      const found = [];
      world.narrowphase.getContacts([body_a], [body_b], world, found, [], [], []);
      return found;
    },
    read: (found) => read(found.map((contact) => oriented(contact, body_a))),
  };
};

// A contact with its normal from A to B, and its points in world axes.
function oriented({ bi, bj, ri, rj, ni }, body_a) {
  const point_i = add(array(bi.position), array(ri));
  const point_j = add(array(bj.position), array(rj));
  const gap = dot(subtract(point_j, point_i), array(ni));
  return bi === body_a ? { gap, normal: array(ni), point_a: point_i, point_b: point_j }
    : { gap, normal: negated(array(ni)), point_a: point_j, point_b: point_i };
}

const overlap = contacts((found) => ({ outcome: found.length > 0 ? "initially_overlapping" : "miss" }));

const penetration = contacts((found) => {
  if (found.length === 0) return { outcome: "miss" };
  const { gap, ...contact } = found.reduce((deepest, other) => (other.gap < deepest.gap ? other : deepest));
  return { outcome: "initially_overlapping", depth: Math.max(0, -gap), ...contact };
});

function ray({ a, origin, direction, t_max }) {
  const body = body_of(a);
  body.aabbNeedsUpdate = true;
  const end = add(origin, scaled(t_max, direction));
  return {
    run: () => {
      const line = new Ray(new Vec3(...origin), new Vec3(...end));
      line.mode = Ray.CLOSEST;
      const result = new RaycastResult();
      line.intersectBody(body, result);
      return result;
    },
    read: (result) => {
      if (!result.hasHit) return { outcome: "miss" };
      const time = dot(subtract(array(result.hitPointWorld), origin), direction) / dot(direction, direction);
      if (time <= 0) return { outcome: "initially_overlapping" };
      return { outcome: "hit", time, normal: array(result.hitNormalWorld) };
    },
  };
}

serve(
  {
    name: `cannon-${call}-${setting}`,
    version: "0.20.0",
    about: "cannon-es: Narrowphase.getContacts of two bodies, Ray.intersectBody",
    scalar: "double",
    shapes: ["sphere", "box"],
  },
  {
    ray: { declares: { answers: ["time", "normal"], starts: false, touching: "either" }, ask: ray },
    overlap: { declares: { answers: [], touching: "either" }, ask: overlap },
    penetration: { declares: { answers: ["depth", "normal", "witnesses"], touching: "either" }, ask: penetration },
  });
