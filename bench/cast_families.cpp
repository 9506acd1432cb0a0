#include "bench/cast_families.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <graze/cast.hpp>

#include "corpus/random.hpp"

namespace graze::bench {
namespace {

using corpus::Random;

double to_float(double x) { return static_cast<double>(static_cast<float>(x)); }
Vec3<double> to_float(const Vec3<double>& x) { return {to_float(x[0]), to_float(x[1]), to_float(x[2])}; }

Vec3<double> in_cube(Random& random, double reach) {
  const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
  return {x, y, random.uniform(-reach, reach)};
}
Vec3<double> direction(Random& random) {
  Vec3<double> x;
  do {
    x = in_cube(random, 1);
  } while (!(x.squaredNorm() <= 1 && x.squaredNorm() > 0.01));
  return x / x.norm();
}
Quaternion<double> turn(Random& random) {
  double q[4], norm_sq = 0;
  do {
    norm_sq = 0;
    for (double& c : q) {
      c = random.uniform(-1, 1);
      norm_sq += c * c;
    }
  } while (!(norm_sq <= 1 && norm_sq > 0.01));
  for (double& c : q) c = to_float(c / std::sqrt(norm_sq));
  return {q[0], q[1], q[2], q[3]};
}

// Points on an ellipsoid with radii of size/2 to size: in convex position, as a hull in a scene is.
Shape<double> round_hull(Random& random, int vertices, double size) {
  const Vec3<double> radii(random.uniform(0.5, 1), random.uniform(0.5, 1), random.uniform(0.5, 1));
  std::vector<Vec3<double>> list;
  for (int i = 0; i < vertices; ++i) list.push_back(to_float(size * radii.cwiseProduct(direction(random))));
  return Hull<double>(std::span<const Vec3<double>>(list));
}
Shape<double> any_box(Random& random) {
  const double x = to_float(random.uniform(0.25, 1)), y = to_float(random.uniform(0.25, 1));
  return Box<double>{Vec3<double>(x, y, to_float(random.uniform(0.25, 1)))};
}
// Half extents of 1/8 to 1: the faces of two on a grid often lie in one plane.
Shape<double> grid_box(Random& random) {
  const double x = random.integer(1, 8) / 8.0, y = random.integer(1, 8) / 8.0;
  return Box<double>{Vec3<double>(x, y, random.integer(1, 8) / 8.0)};
}

CastResult<double> judge(const CastFamily& family, const CastCase& c) {
  CastOptions<double> options;
  options.request = Request::verdict;
  return cast(body_of<double>(c.a, family.shapes), body_of<double>(c.b, family.shapes), options);
}

// The relative motion goes to B, and half of the time A moves as well.
void set_motion(Random& random, CastCase& c, const Vec3<double>& v) {
  if (random.once_in(2)) c.a.displacement = to_float(in_cube(random, 1));
  c.b.displacement = to_float(c.a.displacement + v);
}

// B starts `away` from A and flies at a point within `beside` of A's middle, 1.1 to 2 times as far as that.
CastCase aimed(Random& random, const CastFamily& family, double size_a, double away, double beside) {
  CastCase c;
  const std::size_t half = family.shapes.size() / 2;
  c.a.shape = random.below(half);
  c.b.shape = half + random.below(half);
  c.a.position = to_float(in_cube(random, 4));
  const Vec3<double> start = away * random.uniform(1, 1.5) * direction(random);
  c.b.position = to_float(c.a.position + start);
  const Vec3<double> target = beside * size_a * in_cube(random, 1);
  set_motion(random, c, random.uniform(1.1, 2) * (target - start));
  if (family.rotated) {
    c.a.orientation = turn(random);
    c.b.orientation = turn(random);
  }
  return c;
}

// Draws until half of the cases are hits and half misses; a start in contact is neither.
void fill_half(CastFamily& family, std::size_t cases, const std::function<CastCase()>& draw) {
  std::size_t hits = 0, misses = 0;
  while (hits + misses < cases) {
    CastCase c = draw();
    const Outcome outcome = judge(family, c).outcome;
    c.contact = outcome == Outcome::hit;
    if (outcome == Outcome::hit && 2 * hits < cases) {
      ++hits;
      family.cases.push_back(c);
    } else if (outcome == Outcome::miss && 2 * misses < cases) {
      ++misses;
      family.cases.push_back(c);
    }
  }
}

void fill_with(CastFamily& family, std::size_t cases, Outcome wanted, const std::function<CastCase()>& draw) {
  while (family.cases.size() < cases) {
    CastCase c = draw();
    c.contact = wanted != Outcome::miss;
    if (judge(family, c).outcome == wanted) family.cases.push_back(c);
  }
}

class Families {
 public:
  explicit Families(const FamilySize& size) : size_(size) {}

  std::vector<CastFamily> all() {
    for (const bool rotated : {false, true}) {
      for (const int n : {8, 16, 32, 64}) hulls(n, rotated);
    }
    aligned_boxes("boxes aligned, on a grid", true);
    aligned_boxes("boxes aligned, any motion", false);
    rotated_boxes();
    for (const bool rotated : {false, true}) grazing(rotated);
    for (const bool rotated : {false, true}) size_ratio(rotated);
    misses();
    hulls_in_contact();
    boxes_in_contact();
    touching_hulls();
    touching_boxes();
    return std::move(families_);
  }

 private:
  CastFamily& start(std::string name, bool rotated, const std::function<Shape<double>(Random&)>& shape) {
    random_ = Random(corpus::fnv1a(name));
    CastFamily& family = families_.emplace_back();
    family.name = std::move(name);
    family.rotated = rotated;
    for (std::size_t i = 0; i < size_.shapes; ++i) family.shapes.push_back(shape(random_));
    return family;
  }

  void hulls(int n, bool rotated) {
    CastFamily& family = start(fmt::format("hulls of {}{}", n, rotated ? ", rotated" : ""), rotated,
                               [&](Random& r) { return round_hull(r, n, 1); });
    fill_half(family, size_.cases, [&] { return aimed(random_, family, 1, 3, 1.2); });
  }

  void aligned_boxes(std::string name, bool grid) {
    CastFamily& family = start(std::move(name), false, grid ? grid_box : any_box);
    const auto step = [&](int reach) { return random_.integer(-reach, reach) / 8.0; };
    fill_half(family, size_.cases, [&] {
      if (!grid) return aimed(random_, family, 1, 3, 1.4);
      CastCase c = aimed(random_, family, 1, 3, 1.4);
      c.a.position = {step(32), step(32), step(32)};
      const Vec3<double> start(step(24), step(24), step(24));
      c.b.position = c.a.position + start;
      // Along one axis, or two, or all three: to a point of the grid near A's middle, and on.
      const Vec3<double> target(step(12), step(12), step(12));
      Vec3<double> v = 1.5 * (target - start);
      const int kept = random_.integer(0, 2);
      for (int i = 0; i < 3; ++i) {
        if (i != kept && random_.once_in(2)) v[i] = 0;
      }
      c.a.displacement = Vec3<double>::Zero();
      c.b.displacement = v;
      return c;
    });
  }

  void rotated_boxes() {
    CastFamily& family = start("boxes rotated", true, any_box);
    fill_half(family, size_.cases, [&] { return aimed(random_, family, 1, 3, 1.4); });
  }

  // The path is moved aside until contact is nearly lost: the offset at which it is, to a float, and then
  // from 2^-6 to 2^-22 to either side of it.
  void grazing(bool rotated) {
    CastFamily& family = start(fmt::format("grazing, hulls of 16{}", rotated ? ", rotated" : ""), rotated,
                               [](Random& r) { return round_hull(r, 16, 1); });
    fill_half(family, size_.cases, [&] {
      CastCase c = aimed(random_, family, 1, 3, 0.3);
      const Vec3<double> v = c.b.displacement - c.a.displacement, from = c.b.position;
      const Vec3<double> aside = unit(Vec3<double>(v.cross(direction(random_))));
      const auto at = [&](double offset) {
        c.b.position = to_float(from + offset * aside);
        return c;
      };
      double hit = 0, miss = 4;
      for (int i = 0; i < 30; ++i) {
        const double middle = (hit + miss) / 2;
        (judge(family, at(middle)).outcome == Outcome::miss ? miss : hit) = middle;
      }
      const double side = random_.once_in(2) ? 1 : -1;
      return at(hit + side * std::ldexp(1.0, -random_.integer(6, 22)));
    });
  }

  // B is a thousandth of A.
  void size_ratio(bool rotated) {
    CastFamily& family = start(fmt::format("size ratio 1000, hulls of 16{}", rotated ? ", rotated" : ""),
                               rotated, [&](Random& r) {
                                 const bool large = families_.back().shapes.size() < size_.shapes / 2;
                                 return round_hull(r, 16, large ? 1000 : 1);
                               });
    fill_half(family, size_.cases, [&] { return aimed(random_, family, 1000, 1500, 0.8); });
  }

  void misses() {
    CastFamily& family = start("misses, hulls of 16", false, [](Random& r) { return round_hull(r, 16, 1); });
    fill_with(family, size_.cases, Outcome::miss, [&] { return aimed(random_, family, 1, 3, 2.5); });
  }

  void hulls_in_contact() {
    for (const bool rotated : {false, true}) {
      CastFamily& family = start(fmt::format("in contact, hulls of 16{}", rotated ? ", rotated" : ""),
                                 rotated, [](Random& r) { return round_hull(r, 16, 1); });
      fill_with(family, size_.cases, Outcome::initially_overlapping,
                [&] { return aimed(random_, family, 1, 0.7, 1.2); });
    }
  }

  void boxes_in_contact() {
    CastFamily& family = start("in contact, boxes aligned", false, grid_box);
    fill_with(family, size_.cases, Outcome::initially_overlapping, [&] {
      CastCase c = aimed(random_, family, 1, 0.7, 1.2);
      const auto grid = [](double x) { return std::round(8 * x) / 8; };
      for (int i = 0; i < 3; ++i) {
        c.a.position[i] = grid(c.a.position[i]);
        c.b.position[i] = grid(c.b.position[i]);
        c.b.displacement[i] = grid(c.b.displacement[i]);
      }
      return c;
    });
  }

  // B starts where its cast first found contact, to a float; the starts that are in contact.
  void touching_hulls() {
    CastFamily& family =
        start("touching, hulls of 16", false, [](Random& r) { return round_hull(r, 16, 1); });
    fill_with(family, size_.cases, Outcome::initially_overlapping, [&] {
      CastCase c = aimed(random_, family, 1, 3, 0.8);
      const CastResult<double> r = judge(family, c);
      if (r.outcome != Outcome::hit) return c;
      c.b.position = to_float(c.b.position + r.toi_lower * (c.b.displacement - c.a.displacement));
      return c;
    });
  }

  // Two faces in one plane at the start, B moving into A.
  void touching_boxes() {
    CastFamily& family = start("touching, boxes aligned", false, grid_box);
    fill_with(family, size_.cases, Outcome::initially_overlapping, [&] {
      CastCase c = aimed(random_, family, 1, 3, 1.4);
      const int axis = random_.integer(0, 2);
      const double side = random_.once_in(2) ? 1 : -1;
      for (int i = 0; i < 3; ++i) {
        const double sum = std::get<Box<double>>(family.shapes[c.a.shape]).half_extents[i] +
                           std::get<Box<double>>(family.shapes[c.b.shape]).half_extents[i];
        c.a.position[i] = random_.integer(-32, 32) / 8.0;
        c.b.position[i] = c.a.position[i] + (i == axis ? side * sum : random_.integer(-4, 4) * sum / 8);
        c.b.displacement[i] = i == axis ? -side * random_.integer(1, 16) / 8.0 : random_.integer(-8, 8) / 8.0;
      }
      c.a.displacement = Vec3<double>::Zero();
      return c;
    });
  }

  FamilySize size_;
  Random random_{0};
  std::vector<CastFamily> families_;
};

}  // namespace

std::vector<CastFamily> cast_families(const FamilySize& size) { return Families(size).all(); }

}  // namespace graze::bench
