// An engine in a page: balls in flight, by the quadratic. It also prints on standard output, as libraries do.
#include <graze_adapter.hpp>

#include <cmath>
#include <cstdio>

using namespace graze::adapter;

namespace {

Answer cast(const Question& q) {
  if (q.b.shape.type != ShapeType::sphere) return Answer::unsupported("a ball is wanted");
  std::printf("this goes to standard error\n");
  const double reach = q.a.shape.radius + q.b.shape.radius;
  const Vector gap = q.b.position - q.a.position;
  const Vector v = q.b.displacement - q.a.displacement;
  const double c = dot(gap, gap) - reach * reach;
  if (c <= 0) return Answer::overlapping();
  const double b = dot(gap, v);
  const double discriminant = b * b - dot(v, v) * c;
  if (b >= 0 || discriminant < 0) return Answer::miss();
  const double time = c / (-b + std::sqrt(discriminant));
  if (time > q.t_max) return Answer::miss();
  Answer answer = Answer::hit(time);
  answer.normal = normalized(gap + time * v);
  return answer;
}

}  // namespace

int main() {
  Engine engine;
  engine.name = "tiny";
  engine.shapes = {ShapeType::sphere};
  engine.queries[Query::cast].answers = {"time", "normal"};
  engine.timed = true;
  return serve(engine, cast);
}
