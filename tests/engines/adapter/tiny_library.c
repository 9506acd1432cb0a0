/* An engine in C behind graze_engine.h: distances of balls and extents of hulls, with everything that is optional. */
#include <graze_engine.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char* graze_engine_describe(void) {
  puts("libraries print, too");
  return "{\"schema\": \"graze.engine/1\", \"name\": \"tiny-c\", \"scalar\": \"double\", \"shapes\": [\"sphere\", "
         "\"hull\", \"sum\"], \"queries\": {\"distance\": {\"answers\": [\"distance\", \"normal\", \"witnesses\"]}, "
         "\"penetration\": {\"answers\": [\"depth\"]}, \"ray\": {\"answers\": [\"time\"]}}, \"timed\": true}";
}

/* Prepared: the gap of two balls. */
void* graze_engine_begin(const graze_engine_question* q) {
  double* gap = malloc(sizeof *gap);
  double squares = 0;
  for (int i = 0; i < 3; ++i) squares += pow(q->b.position[i] - q->a.position[i], 2);
  *gap = sqrt(squares) - q->a.shape.radius - q->b.shape.radius;
  return gap;
}
void graze_engine_end(void* prepared) { free(prepared); }

graze_engine_outcome graze_engine_distance(const graze_engine_question* q, void* prepared, graze_engine_answer* out) {
  const double gap = *(const double*)prepared;
  if (q->a.shape.type == GRAZE_ENGINE_SUM) { /* of a ball of radius 0.5 and a hull: says what it was given */
    const graze_engine_shape* hull = &q->a.shape.parts[1];
    snprintf(out->message, sizeof out->message, "%zu parts, radius %g, %zu vertices, last z %g", q->a.shape.part_count,
             q->a.shape.parts[0].radius, hull->vertex_count, hull->vertices[3 * hull->vertex_count - 1]);
    return GRAZE_ENGINE_NOT_CONVERGED;
  }
  if (gap <= 0) return GRAZE_ENGINE_INITIALLY_OVERLAPPING;
  out->distance = gap * (1 - 1e-15);
  out->distance_upper = gap;
  for (int i = 0; i < 3; ++i) {
    out->normal[i] = (q->b.position[i] - q->a.position[i]) / (gap + q->a.shape.radius + q->b.shape.radius);
    out->point_a[i] = q->a.position[i] + q->a.shape.radius * out->normal[i];
    out->point_b[i] = q->b.position[i] - q->b.shape.radius * out->normal[i];
  }
  return GRAZE_ENGINE_MISS;
}

/* Forgets its depth. */
graze_engine_outcome graze_engine_penetration(const graze_engine_question* q, void* prepared, graze_engine_answer* out) {
  (void)q;
  (void)prepared;
  (void)out;
  return GRAZE_ENGINE_INITIALLY_OVERLAPPING;
}
