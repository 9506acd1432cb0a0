// Box2D under the judge, where a question lies in the plane z = 0, as its users call it, in float.
//
//   --call toi         b2TimeOfImpact, and b2Distance at that time     cast, rotating_cast
//          shape-cast  b2ShapeCast                                      cast
//          distance    b2Distance                                       overlap, distance
//   --setting default
//
// A question lies in the plane if three conditions hold:
// - both bodies are upright prisms: boxes, hulls with all vertices in two planes z = c and the same outline in both,
//   and for distances also cylinders
// - nothing moves along z, and all rotation is about z
// - their extents in z overlap
// Then the outlines touch when the bodies do. Everything else is unsupported.
//
// Box2D documents
// - b2_linearSlop, 0.005, as "a small length used as a collision and constraint tolerance" (b2_common.h): `tolerance` of
//   its casts
// - moving shapes between 0.1 and 10 metres (manual, "Units"): `lengths`
// - that b2TimeOfImpact "may miss some intermediate, non-tunneling collisions" (b2_time_of_impact.h)
// - that b2ShapeCast gives no hit for an initial overlap (b2_distance.h): `starts` false
// Its polygons keep apart by design: b2TimeOfImpact ends at a distance of b2_linearSlop, b2ShapeCast at one of
// b2_polygonRadius: `margin`. Circles have other distances, so they are not cast.
//
// b2ShapeCast moves B alone: `motion` relative. Its normal points from A to B, its time is a fraction of the motion.
#include <box2d/b2_distance.h>
#include <box2d/b2_settings.h>
#include <box2d/b2_time_of_impact.h>
#include <graze_adapter.hpp>

#include <algorithm>
#include <memory>
#include <set>

#include "engines/zoo/arguments.hpp"

namespace graze::zoo {
namespace {

using namespace adapter;

b2Vec2 flat(const Vector& x) { return {float(x[0]), float(x[1])}; }

// A prism's outline in its own frame, and its extent in world z.
struct Prism {
  std::vector<b2Vec2> outline;
  float radius = 0;
  double low = 0, high = 0;
};

bool about_z(const Quaternion& q) { return q.x == 0 && q.y == 0; }
double angle_of(const Quaternion& q) { return 2 * std::atan2(q.z, q.w); }

// Null if the body is not an upright prism that stays in its plane.
std::shared_ptr<Prism> prism_of(const Body& body) {
  const Shape& shape = body.shape;
  const Vector& turn = body.rotation;
  if (!about_z(body.orientation) || turn[0] != 0 || turn[1] != 0 || body.displacement[2] != 0) return nullptr;
  auto out = std::make_shared<Prism>();
  if (shape.type == ShapeType::cylinder) {
    out->outline = {{0, 0}};
    out->radius = float(shape.radius);
    out->low = body.position[2] - shape.half_height;
    out->high = body.position[2] + shape.half_height;
    return out;
  }
  const std::vector<Vector> vertices = vertices_of(shape);
  double low = vertices.front()[2];
  double high = low;
  for (const Vector& x : vertices) {
    low = std::min(low, x[2]);
    high = std::max(high, x[2]);
  }
  std::set<std::pair<double, double>> below, above;
  for (const Vector& x : vertices) {
    if (x[2] != low && x[2] != high) return nullptr;
    (x[2] == low ? below : above).insert({x[0], x[1]});
  }
  if (below != above) return nullptr;
  for (const auto& [x, y] : below) out->outline.emplace_back(float(x), float(y));
  out->low = body.position[2] + low;
  out->high = body.position[2] + high;
  return out;
}

struct Pair {
  std::shared_ptr<Prism> a, b;
  Body body_a, body_b;
  double t_max, z = 0;  // z: of a plane that cuts both

  explicit Pair(const Question& q)
      : a(prism_of(q.a)), b(prism_of(q.b)), body_a(q.a), body_b(q.b), t_max(q.t_max) {
    if (planar()) z = (std::max(a->low, b->low) + std::min(a->high, b->high)) / 2;
  }
  [[nodiscard]] bool planar() const {
    return a && b && std::max(a->low, b->low) < std::min(a->high, b->high);
  }
};

b2DistanceProxy proxy_of(const Prism& prism, float radius) {
  b2DistanceProxy out;
  out.Set(prism.outline.data(), int32(prism.outline.size()), radius);
  return out;
}

b2Transform transform_of(const Body& body) {
  return b2Transform(flat(body.position), b2Rot(float(angle_of(body.orientation))));
}

// Box2D sweeps the centre of mass: here it is the pivot.
b2Sweep sweep_of(const Body& body, double t_max) {
  b2Sweep out;
  out.localCenter = flat(body.pivot);
  const Vector centre = body.position + rotate(normalized(body.orientation), body.pivot);
  out.c0 = flat(centre);
  out.c = flat(centre + t_max * body.displacement);
  out.a0 = float(angle_of(body.orientation));
  out.a = float(angle_of(body.orientation) + t_max * body.rotation[2]);
  out.alpha0 = 0;
  return out;
}

void put_points(Answer& answer, const b2DistanceOutput& output, double z) {
  const Vector from{output.pointA.x, output.pointA.y, z};
  const Vector to{output.pointB.x, output.pointB.y, z};
  answer.point_a = from;
  answer.point_b = to;
  if (length(to - from) > 0) answer.normal = normalized(to - from);
}

b2DistanceOutput distance_of(const b2DistanceProxy& a, const b2Transform& at_a, const b2DistanceProxy& b,
                             const b2Transform& at_b, bool radii) {
  b2DistanceInput input;
  input.proxyA = a;
  input.proxyB = b;
  input.transformA = at_a;
  input.transformB = at_b;
  input.useRadii = radii;
  b2SimplexCache cache;
  cache.count = 0;
  b2DistanceOutput output;
  b2Distance(&output, &cache, &input);
  return output;
}

Answer time_of_impact(const Pair& pair) {
  b2TOIInput input;
  input.proxyA = proxy_of(*pair.a, b2_polygonRadius);
  input.proxyB = proxy_of(*pair.b, b2_polygonRadius);
  input.sweepA = sweep_of(pair.body_a, pair.t_max);
  input.sweepB = sweep_of(pair.body_b, pair.t_max);
  input.tMax = 1;
  b2TOIOutput output;
  b2TimeOfImpact(&output, &input);
  if (output.state == b2TOIOutput::e_separated) return Answer::miss();
  if (output.state == b2TOIOutput::e_overlapped) return Answer::overlapping();
  if (output.state != b2TOIOutput::e_touching) return Answer::not_converged("b2TOIOutput::e_failed");
  if (output.t == 0) return Answer::overlapping();
  Answer answer = Answer::hit(output.t * pair.t_max);
  b2Transform at_a, at_b;
  input.sweepA.GetTransform(&at_a, output.t);
  input.sweepB.GetTransform(&at_b, output.t);
  put_points(answer, distance_of(input.proxyA, at_a, input.proxyB, at_b, false), pair.z);
  return answer;
}

Answer shape_cast(const Pair& pair) {
  b2ShapeCastInput input;
  input.proxyA = proxy_of(*pair.a, b2_polygonRadius);
  input.proxyB = proxy_of(*pair.b, b2_polygonRadius);
  input.transformA = transform_of(pair.body_a);
  input.transformB = transform_of(pair.body_b);
  input.translationB = flat(pair.t_max * (pair.body_b.displacement - pair.body_a.displacement));
  b2ShapeCastOutput output;
  if (!b2ShapeCast(&output, &input)) return Answer::miss();
  Answer answer = Answer::hit(output.lambda * pair.t_max);
  answer.normal = Vector{output.normal.x, output.normal.y, 0};
  return answer;
}

Answer distance(const Pair& pair) {
  const b2DistanceOutput output =
      distance_of(proxy_of(*pair.a, pair.a->radius), transform_of(pair.body_a),
                  proxy_of(*pair.b, pair.b->radius), transform_of(pair.body_b), true);
  Answer answer = output.distance > 0 ? Answer::miss() : Answer::overlapping();
  answer.distance = output.distance;
  put_points(answer, output, pair.z);
  return answer;
}

int main_of(int argc, char** argv) {
  const Arguments arguments = read_arguments(argc, argv, {"toi", "shape-cast", "distance"}, {"default"});
  const std::string& call = arguments.call;
  Engine engine;
  engine.name = "box2d-" + call + "-default";
  engine.version = std::to_string(b2_version.major) + "." + std::to_string(b2_version.minor) + "." +
                   std::to_string(b2_version.revision);
  engine.scalar = Scalar::float32;
  engine.shapes = {ShapeType::box, ShapeType::hull};
  engine.lengths = {{0.1, 10}};
  engine.timed = true;
  const auto serve_with = [&](auto function) {
    return serve(engine, [=](const Question& q) {
      return [=, pair = Pair(q)]() -> Answer {
        return pair.planar() ? function(pair) : Answer::unsupported("not in the plane");
      };
    });
  };
  if (call == "toi") {
    engine.about = "b2TimeOfImpact, with b2Distance at that time; in the plane";
    engine.margin = b2_linearSlop;
    for (const Query query : {Query::cast, Query::rotating_cast}) {
      engine.queries[query].answers = {"time", "normal", "witnesses"};
      engine.queries[query].tolerance = b2_linearSlop;
    }
    return serve_with(time_of_impact);
  }
  if (call == "shape-cast") {
    engine.about = "b2ShapeCast; in the plane";
    engine.margin = b2_polygonRadius;
    engine.relative_motion = true;
    Promise& row = engine.queries[Query::cast];
    row.answers = {"time", "normal"};
    row.tolerance = b2_linearSlop;
    row.starts = false;
    return serve_with(shape_cast);
  }
  engine.about = "b2Distance; in the plane";
  engine.shapes.push_back(ShapeType::cylinder);
  engine.queries[Query::overlap].answers = {};
  engine.queries[Query::distance].answers = {"distance", "normal", "witnesses"};
  return serve_with(distance);
}

}  // namespace
}  // namespace graze::zoo

int main(int argc, char** argv) { return graze::zoo::main_of(argc, argv); }
