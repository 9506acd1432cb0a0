// MuJoCo under the judge: a model of two bodies built from XML in memory for each question, as its users build theirs.
//
//   --call primitives   contacts of mj_collision, of its own shapes        overlap, penetration     in double
//          mesh         the same, with hulls as meshes, which it keeps in float                     in float
//          ray          mj_ray, of its own shapes                          ray                      in double
//          ray-mesh     mj_ray, with meshes                                ray                      in float
//   --setting default   options as they come (mpr_tolerance 1e-6, mpr_iterations 50)
//             tightest  mpr_tolerance 1e-14, mpr_iterations 10000
//
// MuJoCo promises no tolerance of its contacts (XML reference: mpr_tolerance is the "tolerance threshold" of its convex
// collider). For a ray that starts inside a geom it returns the exit: `starts` false.
//
// A contact's frame begins with the normal, from geom1 to geom2, and `dist` below 0 is penetration. The contact names
// its two geoms. If there are several contacts, the deepest counts. mj_ray returns a multiple of the ray's vector, and
// no normal.
#include <mujoco/mujoco.h>
#include <graze_adapter.hpp>

#include <cstring>
#include <memory>

#include "engines/zoo/arguments.hpp"

namespace graze::zoo {
namespace {

using namespace adapter;

struct Model {
  mjModel* model = nullptr;
  mjData* data = nullptr;
  std::string error;
  Model() = default;
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;
  ~Model() {
    if (data != nullptr) mj_deleteData(data);
    if (model != nullptr) mj_deleteModel(model);
  }
};

std::string numbers(std::initializer_list<double> values) {
  std::string out;
  for (const double x : values) {
    out += out.empty() ? "" : " ";
    number::write(out, x);
  }
  return out;
}
std::string numbers(const Vector& x) { return numbers({x[0], x[1], x[2]}); }

std::string mesh_of(const Shape& shape, const std::string& name) {
  if (shape.type != ShapeType::hull) return {};
  std::string out = "<mesh name=\"" + name + "\" vertex=\"";
  for (const Vector& x : shape.vertices) out += numbers(x) + " ";
  return out + "\"/>";
}

std::string geom_of(const Shape& shape, const std::string& name) {
  const auto geom = [&](const char* type, const std::string& size) {
    return "<geom name=\"" + name + "\" type=\"" + type + "\" " + size + "/>";
  };
  const double r = shape.radius;
  const double h = shape.half_height;
  switch (shape.type) {
    case ShapeType::sphere:
      return geom("sphere", "size=\"" + numbers({r}) + "\"");
    case ShapeType::capsule:
      return geom("capsule", "size=\"" + numbers({r, h}) + "\"");
    case ShapeType::cylinder:
      return geom("cylinder", "size=\"" + numbers({r, h}) + "\"");
    case ShapeType::box:
      return geom("box", "size=\"" + numbers(shape.half_extents) + "\"");
    case ShapeType::ellipsoid:
      return geom("ellipsoid", "size=\"" + numbers(shape.radii) + "\"");
    default:
      return geom("mesh", "mesh=\"" + name + "\"");
  }
}

// Its mass is nobody's business, so that none has to be found from the shape.
std::string body_of(const Body& body, const std::string& name) {
  const Quaternion& q = body.orientation;
  return "<body pos=\"" + numbers(body.position) + "\" quat=\"" + numbers({q.w, q.x, q.y, q.z}) +
         "\"><freejoint/><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>" +
         geom_of(body.shape, name) + "</body>";
}

std::shared_ptr<Model> model_of(const Question& q, bool tightest) {
  const bool ray = q.query == Query::ray;
  const std::string xml =
      "<mujoco>" + std::string(tightest ? "<option mpr_tolerance=\"1e-14\" mpr_iterations=\"10000\"/>" : "") +
      "<asset>" + mesh_of(q.a.shape, "a") + (ray ? "" : mesh_of(q.b.shape, "b")) + "</asset><worldbody>" +
      body_of(q.a, "a") + (ray ? "" : body_of(q.b, "b")) + "</worldbody></mujoco>";
  auto out = std::make_shared<Model>();
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "pair.xml", static_cast<int>(xml.size()));
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), "pair.xml")], xml.data(), xml.size());
  char error[1000] = "";
  out->model = mj_loadXML("pair.xml", files.get(), error, sizeof error);
  mj_deleteVFS(files.get());
  if (out->model == nullptr) {
    out->error = error;
    return out;
  }
  out->data = mj_makeData(out->model);
  mj_kinematics(out->model, out->data);
  mj_comPos(out->model, out->data);
  return out;
}

Answer contacts(const Model& pair) {
  mj_collision(pair.model, pair.data);
  const mjContact* deepest = nullptr;
  for (int i = 0; i < pair.data->ncon; ++i) {
    const mjContact& contact = pair.data->contact[i];
    if (deepest == nullptr || contact.dist < deepest->dist) deepest = &contact;
  }
  if (deepest == nullptr || deepest->dist > 0) return Answer::miss();
  Answer answer = Answer::overlapping();
  answer.depth = -deepest->dist;
  const Vector normal{deepest->frame[0], deepest->frame[1], deepest->frame[2]};
  answer.normal = deepest->geom1 == mj_name2id(pair.model, mjOBJ_GEOM, "a") ? normal : -normal;
  return answer;
}

Answer ray(const Model& scene, const Question& q) {
  int geom = -1;
  const mjtNum time =
      mj_ray(scene.model, scene.data, q.origin.data(), q.direction.data(), nullptr, 1, -1, &geom);
  if (time < 0 || time > q.t_max) return Answer::miss();
  return Answer::hit(time);
}

int main_of(int argc, char** argv) {
  static_assert(sizeof(mjtNum) == sizeof(double));
  const Arguments arguments =
      read_arguments(argc, argv, {"primitives", "mesh", "ray", "ray-mesh"}, {"default", "tightest"});
  const bool rays = arguments.call.rfind("ray", 0) == 0;
  const bool mesh = arguments.call.find("mesh") != std::string::npos;
  const bool tightest = arguments.setting == "tightest";
  if (rays && tightest) refuse("--setting tightest: of contacts alone");
  Engine engine;
  engine.name = "mujoco-" + arguments.call + "-" + arguments.setting;
  engine.version = mj_versionString();
  engine.about = rays ? "mj_ray" : "mj_collision, the deepest contact";
  engine.timed = true;
  engine.scalar = mesh ? Scalar::float32 : Scalar::float64;
  engine.shapes = {ShapeType::sphere, ShapeType::capsule, ShapeType::cylinder, ShapeType::box,
                   ShapeType::ellipsoid};
  if (mesh) engine.shapes.push_back(ShapeType::hull);
  if (rays) {
    engine.queries[Query::ray].answers = {"time"};
    engine.queries[Query::ray].starts = false;
  } else {
    engine.queries[Query::overlap].answers = {};
    engine.queries[Query::penetration].answers = {"depth", "normal"};
  }
  return serve(engine, [=](const Question& q) {
    return [=, pair = model_of(q, tightest)]() -> Answer {
      if (pair->model == nullptr) return Answer::unsupported("the model compiler says: " + pair->error);
      return rays ? ray(*pair, q) : contacts(*pair);
    };
  });
}

}  // namespace
}  // namespace graze::zoo

int main(int argc, char** argv) { return graze::zoo::main_of(argc, argv); }
