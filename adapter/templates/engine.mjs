// An engine in JavaScript, for Node: casts of balls. graze certify --engine "node engine.mjs"
//
// Put your own cast in the place of `cast`, and your shapes into `says`; docs/engines.md has every field.
import readline from 'node:readline';

const says = {
  schema: 'graze.engine/1', name: 'balls-javascript', scalar: 'double', shapes: ['sphere'],
  queries: { cast: { answers: ['time', 'normal'], relative_tolerance: 1e-7 } },
};

const dot = (x, y) => x[0] * y[0] + x[1] * y[1] + x[2] * y[2];

// The outcome of b moving past a, lengths in the question's unit, times in its t.
function cast(a, b, tMax) {
  const reach = a.shape.radius + b.shape.radius;
  const gap = b.position.map((x, i) => x - a.position[i]);
  const motion = b.displacement.map((v, i) => v - a.displacement[i]);
  const along = dot(gap, motion);
  const speed = dot(motion, motion);
  const apart = Math.hypot(...gap);
  if (apart <= reach) return { outcome: 'initially_overlapping' };
  // The squared distance of the centres is least at t = -along / speed; aside is what remains of the gap there.
  if (along >= 0) return { outcome: 'miss' };
  const aside = Math.hypot(...gap.map((x, i) => x - motion[i] * (along / speed)));
  if (aside > reach) return { outcome: 'miss' };
  const halfChord = Math.sqrt((reach - aside) * (reach + aside) * speed);
  const time = ((apart - reach) * (apart + reach)) / (halfChord - along);
  if (time > tMax) return { outcome: 'miss' };
  const normal = gap.map((x, i) => x + time * motion[i]);
  const length = Math.hypot(...normal);
  return { outcome: 'hit', time, normal: normal.map((x) => x / length) };
}

console.log(JSON.stringify(says));
for await (const line of readline.createInterface({ input: process.stdin })) {
  const q = JSON.parse(line);
  console.log(JSON.stringify({ schema: 'graze.answer/1', id: q.id, ...cast(q.a, q.b, q.t_max) }));
}
