// libccd under the judge: GJK with EPA, and MPR, in the scalar that it was built with.
//
//   --call gjk   ccdGJKIntersect, ccdGJKPenetration       overlap, penetration
//          mpr   ccdMPRIntersect, ccdMPRPenetration       overlap, penetration
//          separate  ccdGJKSeparate                       penetration
//   --setting default   the values of CCD_INIT, with at most 1000 iterations (its examples say 100, and without a bound
//                       it may not return)
//             tightest  tolerances of 1e-10 instead of 1e-4 and 1e-6 (EPA ends by its tolerance alone. On a ball it
//                       needs as many faces as the root of the tolerance's inverse. With a smaller one it does not
//                       return)
//
// Its users write the support of a shape themselves: that is the one here, in double, with the centre for MPR at the
// mean of the vertices, or the origin. Neither epa_tolerance nor mpr_tolerance is documented as a bound on the answer.
//
// `dir` is the direction in which the second object has to move (ccd.h: "if obj2 is translated by distance depth in
// direction dir objects will have touching contact"): the direction of least penetration, from A to B.
#include <ccd/ccd.h>
#include <ccd/quat.h>
#include <graze_adapter.hpp>

#include <memory>

#include "engines/zoo/arguments.hpp"

namespace graze::zoo {
namespace {

using namespace adapter;

constexpr auto kTight = ccd_real_t(1e-10);

// A body at rest, as the callbacks see it.
struct Still {
  Shape shape;
  Vector position{};
  Quaternion there, back;  // from the body's frame to the world's, and the other way
  Vector centre{};         // in the world
};

Still still(const Body& body) {
  Still out{body.shape, body.position, normalized(body.orientation), {}, {}};
  out.back = {out.there.w, -out.there.x, -out.there.y, -out.there.z};
  Vector mean{};
  for (const Vector& x : body.shape.vertices) mean = mean + (1.0 / double(body.shape.vertices.size())) * x;
  out.centre = body.position + rotate(out.there, mean);
  return out;
}

double sign(double x) { return x < 0 ? -1 : 1; }

// The farthest point of a shape in direction d, both in its own frame. d is not 0.
Vector support(const Shape& shape, const Vector& d) {
  const double across = std::hypot(d[0], d[1]);
  const double r = shape.radius;
  const double h = shape.half_height;
  const Vector side = across > 0 ? Vector{r * d[0] / across, r * d[1] / across, 0} : Vector{};
  switch (shape.type) {
    case ShapeType::sphere:
      return (r / length(d)) * d;
    case ShapeType::capsule:
      return (r / length(d)) * d + Vector{0, 0, sign(d[2]) * h};
    case ShapeType::cylinder:
      return side + Vector{0, 0, sign(d[2]) * h};
    case ShapeType::cone: {
      const Vector base = side - Vector{0, 0, h};
      return h * d[2] >= dot(base, d) ? Vector{0, 0, h} : base;
    }
    case ShapeType::box: {
      const Vector& e = shape.half_extents;
      return {sign(d[0]) * e[0], sign(d[1]) * e[1], sign(d[2]) * e[2]};
    }
    case ShapeType::ellipsoid: {
      const Vector scaled{shape.radii[0] * d[0], shape.radii[1] * d[1], shape.radii[2] * d[2]};
      const double norm = length(scaled);
      if (!(norm > 0)) return {};
      return {shape.radii[0] * scaled[0] / norm, shape.radii[1] * scaled[1] / norm,
              shape.radii[2] * scaled[2] / norm};
    }
    default: {
      const Vector* best = &shape.vertices.front();
      for (const Vector& x : shape.vertices) {
        if (dot(x, d) > dot(*best, d)) best = &x;
      }
      return *best;
    }
  }
}

void put(ccd_vec3_t* out, const Vector& x) {
  ccdVec3Set(out, ccd_real_t(x[0]), ccd_real_t(x[1]), ccd_real_t(x[2]));
}
Vector plain(const ccd_vec3_t& x) { return {ccdVec3X(&x), ccdVec3Y(&x), ccdVec3Z(&x)}; }

void support_callback(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const Still& body = *static_cast<const Still*>(object);
  put(out, body.position + rotate(body.there, support(body.shape, rotate(body.back, plain(*direction)))));
}
void centre_callback(const void* object, ccd_vec3_t* out) {
  put(out, static_cast<const Still*>(object)->centre);
}

Answer penetration(int code, ccd_real_t depth, const ccd_vec3_t& direction) {
  if (code == -2) return Answer::not_converged("-2");
  if (code != 0) return Answer::miss();
  Answer answer = Answer::overlapping();
  answer.depth = depth;
  answer.normal = plain(direction);
  return answer;
}

int main_of(int argc, char** argv) {
  const Arguments arguments = read_arguments(argc, argv, {"gjk", "mpr", "separate"}, {"default", "tightest"});
  const std::string& call = arguments.call;
  const bool mpr = call == "mpr";
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support_callback;
  ccd.center1 = ccd.center2 = centre_callback;
  ccd.max_iterations = 1000;
  if (arguments.setting == "tightest") {
    ccd.epa_tolerance = kTight;
    ccd.mpr_tolerance = ccd.dist_tolerance = kTight;
  }
  Engine engine;
  engine.name = "libccd-" + call + "-" + arguments.setting;
  engine.version = GRAZE_LIBCCD_VERSION;
  engine.about = mpr             ? "ccdMPRIntersect, ccdMPRPenetration"
                 : call == "gjk" ? "ccdGJKIntersect, ccdGJKPenetration"
                                 : "ccdGJKSeparate";
#ifdef CCD_SINGLE
  engine.scalar = Scalar::float32;
#endif
  engine.shapes = {ShapeType::hull,     ShapeType::box,  ShapeType::sphere,   ShapeType::capsule,
                   ShapeType::cylinder, ShapeType::cone, ShapeType::ellipsoid};
  engine.timed = true;
  if (call != "separate") engine.queries[Query::overlap].answers = {};
  engine.queries[Query::penetration].answers = {"depth", "normal"};

  return serve(engine, [=](const Question& q) {
    return [=, a = still(q.a), b = still(q.b), query = q.query]() -> Answer {
      if (query == Query::overlap) {
        const bool contact = (mpr ? ccdMPRIntersect : ccdGJKIntersect)(&a, &b, &ccd) != 0;
        return contact ? Answer::overlapping() : Answer::miss();
      }
      ccd_real_t depth = 0;
      ccd_vec3_t direction = *ccd_vec3_origin;
      if (call == "separate") {
        const int code = ccdGJKSeparate(&a, &b, &ccd, &direction);
        depth = CCD_SQRT(ccdVec3Len2(&direction));
        if (code == 0 && depth > 0) ccdVec3Scale(&direction, 1 / depth);
        return penetration(code, depth, direction);
      }
      ccd_vec3_t position;
      const int code =
          (mpr ? ccdMPRPenetration : ccdGJKPenetration)(&a, &b, &ccd, &depth, &direction, &position);
      return penetration(code, depth, direction);
    };
  });
}

}  // namespace
}  // namespace graze::zoo

int main(int argc, char** argv) { return graze::zoo::main_of(argc, argv); }
