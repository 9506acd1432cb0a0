// The ten families that measure engines when callers request their full response: time, normal, contact.
//
// Hulls have 8 to 64 vertices, a quarter of them boxes. In the turned set every body has an orientation of its own,
// drawn at random. Where bodies are placed face on face, or on an edge or a vertex, one orientation turns the whole
// scene, so that they stay so.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <graze/cast.hpp>
#include <numbers>

#include "bench/draw_casts.hpp"

namespace graze::bench {
namespace {

using Points = std::vector<Vec3<double>>;

CastOptions<double> judge() { return {.tier = Tier::exact}; }

// 10^-most to 10^-least, each decade as often.
double small(Random& random, double least, double most) {
  return std::pow(10.0, -random.uniform(least, most));
}

Eigen::Quaterniond rotation_of(const Quaternion<double>& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
}

Shape<double> hull_of(const Points& list) { return Hull<double>(std::span<const Vec3<double>>(list)); }

int hull_size(Random& random) { return 8 << random.integer(0, 3); }

// Half extents of 1/8 to 1 in eighths.
Vec3<double> extents(Random& random) {
  const double x = random.integer(1, 8) / 8.0, y = random.integer(1, 8) / 8.0;
  return {x, y, random.integer(1, 8) / 8.0};
}
// A box as a hull, with vertices that are turned and rounded to floats.
Shape<double> box_hull(const Vec3<double>& half, const Eigen::Quaterniond& turned) {
  Points list;
  for (int i = 0; i < 8; ++i) {
    const Vec3<double> corner(i & 1 ? half[0] : -half[0], i & 2 ? half[1] : -half[1],
                              i & 4 ? half[2] : -half[2]);
    list.push_back(to_float(Vec3<double>(turned * corner)));
  }
  return hull_of(list);
}
Shape<double> level_box(Random& random) { return box_hull(extents(random), Eigen::Quaterniond::Identity()); }
// An edge along x, or along y, is its highest and its lowest part.
Shape<double> box_on_edge(Random& random, bool along_x) {
  const double half = random.integer(1, 8) / 8.0, length = random.integer(1, 8) / 8.0;
  const Vec3<double> axis = along_x ? Vec3<double>::UnitX() : Vec3<double>::UnitY();
  return box_hull(along_x ? Vec3<double>(length, half, half) : Vec3<double>(half, length, half),
                  Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi / 4, axis)));
}
Shape<double> box_on_vertex(Random& random) {
  const Vec3<double> half = extents(random);
  return box_hull(half, Eigen::Quaterniond::FromTwoVectors(half, Vec3<double>::UnitZ()));
}

Shape<double> any_hull(Random& random) {
  return random.once_in(4) ? level_box(random) : round_hull(random, hull_size(random), 1);
}

// One long axis, or two: the others are 1e-1 to 1e-5 of it. One in three is a hull as others are.
Shape<double> sliver(Random& random) {
  if (random.once_in(3)) return any_hull(random);
  const double thin = small(random, 1, 5);
  Vec3<double> radii(1, random.once_in(2) ? 1 : thin, thin);
  std::swap(radii[0], radii[random.integer(0, 2)]);
  return ellipsoid_hull(random, hull_size(random), radii);
}

// The corners of a polygon of n vertices around z, at the heights.
Points polygon(Random& random, int n, std::initializer_list<double> heights) {
  const double rx = random.uniform(0.5, 1), ry = random.uniform(0.5, 1), first = random.uniform(0, 1);
  Points list;
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
  return hull_of(polygon(random, 4 << random.integer(0, 3), {-0.5, 0.5}));
}
// A flat polygon across one of the axes, or across x = z.
Shape<double> flat_hull(Random& random) {
  Points list = polygon(random, random.integer(3, 32), {0});
  const int axis = random.integer(0, 3);
  for (Vec3<double>& x : list) {
    if (axis == 3)
      x[2] = x[0];
    else
      std::swap(x[2], x[axis]);
  }
  return hull_of(list);
}
Shape<double> flat(Random& random) {
  const Vec3<double> a = to_float(direction(random)), b = to_float(direction(random));
  switch (random.below(5)) {
    case 0:
      return Triangle<double>{a, b, to_float(direction(random))};
    case 1:
      return Segment<double>{a, b};
    case 2:
      return Point<double>{};
    default:
      return flat_hull(random);
  }
}

class ResponseFamilies {
 public:
  ResponseFamilies(const FamilySize& size, bool turned) : size_(size), turned_(turned) {}

  std::vector<CastFamily> all() {
    generic();
    boxes();
    grazing();
    slivers();
    size_ratio();
    far();
    contact();
    sliding();
    long_casts();
    flats();
    return std::move(families_);
  }

 private:
  CastFamily& start(std::string name, const std::function<Shape<double>(Random&)>& shape) {
    random_ = Random(corpus::fnv1a(name));
    CastFamily& family = families_.emplace_back();
    family.name = std::move(name);
    family.rotated = turned_;
    for (std::size_t i = 0; i < size_.shapes; ++i) family.shapes.push_back(shape(random_));
    return family;
  }

  // Turns a scene of bodies without orientations, in the turned set.
  CastCase placed(CastCase c) {
    if (!turned_) return c;
    const Quaternion<double> q = turn(random_);
    for (Placed* body : {&c.a, &c.b}) {
      body->orientation = q;
      body->position = to_float(Vec3<double>(rotation_of(q) * body->position));
      body->displacement = to_float(Vec3<double>(rotation_of(q) * body->displacement));
    }
    return c;
  }

  // The shapes of families of placements come in turn.
  enum ShapeKind : std::size_t { level, edge_along_y, edge_along_x, vertex };
  CastFamily& start_placements(std::string name) {
    return start(std::move(name), [this](Random& r) -> Shape<double> {
      switch (families_.back().shapes.size() % 4) {
        case edge_along_y:
          return box_on_edge(r, false);
        case edge_along_x:
          return box_on_edge(r, true);
        case vertex:
          return box_on_vertex(r);
        default:
          return level_box(r);
      }
    });
  }
  std::size_t one_of(const CastFamily& family, ShapeKind kind) {
    return 4 * random_.below(family.shapes.size() / 4) + kind;
  }
  // The highest part of a hull (side 1), or the lowest (-1).
  static double level_of(const CastFamily& family, std::size_t shape, double side) {
    double most = -kInfinity<double>;
    const Hull<double>& hull = std::get<Hull<double>>(family.shapes[shape]);
    for (const Vec3<double>& x : hull.vertices()) most = std::max(most, side * x[2]);
    return side * most;
  }
  // A on a grid, and B above it: its lowest part is this far above A's highest one.
  CastCase above(const CastFamily& family, std::size_t a, std::size_t b, double gap) {
    CastCase c;
    c.a.shape = a;
    c.b.shape = b;
    for (double& x : c.a.position) x = eighths(16);
    c.b.position = c.a.position;
    c.b.position[2] = to_float(c.a.position[2] + level_of(family, a, 1) - level_of(family, b, -1) + gap);
    return c;
  }
  double eighths(int reach) { return random_.integer(-reach, reach) / 8.0; }

  void generic() {
    CastFamily& family = start("generic hulls", any_hull);
    fill_half(family, size_.cases, judge(),
              [&] { return aimed(random_, family, 1, random_.uniform(1.5, 4), 0.9); });
  }

  // Face on face, equal footprints, crossed edges, parallel edges that meet, an edge or a vertex on a face. Straight down
  // or obliquely.
  void boxes() {
    CastFamily& family = start_placements("boxes given as hulls");
    struct Way {
      ShapeKind a, b;
      bool twins;  // of one shape, and one above the other when they meet
    };
    constexpr Way kWays[] = {{level, level, false},
                             {level, level, true},
                             {level, vertex, false},
                             {level, edge_along_y, false},
                             {edge_along_y, vertex, false},
                             {edge_along_y, edge_along_x, false},
                             {edge_along_y, edge_along_y, true}};
    fill_drawn(family, size_.cases, judge(), [&] {
      const Way& way = kWays[random_.below(std::size(kWays))];
      const std::size_t a = one_of(family, way.a), b = way.twins ? a : one_of(family, way.b);
      const double gap = random_.integer(1, 16) / 8.0, down = random_.uniform(1.1, 2);
      CastCase c = above(family, a, b, gap);
      const Vec3<double> aside =
          random_.once_in(2) ? Vec3<double>(in_cube(random_, gap)) : Vec3<double>::Zero();
      Vec3<double> place = -aside / down;
      if (!way.twins) place += Vec3<double>(eighths(4), eighths(4), 0);
      c.b.position = to_float(Vec3<double>(c.b.position + Vec3<double>(place[0], place[1], 0)));
      c.b.displacement = to_float(Vec3<double>(aside[0], aside[1], -down * gap));
      return placed(c);
    });
  }

  // A pass that clips or misses by 1e-1 to 1e-7.
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
      return at(offset + side * small(random_, 1, 7));
    });
  }

  void slivers() {
    CastFamily& family = start("needles and plates", sliver);
    fill_half(family, size_.cases, judge(), [&] { return aimed(random_, family, 1, 3, 0.4); });
  }

  // A hull of size 1/2 falls on a box of 10 to 10,000: straight, obliquely, or not all the way.
  void size_ratio() {
    CastFamily& family = start("size ratio", [&](Random& r) {
      if (families_.back().shapes.size() >= size_.shapes / 2) return round_hull(r, hull_size(r), 0.5);
      return box_hull(std::pow(10.0, r.uniform(1, 4)) * extents(r), Eigen::Quaterniond::Identity());
    });
    fill_drawn(family, size_.cases, judge(), [&] {
      const std::size_t half = size_.shapes / 2, a = random_.below(half);
      const double gap = random_.uniform(0.5, 5), size = level_of(family, a, 1);
      CastCase c = above(family, a, half + random_.below(half), gap);
      const Vec3<double> place = size * in_cube(random_, 1);
      c.b.position = to_float(Vec3<double>(c.b.position + Vec3<double>(place[0], place[1], 0)));
      const std::size_t way = random_.below(3);
      if (way == 1) c.b.displacement = to_float(in_cube(random_, 2 * gap));
      c.b.displacement[2] = to_float(-gap * (way == 2 ? random_.uniform(0.2, 0.9) : random_.uniform(1.1, 2)));
      return placed(c);
    });
  }

  // 10 to 1e5 from the origin, where a float's step is up to 2^-7.
  void far() {
    CastFamily& family = start("far from the origin", any_hull);
    fill_half(family, size_.cases, judge(), [&] {
      CastCase c = aimed(random_, family, 1, 3, 1.2);
      const Vec3<double> base = std::pow(10.0, random_.uniform(1, 5)) * direction(random_);
      c.a.position = to_float(Vec3<double>(c.a.position + base));
      c.b.position = to_float(Vec3<double>(c.b.position + base));
      return c;
    });
  }

  // Faces that touch exactly, and then enter, leave or slide. A vertex that touches. Shallow by 1e-1 to 1e-6, deep, and
  // in the same place.
  void contact() {
    CastFamily& family = start_placements("starts in contact");
    family.in_contact = true;
    fill_with(family, size_.cases, judge(), Outcome::initially_overlapping, [&] {
      const std::size_t way = random_.below(7), a = one_of(family, level);
      const double depth = way == 4 ? small(random_, 1, 6) : way == 5 ? random_.uniform(0.2, 1) : 0;
      const std::size_t b = way == 6 ? a : one_of(family, way == 3 ? vertex : level);
      CastCase c = above(family, a, b, -depth);
      if (way == 6) c.b.position = c.a.position;
      if (way < 3) c.b.position += Vec3<double>(eighths(1), eighths(1), 0);
      Vec3<double> v = to_float(in_cube(random_, 2));
      if (way < 2) v[2] = way == 0 ? -1 : 1;
      if (way == 2) v[2] = 0;
      set_motion(random_, c, v);
      return placed(c);
    });
  }

  // B's lower face moves in the plane of A's upper one or 1e-1 to 1e-6 above it, descends towards it from there, or
  // meets A's rim as far below it.
  void sliding() {
    CastFamily& family = start("sliding", prism);
    fill_drawn(family, size_.cases, judge(), [&] {
      CastCase c = aimed(random_, family, 1, 3, 0.8);
      const std::size_t way = random_.below(3);
      const double gap = way == 0 && random_.once_in(4) ? 0 : small(random_, 1, 6);
      c.a.position[2] = random_.integer(-2, 2) / 4.0;
      c.b.position[2] = to_float(c.a.position[2] + 1 + (way == 2 ? -gap : gap));
      c.b.displacement[2] = to_float(c.a.displacement[2] - (way == 1 ? random_.uniform(0.5, 2) * gap : 0));
      return placed(c);
    });
  }

  // From 10 to 100,000 sizes away.
  void long_casts() {
    CastFamily& family = start("long casts", any_hull);
    fill_half(family, size_.cases, judge(),
              [&] { return aimed(random_, family, 1, std::pow(10.0, random_.uniform(1, 5)), 1.0); });
  }

  // A is flat or a hull. B is a point, a segment, a triangle or a flat polygon.
  void flats() {
    CastFamily& family = start("flats, segments, points", [&](Random& r) {
      const bool first = families_.back().shapes.size() < size_.shapes / 2;
      return first && r.once_in(2) ? any_hull(r) : flat(r);
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
