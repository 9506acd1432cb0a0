#include "bench/cast_families.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <graze/cast.hpp>

#include "bench/draw_casts.hpp"
#include "corpus/random.hpp"

namespace graze::bench {
namespace {

// The judge of these families' verdicts: tier standard in double.
CastOptions<double> judge() { return {}; }

Shape<double> any_box(Random& random) {
  const double x = to_float(random.uniform(0.25, 1)), y = to_float(random.uniform(0.25, 1));
  return Box<double>{Vec3<double>(x, y, to_float(random.uniform(0.25, 1)))};
}
// Half extents of 1/8 to 1: the faces of two on a grid often lie in one plane.
Shape<double> grid_box(Random& random) {
  const double x = random.integer(1, 8) / 8.0, y = random.integer(1, 8) / 8.0;
  return Box<double>{Vec3<double>(x, y, random.integer(1, 8) / 8.0)};
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
    fill_half(family, size_.cases, judge(), [&] { return aimed(random_, family, 1, 3, 1.2); });
  }

  void aligned_boxes(std::string name, bool grid) {
    CastFamily& family = start(std::move(name), false, grid ? grid_box : any_box);
    const auto step = [&](int reach) { return random_.integer(-reach, reach) / 8.0; };
    fill_half(family, size_.cases, judge(), [&] {
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
    fill_half(family, size_.cases, judge(), [&] { return aimed(random_, family, 1, 3, 1.4); });
  }

  // The path is moved aside until contact is nearly lost: the offset at which it is, to a float, and then
  // from 2^-6 to 2^-22 to either side of it.
  void grazing(bool rotated) {
    CastFamily& family = start(fmt::format("grazing, hulls of 16{}", rotated ? ", rotated" : ""), rotated,
                               [](Random& r) { return round_hull(r, 16, 1); });
    fill_half(family, size_.cases, judge(), [&] {
      CastCase c = aimed(random_, family, 1, 3, 0.3);
      const Vec3<double> v = c.b.displacement - c.a.displacement, from = c.b.position;
      const Vec3<double> aside = unit(Vec3<double>(v.cross(direction(random_))));
      const auto at = [&](double offset) {
        c.b.position = to_float(Vec3<double>(from + offset * aside));
        return c;
      };
      const double hit = grazing_offset(family, judge(), at);
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
    fill_half(family, size_.cases, judge(), [&] { return aimed(random_, family, 1000, 1500, 0.8); });
  }

  void misses() {
    CastFamily& family = start("misses, hulls of 16", false, [](Random& r) { return round_hull(r, 16, 1); });
    fill_with(family, size_.cases, judge(), Outcome::miss, [&] { return aimed(random_, family, 1, 3, 2.5); });
  }

  void hulls_in_contact() {
    for (const bool rotated : {false, true}) {
      CastFamily& family = start(fmt::format("in contact, hulls of 16{}", rotated ? ", rotated" : ""),
                                 rotated, [](Random& r) { return round_hull(r, 16, 1); });
      fill_with(family, size_.cases, judge(), Outcome::initially_overlapping,
                [&] { return aimed(random_, family, 1, 0.7, 1.2); });
    }
  }

  void boxes_in_contact() {
    CastFamily& family = start("in contact, boxes aligned", false, grid_box);
    fill_with(family, size_.cases, judge(), Outcome::initially_overlapping, [&] {
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

  // B starts where its cast first found contact, to a float. Kept are the starts that are in contact.
  void touching_hulls() {
    CastFamily& family =
        start("touching, hulls of 16", false, [](Random& r) { return round_hull(r, 16, 1); });
    fill_with(family, size_.cases, judge(), Outcome::initially_overlapping, [&] {
      CastCase c = aimed(random_, family, 1, 3, 0.8);
      const CastResult<double> r =
          cast(body_of<double>(c.a, family.shapes), body_of<double>(c.b, family.shapes), judge());
      if (r.outcome != Outcome::hit) return c;
      c.b.position =
          to_float(Vec3<double>(c.b.position + r.toi_lower * (c.b.displacement - c.a.displacement)));
      return c;
    });
  }

  // Two faces in one plane at the start, B moving into A.
  void touching_boxes() {
    CastFamily& family = start("touching, boxes aligned", false, grid_box);
    fill_with(family, size_.cases, judge(), Outcome::initially_overlapping, [&] {
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
