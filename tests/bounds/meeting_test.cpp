// The decisions of the exact tier in plain doubles on its way to an answer (search/exact/meeting.hpp,
// beyond.hpp, walk.hpp, search/fast/fast_walk.hpp): each stated error against exact numbers.
#include <gtest/gtest.h>

#include <graze/detail/search/exact/meeting.hpp>
#include <graze/detail/search/exact/passage.hpp>
#include <graze/detail/search/fast/swept_support.hpp>

#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/bound_truth.hpp"
#include "tests/bounds/describe.hpp"

namespace graze::test {
namespace {

using detail::exact::Dyadic;
using detail::exact::Facet;
using detail::exact::Meeting;
using detail::exact::Pair;
using detail::exact::Scene;
using detail::exact::Steps;
using detail::exact::Term;
using detail::exact::Vertex;
using oracle::WorkingPrecision;

constexpr long kExactBits = 16000;

using test::exactly;
BallVec exactly(const detail::exact::Exact& x) {
  const Ball weight = exactly(x.weight);
  return {exactly(x.x[0]) / weight, exactly(x.x[1]) / weight, exactly(x.x[2]) / weight};
}
BallVec exactly(const detail::Triple& x) { return BallVec(x.vector()); }
Ball largest_of(const BallVec& x) { return max(abs(x.x), max(abs(x.y), abs(x.z))); }

// --- numbers

TEST(MeetingBounds, ProductsAndQuotientsOfPairs) {
  const WorkingPrecision precision(4096);
  HostileDraw draw(191);
  Tally products("Pair times a double, over 2^-97 X s"), quotients("Pair over a weight, over 2^-97 X / w");
  const auto pair = [&](double size) {
    Pair out{size * (draw.chance(0.4) ? 1 - draw.power(-53, -45) : draw.plain().between(-1, 1)), 0};
    out.lo = 0x1p-49 * size * (draw.chance(0.4) ? 1 - draw.power(-53, -45) : draw.plain().between(-1, 1));
    return out;
  };
  for (int i = 0; i < rounds(20000); ++i) {
    const double size = draw.power(-3, 3);
    const Pair x = pair(size);
    const double s = draw.plain().between(-4, 4);
    const double w_hi = 1 + 15 * draw.plain().between(0, 1);
    const Pair w{w_hi, 0x1p-49 * w_hi * draw.plain().between(-1, 1)};
    const Ball true_x = Ball(x.hi) + Ball(x.lo), true_w = Ball(w.hi) + Ball(w.lo);
    const auto with = [&] {
      std::ostringstream out;
      out << std::hexfloat << "  " << x.hi << " + " << x.lo << ", " << s << ", " << w.hi << " + " << w.lo
          << "\n";
      return out.str();
    };
    const Pair product = detail::exact::times(x, s), quotient = detail::exact::over(x, w, 1 / rounded(w));
    products.add(0x1p-97,
                 abs(Ball(product.hi) + Ball(product.lo) - true_x * Ball(s)) / Ball(2 * size * std::abs(s)),
                 with);
    quotients.add(0x1p-97,
                  abs(Ball(quotient.hi) + Ball(quotient.lo) - true_x / true_w) * true_w / Ball(2 * size),
                  with);
  }
  products.finish(5000);
  quotients.finish(5000);
}

// A number, often one that was used before.
class Numbers {
 public:
  explicit Numbers(HostileDraw& draw) : draw_(draw) {}
  double next() {
    if (!seen_.empty() && draw_.chance(0.3)) return seen_[draw_.below(seen_.size())];
    const double x = draw_.plain().between(-1, 1) * (draw_.chance(0.5) ? 1 : draw_.power(-60, 30));
    seen_.push_back(draw_.chance(0.2) ? std::round(x) : x);
    return seen_.back();
  }
  detail::Triple triple() {
    const double x = next(), y = next();
    return {x, y, next()};
  }

 private:
  HostileDraw& draw_;
  std::vector<double> seen_;
};

TEST(MeetingBounds, NormalsOfEdgesInDoubles) {
  const WorkingPrecision precision(4096);
  HostileDraw draw(192);
  Tally errors("normal_error of two edges of C, nothing turned");
  int zeros = 0;
  for (int i = 0; i < rounds(3000); ++i) {
    Numbers numbers(draw);
    const bool of_b = draw.chance(0.7), of_a = !of_b || draw.chance(0.7);
    std::array<detail::Triple, 3> a, b;
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = of_a || k == 0 ? numbers.triple() : a[0];
      b[k] = of_b || k == 0 ? numbers.triple() : b[0];
    }
    const Steps e{a[1] - a[0], b[1] - b[0]}, f{a[2] - a[0], b[2] - b[0]};
    const Vec3<double> error = detail::exact::normal_error(e, f), n = cross(e.edge(), f.edge()).vector();
    const auto edge = [&](std::size_t k) {
      return (exactly(a[k]) - exactly(a[0])) - (exactly(b[k]) - exactly(b[0]));
    };
    const BallVec truth = cross(edge(1), edge(2));
    const auto with = [&] {
      std::ostringstream out;
      out << std::hexfloat;
      for (std::size_t k = 0; k < 3; ++k) {
        write(out, a[k].vector());
        write(out, b[k].vector());
      }
      return out.str();
    };
    errors.add(error[0], abs(Ball(n[0]) - truth.x), with);
    errors.add(error[1], abs(Ball(n[1]) - truth.y), with);
    errors.add(error[2], abs(Ball(n[2]) - truth.z), with);
    zeros += (error.array() == 0).count() > 0;
  }
  errors.finish(2000);
  EXPECT_GT(zeros, rounds(50));
}

// --- pairs of bodies

struct Scenery {
  Body<double> a, b;
  [[nodiscard]] std::string text() const {
    std::ostringstream out;
    out << std::hexfloat << "  A: ";
    write(out, RotatingBody<double>{a});
    out << " to ";
    write(out, a.displacement);
    out << "\n  B: ";
    write(out, RotatingBody<double>{b});
    out << " to ";
    write(out, b.displacement);
    out << "\n";
    return out.str();
  }
};
enum class Turns { none, one, alike, both };

class Sceneries {
 public:
  explicit Sceneries(std::uint64_t seed) : draw_(seed) {}
  HostileDraw& draw() { return draw_; }

  Scenery next(Turns turns) {
    // Numbers of few bits, or any doubles, flattened along an axis or far out in the body's own frame.
    few_bits_ = draw_.chance(0.3);
    Scenery out;
    out.a.shape = shape();
    out.b.shape = shape();
    out.a.position = place();
    out.b.position = place();
    out.a.displacement = draw_.chance(0.3) ? Vec3<double>(Vec3<double>::Zero()) : place();
    out.b.displacement = place();
    if (out.a.displacement == out.b.displacement) out.b.displacement[0] += 1;
    if (turns == Turns::both || turns == Turns::one || turns == Turns::alike) out.b.orientation = turn();
    if (turns == Turns::both) out.a.orientation = turn();
    if (turns == Turns::alike) out.a.orientation = out.b.orientation;
    return out;
  }

 private:
  double number() {
    if (few_bits_) return 0.125 * (double(draw_.below(33)) - 16);
    return draw_.plain().between(-1, 1);
  }
  Vec3<double> vector() {
    const double x = number(), y = number();
    return {x, y, number()};
  }
  Vec3<double> place() {
    Vec3<double> x = 4 * vector();
    if (!few_bits_ && draw_.chance(0.2)) x *= draw_.power(-20, 30);
    return x;
  }
  Quaternion<double> turn() {
    Quaternion<double> q = draw_.plain().turn<double>();
    if (draw_.chance(0.2)) q = {1, draw_.power(-50, 0), 0, 0};
    if (draw_.chance(0.2)) q = {1, double(draw_.below(2)), double(draw_.below(2)), double(draw_.below(2))};
    const double length = draw_.chance(0.5) ? 1 : draw_.plain().between(1, 2);
    return {length * q.w, length * q.x, length * q.y, length * q.z};
  }
  Shape<double> shape() {
    const std::uint64_t kind = draw_.below(6);
    if (kind == 0) return Box<double>{vector().cwiseAbs() + Vec3<double>(0.25, 0.25, 0.25)};
    if (kind == 1) return Segment<double>{vector(), vector()};
    if (kind == 2) {
      const Vec3<double> x = vector(), y = vector();
      return Triangle<double>{x, y, vector()};
    }
    // A prism or points at random.
    std::vector<Vec3<double>> list;
    const Vec3<double> along = vector();
    const std::size_t n = 4 + draw_.below(5);
    for (std::size_t i = 0; i < n; ++i) list.push_back(vector());
    if (kind == 3) {
      for (std::size_t i = 0; i < n; ++i) list.push_back(list[i] + along);
    }
    if (!few_bits_) {
      const double thin = draw_.chance(0.3) ? draw_.power(-30, 0) : 1;
      const Vec3<double> out = draw_.chance(0.3) ? Vec3<double>(draw_.power(0, 30) * vector())
                                                 : Vec3<double>(Vec3<double>::Zero());
      for (Vec3<double>& x : list) x = Vec3<double>(x[0], x[1], thin * x[2]) + out;
    }
    return Hull<double>(std::span<const Vec3<double>>(list));
  }

  HostileDraw draw_;
  bool few_bits_ = false;
};

Vertex vertex_of(HostileDraw& draw, const Scenery& s) {
  return {static_cast<std::uint32_t>(draw.below(detail::vertex_count<double>(s.a.shape))),
          static_cast<std::uint32_t>(draw.below(detail::vertex_count<double>(s.b.shape)))};
}
// Any three vertices of C that the path crosses the plane of, n.v > 0: often a face of one body, or an edge of each.
bool any_facet(HostileDraw& draw, const Scenery& s, const Scene<double>& scene, Facet& out) {
  std::array<Vertex, 3> c;
  for (Vertex& v : c) v = vertex_of(draw, s);
  const std::uint64_t kind = draw.below(4);
  if (kind == 0) c[1].a = c[2].a = c[0].a;
  if (kind == 1) c[1].b = c[2].b = c[0].b;
  if (kind == 2) {
    c[1].b = c[0].b;
    c[2].a = draw.chance(0.5) ? c[0].a : c[1].a;
  }
  for (int flip = 0; flip < 2; ++flip) {
    out = {c[0], Term::difference(c[0], c[1]), Term::difference(c[0], c[2]), c, 3};
    const int sign = scene.determinant_sign(out.f1, out.f2, Term::motion());
    if (sign > 0) return true;
    if (sign == 0) return false;
    std::swap(c[1], c[2]);
  }
  return false;
}

std::array<BallVec, 3> corners(const Scene<double>& scene, const Facet& facet) {
  std::array<BallVec, 3> out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = exactly(scene.exact(Term::point(facet.corner[k])));
  return out;
}

constexpr std::array kTurns = {Turns::none, Turns::one, Turns::alike, Turns::both};

// The time at which the path meets the plane of any three vertices is within the stated error, and rounds to
// the same doubles as the exact number. The plane's normal is within 2 u.
TEST(MeetingBounds, TimesOfAnyFacets) {
  const WorkingPrecision precision(kExactBits);
  Sceneries sceneries(193);
  HostileDraw& draw = sceneries.draw();
  Tally quotients("Meeting: time, over its error"), normals("Meeting: unit normal, over 2 u");
  int decided = 0, looked_at = 0;
  for (int i = 0; i < rounds(1200); ++i) {
    const Scenery s = sceneries.next(kTurns[static_cast<std::size_t>(i) % kTurns.size()]);
    const detail::PreparedPair<double> pair(s.a, s.b);
    const Scene<double> scene(s.a, s.b, pair.length_exponent(), pair.speed_exponent());
    Facet facet;
    if (!any_facet(draw, s, scene, facet)) continue;
    const Term v = Term::motion();
    const Meeting<double> meeting(pair, scene, facet, v);
    const auto* q = meeting.quotient();
    if (q == nullptr) continue;
    ++looked_at;
    const auto with = [&] { return s.text(); };
    const detail::exact::ExactTime time = detail::exact::exact_time(scene, facet, v);
    const std::array<BallVec, 3> c = corners(scene, facet);
    ASSERT_TRUE(scene.valid());
    const Ball t = exactly(time.numerator) / exactly(time.denominator) *
                   two_to(pair.speed_exponent() - pair.length_exponent());
    quotients.add(q->error, abs(t - Ball(q->s) - Ball(q->delta)), with);
    const BallVec n = unit_of(cross(c[1] - c[0], c[2] - c[0]));
    normals.add(2 * kUnitRoundoff<double>, largest_of(BallVec(meeting.normal()) - n), with);
    const int before = scene.exact_decisions();
    const detail::exact::TimeBracket found = meeting.time(), truth = detail::exact::bracket_of(time);
    decided += scene.exact_decisions() == before;
    EXPECT_TRUE(found.lower == truth.lower && found.upper == truth.upper) << s.text();
  }
  quotients.finish(300);
  normals.finish(300);
  std::printf("meetings: %d, of which %d without exact numbers\n", looked_at, decided);
  EXPECT_GT(decided, looked_at * 4 / 5);
}

// The two witnesses that a meeting returns are one point, to within the rounding of their sums. The distance
// that pairs of doubles leave between them is small here.
TEST(MeetingBounds, WitnessesOfFacetsThatAreMet) {
  const WorkingPrecision precision(kExactBits);
  Sceneries sceneries(194);
  Tally apart("Meeting: witnesses apart, over 16 u of what they are added up from"),
      gaps("Meeting: g, over its error");
  for (int i = 0; i < rounds(2000); ++i) {
    Scenery s = sceneries.next(kTurns[static_cast<std::size_t>(i) % kTurns.size()]);
    s.b.position += 8 * Vec3<double>(1, 0.5, 0.25);
    // At each other.
    s.b.displacement = 2 * (s.a.position - s.b.position);
    s.a.displacement.setZero();
    Counters counters;
    detail::exact::PassageSearch<double> search(s.a, s.b, counters);
    const detail::exact::Answer answer = search.pass();
    if (answer.passage != detail::exact::Passage::ahead || answer.facet.size != 3) continue;
    Meeting<double> meeting(search.pair(), search.scene(), answer.facet, search.v());
    const double t = meeting.time().lower;
    const auto [p, q] = meeting.witnesses(t);
    const double unit = power_of_two(search.pair().length_exponent());
    const double size = unit * (search.pair().a().reach() + search.pair().b().reach()) + s.a.position.norm() +
                        s.b.position.norm() + t * s.b.displacement.norm() +
                        search.pair().a().placed_center().vector().norm() +
                        search.pair().b().placed_center().vector().norm();
    const auto with = [&] { return s.text(); };
    apart.add(16 * kUnitRoundoff<double> * size, largest_of(BallVec(p) - BallVec(q)), with);
    const auto* found = meeting.quotient();
    if (found == nullptr || i % 3 != 0) continue;
    const std::array<BallVec, 3> c = corners(search.scene(), answer.facet);
    const BallVec point =
        c[0] + Ball(found->lambda[0]) * (c[1] - c[0]) + Ball(found->lambda[1]) * (c[2] - c[0]);
    const BallVec g = point - Ball(found->s) * exactly(search.scene().exact(search.v()));
    // It is handed on rounded: where that counts little it says something of g_error.
    const double rounding = kUnitRoundoff<double> * largest(found->g);
    if (rounding < found->g_error / 16)
      gaps.add(found->g_error + rounding, largest_of(exactly(found->g) - g), with);
  }
  apart.finish(200);
  gaps.finish(100);
}

// --- beyond.hpp: a face of one body, or of two that turn as one, in its own axes

TEST(MeetingBounds, WhatIsBeyondAFaceInItsOwnAxes) {
  Sceneries sceneries(195);
  HostileDraw& draw = sceneries.draw();
  int found = 0, none = 0, exact_signs = 0;
  for (int i = 0; i < rounds(400); ++i) {
    const bool alike = i % 2 == 0;
    const Scenery s = sceneries.next(alike ? Turns::alike : Turns::both);
    const detail::PreparedPair<double> pair(s.a, s.b);
    const Scene<double> scene(s.a, s.b, pair.length_exponent(), pair.speed_exponent());
    const detail::exact::BeyondSearch<double> search(scene, pair);
    std::array<Vertex, 3> c;
    for (Vertex& v : c) v = vertex_of(draw, s);
    const bool of_a = draw.chance(0.5);
    if (!alike) (of_a ? c[1].b : c[1].a) = (of_a ? c[2].b : c[2].a) = of_a ? c[0].b : c[0].a;
    const auto step = [&](std::size_t k) -> Steps {
      return {pair.a().own(c[k].a) - pair.a().own(c[0].a), pair.b().own(c[k].b) - pair.b().own(c[0].b)};
    };
    const Steps e = step(1), f = step(2);
    const detail::Triple own = cross(e.edge(), f.edge());
    detail::exact::Direction n{Term::difference(c[0], c[1]), Term::difference(c[0], c[2]), 1, own.vector()};
    // In the world's axes nothing is known.
    n.error.setConstant(0x1p600);
    n.of_body = {alike || of_a, alike || !of_a};
    n.own = own.vector();
    n.own_error = detail::exact::normal_error(e, f);
    const detail::exact::Dyadic3 along = detail::exact::cross(scene.exact(n.f1).x, scene.exact(n.f2).x);
    const int before = scene.exact_decisions();
    Vertex beyond{};
    const bool seen = search.find(n, c[0], std::array{c[1], c[2]}, beyond);
    exact_signs += scene.exact_decisions() - before;
    bool truth = false;
    for (std::uint32_t l = 0; l < scene.leaves().size(); ++l) {
      const auto& leaf = scene.leaves()[l];
      for (std::uint32_t k = 0; k < leaf.count; ++k) {
        if (k == leaf.vertex(c[0])) continue;
        const detail::exact::Dyadic height =
            detail::exact::dot(scene.exact(Term::step(l, leaf.vertex(c[0]), k)).x, along);
        truth = truth || height.sign() > 0;
      }
    }
    ASSERT_TRUE(scene.valid());
    EXPECT_EQ(seen, truth) << s.text();
    (truth ? found : none) += 1;
  }
  std::printf("beyond a face: %d found, %d none, %d signs by exact numbers\n", found, none, exact_signs);
  EXPECT_GT(found, rounds(100));
  EXPECT_GT(none, rounds(10));
}

// --- walk.hpp: on which side of an edge the middle of a triangle is, as o is moved where it ties

TEST(MeetingBounds, SidesOfTheMiddle) {
  const WorkingPrecision precision(kExactBits);
  Sceneries sceneries(197);
  HostileDraw& draw = sceneries.draw();
  Tally sides("side_of_middle, over its error");
  for (int i = 0; i < rounds(800); ++i) {
    const Scenery s = sceneries.next(kTurns[static_cast<std::size_t>(i) % kTurns.size()]);
    const detail::PreparedPair<double> pair(s.a, s.b);
    const Scene<double> scene(s.a, s.b, pair.length_exponent(), pair.speed_exponent());
    const detail::exact::Line line(Term::motion(), pair.direction());
    const detail::exact::Bounds bounds(pair);
    const auto corner = [&](const Vertex& v) {
      detail::exact::Corner out;
      out.id = v;
      out.w = pair.a().at(v.a) - (pair.b().at(v.b) + pair.offset());
      out.qx = dot(line.across_x, out.w);
      out.qy = dot(line.across_y, out.w);
      return out;
    };
    std::array<Vertex, 3> around;
    double x = 0, y = 0;
    for (Vertex& v : around) {
      v = vertex_of(draw, s);
      x += corner(v).qx;
      y += corner(v).qy;
    }
    const Vertex c = vertex_of(draw, s), d = vertex_of(draw, s);
    if (c == d) continue;
    const detail::exact::Measured found =
        detail::exact::side_of_middle(corner(c), corner(d), x, y, bounds.seen);
    const BallVec v = exactly(scene.exact(Term::motion()));
    const std::array<Ball, 3> along = {v.x, v.y, v.z};
    const Ball truth = dot(exactly(scene.exact(Term::difference(c, d))),
                           cross(exactly(scene.exact(Term::inside(around, c))), v)) /
                       along[static_cast<std::size_t>(line.z)];
    sides.add(found.error, abs(Ball(found.value) - truth), [&] { return s.text(); });
  }
  sides.finish(400);
}

// --- fast_walk.hpp: an axis that proves a miss

TEST(MeetingBounds, HeightsAlongAnAxisOfTheQuickWalk) {
  const WorkingPrecision precision(kExactBits);
  Sceneries sceneries(196);
  HostileDraw& draw = sceneries.draw();
  Tally heights("FastWalk: n.w and the path's end, over its margin"),
      motions("n.r of the path, over 16 u |n|_1");
  for (int i = 0; i < rounds(300); ++i) {
    const Scenery s = sceneries.next(kTurns[static_cast<std::size_t>(i) % kTurns.size()]);
    const detail::PreparedPair<double> pair(s.a, s.b);
    const Scene<double> scene(s.a, s.b, pair.length_exponent(), pair.speed_exponent());
    const double horizon = pair.extent() * draw.plain().between(0, 2);
    Counters counters;
    const detail::FastWalk<double, true> walk(pair, horizon, 0, detail::kFastSteps, counters);
    detail::Triple n = detail::triple(draw.plain().vector<double>(1));
    // Often nearly the normal of a face, along which several vertices are nearly as far.
    if (draw.chance(0.5)) {
      const Vertex x = vertex_of(draw, s), y = vertex_of(draw, s), z = vertex_of(draw, s);
      const auto at = [&](const Vertex& v) { return pair.a().at(v.a) - pair.b().at(v.b); };
      const detail::Triple face = cross(at(y) - at(x), at(z) - at(x));
      if (sum(magnitude(face)) > 0x1p-60) n = face;
    }
    Vertex w{};
    const detail::Triple a = pair.a().farthest(n, w.a), b = pair.b().farthest(-n, w.b), d = pair.offset();
    const detail::Triple far{a.x - (b.x + d.x), a.y - (b.y + d.y), a.z - (b.z + d.z)};
    const BallVec true_n = exactly(n), v = exactly(scene.exact(Term::motion()));
    const auto height = [&](const Vertex& at) { return dot(true_n, exactly(scene.exact(Term::point(at)))); };
    Vertex best = w;
    for (std::uint32_t k = 0; k < detail::vertex_count<double>(s.a.shape); ++k) {
      if (certainly_less(height(best), height({k, best.b}))) best.a = k;
    }
    for (std::uint32_t k = 0; k < detail::vertex_count<double>(s.b.shape); ++k) {
      if (certainly_less(height(best), height({best.a, k}))) best.b = k;
    }
    const double size = sum(magnitude(n));
    const auto with = [&] { return s.text(); };
    const Ball truth = abs(height(best) - Ball(dot(n, far))) +
                       abs(Ball(horizon) * dot(true_n, v) - Ball(dot(n, walk.end())));
    heights.add(walk.margin() * size, truth, with);
    motions.add(16 * kUnitRoundoff<double> * size, abs(dot(true_n, v) - Ball(dot(n, pair.direction()))),
                with);
  }
  heights.finish(200);
  motions.finish(50);
}

// --- swept_support.hpp: a vertex of the swept set

TEST(MeetingBounds, VerticesOfTheSweptSet) {
  const WorkingPrecision precision(kExactBits);
  Sceneries sceneries(197);
  HostileDraw& draw = sceneries.draw();
  Tally vertices("SweptSupport: a vertex of D, over e + the offset's error + 11 u M");
  int moved = 0;
  for (int i = 0; i < rounds(600); ++i) {
    const Scenery s = sceneries.next(kTurns[static_cast<std::size_t>(i) % kTurns.size()]);
    const detail::PreparedPair<double> pair(s.a, s.b);
    if (!pair.moves()) continue;
    const Scene<double> scene(s.a, s.b, pair.length_exponent(), pair.speed_exponent());
    const double end = detail::swept_reach(
        pair, draw.chance(0.5) ? kInfinity<double> : pair.extent() * draw.plain().between(0, 2));
    Counters counters;
    detail::SweptSupport<double> support(pair, end, counters);
    const detail::Triple n = detail::triple(draw.plain().vector<double>(1));
    if (detail::is_small_direction(n)) continue;
    detail::PairVertex found;
    draw.chance(0.5) ? support.guess(n, found) : support.sure(n, found);
    const bool is_moved = dot(n, pair.direction()) < 0;
    moved += is_moved ? 1 : 0;
    const Vertex v{found.vertex_a & ~(std::uint32_t{1} << 31), found.vertex_b};
    BallVec truth = exactly(scene.exact(Term::point(v)));
    if (is_moved) truth = truth - Ball(end) * exactly(scene.exact(Term::motion()));
    const double bound = pair.a().error() + pair.b().error() + pair.offset_error() +
                         11 * kUnitRoundoff<double> * pair.extent();
    for (const Ball& off : {truth.x - Ball(found.w.x), truth.y - Ball(found.w.y), truth.z - Ball(found.w.z)})
      vertices.add(bound, abs(off), [&] { return s.text(); });
  }
  EXPECT_GT(moved, 100);
  vertices.finish(600);
}

}  // namespace
}  // namespace graze::test
