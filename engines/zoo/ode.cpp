// ODE under the judge, as its users call it, in the scalar that it was built with.
//
//   --call collide   dCollide, up to 16 contacts, of which the deepest counts     overlap, penetration
//          ray       dCollide of a ray                                           ray
//   --setting default
//
// ODE promises no tolerance. Its manual ("Collision Detection") lists the supported pairs. It does not mention a ray
// that starts inside a geom: `starts` false.
//
// A contact's normal points into body 1, from B to A (contact.h: "if body 1 is moved along the normal vector by a
// distance depth … then the contact depth will be reduced to zero"). For a ray, `depth` is the distance from its start,
// and the normal points out of the geom. Lengths of capsules (without their caps) and cylinders, and sides of boxes,
// are full lengths. A convex geom needs its planes and polygons, and its origin inside. Here its origin is the mean of
// its vertices.
#include <ode/ode.h>
#include <graze_adapter.hpp>

#include <memory>

#include "engines/zoo/arguments.hpp"
#include "engines/zoo/faces.hpp"

namespace graze::zoo {
namespace {

using namespace adapter;

constexpr int kContacts = 16;

// A geom, and the arrays that a convex one points into.
struct Geom {
  dGeomID id = nullptr;
  std::vector<dReal> planes, points;
  std::vector<unsigned> polygons;
  Geom() = default;
  Geom(const Geom&) = delete;
  Geom& operator=(const Geom&) = delete;
  ~Geom() {
    if (id != nullptr) dGeomDestroy(id);
  }
};

// Fills in a convex geom and sets its origin in the body's frame. False if its faces are not found.
bool make_convex(Geom& geom, const Points& vertices, Vector& origin) {
  const std::vector<Face> faces = faces_of(vertices);
  if (faces.empty()) return false;
  std::map<std::size_t, unsigned> places;  // the hull's own vertices only
  std::vector<Vector> corners;
  for (const Face& face : faces) {
    geom.polygons.push_back(static_cast<unsigned>(face.size()));
    for (const std::size_t i : face) {
      const auto [place, added] = places.emplace(i, static_cast<unsigned>(corners.size()));
      if (added) corners.push_back(vertices[i]);
      geom.polygons.push_back(place->second);
    }
  }
  origin = {};
  for (const Vector& x : corners) origin = origin + (1.0 / double(corners.size())) * x;
  for (Vector& x : corners) {
    x = x - origin;
    for (const double coordinate : x) geom.points.push_back(dReal(coordinate));
  }
  for (const Face& face : faces) {
    const Vector at = corners[places[face[0]]];
    const Vector n = normalized(cross(corners[places[face[1]]] - at, corners[places[face[2]]] - at));
    for (const double coordinate : n) geom.planes.push_back(dReal(coordinate));
    geom.planes.push_back(dReal(dot(n, at)));
  }
  geom.id = dCreateConvex(nullptr, geom.planes.data(), static_cast<unsigned>(faces.size()),
                          geom.points.data(), static_cast<unsigned>(corners.size()), geom.polygons.data());
  return true;
}

// Null for a hull whose faces are not found.
std::shared_ptr<Geom> geom_of(const Body& body) {
  auto geom = std::make_shared<Geom>();
  const Shape& shape = body.shape;
  const auto radius = dReal(shape.radius);
  const auto length = dReal(2 * shape.half_height);
  Vector origin{};
  switch (shape.type) {
    case ShapeType::sphere:
      geom->id = dCreateSphere(nullptr, radius);
      break;
    case ShapeType::capsule:
      geom->id = dCreateCapsule(nullptr, radius, length);
      break;
    case ShapeType::cylinder:
      geom->id = dCreateCylinder(nullptr, radius, length);
      break;
    case ShapeType::box: {
      const Vector& h = shape.half_extents;
      geom->id = dCreateBox(nullptr, dReal(2 * h[0]), dReal(2 * h[1]), dReal(2 * h[2]));
      break;
    }
    default:
      if (!make_convex(*geom, shape.vertices, origin)) return nullptr;
  }
  const Quaternion& q = body.orientation;
  const dQuaternion turn{dReal(q.w), dReal(q.x), dReal(q.y), dReal(q.z)};
  dGeomSetQuaternion(geom->id, turn);
  const Vector at = body.position + rotate(normalized(q), origin);
  dGeomSetPosition(geom->id, dReal(at[0]), dReal(at[1]), dReal(at[2]));
  return geom;
}

Vector plain(const dReal* x) { return {x[0], x[1], x[2]}; }

Answer no_faces() { return Answer::unsupported("a flat hull, or one whose faces the adapter does not find"); }

Answer collide(const Geom& a, const Geom& b) {
  dContactGeom contacts[kContacts];
  const int count = dCollide(a.id, b.id, kContacts, contacts, sizeof(dContactGeom));
  if (count == 0) return Answer::miss();
  const dContactGeom* deepest = contacts;
  for (int i = 1; i < count; ++i) {
    if (contacts[i].depth > deepest->depth) deepest = contacts + i;
  }
  Answer answer = Answer::overlapping();
  answer.depth = deepest->depth;
  answer.normal = -plain(deepest->normal);
  return answer;
}

Answer ray(const Geom& a, const Geom& beam, double speed) {
  dContactGeom contact;
  if (dCollide(beam.id, a.id, 1, &contact, sizeof contact) == 0) return Answer::miss();
  Answer answer = Answer::hit(contact.depth / speed);
  answer.normal = plain(contact.normal);
  return answer;
}

int main_of(int argc, char** argv) {
  const Arguments arguments = read_arguments(argc, argv, {"collide", "ray"}, {"default"});
  dInitODE2(0);
  Engine engine;
  engine.name = "ode-" + arguments.call + "-default";
  engine.version = GRAZE_ODE_VERSION;
  if (sizeof(dReal) == sizeof(float)) engine.scalar = Scalar::float32;
  engine.shapes = {ShapeType::hull, ShapeType::box, ShapeType::sphere, ShapeType::capsule,
                   ShapeType::cylinder};
  engine.timed = true;
  int code = 0;
  if (arguments.call == "collide") {
    engine.about = "dCollide, the deepest of up to 16 contacts";
    engine.queries[Query::overlap].answers = {};
    engine.queries[Query::penetration].answers = {"depth", "normal"};
    code = serve(engine, [](const Question& q) {
      return
          [a = geom_of(q.a), b = geom_of(q.b)]() -> Answer { return a && b ? collide(*a, *b) : no_faces(); };
    });
  } else {
    engine.about = "dCollide of a ray";
    Promise& row = engine.queries[Query::ray];
    row.answers = {"time", "normal"};
    row.starts = false;
    code = serve(engine, [](const Question& q) {
      const double speed = length(q.direction);
      auto beam = std::make_shared<Geom>();
      beam->id = dCreateRay(nullptr, dReal(speed * q.t_max));
      const Vector& x = q.origin;
      const Vector& d = q.direction;
      dGeomRaySet(beam->id, dReal(x[0]), dReal(x[1]), dReal(x[2]), dReal(d[0]), dReal(d[1]), dReal(d[2]));
      return [a = geom_of(q.a), beam, speed]() -> Answer { return a ? ray(*a, *beam, speed) : no_faces(); };
    });
  }
  dCloseODE();
  return code;
}

}  // namespace
}  // namespace graze::zoo

int main(int argc, char** argv) { return graze::zoo::main_of(argc, argv); }
