#include "properties/draw_case.hpp"

#include <array>
#include <cmath>

#include "properties/case_edit.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Random;

namespace {

enum class Kind { small_integers, floats, doubles, powers, mixture };

class Drawing {
 public:
  Drawing(Random& random, int size) : random_(random), size_(size) {
    // Half of the cases are on integers: there ties are exact and failures easy to read.
    constexpr std::array kKinds = {Kind::small_integers, Kind::small_integers, Kind::small_integers,
                                   Kind::floats,         Kind::doubles,        Kind::powers,
                                   Kind::mixture,        Kind::mixture};
    kind_ = kKinds[random_.below(kKinds.size())];
  }

  Case draw() {
    Case problem;
    problem.family = "drawn";
    problem.a.shape = shape();
    problem.b.shape = shape();
    if (random_.once_in(4)) problem.a.orientation = orientation();
    if (random_.once_in(4)) problem.b.orientation = orientation();
    if (!random_.once_in(3)) problem.a.position = vector();
    place(problem);
    if (random_.once_in(8)) problem.target_distance = std::abs(coordinate());
    switch (random_.below(8)) {
      case 0:
        problem.t_max = kInfinity<double>;
        break;
      case 1:
        problem.t_max = random_.once_in(2) ? 2 : 0.5;
        break;
      case 2:
        problem.t_max = random_.once_in(4) ? 0 : 4;
        break;
      default:
        break;
    }
    if (random_.once_in(6)) nudge(problem);
    return problem;
  }

 private:
  double small_integer() { return random_.integer(-4, 4); }

  double coordinate() {
    const double x = fresh();
    seen_[count_++ % seen_.size()] = x;
    return x;
  }

  double fresh() {
    switch (kind_) {
      case Kind::small_integers:
        return small_integer();
      case Kind::floats:
        return static_cast<double>(static_cast<float>(random_.uniform(-4, 4)));
      case Kind::doubles:
        return random_.uniform(-4, 4);
      case Kind::powers:
        return power();
      case Kind::mixture:
        break;
    }
    const double earlier = seen_[random_.below(seen_.size())];
    switch (random_.below(6)) {
      case 0:
        return small_integer();
      case 1:
        return static_cast<double>(static_cast<float>(random_.uniform(-4, 4)));
      case 2:
        return random_.uniform(-4, 4);
      case 3:
        return random_.once_in(4) ? power() : std::scalbn(small_integer(), -2);
      case 4:  // never the neighbour of 0: it lies outside of the domain
        return earlier == 0 ? 0 : std::nextafter(earlier, random_.once_in(2) ? 1e9 : -1e9);
      default:
        return random_.once_in(2) ? earlier : -earlier;
    }
  }

  double power() {
    const int spread = 2 + size_ / 8;
    const double x = std::scalbn(1.0, random_.integer(-spread, spread));
    return random_.once_in(2) ? x : -x;
  }

  Vec3<double> vector() {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
  }

  double extent() { return random_.once_in(8) ? 0 : std::abs(coordinate()); }

  Quaternion<double> orientation() {
    Quaternion<double> q;
    do {
      const bool plain = !random_.once_in(4);  // else four full doubles, of any length
      for (double* x : {&q.w, &q.x, &q.y, &q.z}) *x = plain ? random_.integer(-2, 2) : random_.uniform(-2, 2);
    } while (q.w == 0 && q.is_identity());
    return q;
  }

  Shape<double> shape() {
    switch (random_.below(8)) {
      case 0:
        return Point<double>{};
      case 1:
      case 2:
        return Sphere<double>{extent()};
      case 3:
      case 4: {
        const double x = extent(), y = extent(), z = extent();
        return Box<double>{{x, y, z}};
      }
      default:
        break;
    }
    // Any vertices: duplicates, flat and collinear sets come by themselves on the integers.
    std::vector<Vec3<double>> vertices(1 + random_.below(4 + static_cast<unsigned>(size_) / 8));
    for (Vec3<double>& v : vertices) v = vector();
    if (random_.once_in(4)) {  // flat
      const int axis = random_.integer(0, 2);
      for (Vec3<double>& v : vertices) v[axis] = vertices[0][axis];
    }
    return Hull<double>(std::span<const Vec3<double>>(vertices));
  }

  // A point of the surface, or a vertex, of a shape in its own frame.
  Vec3<double> feature(const Shape<double>& shape) {
    if (const auto* sphere = std::get_if<Sphere<double>>(&shape)) {
      Vec3<double> x = Vec3<double>::Zero();
      x[random_.integer(0, 2)] = random_.once_in(2) ? sphere->radius : -sphere->radius;
      return x;
    }
    if (const auto* box = std::get_if<Box<double>>(&shape)) {
      Vec3<double> x = box->half_extents;
      for (int i = 0; i < 3; ++i) x[i] *= random_.once_in(4) ? 0 : random_.once_in(2) ? 1 : -1;
      return x;
    }
    if (const auto* hull = std::get_if<Hull<double>>(&shape))
      return hull->vertex(random_.below(hull->size()));
    return Vec3<double>::Zero();
  }

  // x -> q x conj(q) / |q|^2, rounded: near is enough, since the case means what its numbers say.
  static Vec3<double> turned(const Quaternion<double>& q, const Vec3<double>& x) {
    const Vec3<double> r(q.x, q.y, q.z);
    const double norm_sq = q.w * q.w + r.squaredNorm();
    return x + 2 * (q.w * r.cross(x) + r.cross(r.cross(x))) / norm_sq;
  }

  void place(Case& problem) {
    Vec3<double> v = vector();
    if (random_.once_in(3)) {  // along an axis: in the planes of faces
      const int axis = random_.integer(0, 2);
      for (int i = 0; i < 3; ++i) v[i] = i == axis ? v[i] : 0;
    }
    if (random_.once_in(40)) v.setZero();
    problem.b.displacement = v;
    if (random_.once_in(4)) {
      problem.a.displacement = vector();
      problem.b.displacement += problem.a.displacement;
      v = problem.b.displacement - problem.a.displacement;
    }
    if (random_.once_in(3)) {
      problem.b.position = vector();
      return;
    }
    // A feature of B meets a feature of A at time t.
    constexpr std::array kTimes = {0.0, 0.25, 0.5, 1.0, 1.0, 2.0};
    const double t = kTimes[random_.below(kTimes.size())];
    const Vec3<double> a = turned(problem.a.orientation, feature(problem.a.shape));
    const Vec3<double> b = turned(problem.b.orientation, feature(problem.b.shape));
    problem.b.position = problem.a.position + a - b - t * v;
  }

  // One number, by one unit in the last place.
  void nudge(Case& problem) {
    const std::size_t which = random_.below(scalars(problem).size());
    const bool up = random_.once_in(2);
    std::size_t at = 0;
    problem = map_scalars(problem, [&](Slot slot, double x) {
      const bool may = slot != Slot::orientation && slot != Slot::horizon && x != 0;
      return at++ == which && may ? std::nextafter(x, up ? 2 * x : 0) : x;
    });
  }

  Random& random_;
  int size_;
  Kind kind_;
  std::array<double, 8> seen_ = {0, 1, -1, 2, 0.5, 3, -2, 0.25};
  std::size_t count_ = 0;
};

}  // namespace

Case draw_case(Random& random, int size) { return Drawing(random, size).draw(); }

}  // namespace graze::law
