// Two hulls at rest: overlap, distance and penetration beside Bullet's and libccd's, in one run.
//
//   overlap       with unprepared bodies, with prepared ones, and from a start, beside Bullet's pair detector
//                 without a depth solver, and libccd's GJK and MPR
//   distance      the same, beside Bullet's pair detector
//   penetration   EPA, beside Bullet's pair detector with its EPA, and libccd's MPR and GJK with EPA
//
// Hulls of 8, 16 and 64 random points on the unit sphere, in random orientations. They are apart (centres 3 apart),
// near (a hundredth apart), touching (within rounding), shallow (a tenth deep along the normal) or deep (centres 0.4
// apart). Each row has 256 pairs. Contestants take turns, and each round queries every pair in an order of its own.
// Times are processor time in ns a query, as medians over the rounds. A ratio is the median of the rounds' ratios.
//
// Wrong answers are counted among the 256: verdicts that contradict our distance, except where bodies touch, and
// distances and depths that differ from ours by more than kOff. The laws compare ours with exact answers, and the
// widest of their brackets is printed. Points are on unit spheres, so the error of floats is far less than kOff.
//
// Bullet is in float, as Debian builds it, with margin 0 and the Voronoi simplex solver. libccd is in double, with the
// support function that FCL gives it: the direction is rotated by a quaternion, the vertices are scanned, and the
// result is rotated back.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <ccd/ccd.h>
#include <ccd/quat.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <functional>
#include <graze/distance.hpp>
#include <graze/overlap.hpp>
#include <graze/penetration.hpp>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "tests/shared/generate.hpp"

namespace graze::test {
namespace {

constexpr std::size_t kPairs = 256;
constexpr double kOff = 1e-3;

struct CcdBody {
  std::vector<ccd_vec3_t> points;
  ccd_vec3_t position, centre;
  ccd_quat_t turn, back;
};

void ccd_support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const auto& body = *static_cast<const CcdBody*>(object);
  ccd_vec3_t d;
  ccdVec3Copy(&d, direction);
  ccdQuatRotVec(&d, &body.back);
  const ccd_vec3_t* best = body.points.data();
  ccd_real_t most = -CCD_REAL_MAX;
  for (const ccd_vec3_t& p : body.points) {
    const ccd_real_t value = ccdVec3Dot(&p, &d);
    if (value > most) {
      most = value;
      best = &p;
    }
  }
  ccdVec3Copy(out, best);
  ccdQuatRotVec(out, &body.turn);
  ccdVec3Add(out, &body.position);
}
void ccd_centre(const void* object, ccd_vec3_t* out) {
  ccdVec3Copy(out, &static_cast<const CcdBody*>(object)->centre);
}

CcdBody ccd_body(const Body<double>& body) {
  CcdBody out;
  const auto& hull = std::get<Hull<double>>(body.shape);
  Vec3<double> mean = Vec3<double>::Zero();
  for (const Vec3<double>& v : hull.vertices()) {
    mean += v / double(hull.size());
    ccd_vec3_t p;
    ccdVec3Set(&p, v[0], v[1], v[2]);
    out.points.push_back(p);
  }
  const Quaternion<double>& q = body.orientation;
  const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  ccdQuatSet(&out.turn, q.x / norm, q.y / norm, q.z / norm, q.w / norm);
  ccdQuatInvert2(&out.back, &out.turn);
  ccdVec3Set(&out.position, body.position[0], body.position[1], body.position[2]);
  ccdVec3Set(&out.centre, mean[0], mean[1], mean[2]);
  ccdQuatRotVec(&out.centre, &out.turn);
  ccdVec3Add(&out.centre, &out.position);
  return out;
}

struct BulletBody {
  std::unique_ptr<btConvexHullShape> shape;
  btTransform pose;
};

BulletBody bullet_body(const Body<double>& body) {
  BulletBody out{std::make_unique<btConvexHullShape>(), {}};
  for (const Vec3<double>& v : std::get<Hull<double>>(body.shape).vertices())
    out.shape->addPoint({btScalar(v[0]), btScalar(v[1]), btScalar(v[2])}, false);
  out.shape->recalcLocalAabb();
  out.shape->setMargin(0);
  const Quaternion<double>& q = body.orientation;
  const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  const Vec3<double>& p = body.position;
  out.pose = btTransform(
      btQuaternion(btScalar(q.x / norm), btScalar(q.y / norm), btScalar(q.z / norm), btScalar(q.w / norm)),
      btVector3(btScalar(p[0]), btScalar(p[1]), btScalar(p[2])));
  return out;
}

struct Pair {
  Body<double> a, b;
  Prepared<double> prepared_a, prepared_b;
  WarmStart start, distance_start;  // of the same question
  BulletBody bullet_a, bullet_b;
  CcdBody ccd_a, ccd_b;
};

enum class Place { apart, near, touching, shallow, deep };
constexpr std::string_view kPlaces[] = {"apart", "near", "touching", "shallow", "deep"};

std::vector<Pair> pairs(int vertices, Place place) {
  Draw draw{5};
  std::vector<Pair> out;
  const auto hull = [&] {
    std::vector<Vec3<double>> v;
    for (int i = 0; i < vertices; ++i) v.push_back(unit(draw.vector<double>(1)));
    return Hull<double>(std::span<const Vec3<double>>(v));
  };
  while (out.size() < kPairs) {
    Body<double> a{.shape = hull(), .orientation = draw.turn<double>()},
        b{.shape = hull(), .orientation = draw.turn<double>()};
    const Vec3<double> towards = unit(draw.vector<double>(1));
    b.position = (place == Place::deep ? 0.4 : 3.0) * towards;
    if (place != Place::apart && place != Place::deep) {
      const auto d = distance(a, b);
      const double left = place == Place::near ? 0.01 : place == Place::shallow ? -0.1 : 0.0;
      b.position -= (d.lower - left) * d.normal;
    }
    out.push_back({a, b, Prepared<double>(a), Prepared<double>(b), overlap_mpr(a, b).warm,
                   distance(a, b).warm, bullet_body(a), bullet_body(b), ccd_body(a), ccd_body(b)});
  }
  return out;
}

// The signed distance. Without a depth solver it finds nothing for bodies in contact, and the result is 0.
double bullet(const Pair& p, bool depth) {
  btVoronoiSimplexSolver solver;
  btGjkEpaPenetrationDepthSolver epa;
  btGjkPairDetector detector(p.bullet_a.shape.get(), p.bullet_b.shape.get(), &solver, depth ? &epa : nullptr);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = p.bullet_a.pose;
  input.m_transformB = p.bullet_b.pose;
  btPointCollector found;
  detector.getClosestPoints(input, found, nullptr);
  return found.m_hasResult || depth ? found.m_distance : 0;
}

ccd_t ccd_settings() {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = ccd_support;
  ccd.center1 = ccd.center2 = ccd_centre;
  ccd.max_iterations = 100;
  return ccd;
}

double contact(Outcome outcome) {
  return outcome == Outcome::initially_overlapping ? 1 : outcome == Outcome::miss ? 0 : -1;
}

// `ask` returns 1 for contact and 0 for none, or the distance, or the depth.
struct Contestant {
  std::string name;
  std::function<double(const Pair&)> ask;
  std::vector<double> ns = {};
  std::size_t wrong = 0;
};

double now_ns() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e9 * double(t.tv_sec) + double(t.tv_nsec);
}

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + std::ptrdiff_t(v.size() / 2), v.end());
  return v[v.size() / 2];
}
double ratio(const Contestant& top, const Contestant& bottom) {
  std::vector<double> out;
  for (std::size_t k = 0; k < top.ns.size(); ++k) out.push_back(top.ns[k] / bottom.ns[k]);
  return median(out);
}

enum class Query { overlap, distance, penetration };
constexpr std::string_view kQueries[] = {"overlap", "distance", "penetration"};

struct Bracket {
  double lower, upper;
};
// The true answer for a pair. A verdict that the place leaves open has both values. Shallow and deep pairs may be
// apart.
Bracket truth(Query query, Place place, const Pair& p) {
  if (query == Query::overlap) {
    if (place == Place::touching) return {0, 1};
    const double known = distance(p.a, p.b).upper > 0 ? 0 : 1;
    return {known, known};
  }
  if (query == Query::distance) {
    const auto d = distance(p.a, p.b);
    return {d.lower, d.upper};
  }
  const auto d = penetration(p.a, p.b);
  return {d.lower, d.upper};
}

struct Asked {
  int rounds = 21;
  bool csv = false;
  std::string row;
};

// Our contestants come first, then theirs. The first of theirs is the rival.
void run(Query query, int vertices, Place place, const Asked& asked, std::vector<Contestant> contestants) {
  const std::string row = fmt::format("{} {}, {}", kQueries[int(query)], kPlaces[int(place)], vertices);
  if (row.find(asked.row) == std::string::npos) return;
  const std::vector<Pair> all = pairs(vertices, place);
  std::vector<std::size_t> order(all.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::mt19937 random(1);
  double kept = 0;
  for (int round = 0; round <= asked.rounds; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    for (Contestant& c : contestants) {
      const double begin = now_ns();
      for (const std::size_t i : order) kept += c.ask(all[i]);
      if (round > 0) c.ns.push_back((now_ns() - begin) / double(order.size()));
    }
  }
  double widest = 0;
  for (const Pair& p : all) {
    const Bracket known = truth(query, place, p);
    if (query != Query::overlap) widest = std::max(widest, known.upper - known.lower);
    for (Contestant& c : contestants) {
      const double answer = c.ask(p);
      c.wrong += answer >= known.lower - kOff && answer <= known.upper + kOff ? 0 : 1;
    }
  }
  const auto is_ours = [](const Contestant& c) { return c.name.starts_with("graze"); };
  const Contestant& rival = *std::ranges::find_if_not(contestants, is_ours);
  if (asked.csv) {
    for (const Contestant& c : contestants)
      fmt::print("{},\"{}, {}\",{},,\"{}\",{:.1f},,{},{:.3f}\n", kQueries[int(query)], kPlaces[int(place)],
                 vertices, all.size(), c.name, median(c.ns), c.wrong, ratio(c, rival));
    return;
  }
  fmt::print("{:<12} {:<9} {:>2} ", kQueries[int(query)], kPlaces[int(place)], vertices);
  for (const Contestant& c : contestants) fmt::print(" | {} {:.0f}", c.name, median(c.ns));
  fmt::print("\n{:>26} ", "ratio");
  for (const Contestant& ours : contestants) {
    for (const Contestant& c : contestants) {
      if (is_ours(ours) && !is_ours(c)) fmt::print(" | {} : {} {:.2f}", ours.name, c.name, ratio(ours, c));
    }
  }
  fmt::print("\n{:>26} ", "wrong");
  for (const Contestant& c : contestants) fmt::print(" | {} {}", c.name, c.wrong);
  fmt::print(" | of {}", all.size());
  if (query != Query::overlap) fmt::print(", our widest bracket {:.1g}", widest);
  fmt::print("\n");
  if (kept == 0.123) fmt::print("\n");
}

void run_all(const Asked& asked) {
  const ccd_t ccd = ccd_settings();
  const Contestant bullet_gjk{"Bullet", [](const Pair& p) { return bullet(p, false); }};
  const Contestant bullet_epa{"Bullet EPA", [](const Pair& p) { return std::max(-bullet(p, true), 0.0); }};
  const Contestant ccd_gjk{
      "libccd GJK", [ccd](const Pair& p) { return double(ccdGJKIntersect(&p.ccd_a, &p.ccd_b, &ccd)); }};
  const Contestant ccd_mpr{
      "libccd MPR", [ccd](const Pair& p) { return double(ccdMPRIntersect(&p.ccd_a, &p.ccd_b, &ccd)); }};
  const auto depth_of = [ccd](const Pair& p, auto query) {
    ccd_real_t depth = 0;
    ccd_vec3_t direction, position;
    query(&p.ccd_a, &p.ccd_b, &ccd, &depth, &direction, &position);
    return double(depth);
  };
  const Contestant ccd_epa_depth{"libccd EPA", [=](const Pair& p) { return depth_of(p, ccdGJKPenetration); }};
  const Contestant ccd_mpr_depth{"libccd MPR", [=](const Pair& p) { return depth_of(p, ccdMPRPenetration); }};
  const Contestant mpr{"graze mpr", [](const Pair& p) { return contact(overlap_mpr(p.a, p.b).outcome); }};
  const Contestant mpr_prepared{"graze mpr prepared", [](const Pair& p) {
                                  return contact(overlap_mpr(p.prepared_a, p.prepared_b).outcome);
                                }};
  const Contestant mpr_start{"graze mpr prepared, start", [](const Pair& p) {
                               return contact(overlap_mpr(p.prepared_a, p.prepared_b, p.start).outcome);
                             }};
  const Contestant gjk{"graze gjk", [](const Pair& p) { return contact(overlap_gjk(p.a, p.b).outcome); }};
  const Contestant gjk_distance{"graze", [](const Pair& p) { return distance(p.a, p.b).upper; }};
  const Contestant distance_prepared{
      "graze prepared", [](const Pair& p) { return distance(p.prepared_a, p.prepared_b).upper; }};
  const Contestant distance_start{"graze prepared, start", [](const Pair& p) {
                                    const DistanceOptions<double> options{.start = p.distance_start};
                                    return distance(p.prepared_a, p.prepared_b, options).upper;
                                  }};
  const Contestant epa{"graze", [](const Pair& p) { return penetration(p.a, p.b).upper; }};
  const Contestant epa_prepared{"graze prepared",
                                [](const Pair& p) { return penetration(p.prepared_a, p.prepared_b).upper; }};

  for (const int n : {8, 16, 64}) {
    for (const Place place : {Place::apart, Place::near, Place::touching, Place::shallow, Place::deep})
      run(Query::overlap, n, place, asked, {mpr, mpr_prepared, mpr_start, gjk, ccd_mpr, ccd_gjk});
  }
  for (const int n : {8, 16, 64}) {
    for (const Place place : {Place::apart, Place::near, Place::touching})
      run(Query::distance, n, place, asked, {gjk_distance, distance_prepared, distance_start, bullet_gjk});
  }
  for (const int n : {8, 16, 64}) {
    for (const Place place : {Place::touching, Place::shallow, Place::deep})
      run(Query::penetration, n, place, asked, {epa, epa_prepared, bullet_epa, ccd_mpr_depth, ccd_epa_depth});
  }
}

int run(int argc, char** argv) {
  CLI::App app(
      "Measures what overlap, distance and penetration of two hulls at rest cost, beside Bullet's and "
      "libccd's.");
  Asked asked;
  app.add_option("--rounds", asked.rounds, "rounds that the median is taken over")
      ->check(CLI::PositiveNumber);
  app.add_option("--row", asked.row, "only rows whose name contains this: distance near, 8");
  app.add_flag("--csv", asked.csv, "one line a row and contestant, as cast_bench");
  CLI11_PARSE(app, argc, argv);
  if (asked.csv) fmt::print("set,family,cases,contacts,contestant,ns,p99_over_median,wrong,over_rival\n");
  run_all(asked);
  return 0;
}

}  // namespace
}  // namespace graze::test

int main(int argc, char** argv) { return graze::test::run(argc, argv); }
