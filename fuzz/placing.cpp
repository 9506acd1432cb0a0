#include <Eigen/Geometry>

#include "fuzz/placing.hpp"

#include "corpus/support_value.hpp"
#include "properties/edit/shape.hpp"

namespace graze::fuzz {

namespace {

constexpr std::size_t kMostPoints = 128;

// q x conj(q) / |q|^2 for a pure quaternion x, or the inverse rotation for `back`.
Vec3<double> turned(const Quaternion<double>& q, const Vec3<double>& x, bool back) {
  const double square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  if (!(square > 0) || q.is_identity()) return x;
  const Vec3<double> u = Vec3<double>(q.x, q.y, q.z) * (back ? -1 : 1);
  const Vec3<double> twice = 2 * u.cross(x);
  return x + (q.w * twice + u.cross(twice)) / square;
}

std::vector<Vec3<double>> own_points(const Shape<double>& shape) {
  if (auto exact = law::exact_vertices(shape, kMostPoints)) return *std::move(exact);
  if (law::is_malformed(shape)) return {};
  const corpus::Bounds box = corpus::bounds(shape);
  if (!box.low.allFinite() || !box.high.allFinite()) return {};
  const Vec3<double> middle = box.low / 2 + box.high / 2;
  std::vector<Vec3<double>> out;
  for (int i = 0; i < 3; ++i) {
    for (const double x : {box.low[i], box.high[i]}) {
      out.push_back(middle);
      out.back()[i] = x;
    }
  }
  return out;
}

}  // namespace

std::vector<Vec3<double>> feature_points(const Body<double>& body) {
  std::vector<Vec3<double>> points = own_points(body.shape);
  for (Vec3<double>& p : points) p = body.position + turned(body.orientation, p, false);
  return points;
}

Vec3<double> into_body(const Body<double>& body, const Vec3<double>& world) {
  return turned(body.orientation, world - body.position, true);
}

}  // namespace graze::fuzz
