// An engine in JavaScript, for Node: casts of balls. graze certify --engine "node engine.mjs"
//
// To change: 1. `cast` calls your engine, 2. `says` names your shapes and what you promise. docs/reference/protocol.md has every field.
import readline from 'node:readline';

// 2. shapes: ['sphere', 'capsule', 'box', 'hull']
const says = {
  schema: 'graze.engine/1', name: 'balls-javascript', scalar: 'double', shapes: ['sphere'],
  queries: { cast: { answers: ['time', 'normal'], relative_tolerance: 1e-7 } },
};

const dot = (x, y) => x[0] * y[0] + x[1] * y[1] + x[2] * y[2];

const cross = (x, y) => [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];

// x turned by the quaternion w, x, y, z.
function turned([w, ...axis], x) {
  const side = cross(axis, x).map((c) => 2 * c);
  const rest = cross(axis, side);
  return x.map((c, i) => c + w * side[i] + rest[i]);
}

// A body at t = 0, in world axes: the hull of points, rounded by a radius. Cylinders, cones and ellipsoids are not of this
// form, and come with radius and half_height (their axis is z) or with radii.
function formOf({ shape, position, orientation }) {
  const points = {
    sphere: () => [[0, 0, 0]],
    capsule: () => [[0, 0, -shape.half_height], [0, 0, shape.half_height]],
    box: () => [0, 1, 2, 3, 4, 5, 6, 7].map((k) => shape.half_extents.map((h, i) => ((k >> i) & 1 ? h : -h))),
    hull: () => shape.vertices,
  }[shape.type] ?? (() => []);
  return {
    points: points().map((point) => turned(orientation, point).map((x, i) => position[i] + x)),
    radius: shape.radius ?? 0,
  };
}

// The outcome of b moving past a, lengths in the question's unit, times in its t.
function cast(a, b, tMax) {
  const [one, two] = [formOf(a), formOf(b)];
  // 1. Your engine, by these, a.displacement, b.displacement and tMax. What follows casts balls.
  if (one.points.length !== 1 || two.points.length !== 1) return { outcome: 'unsupported' };
  const reach = one.radius + two.radius;
  const gap = two.points[0].map((x, i) => x - one.points[0][i]);
  const motion = b.displacement.map((v, i) => v - a.displacement[i]);
  const along = dot(gap, motion);
  const speed = dot(motion, motion);
  const apart = Math.hypot(...gap);
  if (apart <= reach) return { outcome: 'initially_overlapping' };
  // The squared distance of the centres is least at t = -along / speed; rest is what remains of the gap there.
  if (along >= 0) return { outcome: 'miss' };
  const rest = gap.map((x, i) => x - motion[i] * (along / speed));
  const aside = Math.hypot(...rest);
  if (aside > reach) return { outcome: 'miss' };
  const halfChord = Math.sqrt((reach - aside) * (reach + aside) * speed);
  const time = ((apart - reach) * (apart + reach)) / (halfChord - along);
  if (time > tMax) return { outcome: 'miss' };
  // The gap at `time`, of two perpendicular parts: gap + time * motion would cancel where the bodies come from afar.
  const touching = rest.map((x, i) => x - motion[i] * (halfChord / speed));
  const normal = touching.some((x) => x !== 0) ? touching : motion.map((v) => -v); // points that meet leave no gap
  const length = Math.hypot(...normal);
  return { outcome: 'hit', time, normal: normal.map((x) => x / length) };
}

console.log(JSON.stringify(says));
for await (const line of readline.createInterface({ input: process.stdin })) {
  const q = JSON.parse(line);
  console.log(JSON.stringify({ schema: 'graze.answer/1', id: q.id, ...cast(q.a, q.b, q.t_max) }));
}
