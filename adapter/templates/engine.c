/* An engine in C, a shared library: casts of balls.
 *   cc -shared -fPIC engine.c -o engine.so -lm && graze certify --engine ./engine.so
 *
 * Put your own cast in the place of graze_engine_cast, and your shapes into graze_engine_describe; docs/engines.md has
 * every field. */
#include <graze_engine.h>
#include <math.h>

const char* graze_engine_describe(void) {
  return "{\"schema\": \"graze.engine/1\", \"name\": \"balls-c\", \"scalar\": \"double\", \"shapes\": "
         "[\"sphere\"], "
         "\"queries\": {\"cast\": {\"answers\": [\"time\", \"normal\"], \"relative_tolerance\": 1e-7}}}";
}

static double dot(const double x[3], const double y[3]) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

/* Lengths in the question's unit, times in its t. */
graze_engine_outcome graze_engine_cast(const graze_engine_question* q, void* prepared,
                                       graze_engine_answer* out) {
  const double reach = q->a.shape.radius + q->b.shape.radius;
  double gap[3], motion[3], rest[3];
  (void)prepared;
  for (int i = 0; i < 3; ++i) {
    gap[i] = q->b.position[i] - q->a.position[i];
    motion[i] = q->b.displacement[i] - q->a.displacement[i];
  }
  const double along = dot(gap, motion), speed = dot(motion, motion), apart = sqrt(dot(gap, gap));
  if (apart <= reach) return GRAZE_ENGINE_INITIALLY_OVERLAPPING;
  /* The squared distance of the centres is least at t = -along / speed; aside is what remains of the gap there. */
  if (along >= 0) return GRAZE_ENGINE_MISS;
  for (int i = 0; i < 3; ++i) rest[i] = gap[i] - along / speed * motion[i];
  const double aside = sqrt(dot(rest, rest));
  if (aside > reach) return GRAZE_ENGINE_MISS;
  const double half_chord = sqrt((reach - aside) * (reach + aside) * speed);
  out->time = (apart - reach) * (apart + reach) / (half_chord - along);
  if (out->time > q->t_max) return GRAZE_ENGINE_MISS;
  for (int i = 0; i < 3; ++i) rest[i] = gap[i] + out->time * motion[i];
  const double length = sqrt(dot(rest, rest));
  for (int i = 0; i < 3; ++i) out->normal[i] = rest[i] / length;
  return GRAZE_ENGINE_HIT;
}
