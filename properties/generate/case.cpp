#include "properties/generate/case.hpp"

#include <array>
#include <cmath>

#include "corpus/families/draw.hpp"
#include "properties/edit/case.hpp"

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
    if (random_.once_in(6)) pass_over(problem);
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

  Shape<double> hull() {
    // Any vertices: duplicates, flat and collinear sets come by themselves on the integers.
    std::vector<Vec3<double>> vertices(1 + random_.below(4 + static_cast<unsigned>(size_) / 8));
    for (Vec3<double>& v : vertices) v = vector();
    if (random_.once_in(4)) {  // flat
      const int axis = random_.integer(0, 2);
      for (Vec3<double>& v : vertices) v[axis] = vertices[0][axis];
    }
    return Hull<double>(std::span<const Vec3<double>>(vertices));
  }

  Vec3<double> extents() {
    const double x = extent(), y = extent(), z = extent();
    return {x, y, z};
  }

  template <class Round>
  Shape<double> round() {
    const double radius = extent(), half_height = extent();
    return Round{radius, half_height};
  }

  Shape<double> leaf() {
    switch (random_.below(14)) {
      case 0:
        return Point<double>{};
      case 1:
      case 2:
        return Sphere<double>{extent()};
      case 3:
      case 4:
        return Box<double>{extents()};
      case 5: {
        const Vec3<double> a = vector(), b = vector();
        return Segment<double>{a, random_.once_in(8) ? a : b};
      }
      case 6: {
        const Vec3<double> a = vector(), b = vector(), c = vector();
        // Now and then without an area.
        return Triangle<double>{a, b, random_.once_in(8) ? Vec3<double>(2 * b - a) : c};
      }
      case 7:
        return round<Capsule<double>>();
      case 8:
        return Ellipsoid<double>{extents()};
      case 9:
        return round<Cylinder<double>>();
      case 10:
        return round<Cone<double>>();
      default:
        return hull();
    }
  }

  // The vertices of a part are few, since those of a sum are multiplied.
  Shape<double> part(int depth) {
    constexpr std::uint64_t kMost = 8;
    Shape<double> one = depth > 0 && random_.once_in(3) ? combined(depth - 1) : leaf();
    return vertex_count(one) <= kMost ? one : Shape<double>(Sphere<double>{extent()});
  }

  Shape<double> combined(int depth) {
    const auto two_parts = [&] {
      std::vector<SharedShape<double>> parts{share(part(depth))};
      parts.push_back(share(part(depth)));
      return parts;
    };
    switch (random_.below(6)) {
      case 0: {
        Shape<double> one = part(depth);
        const Vec3<double> position = vector();
        return posed<double>(std::move(one), position,
                             random_.once_in(2) ? orientation() : Quaternion<double>{});
      }
      case 1: {
        Shape<double> one = part(depth);
        return rounded<double>(std::move(one), extent());
      }
      case 2:
        return Sum<double>{two_parts()};
      case 3: {
        Shape<double> one = part(depth);
        return swept<double>(std::move(one), vector());
      }
      case 4: {  // a tapered capsule
        const double r = extent(), s = extent();
        return hull_of<double>(Sphere<double>{r}, translated<double>(Sphere<double>{s}, vector()));
      }
      default:
        return HullOf<double>{two_parts()};
    }
  }

  Shape<double> shape() {
    constexpr int kDepth = 2;
    return random_.once_in(8) ? combined(random_.integer(0, kDepth)) : leaf();
  }

  // radius along an axis.
  Vec3<double> pole(double radius) {
    Vec3<double> x = Vec3<double>::Zero();
    x[random_.integer(0, 2)] = random_.once_in(2) ? radius : -radius;
    return x;
  }
  double either_sign(double x) { return random_.once_in(2) ? x : -x; }
  // On the rim of a disk about z.
  Vec3<double> rim(double radius, double height) {
    return random_.once_in(2) ? Vec3<double>(either_sign(radius), 0, height)
                              : Vec3<double>(0, either_sign(radius), height);
  }
  Vec3<double> feature_of_part(const SharedShape<double>& part) { return feature(part->shape); }

  // A point of the surface, or a vertex, of a shape in its own frame.
  Vec3<double> feature(const Shape<double>& shape) {
    return std::visit([&](const auto& one) { return feature_of(one); }, shape);
  }
  Vec3<double> feature_of(const Point<double>&) { return Vec3<double>::Zero(); }
  Vec3<double> feature_of(const Segment<double>& s) {
    return random_.once_in(4) ? Vec3<double>((s.a + s.b) / 2) : random_.once_in(2) ? s.a : s.b;
  }
  Vec3<double> feature_of(const Triangle<double>& t) {
    const Vec3<double> corners[] = {t.a, t.b, t.c, (t.a + t.b) / 2, (t.a + t.b + t.c) / 3};
    return corners[random_.below(std::size(corners))];
  }
  Vec3<double> feature_of(const Sphere<double>& s) { return pole(s.radius); }
  Vec3<double> feature_of(const Capsule<double>& c) {
    const Vec3<double> end(0, 0, either_sign(c.half_height));
    return end + pole(c.radius);
  }
  Vec3<double> feature_of(const Box<double>& b) {
    Vec3<double> x = b.half_extents;
    for (int i = 0; i < 3; ++i) x[i] *= random_.once_in(4) ? 0 : random_.once_in(2) ? 1 : -1;
    return x;
  }
  Vec3<double> feature_of(const Ellipsoid<double>& e) { return pole(1).cwiseProduct(e.radii); }
  Vec3<double> feature_of(const Cylinder<double>& c) {
    const double height = either_sign(c.half_height);
    return random_.once_in(3) ? Vec3<double>(0, 0, height) : rim(c.radius, random_.once_in(3) ? 0 : height);
  }
  Vec3<double> feature_of(const Cone<double>& c) {
    return random_.once_in(3) ? Vec3<double>(0, 0, c.half_height) : rim(c.radius, -c.half_height);
  }
  Vec3<double> feature_of(const Hull<double>& h) { return h.vertex(random_.below(h.size())); }
  Vec3<double> feature_of(const Posed<double>& p) {
    return p.position + corpus::rotate(p.orientation, feature_of_part(p.shape));
  }
  Vec3<double> feature_of(const Rounded<double>& r) {
    const Vec3<double> x = feature_of_part(r.shape);
    return x + pole(r.radius);
  }
  Vec3<double> feature_of(const Sum<double>& s) {
    Vec3<double> x = Vec3<double>::Zero();
    for (const SharedShape<double>& one : s.shapes) x += feature_of_part(one);
    return x;
  }
  Vec3<double> feature_of(const HullOf<double>& h) {
    return feature_of_part(h.shapes[random_.below(h.shapes.size())]);
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
    const Vec3<double> a = corpus::rotate(problem.a.orientation, feature(problem.a.shape));
    const Vec3<double> b = corpus::rotate(problem.b.orientation, feature(problem.b.shape));
    problem.b.position = problem.a.position + a - b - t * v;
  }

  // Sets the policy, half of the time with a gap of about the target distance, or within it.
  void pass_over(Case& problem) {
    problem.start_policy = corpus::StartPolicy::pass_over;
    if (random_.once_in(2)) return;
    if (problem.target_distance == 0) problem.target_distance = std::abs(coordinate());
    problem.b.position += pole(problem.target_distance * random_.integer(1, 6) / 4);
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
