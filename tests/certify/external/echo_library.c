/* Answers every question with a hash of all that it was told: two ways of telling the same get the same answer. */
#include <graze_engine.h>
#include <stdint.h>

const char* graze_engine_describe(void) {
  return "{\"schema\": \"graze.engine/1\", \"name\": \"echo\", \"scalar\": \"double\", \"infinite_t_max\": true, "
         "\"shapes\": [\"point\", \"segment\", \"triangle\", \"sphere\", \"capsule\", \"cylinder\", \"cone\", \"box\", "
         "\"ellipsoid\", \"hull\", \"posed\", \"rounded\", \"sum\", \"hull_of\"], \"queries\": {"
         "\"cast\": {\"answers\": [\"time\", \"normal\", \"witnesses\"], \"target_distance\": true, \"pass_over\": true}, "
         "\"rotating_cast\": {\"answers\": [\"time\"]}, \"ray\": {\"answers\": [\"time\"]}, "
         "\"distance\": {\"answers\": [\"distance\"]}, \"penetration\": {\"answers\": [\"depth\"]}}}";
}

static void bytes(uint64_t* hash, const void* from, size_t size) {
  for (size_t i = 0; i < size; ++i) *hash = (*hash ^ ((const unsigned char*)from)[i]) * 1099511628211u;
}

static void shape(uint64_t* hash, const graze_engine_shape* s) {
  const uint64_t counts[3] = {(uint64_t)s->type, s->vertex_count, s->part_count};
  bytes(hash, counts, sizeof counts);
  bytes(hash, &s->radius, sizeof s->radius);
  bytes(hash, &s->half_height, sizeof s->half_height);
  bytes(hash, s->half_extents, sizeof s->half_extents);
  bytes(hash, s->radii, sizeof s->radii);
  bytes(hash, s->position, sizeof s->position);
  bytes(hash, s->orientation, sizeof s->orientation);
  bytes(hash, s->vertices, 3 * sizeof(double) * s->vertex_count);
  for (size_t i = 0; i < s->part_count; ++i) shape(hash, &s->parts[i]);
}

static void body(uint64_t* hash, const graze_engine_body* b) {
  shape(hash, &b->shape);
  bytes(hash, b->position, sizeof b->position);
  bytes(hash, b->orientation, sizeof b->orientation);
  bytes(hash, b->displacement, sizeof b->displacement);
  bytes(hash, b->rotation, sizeof b->rotation);
  bytes(hash, b->pivot, sizeof b->pivot);
}

static double heard(const graze_engine_question* q) {
  uint64_t hash = 14695981039346656037u;
  const uint64_t words[2] = {(uint64_t)q->query, (uint64_t)q->pass_over};
  bytes(&hash, words, sizeof words);
  body(&hash, &q->a);
  body(&hash, &q->b);
  bytes(&hash, q->origin, sizeof q->origin);
  bytes(&hash, q->direction, sizeof q->direction);
  bytes(&hash, &q->t_max, sizeof q->t_max);
  bytes(&hash, &q->target_distance, sizeof q->target_distance);
  return (double)(hash >> 11) / 9007199254740992.0;
}

graze_engine_outcome graze_engine_cast(const graze_engine_question* q, void* prepared, graze_engine_answer* out) {
  const double h = heard(q);
  (void)prepared;
  out->time = h / 2;
  out->time_upper = h;
  out->normal[0] = out->normal[2] = 0;
  out->normal[1] = h < 0.5 ? -1 : 1;
  for (int i = 0; i < 3; ++i) {
    out->point_a[i] = h + i;
    out->point_b[i] = h - i;
  }
  return GRAZE_ENGINE_HIT;
}
graze_engine_outcome graze_engine_rotating_cast(const graze_engine_question* q, void* prepared, graze_engine_answer* out) {
  (void)prepared;
  out->time = heard(q);
  return GRAZE_ENGINE_HIT;
}
graze_engine_outcome graze_engine_ray(const graze_engine_question* q, void* prepared, graze_engine_answer* out) {
  return graze_engine_rotating_cast(q, prepared, out);
}
graze_engine_outcome graze_engine_distance(const graze_engine_question* q, void* prepared, graze_engine_answer* out) {
  (void)prepared;
  out->distance = heard(q);
  return GRAZE_ENGINE_MISS;
}
graze_engine_outcome graze_engine_penetration(const graze_engine_question* q, void* prepared, graze_engine_answer* out) {
  (void)prepared;
  out->depth = heard(q);
  return GRAZE_ENGINE_INITIALLY_OVERLAPPING;
}
