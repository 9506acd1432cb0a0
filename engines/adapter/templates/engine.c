/* An engine in C, a shared library: casts of balls.
 *   cc -shared -fPIC engine.c -o engine.so -lm && graze certify --engine ./engine.so
 *
 * To change: 1. graze_engine_cast calls your engine, 2. graze_engine_describe names your shapes and what you promise.
 * docs/reference/protocol.md has every field. */
#include <graze_engine.h>
#include <math.h>

/* 2. "shapes": ["sphere", "capsule", "box", "hull"] */
const char* graze_engine_describe(void) {
  return "{\"schema\": \"graze.engine/1\", \"name\": \"balls-c\", \"scalar\": \"double\", \"shapes\": "
         "[\"sphere\"], "
         "\"queries\": {\"cast\": {\"answers\": [\"time\", \"normal\"], \"relative_tolerance\": 1e-7}}}";
}

static double dot(const double x[3], const double y[3]) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

/* What a shape holds, in its body's frame; the body stands at `position`, turned by `orientation` (w, x, y, z). */
static int is_ball(const graze_engine_shape* shape) {
  switch (shape->type) {
    case GRAZE_ENGINE_SPHERE: /* radius */
      return 1;
    case GRAZE_ENGINE_CAPSULE: /* radius, half_height: within radius of the segment to +-half_height on z */
    case GRAZE_ENGINE_BOX:     /* half_extents */
    case GRAZE_ENGINE_HULL:    /* vertices, 3 numbers each, vertex_count of them */
    default:                   /* graze_engine.h says the others */
      return 0;
  }
}

/* Lengths in the question's unit, times in its t. */
graze_engine_outcome graze_engine_cast(const graze_engine_question* q, void* prepared,
                                       graze_engine_answer* out) {
  /* 1. Your engine, by q->a and q->b: shape, position, orientation and displacement, and q->t_max. What follows casts
   * balls. */
  if (!is_ball(&q->a.shape) || !is_ball(&q->b.shape)) return GRAZE_ENGINE_UNSUPPORTED;
  const double reach = q->a.shape.radius + q->b.shape.radius;
  double gap[3], motion[3], rest[3];
  (void)prepared;
  for (int i = 0; i < 3; ++i) {
    gap[i] = q->b.position[i] - q->a.position[i];
    motion[i] = q->b.displacement[i] - q->a.displacement[i];
  }
  const double along = dot(gap, motion), speed = dot(motion, motion), apart = sqrt(dot(gap, gap));
  if (apart <= reach) return GRAZE_ENGINE_INITIALLY_OVERLAPPING;
  /* The squared distance of the centres is least at t = -along / speed; rest is what remains of the gap there. */
  if (along >= 0) return GRAZE_ENGINE_MISS;
  for (int i = 0; i < 3; ++i) rest[i] = gap[i] - along / speed * motion[i];
  const double aside = sqrt(dot(rest, rest));
  if (aside > reach) return GRAZE_ENGINE_MISS;
  const double half_chord = sqrt((reach - aside) * (reach + aside) * speed);
  out->time = (apart - reach) * (apart + reach) / (half_chord - along);
  if (out->time > q->t_max) return GRAZE_ENGINE_MISS;
  /* The gap at `time`, of two perpendicular parts: gap + time * motion would cancel where the bodies come from afar. */
  for (int i = 0; i < 3; ++i) rest[i] -= half_chord / speed * motion[i];
  const double length = sqrt(dot(rest, rest));
  /* Points that meet leave no gap. */
  for (int i = 0; i < 3; ++i) out->normal[i] = length > 0 ? rest[i] / length : -motion[i] / sqrt(speed);
  return GRAZE_ENGINE_HIT;
}
