// A cast of balls, with bugs as they occur: a root that is taken for the other, a normal with its sign wrong, an assertion.
#include <cmath>
#include <cstdlib>
#include <graze_adapter.hpp>

using namespace graze::adapter;

Answer cast(const Question& q) {
  const double reach = q.a.shape.radius + q.b.shape.radius;
  const Vector gap = q.b.position - q.a.position;
  const Vector motion = q.b.displacement - q.a.displacement;
  const double along = dot(gap, motion), speed = dot(motion, motion), apart = length(gap);
  if (apart <= reach) return Answer::overlapping();
  if (along >= 0) return Answer::miss();
  const double aside = length(gap - (along / speed) * motion);
  if (aside > reach) return Answer::miss();
  const double half_chord = std::sqrt((reach - aside) * (reach + aside) * speed);
  double time = (apart - reach) * (apart + reach) / (half_chord - along);
  if (time > q.t_max) return Answer::miss();
#if defined(IS_falling)
  std::abort();
#elif defined(IS_late)
  time = std::fmin(q.t_max, (half_chord - along) / speed);
#endif
  Answer answer = Answer::hit(time);
  answer.normal = normalized(gap + time * motion);
#if defined(IS_flipped)
  answer.normal = -*answer.normal;
#endif
  return answer;
}

int main() {
  Engine engine;
  engine.name = "theirs";
  engine.shapes = {ShapeType::sphere};
  engine.queries[Query::cast].answers = {"time", "normal"};
  return serve(engine, cast);
}
