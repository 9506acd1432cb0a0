// The ten families that measure engines when callers request their full response: time, normal, contact.
//
// Hulls have 8 to 64 vertices, except boxes (8) and flats. In the turned set every body has an orientation of its own,
// drawn at random. In `sliding` one orientation turns the whole scene, so that its faces stay parallel.
#include <Eigen/Geometry>
#include <cmath>
#include <graze/cast.hpp>
#include <numbers>

#include "bench/draw_casts.hpp"

namespace graze::bench {
namespace {

CastOptions<double> judge() { return {.tier = Tier::exact}; }

int hull_size(Random& random) { return 8 << random.integer(0, 3); }

// A box as a hull, with half extents of 1/8 to 1 in eighths.
Shape<double> box_hull(Random& random) {
  const double x = random.integer(1, 8) / 8.0, y = random.integer(1, 8) / 8.0, z = random.integer(1, 8) / 8.0;
  std::vector<Vec3<double>> list;
  for (const double i : {-x, x}) {
    for (const double j : {-y, y}) {
      for (const double k : {-z, z}) list.emplace_back(i, j, k);
    }
  }
  return Hull<double>(std::span<const Vec3<double>>(list));
}

// One long axis, or two: the others 1/16 to 1/512 of it.
Shape<double> needle_or_plate(Random& random) {
  const double thin = std::ldexp(1.0, -random.integer(4, 9));
  Vec3<double> radii(1, random.once_in(2) ? 1 : thin, thin);
  std::swap(radii[0], radii[random.integer(0, 2)]);
  return ellipsoid_hull(random, hull_size(random), radii);
}

// The corners of a polygon of n vertices around z, at the heights.
std::vector<Vec3<double>> polygon(Random& random, int n, std::initializer_list<double> heights) {
  const double rx = random.uniform(0.5, 1), ry = random.uniform(0.5, 1), first = random.uniform(0, 1);
  std::vector<Vec3<double>> list;
  for (const double z : heights) {
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * (i + first) / n;
      list.push_back(to_float(Vec3<double>(rx * std::cos(angle), ry * std::sin(angle), z)));
    }
  }
  return list;
}
// Level faces at -1/2 and 1/2.
Shape<double> prism(Random& random) {
  const std::vector<Vec3<double>> list = polygon(random, 4 << random.integer(0, 3), {-0.5, 0.5});
  return Hull<double>(std::span<const Vec3<double>>(list));
}
// A flat polygon across one of the axes.
Shape<double> flat_hull(Random& random) {
  std::vector<Vec3<double>> list = polygon(random, random.integer(3, 32), {0});
  const int axis = random.integer(0, 2);
  for (Vec3<double>& x : list) std::swap(x[2], x[axis]);
  return Hull<double>(std::span<const Vec3<double>>(list));
}
Shape<double> triangle(Random& random) {
  const Vec3<double> a = to_float(direction(random)), b = to_float(direction(random));
  return Triangle<double>{a, b, to_float(direction(random))};
}
Shape<double> segment(Random& random) {
  const Vec3<double> a = to_float(direction(random));
  return Segment<double>{a, to_float(direction(random))};
}

class ResponseFamilies {
 public:
  ResponseFamilies(const FamilySize& size, bool turned) : size_(size), turned_(turned) {}

  std::vector<CastFamily> all() {
    generic();
    boxes();
    grazing();
    needles();
    size_ratio();
    far();
    contact();
    sliding();
    long_casts();
    flats();
    return std::move(families_);
  }

 private:
  using Draw = Shape<double> (*)(Random&);

  CastFamily& start(std::string name, const std::function<Shape<double>(Random&)>& shape) {
    random_ = Random(corpus::fnv1a(name));
    CastFamily& family = families_.emplace_back();
    family.name = std::move(name);
    family.rotated = turned_;
    for (std::size_t i = 0; i < size_.shapes; ++i) family.shapes.push_back(shape(random_));
    return family;
  }
  static Shape<double> any_hull(Random& random) { return round_hull(random, hull_size(random), 1); }

  void generic() {
    CastFamily& family = start("generic hulls", any_hull);
    fill_half(family, size_.cases, judge(), [&] {
      CastCase c = aimed(random_, family, 1, 3, 1.2);
      // One path in four ends before it gets there.
      if (random_.once_in(4)) shorten(c, random_.uniform(0.2, 0.7));
      return c;
    });
  }
  static void shorten(CastCase& c, double part) {
    c.a.displacement = to_float(Vec3<double>(part * c.a.displacement));
    c.b.displacement = to_float(Vec3<double>(part * c.b.displacement));
  }

  // On a grid, along one axis, two or three, or with any motion.
  void boxes() {
    CastFamily& family = start("boxes given as hulls", box_hull);
    const auto step = [&](int reach) { return random_.integer(-reach, reach) / 8.0; };
    const auto grid_point = [&](int reach) {
      const double x = step(reach), y = step(reach);
      return Vec3<double>(x, y, step(reach));
    };
    fill_half(family, size_.cases, judge(), [&] {
      CastCase c = aimed(random_, family, 1, 3, 1.4);
      if (random_.once_in(2)) return c;
      c.a.position = grid_point(32);
      const Vec3<double> start = grid_point(24), target = grid_point(12);
      c.b.position = c.a.position + start;
      c.a.displacement = Vec3<double>::Zero();
      c.b.displacement = 1.5 * (target - start);
      const int kept = random_.integer(0, 2);
      for (int i = 0; i < 3; ++i) {
        if (i != kept && random_.once_in(2)) c.b.displacement[i] = 0;
      }
      return c;
    });
  }

  void grazing() {
    CastFamily& family = start("grazing", any_hull);
    fill_half(family, size_.cases, judge(), [&] {
      CastCase c = aimed(random_, family, 1, 3, 0.3);
      const Vec3<double> v = c.b.displacement - c.a.displacement, from = c.b.position;
      const Vec3<double> aside = unit(Vec3<double>(v.cross(direction(random_))));
      const auto at = [&](double offset) {
        c.b.position = to_float(Vec3<double>(from + offset * aside));
        return c;
      };
      const double offset = grazing_offset(family, judge(), at), side = random_.once_in(2) ? 1 : -1;
      return at(offset + side * std::ldexp(1.0, -random_.integer(6, 22)));
    });
  }

  void needles() {
    CastFamily& family = start("needles and plates", needle_or_plate);
    fill_half(family, size_.cases, judge(), [&] { return aimed(random_, family, 1, 3, 0.4); });
  }

  // B is a thousandth of A.
  void size_ratio() {
    CastFamily& family = start("size ratio", [&](Random& r) {
      const bool large = families_.back().shapes.size() < size_.shapes / 2;
      return round_hull(r, hull_size(r), large ? 1000 : 1);
    });
    fill_half(family, size_.cases, judge(), [&] { return aimed(random_, family, 1000, 1500, 0.8); });
  }

  // 2^12 to 2^16 sizes away, where a float's step is 2^-12 to 2^-8 of a size.
  void far() {
    CastFamily& family = start("far from the origin", any_hull);
    fill_half(family, size_.cases, judge(), [&] {
      CastCase c = aimed(random_, family, 1, 3, 1.2);
      const Vec3<double> base = std::ldexp(1.0, random_.integer(12, 16)) * direction(random_);
      c.a.position = to_float(Vec3<double>(c.a.position + base));
      c.b.position = to_float(Vec3<double>(c.b.position + base));
      return c;
    });
  }

  // Three quarters overlap, the rest just touches: B is where its cast first found contact, to a float.
  void contact() {
    CastFamily& family = start("starts in contact", any_hull);
    family.in_contact = true;
    fill_with(family, size_.cases, judge(), Outcome::initially_overlapping, [&] {
      if (!random_.once_in(4)) return aimed(random_, family, 1, 0.7, 1.2);
      while (true) {
        CastCase c = aimed(random_, family, 1, 3, 0.8);
        const CastResult<double> r =
            cast(body_of<double>(c.a, family.shapes), body_of<double>(c.b, family.shapes), judge());
        if (r.outcome != Outcome::hit) continue;
        const Vec3<double> v = c.b.displacement - c.a.displacement;
        c.b.position = to_float(Vec3<double>(c.b.position + r.toi_lower * v));
        if (outcome_of(family, c, judge()) == Outcome::initially_overlapping) return c;
      }
    });
  }

  // B's lower face moves in the plane of A's upper one, or 2^-10 to 2^-20 above or below it.
  void sliding() {
    CastFamily& family = start("sliding", prism);
    fill_half(family, size_.cases, judge(), [&] {
      CastCase c = aimed(random_, family, 1, 3, 0.8);
      const double gap =
          random_.once_in(2) ? 0 : std::ldexp(random_.once_in(2) ? 1 : -1, -random_.integer(10, 20));
      c.a.position[2] = random_.integer(-2, 2) / 4.0;
      c.b.position[2] = c.a.position[2] + 1 + gap;
      c.b.displacement[2] = c.a.displacement[2];
      if (!turned_) return c;
      const Quaternion<double> q = turn(random_);
      const Eigen::Quaterniond rotation = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
      for (Placed* body : {&c.a, &c.b}) {
        body->orientation = q;
        body->position = to_float(Vec3<double>(rotation * body->position));
        body->displacement = to_float(Vec3<double>(rotation * body->displacement));
      }
      return c;
    });
  }

  // From 10 to 10,000 sizes away. Half of the paths continue up to 1,000 times the distance.
  void long_casts() {
    CastFamily& family = start("long casts", any_hull);
    fill_half(family, size_.cases, judge(), [&] {
      CastCase c = aimed(random_, family, 1, std::pow(10.0, random_.uniform(1, 4)), 1.0);
      if (random_.once_in(2)) shorten(c, std::ldexp(1.0, random_.integer(1, 10)));
      return c;
    });
  }

  // A is flat or a hull. B is a point, a segment, a triangle or flat.
  void flats() {
    CastFamily& family = start("flats, segments, points", [&](Random& r) -> Shape<double> {
      if (families_.back().shapes.size() < size_.shapes / 2) {
        constexpr Draw kLarge[] = {flat_hull, any_hull, triangle};
        return kLarge[r.below(3)](r);
      }
      constexpr Draw kSmall[] = {flat_hull, segment, triangle,
                                 [](Random&) -> Shape<double> { return Point<double>{}; }};
      return kSmall[r.below(4)](r);
    });
    fill_half(family, size_.cases, judge(), [&] { return aimed(random_, family, 1, 3, 0.6); });
  }

  FamilySize size_;
  bool turned_;
  Random random_{0};
  std::vector<CastFamily> families_;
};

}  // namespace

std::vector<CastFamily> response_families(const FamilySize& size, bool turned) {
  return ResponseFamilies(size, turned).all();
}

}  // namespace graze::bench
