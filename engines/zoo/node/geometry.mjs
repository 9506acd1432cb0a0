// Vectors are arrays of three numbers; quaternions are w, x, y, z; all in double, as JavaScript's numbers are.

export const kZero = [0, 0, 0];

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (s, a) => [s * a[0], s * a[1], s * a[2]];
export const negated = (a) => [-a[0], -a[1], -a[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const norm = (a) => Math.hypot(a[0], a[1], a[2]);

// a, made a unit vector; a itself where it has no direction, which the judge then sees.
export function normalized(a) {
  const length = norm(a);
  return length > 0 && Number.isFinite(length) ? scaled(1 / length, a) : a;
}

export function product(p, q) {
  const [a, b, c, d] = p;
  const [w, x, y, z] = q;
  return [
    a * w - b * x - c * y - d * z,
    a * x + b * w + c * z - d * y,
    a * y - b * z + c * w + d * x,
    a * z + b * y - c * x + d * w,
  ];
}

export const conjugate = (q) => [q[0], -q[1], -q[2], -q[3]];

// x -> q x conj(q) / |q|^2.
export function rotated(q, x) {
  const u = [q[1], q[2], q[3]];
  const t = scaled(2 / (q[0] * q[0] + dot(u, u)), cross(u, x));
  return add(add(x, scaled(q[0], t)), cross(u, t));
}

export const unrotated = (q, x) => rotated(conjugate(q), x);

// Turns of 120 degrees, which only permute the axes: no coordinate is rounded, and of a quaternion q * turn no
// component but by the last bit of a sum of four. Engines whose capsules, cylinders and cones lie along y or x take them.
export const kYToZ = [0.5, 0.5, 0.5, 0.5];
export const kXToZ = [0.5, -0.5, -0.5, -0.5];

// World axes of `body` at time t, of a point of its own frame.
export function to_world(body, point, t = 0) {
  return add(add(rotated(body.orientation, point), body.position), scaled(t, body.displacement));
}

// A bound on the distance of the points of a shape from the origin of its frame.
export function bounding_radius(shape) {
  switch (shape.type) {
    case "point":
      return 0;
    case "segment":
      return Math.max(norm(shape.a), norm(shape.b));
    case "triangle":
      return Math.max(norm(shape.a), norm(shape.b), norm(shape.c));
    case "sphere":
      return shape.radius;
    case "capsule":
      return shape.radius + shape.half_height;
    case "box":
      return norm(shape.half_extents);
    case "ellipsoid":
      return Math.max(...shape.radii);
    case "cylinder":
    case "cone":
      return Math.hypot(shape.radius, shape.half_height);
    case "hull":
      return shape.vertices.reduce((most, vertex) => Math.max(most, norm(vertex)), 0);
    case "rounded":
      return shape.radius + bounding_radius(shape.shape);
    case "posed":
      return norm(shape.position) + bounding_radius(shape.shape);
    case "sum":
      return shape.shapes.reduce((sum, part) => sum + bounding_radius(part), 0);
    default:
      return Math.max(...shape.shapes.map(bounding_radius));
  }
}
