// The priced topics: families in which accuracy has a price, one by one, polytopes, in which it has none,
// curves of growth, the cost of each request, and queries other than casts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "corpus/families.hpp"
#include "engines/convert.hpp"
#include "reports/price/draw_price.hpp"
#include "reports/price/shapes.hpp"

namespace graze::price {
namespace {

using corpus::Case;
using engine::Kind;

constexpr const char* kBestLinear = "gjk/double";
constexpr const char* kBestTurning = "bilateral/double";

// How many cases a table has.
struct Effort {
  std::size_t smooth, turning, polytopes, points, requests, queries;
};
constexpr Effort kFast = {24, 12, 32, 12, 32, 48}, kThorough = {192, 64, 256, 64, 128, 256};

// A case of the corpus' families whose numbers are then floats, one level after the other.
std::function<Case(Random&, std::size_t)> of_families(std::vector<const char*> names, double first,
                                                      double last) {
  return [names = std::move(names), first, last](Random& random, std::size_t place) {
    const corpus::Family& family = *corpus::find_family(names[place % names.size()]);
    std::vector<double> levels;
    for (const double level : family.levels) {
      if (first <= level && level <= last) levels.push_back(level);
    }
    const double level =
        levels.empty() ? family.levels.front() : levels[place / names.size() % levels.size()];
    Case problem = engine::rounded_case<float>(family.generate(level, random.bits() % 1'000'000));
    if (!std::isfinite(problem.t_max)) problem.t_max = 4;
    return problem;
  };
}

Topic family(const char* name, const char* group, std::string title, std::string sentence, std::size_t cases,
             std::function<Case(Random&, std::size_t)> draw) {
  Topic topic;
  topic.head.part = Part::family;
  topic.head.name = name;
  topic.head.group = group;
  topic.head.title = std::move(title);
  topic.head.sentence = std::move(sentence);
  topic.head.baseline = kBestLinear;
  topic.cases = cases;
  topic.draw = std::move(draw);
  return topic;
}

Topic turning(Topic topic) {
  topic.kind = Kind::rotating;
  topic.head.baseline = kBestTurning;
  topic.in_float = false;  // the rotating methods compute in double whatever the scalar is
  return topic;
}

void add_smooth(std::vector<Topic>& out, const Effort& effort) {
  for (int kind = 0; kind < 5; ++kind) {
    static constexpr const char* kNames[] = {"smooth_sphere", "smooth_capsule", "smooth_ellipsoid",
                                             "smooth_cylinder", "smooth_cone"};
    out.push_back(
        family(kNames[kind], "smooth",
               fmt::format("A {} against spheres, capsules, ellipsoids, cylinders, cones and hulls of 16",
                           kRoundNames[kind]),
               "A smooth shape has infinitely many supports: every step comes nearer, none is the last, and "
               "each digit takes more of them.",
               effort.smooth, [kind](Random& random, std::size_t place) {
                 Case problem;
                 problem.a.shape = round_shape(random, static_cast<Round>(kind));
                 problem.b.shape = place % 6 == 5 ? round_hull(random, 16, false)
                                                  : round_shape(random, static_cast<Round>(place % 6));
                 if (random.once_in(2)) std::swap(problem.a.shape, problem.b.shape);
                 send(random, problem, 0.8);
                 return problem;
               }));
  }
  out.push_back(family("curved_sums", "sums", "Sums, sweeps, hulls and roundings of curved shapes",
                       "As of smooth shapes, and each support costs the supports of all parts.",
                       effort.smooth, [](Random& random, std::size_t) {
                         Case problem;
                         problem.a.shape = curved_sum(random);
                         problem.b.shape = random.once_in(2)
                                               ? curved_sum(random)
                                               : round_shape(random, static_cast<Round>(random.below(5)));
                         send(random, problem, 1.2);
                         return problem;
                       }));
}

// Both rotate by about `angle` radians in the step, about pivots near their centres.
Case turning_pair(Random& random, double least, double most) {
  const auto solid = [&] {
    switch (random.below(4)) {
      case 0:
        return round_shape(random, Round::cone);
      case 1:
        return round_hull(random, 16, false);
      case 2:
        return round_shape(random, Round::ellipsoid);
      default:
        return box(random);
    }
  };
  Case problem;
  problem.a.shape = solid();
  problem.b.shape = solid();
  send(random, problem, 0.8);
  for (corpus::Spin* spin : {&problem.spin_a, &problem.spin_b}) {
    const double angle = random.uniform(least, most);
    spin->rotation = to_float(Vec3<double>(angle * direction(random)));
    spin->pivot = to_float(Vec3<double>(0.25 * direction(random)));
  }
  return problem;
}

void add_turning(std::vector<Topic>& out, const Effort& effort) {
  out.push_back(turning(
      family("slow_turn", "rotation", "Both bodies rotate by 0.05 to 0.5 radians while they pass",
             "The path of a rotating corner is curved: the search closes in on the root, digit by digit.",
             effort.turning, [](Random& random, std::size_t) { return turning_pair(random, 0.05, 0.5); })));
  out.push_back(turning(
      family("fast_turn", "rotation", "Both bodies rotate by 3 to 12 radians while they pass",
             "The same root, and there may be many before it that come near: what is skipped must be proved.",
             effort.turning, [](Random& random, std::size_t) { return turning_pair(random, 3, 12); })));
  out.push_back(turning(family(
      "grazing_turn", "rotation", "A spinning corner passes a face by 2^-8 to 2^-16, or meets it by as much",
      "Until the gap is resolved nothing decides, so a looser tolerance buys time and gives verdicts away.",
      effort.turning, of_families({"spinning_graze"}, 8, 16))));
}

Case hulls(Random& random, int vertices, bool climbs) {
  Case problem;
  problem.a.shape = round_hull(random, vertices, climbs);
  problem.b.shape = round_hull(random, vertices, climbs);
  send(random, problem, 0.8);
  return problem;
}

void add_polytopes(std::vector<Topic>& out, const Effort& effort) {
  Topic large = family("large_hulls", "large", "Hulls of 256, 512, 1,024 and 2,048 vertices, with adjacency",
                       "Facets of a hundredth: near a smooth shape until the tolerance is finer than they "
                       "are, then a polytope, where the last step is exact.",
                       std::max<std::size_t>(effort.polytopes / 4, 8), [](Random& random, std::size_t place) {
                         return hulls(random, 256 << (place % 4), true);
                       });
  large.in_float = false;  // to derive the adjacency in float takes longer than all its casts
  out.push_back(std::move(large));
  out.push_back(family(
      "near_ties", "ties",
      "Polytopes with faces, edges and corners that are parallel, or pass by 10^-1 to 10^-9",
      "The last step is still exact, and near a tie there are more candidates for it. The cost is to be "
      "sure of the verdict.",
      effort.polytopes,
      of_families({"grazing_face", "grazing_edge", "parallel_faces", "parallel_edges"}, 1, 9)));
  out.push_back(family("smooth_ties", "ties", "Smooth shapes that pass by 10^-1 to 10^-6, or meet by as much",
                       "A gap of g moves the contact point by its root: every digit of the gap costs half a "
                       "digit's steps more, and a looser tolerance gives the verdict away.",
                       effort.smooth, of_families({"smooth_graze"}, 1, 6)));
  out.push_back(
      family("polytopes", "polytopes", "Boxes, and hulls of 8, 16, 32 and 64 vertices",
             "A polytope has finitely many facets: a method walks to the facet that the path enters, and its "
             "plane gives the time to the last bit. It is there or a step or two short of it, with nothing "
             "between: below 1e-2 or so accuracy has no price.",
             effort.polytopes, [](Random& random, std::size_t place) {
               if (place % 5 < 4) return hulls(random, 8 << (place % 5), false);
               Case problem;
               problem.a.shape = box(random);
               problem.b.shape = box(random);
               send(random, problem, 0.8);
               return problem;
             }));
}

Topic point(const char* series, const char* x_name, double x, std::string title, std::string sentence,
            std::size_t cases, std::vector<std::string> methods,
            std::function<Case(Random&, std::size_t)> draw) {
  Topic topic;
  topic.head.part = Part::growth;
  topic.head.series = series;
  topic.head.x = x;
  topic.head.x_name = x_name;
  topic.head.name = fmt::format("{} {:g}", series, x);
  topic.head.title = std::move(title);
  topic.head.sentence = std::move(sentence);
  topic.head.baseline = kBestLinear;
  topic.measures = topic.sweeps = topic.in_float = false;
  topic.cases = cases;
  topic.methods = std::move(methods);
  topic.draw = std::move(draw);
  return topic;
}

void add_growth(std::vector<Topic>& out, const Effort& effort) {
  const std::vector<std::string> all = {"ca", "gjk", "mpr", "certified", "exact"};
  for (const bool climbs : {false, true}) {
    for (int n = climbs ? 64 : 8; n <= 4096; n *= 2) {
      out.push_back(point(
          climbs ? "vertices, climbed" : "vertices, scanned", "vertices of each hull", n,
          fmt::format("Hulls of {} vertices, {}", n, climbs ? "with adjacency" : "without adjacency"), "",
          effort.points, all, [=](Random& random, std::size_t) { return hulls(random, n, climbs); }));
    }
  }
  for (int k = 1; k <= 12; ++k) {
    out.push_back(point("smooth gap", "k: the gap or the depth is 10^-k of 4", k,
                        fmt::format("Smooth shapes pass by 10^-{}, or meet by as much", k), "", effort.points,
                        {"ca", "gjk", "mpr", "certified"}, of_families({"smooth_graze"}, k, k)));
  }
  for (int k = 2; k <= 12; k += 2) {
    out.push_back(point("face gap", "k: the gap or the depth is 10^-k", k,
                        fmt::format("Faces of polytopes pass by 10^-{}, or meet by as much", k), "",
                        effort.points, all, of_families({"grazing_face"}, k, k)));
  }
  for (const double angle : {0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0}) {
    Topic topic = point(
        "spin", "radians in the step, of each body", angle,
        fmt::format("Both bodies rotate by {:g} radians while they pass", angle), "", effort.points,
        {"rotating ca", "rotating bilateral", "rotating steps", "rotating spheres", "rotating certified"},
        [=](Random& random, std::size_t) { return turning_pair(random, angle, angle); });
    topic.kind = Kind::rotating;
    topic.head.baseline = kBestTurning;
    out.push_back(std::move(topic));
  }
}

Topic requests(const char* name, std::string title, std::size_t cases, std::vector<std::string> methods,
               std::function<Case(Random&, std::size_t)> draw) {
  Topic topic;
  topic.head.part = Part::request;
  topic.head.name = name;
  topic.head.title = std::move(title);
  topic.head.baseline = kBestLinear;
  topic.sweeps = topic.in_float = topic.measures = false;
  topic.cases = cases;
  topic.methods = std::move(methods);
  topic.requests = {Request::verdict,   Request::normal,
                    Request::witnesses, Request::normal | Request::witnesses,
                    Request::proof,     Request::everything};
  topic.draw = std::move(draw);
  return topic;
}

void add_requests(std::vector<Topic>& out, const Effort& effort) {
  out.push_back(requests(
      "requests polytopes", "Cost of each request, hulls of 8 to 64 vertices", effort.requests,
      {"gjk", "mpr", "certified", "exact", "swept_overlap gjk", "swept_overlap mpr", "swept_overlap exact"},
      [](Random& random, std::size_t place) { return hulls(random, 8 << (place % 4), false); }));
  out.push_back(requests("requests smooth", "Cost of each request, smooth shapes", effort.requests,
                         {"gjk", "mpr", "certified", "swept_overlap gjk", "swept_overlap mpr"},
                         [](Random& random, std::size_t place) {
                           Case problem;
                           problem.a.shape = round_shape(random, static_cast<Round>(place % 5));
                           problem.b.shape = round_shape(random, static_cast<Round>(place / 5 % 5));
                           send(random, problem, 0.8);
                           return problem;
                         }));
  Topic topic =
      requests("requests turning", "Cost of each request, bodies that rotate by 0.3 to 3 radians",
               std::max<std::size_t>(effort.requests / 2, 8), {"rotating bilateral", "rotating certified"},
               [](Random& random, std::size_t) { return turning_pair(random, 0.3, 3); });
  topic.kind = Kind::rotating;
  topic.head.baseline = kBestTurning;
  out.push_back(std::move(topic));
}

Topic query(const char* series, double x, const char* x_name, std::string title, std::string baseline,
            std::size_t cases, std::vector<std::string> methods,
            std::function<Case(Random&, std::size_t)> draw) {
  Topic topic;
  topic.head.part = Part::query;
  topic.head.series = series;
  topic.head.x = x;
  topic.head.x_name = x_name;
  topic.head.name = std::isnan(x) ? series : fmt::format("{} {:g}", series, x);
  topic.head.title = std::move(title);
  topic.head.baseline = std::move(baseline);
  topic.kind = Kind::query;
  topic.measures = topic.sweeps = topic.in_float = false;
  topic.cases = cases;
  topic.methods = std::move(methods);
  topic.draw = std::move(draw);
  return topic;
}

void add_queries(std::vector<Topic>& out, const Effort& effort) {
  // Deep means that the centres are nearer than the least half width. Shallow means that the shapes overlap
  // by about a tenth.
  struct Depth {
    const char* series;
    double apart;
  };
  for (const Depth& depth : {Depth{"penetration, shallow", 1.2}, Depth{"penetration, deep", 0.4}}) {
    for (const int n : {8, 32, 128, 512}) {
      out.push_back(query(depth.series, n, "vertices of each hull",
                          fmt::format("How deep are two hulls of {} vertices in each other?", n),
                          "penetration_along mpr/double", effort.queries,
                          {"penetration_along mpr", "penetration epa", "distance gjk"},
                          [=, apart = depth.apart](Random& random, std::size_t) {
                            Case problem;
                            problem.a.shape = round_hull(random, n, false);
                            problem.b.shape = round_hull(random, n, false);
                            stand(random, problem, apart);
                            problem.direction =
                                to_float(Vec3<double>(problem.b.position - problem.a.position));
                            return problem;
                          }));
    }
  }
  for (const int n : {8, 32, 128, 512}) {
    out.push_back(query("swept", n, "vertices of each hull",
                        fmt::format("Do two hulls of {} vertices touch at any time of the step?", n),
                        "swept_overlap gjk/double", effort.queries,
                        {"swept_overlap gjk", "swept_overlap mpr", "swept_overlap before_after"},
                        [=](Random& random, std::size_t) { return hulls(random, n, false); }));
  }
  Topic topic = query("smooth penetration", kNone, "", "How deep are two smooth shapes in each other?",
                      "penetration_along mpr/double", effort.smooth,
                      {"penetration_along mpr", "penetration epa"}, [](Random& random, std::size_t place) {
                        Case problem;
                        problem.a.shape = round_shape(random, static_cast<Round>(place % 5));
                        problem.b.shape = round_shape(random, static_cast<Round>(place / 5 % 5));
                        stand(random, problem, 0.4);
                        problem.direction = to_float(Vec3<double>(problem.b.position - problem.a.position));
                        return problem;
                      });
  topic.head.sentence = "As of casts: the boundary is curved, and the expanding polytope only nears it.";
  topic.measures = topic.sweeps = true;
  out.push_back(std::move(topic));
}

}  // namespace

std::vector<Topic> topics(bool thorough) {
  const Effort& effort = thorough ? kThorough : kFast;
  std::vector<Topic> out;
  add_smooth(out, effort);
  add_turning(out, effort);
  add_polytopes(out, effort);
  add_growth(out, effort);
  add_requests(out, effort);
  add_queries(out, effort);
  for (Topic& topic : out) {
    topic.head.kind = std::string(to_text(topic.kind));
    topic.head.cases = topic.cases;
  }
  return out;
}

std::vector<Case> cases_of(const Topic& topic, std::uint64_t seed) {
  std::vector<Case> out;
  for (std::size_t i = 0; i < topic.cases; ++i) {
    Random random(corpus::fnv1a(topic.head.name) ^ (seed * 0x9e3779b97f4a7c15u + i));
    Case problem = topic.draw(random, i);
    problem.family = topic.head.name;
    problem.id = fmt::format("price/{}/{}", topic.head.name, i + 1);
    std::replace(problem.id.begin(), problem.id.end(), ' ', '_');
    std::erase(problem.id, ',');
    out.push_back(std::move(problem));
  }
  return out;
}

}  // namespace graze::price
