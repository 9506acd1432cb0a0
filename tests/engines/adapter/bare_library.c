/* A library that says nothing of itself: one function. */
#include <graze_engine.h>

graze_engine_outcome graze_engine_cast(const graze_engine_question* q, void* prepared, graze_engine_answer* out) {
  out->time = q->t_max / 2;
  return prepared == NULL ? GRAZE_ENGINE_HIT : GRAZE_ENGINE_MISS;
}
