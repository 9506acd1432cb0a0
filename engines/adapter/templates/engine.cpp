// An engine in C++: casts of balls. c++ -std=c++17 engine.cpp -o engine && graze certify --engine ./engine
// (with -I and the folder of graze_adapter.hpp where graze is not installed)
//
// To change: 1. `cast` calls your engine, 2. `main` names your shapes and what you promise. docs/reference/protocol.md has every field.
#include <cmath>
#include <graze_adapter.hpp>

using namespace graze::adapter;

// A body at t = 0, in world axes: the hull of points, rounded by a radius. Cylinders, cones and ellipsoids are not of this
// form, and come with radius and half_height (their axis is z) or with radii.
struct Form {
  std::vector<Vector> points;
  double radius = 0;
};

Form form_of(const Body& body) {
  const Shape& shape = body.shape;
  Form form{vertices_of(shape)};  // point, segment, triangle, box, hull
  if (shape.type == ShapeType::sphere) form = {{Vector{}}, shape.radius};
  if (shape.type == ShapeType::capsule)
    form = {{{0, 0, -shape.half_height}, {0, 0, shape.half_height}}, shape.radius};
  for (Vector& point : form.points) point = body.position + rotate(body.orientation, point);
  return form;
}

// Lengths in the question's unit, times in its t.
Answer cast(const Question& q) {
  const Form a = form_of(q.a), b = form_of(q.b);
  // 1. Your engine, by a, b, q.a.displacement, q.b.displacement and q.t_max. The code below casts balls.
  if (a.points.size() != 1 || b.points.size() != 1) return Answer::unsupported("this template casts balls");
  const double reach = a.radius + b.radius;
  const Vector gap = b.points[0] - a.points[0];
  const Vector motion = q.b.displacement - q.a.displacement;
  const double along = dot(gap, motion), speed = dot(motion, motion), apart = length(gap);
  if (apart <= reach) return Answer::overlapping();
  // The squared distance of the centres is least at t = -along / speed. `rest` is the part of the gap that remains
  // there.
  if (along >= 0) return Answer::miss();
  const Vector rest = gap - (along / speed) * motion;
  const double aside = length(rest);
  if (aside > reach) return Answer::miss();
  const double half_chord = std::sqrt((reach - aside) * (reach + aside) * speed);
  const double time = (apart - reach) * (apart + reach) / (half_chord - along);
  if (time > q.t_max) return Answer::miss();
  Answer answer = Answer::hit(time);
  // The gap at `time`, of two perpendicular parts: gap + time * motion would cancel where the bodies come from afar.
  const Vector touching = rest - (half_chord / speed) * motion;
  answer.normal = normalized(length(touching) > 0 ? touching : -1 * motion);  // points that meet leave no gap
  return answer;
}

int main() {
  Engine engine;
  // 2. {ShapeType::sphere, ShapeType::capsule, ShapeType::box, ShapeType::hull, ...}
  engine.name = "balls-cpp";
  engine.shapes = {ShapeType::sphere};
  engine.queries[Query::cast].answers = {"time", "normal"};
  engine.queries[Query::cast].relative_tolerance = 1e-7;
  return serve(engine, cast);
}
