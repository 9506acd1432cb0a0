// The families of rotating casts: boxes, or hulls of 12, with random orientations at the start.
//
// Bodies are half a unit to a unit in size, half extents and radii, and fly four to six units. Their judge is tier
// certified: its verdicts, and the times by which there is contact, are proved.
#include <Eigen/Geometry>  // cross
#include <graze/rotating_cast.hpp>

#include "bench/draw_casts.hpp"

namespace graze::bench {
namespace {

Shape<double> box(Random& random) {
  const double x = random.uniform(0.5, 1), y = random.uniform(0.5, 1);
  return Box<double>{to_float(Vec3<double>(x, y, random.uniform(0.5, 1)))};
}
Shape<double> hull_of_12(Random& random) { return round_hull(random, 12, 1); }

RotatingResult<double> judged(const CastFamily& family, const CastCase& c) {
  return cast(turning_body_of<double>(c.a, family.shapes), turning_body_of<double>(c.b, family.shapes),
              {.tier = Tier::certified, .request = Request::verdict});
}

// Keeps a case with its verdict, if it has one and starts apart, until `most` are alike.
bool keep(CastFamily& family, CastCase c, std::size_t most_hits, std::size_t most_misses) {
  const RotatingResult<double> known = judged(family, c);
  c.contact = known.outcome == Outcome::hit;
  if (!c.contact && known.outcome != Outcome::miss) return false;
  if (c.contact) c.latest = known.toi_upper;
  const auto hits = static_cast<std::size_t>(family.contacts()), misses = family.cases.size() - hits;
  if (c.contact ? hits >= most_hits : misses >= most_misses) return false;
  family.cases.push_back(std::move(c));
  return true;
}

void spin(Random& random, Placed& body, double least, double most) {
  body.rotation = to_float(Vec3<double>(random.uniform(least, most) * direction(random)));
}
// Moves the pivot that far from the body's origin.
void move_pivot(Random& random, Placed& body, double away) {
  body.pivot = to_float(Vec3<double>(away * direction(random)));
}

CastCase spinning(Random& random, const CastFamily& family, double least, double most) {
  CastCase c = aimed(random, family, 1, 4, 1.3);
  spin(random, c.a, least, most);
  spin(random, c.b, least, most);
  return c;
}

// Half a radian about a point six to ten units away is a path of some three to five, so the rotation makes all of it.
CastCase about_far_pivots(Random& random, const CastFamily& family) {
  CastCase c = spinning(random, family, 0.2, 0.8);
  move_pivot(random, c.b, random.uniform(6, 10));
  if (random.once_in(2)) move_pivot(random, c.a, random.uniform(6, 10));
  c.b.displacement = to_float(Vec3<double>(c.a.displacement + in_cube(random, 1)));
  return c;
}

// Passes A at `beside` from its path, aside from where it flies.
CastCase passing(Random& random, const CastFamily& family, double beside) {
  CastCase c = spinning(random, family, 0.2, 1.5);
  const Vec3<double> along = direction(random), aside = along.cross(direction(random)).normalized();
  const double away = random.uniform(4, 6);
  c.b.position = to_float(Vec3<double>(c.a.position - away * along + beside * aside));
  c.b.displacement = to_float(Vec3<double>(c.a.displacement + random.uniform(1.6, 2) * away * along));
  return c;
}

// The cases within `near` of the end of contact: those on either side in a bisection.
void add_grazing(Random& random, CastFamily& family, double near, std::size_t half) {
  const Random start = random;
  const auto at = [&](double beside) {
    random = start;  // the same draw
    return passing(random, family, beside);
  };
  double inside = 0, outside = 4;
  if (judged(family, at(inside)).outcome != Outcome::hit ||
      judged(family, at(outside)).outcome != Outcome::miss)
    return;
  while (outside - inside > near) {
    const double middle = (inside + outside) / 2;
    (judged(family, at(middle)).outcome == Outcome::hit ? inside : outside) = middle;
  }
  keep(family, at(inside), half, half);
  keep(family, at(outside), half, half);
}

}  // namespace

std::vector<CastFamily> rotating_families(const FamilySize& size) {
  std::vector<CastFamily> out;
  const auto add = [&](const std::string& kind, bool boxes, const auto& fill) {
    const std::string name = kind + (boxes ? ", boxes" : ", hulls of 12");
    Random random(corpus::fnv1a(name));
    CastFamily& family = out.emplace_back();
    family.name = name;
    family.rotated = family.turning = true;
    for (std::size_t i = 0; i < size.shapes; ++i)
      family.shapes.push_back(boxes ? box(random) : hull_of_12(random));
    while (family.cases.size() < size.cases) fill(random, family);
  };
  const std::size_t half = (size.cases + 1) / 2;
  for (const bool boxes : {true, false}) {
    add("moderate spin", boxes, [&](Random& random, CastFamily& family) {
      keep(family, spinning(random, family, 0.2, 1.5), half, half);
    });
    add("fast spin", boxes, [&](Random& random, CastFamily& family) {
      keep(family, spinning(random, family, 6, 12), half, half);
    });
    add("far pivot", boxes, [&](Random& random, CastFamily& family) {
      keep(family, about_far_pivots(random, family), half, half);
    });
    add("grazing, 1e-2", boxes,
        [&](Random& random, CastFamily& family) { add_grazing(random, family, 1e-2, half); });
    add("grazing, 1e-5", boxes,
        [&](Random& random, CastFamily& family) { add_grazing(random, family, 1e-5, half); });
    add("clear miss", boxes, [&](Random& random, CastFamily& family) {
      keep(family, passing(random, family, random.uniform(2.5, 5)), 0, size.cases);
    });
  }
  return out;
}

}  // namespace graze::bench
