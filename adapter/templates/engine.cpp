// An engine in C++: casts of balls. c++ -std=c++17 engine.cpp -o engine && graze certify --engine ./engine
//
// Put your own cast in the place of `cast`, and your shapes into `main`; docs/engines.md has every field.
#include <cmath>
#include <graze_adapter.hpp>

using namespace graze::adapter;

// Lengths in the question's unit, times in its t.
Answer cast(const Question& q) {
  const double reach = q.a.shape.radius + q.b.shape.radius;
  const Vector gap = q.b.position - q.a.position;
  const Vector motion = q.b.displacement - q.a.displacement;
  const double along = dot(gap, motion), speed = dot(motion, motion), apart = length(gap);
  if (apart <= reach) return Answer::overlapping();
  // The squared distance of the centres is least at t = -along / speed; aside is what remains of the gap there.
  if (along >= 0) return Answer::miss();
  const double aside = length(gap - (along / speed) * motion);
  if (aside > reach) return Answer::miss();
  const double half_chord = std::sqrt((reach - aside) * (reach + aside) * speed);
  const double time = (apart - reach) * (apart + reach) / (half_chord - along);
  if (time > q.t_max) return Answer::miss();
  Answer answer = Answer::hit(time);
  answer.normal = normalized(gap + time * motion);
  return answer;
}

int main() {
  Engine engine;
  engine.name = "balls-cpp";
  engine.shapes = {ShapeType::sphere};
  engine.queries[Query::cast].answers = {"time", "normal"};
  engine.queries[Query::cast].relative_tolerance = 1e-7;
  return serve(engine, cast);
}
