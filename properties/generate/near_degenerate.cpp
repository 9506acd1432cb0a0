#include "properties/generate/near_degenerate.hpp"

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <variant>
#include <vector>

#include "corpus/families/draw.hpp"
#include "properties/generate/meeting.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Random;

namespace {

class NearTie {
 public:
  explicit NearTie(Random& random) : random_(random) {}

  Case draw() {
    Case problem;
    problem.family = "near ties";
    for (Body<double>* body : {&problem.a, &problem.b}) {
      body->shape = shape();
      if (random_.once_in(2)) body->orientation = draw_orientation(random_);
      if (random_.once_in(2)) body->position = vector();
    }
    const Vec3<double> v = vector();
    problem.b.displacement = v;
    if (random_.once_in(3)) {
      problem.a.displacement = vector();
      problem.b.displacement += problem.a.displacement;
    }
    // Farthest along nearly one direction: a vertex twice, or the ends of an edge. Across v the path grazes,
    // and against it the path meets a face.
    const Vec3<double> across = random_.once_in(4) ? Vec3<double>(-v) : Vec3<double>(v.cross(vector()));
    Vec3<double> target = Vec3<double>::Zero();
    double left = 1;
    for (int i = 0; i < 3; ++i) {
      const double weight = i == 2 ? left : left * random_.uniform(0, 1);
      left -= weight;
      const Vec3<double> d = across + 0x1p-3 * across.norm() * vector() / 4;
      target += weight * (farthest(problem.a, d) - farthest(problem.b, -d));
    }
    // t v = a - (b + shift) at t = 1/2: v is added in halves.
    problem.b.position = problem.a.position + target - v / 2;
    return problem;
  }

 private:
  double number() {
    const double x = random_.uniform(-4, 4);
    return random_.once_in(2) ? x : static_cast<double>(static_cast<float>(x));
  }
  Vec3<double> vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  Shape<double> shape() {
    const Vec3<double> half = vector().cwiseAbs();
    const Quaternion<double> q = draw_orientation(random_);
    std::vector<Vec3<double>> vertices;
    switch (random_.below(4)) {
      case 0:
        return Box<double>{half};
      case 1:  // a prism of six sides
        for (int i = 0; i < 12; ++i) {
          constexpr std::array<std::array<double, 2>, 6> kHexagon = {
              {{2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}}};
          const auto& corner = kHexagon[static_cast<std::size_t>(i % 6)];
          vertices.push_back(
              corpus::rotate(q, half.cwiseProduct(Vec3<double>(corner[0], corner[1], i < 6 ? 1 : -1)) / 2));
        }
        break;
      case 2:
        for (int i = 0; i < 8; ++i) {
          const Vec3<double> signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
          vertices.push_back(corpus::rotate(q, half.cwiseProduct(signs)));
        }
        break;
      default:
        for (int i = 0; i < 4 + static_cast<int>(random_.below(20)); ++i) vertices.push_back(vector());
    }
    return Hull<double>(std::span<const Vec3<double>>(vertices));
  }
  // The farthest of a body's own corners along a direction of the world, about its position.
  static Vec3<double> farthest(const Body<double>& body, const Vec3<double>& d) {
    std::vector<Vec3<double>> corners;
    if (const auto* box = std::get_if<Box<double>>(&body.shape)) {
      for (int i = 0; i < 8; ++i) {
        const Vec3<double> signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        corners.push_back(box->half_extents.cwiseProduct(signs));
      }
    } else {
      const auto vertices = std::get<Hull<double>>(body.shape).vertices();
      corners.assign(vertices.begin(), vertices.end());
    }
    Vec3<double> best = corpus::rotate(body.orientation, corners[0]);
    for (const Vec3<double>& corner : corners) {
      const Vec3<double> x = corpus::rotate(body.orientation, corner);
      if (d.dot(x) > d.dot(best)) best = x;
    }
    return best;
  }

  Random& random_;
};

}  // namespace

Case draw_near_tie(Random& random) { return NearTie(random).draw(); }

Case draw_near_touch(Random& random) {
  Case problem;
  problem.family = "near touches";
  const double height = std::ldexp(1.0, -22 - static_cast<int>(random.below(14)));
  // Up to z = 0 from below, or down to it, with a point behind.
  const auto facing = [&](double up) {
    std::vector<Vec3<double>> vertices = {{0, 0, -2 * up}};
    for (std::uint64_t left = 4 + random.below(9); left > 0; --left) {
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      vertices.emplace_back(x, y, -up * height * random.uniform(0, 1));
    }
    return Hull<double>(std::span<const Vec3<double>>(vertices));
  };
  problem.a.shape = facing(1);
  problem.b.shape = facing(-1);
  if (random.once_in(2)) problem.a.orientation = problem.b.orientation = draw_orientation(random);
  problem.b.position =
      corpus::rotate(problem.a.orientation, Vec3<double>(0, 0, height * random.uniform(-1, 1)));
  return problem;
}

}  // namespace graze::law
