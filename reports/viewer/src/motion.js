// Where bodies are: in doubles, about a place of the scene and in its own unit, so that what is drawn near that place
// keeps its digits at any magnification.

export const add = (x, y) => [x[0] + y[0], x[1] + y[1], x[2] + y[2]];
export const sub = (x, y) => [x[0] - y[0], x[1] - y[1], x[2] - y[2]];
export const times = (s, x) => [s * x[0], s * x[1], s * x[2]];
export const dot = (x, y) => x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
export const cross = (x, y) => [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
export const norm = (x) => Math.hypot(x[0], x[1], x[2]);
export const unit = (x) => {
  const most = Math.max(Math.abs(x[0]), Math.abs(x[1]), Math.abs(x[2]));
  if (!(most > 0)) return [0, 0, 0];
  const y = times(1 / most, x);
  return times(1 / norm(y), y);
};
// Two unit vectors across n, right-handed with it.
export function across(n) {
  const first = unit(cross(n, Math.abs(n[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0]));
  return [first, cross(n, first)];
}

// Matrices are three rows.
export const apply = (m, x) => [dot(m[0], x), dot(m[1], x), dot(m[2], x)];
function multiply(l, r) {
  const columns = [0, 1, 2].map((j) => [r[0][j], r[1][j], r[2][j]]);
  return l.map((row) => columns.map((column) => dot(row, column)));
}
function ofQuaternion([w, x, y, z]) {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}
// R(w): by |w| radians about w.
export function turnBy(w) {
  const angle = norm(w);
  if (!(angle > 0)) return [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const s = Math.sin(angle / 2) / angle;
  return ofQuaternion([Math.cos(angle / 2), s * w[0], s * w[1], s * w[2]]);
}

// {rotation, position}: of a body of a scene at time t, places about the scene's origin.
export function poseAt(body, t) {
  const first = ofQuaternion(body.orientation);
  const turn = turnBy(times(t, body.rotation));
  const middle = add(body.position, apply(first, body.pivot));
  return {
    rotation: multiply(turn, first),
    position: add(add(apply(turn, sub(body.position, middle)), middle), times(t, body.displacement)),
  };
}
export const place = (pose, x) => add(apply(pose.rotation, x), pose.position);
export const moves = (body) => norm(body.displacement) > 0 || norm(body.rotation) > 0;
// x of a body placed at `pose`, in the body's frame.
export function inBody(pose, x) {
  const y = sub(x, pose.position);
  return [0, 1, 2].map((j) => pose.rotation[0][j] * y[0] + pose.rotation[1][j] * y[1] + pose.rotation[2][j] * y[2]);
}
