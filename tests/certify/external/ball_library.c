/* Casts of balls behind graze_engine.h; falls at balls whose radius is 13, and hangs at those whose is 17. */
#include <graze_engine.h>
#include <math.h>
#include <stdlib.h>

const char* graze_engine_describe(void) {
  return "{\"schema\": \"graze.engine/1\", \"name\": \"balls-c\", \"scalar\": \"double\", \"shapes\": [\"sphere\"], \"timed\": true, "
         "\"queries\": {\"cast\": {\"answers\": [\"time\", \"normal\"], \"relative_tolerance\": 1e-9}}}";
}

graze_engine_outcome graze_engine_cast(const graze_engine_question* q, void* prepared, graze_engine_answer* out) {
  const double reach = q->a.shape.radius + q->b.shape.radius;
  double gap[3], v[3], c = -reach * reach, b = 0, vv = 0;
  (void)prepared;
  if (q->b.shape.radius == 13) abort();
  for (volatile int on = q->b.shape.radius == 17; on;) {
  }
  for (int i = 0; i < 3; ++i) {
    gap[i] = q->b.position[i] - q->a.position[i];
    v[i] = q->b.displacement[i] - q->a.displacement[i];
    c += gap[i] * gap[i];
    b += gap[i] * v[i];
    vv += v[i] * v[i];
  }
  if (c <= 0) return GRAZE_ENGINE_INITIALLY_OVERLAPPING;
  const double discriminant = b * b - vv * c;
  if (b >= 0 || discriminant < 0) return GRAZE_ENGINE_MISS;
  out->time = c / (-b + sqrt(discriminant));
  if (out->time > q->t_max) return GRAZE_ENGINE_MISS;
  for (int i = 0; i < 3; ++i) out->normal[i] = (gap[i] + out->time * v[i]) / reach;
  return GRAZE_ENGINE_HIT;
}
