// The cost of a cast: our methods and tiers beside Bullet's btSubsimplexConvexCast and btContinuousConvexCollision.
//
// All contestants get the same cases in one run, in rounds that take turns. Ours: bodies built once, with hulls of
// their own, cast() with its validation. Bullet, if it was found: bullet_casts.cpp. A round is a timed sweep over all
// cases of a family, after an untimed one. Its processor time over the number of cases is the round's time. The number
// shown is the median over the rounds, and a ratio is the median of the rounds' ratios. Five sets of families:
//
//   response   the data that an engine returns, time, normal and contact points: ten families, bodies with and
//              without orientations, in the same order each round (the processor learns branches) and in a new
//              random one each. Wrong: the verdict differs from tier exact's. Bullet's cast answers no start in
//              contact. Beside it, its cast followed by its penetration query.
//   curved     the same for curved bodies, also with a tolerance and with a proof (curved_families.cpp).
//   rotation   the same for rotating bodies (rotating_families.cpp). Late: a contact that tier certified proves to
//              be over kLate of the step earlier.
//   growth     hulls of 16 to 4,096 vertices, with adjacency and without (growth_families.cpp). One run uses many
//              shapes in a new random order each round without a sweep before, another two shapes in the same order.
//   verdict    verdicts alone, in a new random order each round, so that the processor learns no case's branches.
//              For the tail each case is timed by itself in five sweeps: the least of the five, less the clock's
//              own time. Shown is the 99th percentile of that over the cases, over its median.
#include <dlfcn.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <graze/cast.hpp>
#include <graze/rotating_cast.hpp>
#include <map>
#include <memory>
#include <numeric>
#include <optional>

#include "bench/bullet_casts.hpp"
#include "bench/cast_families.hpp"
#include "corpus/random.hpp"
#include "engines/convert.hpp"

namespace graze::bench {
namespace {

using Clock = std::chrono::steady_clock;

double nanoseconds(Clock::duration d) { return std::chrono::duration<double, std::nano>(d).count(); }

// This thread's processor time, so that a sweep is not charged for other work of the machine.
double processor_ns() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

template <class Result>
Answer answer_of(const Result& result) {
  switch (result.outcome) {
    case Outcome::miss:
      return {Verdict::miss, 0};
    case Outcome::hit:
    case Outcome::initially_overlapping:
      return {Verdict::contact, static_cast<double>(result.toi_lower)};
    default:
      return {};
  }
}

template <Scalar S>
class OurCasts final : public PreparedCasts {
 public:
  OurCasts(const CastFamily& family, const CastOptions<S>& options, bool adjacency) : options_(options) {
    std::vector<Shape<S>> shapes;
    for (const Shape<double>& shape : family.shapes) {
      Shape<S> one = engine::round_to<S>(shape);
      // Each contestant gets hulls of its own. Copies share their vertices, and a contestant would find in
      // the caches the data that the previous one has read.
      if (const auto* hull = std::get_if<Hull<S>>(&one))
        one = adjacency ? with_adjacency(hull->vertices()) : Hull<S>(hull->vertices());
      shapes.push_back(std::move(one));
    }
    for (const CastCase& c : family.cases)
      pairs_.push_back({body_of<S>(c.a, shapes), body_of<S>(c.b, shapes)});
  }

  void cast_all(const std::uint32_t* order, std::size_t count, Answer* answers) const override {
    for (std::size_t k = 0; k < count; ++k) {
      const Pair& pair = pairs_[order[k]];
      answers[order[k]] = answer_of(cast(pair.a, pair.b, options_));
    }
  }

 private:
  struct Pair {
    Body<S> a, b;
  };
  CastOptions<S> options_;
  std::vector<Pair> pairs_;
};

template <Scalar S>
class OurTurningCasts final : public PreparedCasts {
 public:
  OurTurningCasts(const CastFamily& family, const RotatingOptions<S>& options) : options_(options) {
    std::vector<Shape<S>> shapes;
    for (const Shape<double>& shape : family.shapes) shapes.push_back(engine::round_to<S>(shape));
    for (const CastCase& c : family.cases)
      pairs_.push_back({turning_body_of<S>(c.a, shapes), turning_body_of<S>(c.b, shapes)});
  }

  void cast_all(const std::uint32_t* order, std::size_t count, Answer* answers) const override {
    for (std::size_t k = 0; k < count; ++k) {
      const Pair& pair = pairs_[order[k]];
      answers[order[k]] = answer_of(cast(pair.a, pair.b, options_));
    }
  }

 private:
  struct Pair {
    RotatingBody<S> a, b;
  };
  RotatingOptions<S> options_;
  std::vector<Pair> pairs_;
};

// A module with Bullet's casts in one scalar. Nothing of it is unloaded before the end of the process.
MakeBulletCasts open_bullet(const char* path) {
  void* module = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (module == nullptr) {
    fmt::print(stderr, "cast_bench: {}\n", dlerror());
    return nullptr;
  }
  return reinterpret_cast<MakeBulletCasts>(dlsym(module, kMakeBulletCasts));
}

// The vertices of shapes that are neither hulls nor round.
std::vector<Vec3<double>> few_vertices(const Shape<double>& shape) {
  if (const auto* box = std::get_if<Box<double>>(&shape)) {
    std::vector<Vec3<double>> corners;
    for (const double x : {-1., 1.}) {
      for (const double y : {-1., 1.}) {
        for (const double z : {-1., 1.})
          corners.push_back(box->half_extents.cwiseProduct(Vec3<double>(x, y, z)));
      }
    }
    return corners;
  }
  if (const auto* segment = std::get_if<Segment<double>>(&shape)) return {segment->a, segment->b};
  if (const auto* triangle = std::get_if<Triangle<double>>(&shape))
    return {triangle->a, triangle->b, triangle->c};
  return {Vec3<double>::Zero()};
}

std::vector<Vec3<double>> vertices_of(const Shape<double>& shape) {
  const auto* hull = std::get_if<Hull<double>>(&shape);
  if (hull == nullptr) return few_vertices(shape);
  return {hull->vertices().begin(), hull->vertices().end()};
}

std::unique_ptr<PreparedCasts> bullet_casts(MakeBulletCasts make, const CastFamily& family,
                                            BulletCast which) {
  std::vector<PlainShape> shapes;
  std::vector<std::vector<Vec3<double>>> kept;  // until the module has copied them
  for (const Shape<double>& shape : family.shapes) {
    PlainShape& plain = shapes.emplace_back();
    const auto solid = [&](PlainKind kind, const Vec3<double>& half) {
      plain.kind = kind;
      Eigen::Map<Vec3<double>>(plain.half_extents) = half;
    };
    const auto round = [&](PlainKind kind, double radius, double half_height) {
      solid(kind, Vec3<double>(radius, radius, half_height));
    };
    if (const auto* box = std::get_if<Box<double>>(&shape)) solid(PlainKind::box, box->half_extents);
    if (const auto* s = std::get_if<Sphere<double>>(&shape)) round(PlainKind::sphere, s->radius, s->radius);
    if (const auto* s = std::get_if<Capsule<double>>(&shape))
      round(PlainKind::capsule, s->radius, s->half_height);
    if (const auto* s = std::get_if<Cylinder<double>>(&shape))
      round(PlainKind::cylinder, s->radius, s->half_height);
    if (const auto* s = std::get_if<Cone<double>>(&shape)) round(PlainKind::cone, s->radius, s->half_height);
    if (plain.kind != PlainKind::hull) continue;
    const std::vector<Vec3<double>>& vertices = kept.emplace_back(vertices_of(shape));
    plain.xyz = vertices.data()->data();
    plain.vertices = vertices.size();
  }
  const auto plain_body = [&](const Placed& placed) {
    PlainBody out;
    out.shape = placed.shape;
    Vec3<double> position = placed.position;
    if (placed.pivot != Vec3<double>::Zero()) {
      // Bullet rotates a body about the origin of its frame, so the pivot becomes the origin.
      std::vector<Vec3<double>>& vertices = kept.emplace_back(vertices_of(family.shapes[placed.shape]));
      for (Vec3<double>& x : vertices) x -= placed.pivot;
      out.shape = shapes.size();
      shapes.push_back(
          {.kind = PlainKind::hull, .xyz = vertices.data()->data(), .vertices = vertices.size()});
      const Quaternion<double>& q = placed.orientation;
      position += Eigen::Quaterniond(q.w, q.x, q.y, q.z) * placed.pivot;
    }
    Eigen::Map<Vec3<double>>(out.position) = position;
    Eigen::Map<Vec3<double>>(out.rotation) = placed.rotation;
    Eigen::Map<Vec3<double>>(out.displacement) = placed.displacement;
    const Quaternion<double>& q = placed.orientation;
    Eigen::Map<Eigen::Vector4d>(out.orientation) = Eigen::Vector4d(q.w, q.x, q.y, q.z);
    return out;
  };
  std::vector<PlainPair> pairs;
  for (const CastCase& c : family.cases) pairs.push_back({plain_body(c.a), plain_body(c.b)});
  return std::unique_ptr<PreparedCasts>(
      make(shapes.data(), shapes.size(), pairs.data(), pairs.size(), which));
}

struct Contestant {
  std::string name;
  std::function<std::unique_ptr<PreparedCasts>(const CastFamily&)> prepare;
  bool only_in_contact = false;  // run where every case starts in contact, and nowhere else
};

template <Scalar S>
Contestant ours(std::string name, Request request, CastOptions<S> options, bool adjacency = false) {
  options.request = request;
  return {std::move(name), [options, adjacency](const CastFamily& family) {
            return std::make_unique<OurCasts<S>>(family, options, adjacency);
          }};
}

template <Scalar S>
Contestant ours_turning(std::string name, RotatingOptions<S> options) {
  options.request = Request::normal | Request::witnesses;
  return {std::move(name), [options](const CastFamily& family) {
            return std::make_unique<OurTurningCasts<S>>(family, options);
          }};
}

// `beside`: another of its casts, run where the first is not enough.
struct BulletAsked {
  BulletCast which = BulletCast::subsimplex;
  std::optional<BulletCast> beside = {};
  const char* suffix = "";
  bool only_in_contact = false;
};

void add_bullet(std::vector<Contestant>& out, const BulletAsked& asked) {
  [[maybe_unused]] const auto add = [&](const std::string& scalar, const char* path) {
    const MakeBulletCasts make = open_bullet(path);
    if (make == nullptr) return;
    const auto prepare = [make](BulletCast which) {
      return [make, which](const CastFamily& family) { return bullet_casts(make, family, which); };
    };
    out.push_back({"bullet/" + scalar, prepare(asked.which)});
    if (asked.beside)
      out.push_back({"bullet" + std::string(asked.suffix) + "/" + scalar, prepare(*asked.beside),
                     asked.only_in_contact});
  };
#ifdef GRAZE_BULLET_FLOAT
  add("float", GRAZE_BULLET_FLOAT);
#endif
#ifdef GRAZE_BULLET_DOUBLE
  add("double", GRAZE_BULLET_DOUBLE);
#endif
}

std::vector<Contestant> verdict_contestants() {
  constexpr Request kAsked = Request::verdict;
  std::vector<Contestant> out = {
      ours<double>("gjk/double", kAsked, {.method = Method::gjk_ray_cast}),
      ours<double>("mpr/double", kAsked, {.method = Method::mpr_sweep}),
      ours<double>("ca/double", kAsked, {.method = Method::conservative_advancement}),
      ours<float>("gjk/float", kAsked, {.method = Method::gjk_ray_cast}),
      ours<float>("mpr/float", kAsked, {.method = Method::mpr_sweep}),
      ours<float>("ca/float", kAsked, {.method = Method::conservative_advancement}),
      ours<double>("exact/double", kAsked, {.tier = Tier::exact}),
      ours<float>("exact/float", kAsked, {.tier = Tier::exact}),
  };
  add_bullet(out, {});
  return out;
}

std::vector<Contestant> response_contestants() {
  constexpr Request kAsked = Request::normal | Request::witnesses;
  std::vector<Contestant> out = {
      ours<float>("standard/float", kAsked, {}),
      ours<double>("standard/double", kAsked, {}),
      ours<double>("exact/double", kAsked, {.tier = Tier::exact}),
      ours<float>("exact/float", kAsked, {.tier = Tier::exact}),
      ours<double>("certified/double", kAsked, {.tier = Tier::certified}),
      ours<double>("gjk/double", kAsked, {.method = Method::gjk_ray_cast}),
  };
  add_bullet(out, {BulletCast::subsimplex, BulletCast::subsimplex_and_depth, "+depth", true});
  return out;
}

// For curved bodies. A tolerance should not make a cast slower. A proof is requested beside the rest.
std::vector<Contestant> curved_contestants() {
  constexpr Request kAsked = Request::normal | Request::witnesses;
  std::vector<Contestant> out = {
      ours<double>("standard/double", kAsked, {}),
      ours<float>("standard/float", kAsked, {}),
      ours<double>("certified/double", kAsked, {.tier = Tier::certified}),
      ours<double>("standard 1e-4", kAsked, {.tolerance = 1e-4}),
      ours<double>("gjk/double", kAsked, {.method = Method::gjk_ray_cast}),
      ours<double>("gjk 1e-4", kAsked, {.method = Method::gjk_ray_cast, .tolerance = 1e-4}),
      ours<double>("gjk 1e-12", kAsked, {.method = Method::gjk_ray_cast, .tolerance = 1e-12}),
      ours<double>("ca 1e-12", kAsked, {.method = Method::conservative_advancement, .tolerance = 1e-12}),
      ours<double>("ca/double", kAsked, {.method = Method::conservative_advancement}),
      ours<double>("mpr/double", kAsked, {.method = Method::mpr_sweep}),
      ours<double>("standard, proof", Request::everything, {}),
      ours<double>("certified, proof", Request::everything, {.tier = Tier::certified}),
  };
  add_bullet(out, {});
  return out;
}

std::vector<Contestant> rotating_contestants() {
  std::vector<Contestant> out = {
      ours_turning<double>("standard/double", {}),
      ours_turning<float>("standard/float", {}),
      ours_turning<double>("certified/double", {.tier = Tier::certified}),
      ours_turning<double>("standard 1e-4", {.tolerance = 1e-4}),
  };
  add_bullet(out, {BulletCast::continuous, BulletCast::continuous_in_pieces, " in pieces"});
  return out;
}

// "+" stands for adjacency.
std::vector<Contestant> growth_contestants() {
  constexpr Request kAsked = Request::normal | Request::witnesses;
  std::vector<Contestant> out;
  for (const bool adjacency : {false, true}) {
    const auto name = [&](const char* of) { return std::string(of) + (adjacency ? "+" : ""); };
    out.push_back(ours<double>(name("standard/double"), kAsked, {}, adjacency));
    out.push_back(ours<double>(name("exact/double"), kAsked, {.tier = Tier::exact}, adjacency));
    out.push_back(ours<double>(name("gjk/double"), kAsked, {.method = Method::gjk_ray_cast}, adjacency));
    out.push_back(ours<float>(name("standard/float"), kAsked, {}, adjacency));
  }
  add_bullet(out, {});
  return out;
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto nth =
      values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

struct Measured {
  std::vector<double> round_ns;  // a cast, by round
  std::vector<double> case_ns;   // the least of five, by case
  std::size_t wrong = 0;         // verdicts that differ from the case's
  std::size_t late = 0;          // contacts later than the case's
  [[nodiscard]] double ns() const { return quantile(round_ns, 0.5); }
  [[nodiscard]] double tail() const { return quantile(case_ns, 0.99) / quantile(case_ns, 0.5); }
};

using Report = std::map<std::string, Measured>;

double clock_ns() {
  double least = kInfinity<double>;
  for (int i = 0; i < 1000; ++i) {
    const auto start = Clock::now();
    least = std::min(least, nanoseconds(Clock::now() - start));
  }
  return least;
}

constexpr int kTailRepeats = 5;
constexpr double kLate = 1e-3;  // of the step

struct Manner {
  bool shuffled = true;  // a new random order each round
  bool tail = true;
  bool cold = false;  // the other contestants have driven this one's data out of the near caches
};

Report measure(const CastFamily& family, const std::vector<Contestant>& given, int rounds,
               const Manner& manner) {
  const std::size_t n = family.cases.size();
  std::vector<Contestant> field;
  std::vector<std::unique_ptr<PreparedCasts>> prepared;
  for (const Contestant& c : given) {
    if (c.only_in_contact && !family.in_contact) continue;
    field.push_back(c);
    prepared.push_back(c.prepare(family));
  }
  std::vector<std::vector<Answer>> answers(field.size(), std::vector<Answer>(n));
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  corpus::Random random(1);
  const auto shuffle = [&] {
    for (std::size_t k = n; k > 1; --k) std::swap(order[k - 1], order[random.below(k)]);
  };
  // Untimed, in a separate order where orders are random. The caches then hold what a program that runs only
  // this contestant finds there, and the branches of the timed order are new.
  const auto warm_up = [&](std::size_t i) {
    const std::vector<std::uint32_t> timed = order;
    if (manner.shuffled) shuffle();
    prepared[i]->cast_all(order.data(), n, answers[i].data());
    order = timed;
  };

  Report report;
  for (int round = -1; round < rounds; ++round) {  // the first only warms up
    if (manner.shuffled) shuffle();
    for (std::size_t i = 0; i < field.size(); ++i) {
      if (!manner.cold) warm_up(i);
      const double start = processor_ns();
      prepared[i]->cast_all(order.data(), n, answers[i].data());
      const double ns = (processor_ns() - start) / static_cast<double>(n);
      if (round >= 0) report[field[i].name].round_ns.push_back(ns);
    }
  }
  const double clock = clock_ns();
  for (std::size_t i = 0; i < field.size(); ++i) {
    Measured& m = report[field[i].name];
    m.case_ns.assign(n, kInfinity<double>);
    for (int repeat = 0; manner.tail && repeat < kTailRepeats; ++repeat) {
      shuffle();
      for (const std::uint32_t k : order) {
        const auto start = Clock::now();
        prepared[i]->cast_all(&k, 1, answers[i].data());
        m.case_ns[k] = std::min(m.case_ns[k], nanoseconds(Clock::now() - start) - clock);
      }
    }
    for (std::size_t k = 0; k < n; ++k) {
      const CastCase& c = family.cases[k];
      const Answer& answer = answers[i][k];
      const bool right = answer.verdict == (c.contact ? Verdict::contact : Verdict::miss);
      m.wrong += right ? 0 : 1;
      m.late += right && c.contact && answer.toi > c.latest + kLate ? 1 : 0;
    }
  }
  return report;
}

// The median over the rounds of top's time over bottom's, or NaN where one is missing.
double ratio(const Report& report, const std::string& top, const std::string& bottom) {
  const auto t = report.find(top), b = report.find(bottom);
  if (t == report.end() || b == report.end()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> ratios;
  for (std::size_t i = 0; i < t->second.round_ns.size(); ++i) {
    ratios.push_back(t->second.round_ns[i] / b->second.round_ns[i]);
  }
  return quantile(ratios, 0.5);
}
std::string ratio_text(double x) { return x == x ? fmt::format("{:.2f}", x) : "-"; }

struct Ratio {
  const char *heading, *top, *bottom;
};
constexpr Ratio kRatios[] = {
    {"exact:gjk d", "exact/double", "gjk/double"},     {"exact:mpr d", "exact/double", "mpr/double"},
    {"exact:gjk f", "exact/float", "gjk/float"},       {"exact:mpr f", "exact/float", "mpr/float"},
    {"bullet:gjk f", "bullet/float", "gjk/float"},     {"bullet:mpr f", "bullet/float", "mpr/float"},
    {"bullet:exact f", "bullet/float", "exact/float"}, {"bullet f:gjk d", "bullet/float", "gjk/double"},
    {"bullet f:mpr d", "bullet/float", "mpr/double"},  {"bullet f:exact d", "bullet/float", "exact/double"},
};

struct Measurement {
  CastFamily family;
  Report report;
};

void print_row(const std::string& name, const std::vector<std::string>& cells) {
  fmt::print("{:39}", name);
  for (const std::string& cell : cells) fmt::print(" {:>16}", cell);
  fmt::print("\n");
}

// One row a family, one cell a contestant.
template <class Cell>
void print_table(const std::string& title, const std::vector<Contestant>& field,
                 const std::vector<Measurement>& measurements, const Cell& cell) {
  std::vector<std::string> cells;
  for (const Contestant& c : field) cells.push_back(c.name);
  print_row("\n" + title, cells);
  for (const Measurement& m : measurements) {
    cells.clear();
    for (const Contestant& c : field) {
      const auto one = m.report.find(c.name);
      cells.push_back(one == m.report.end() ? "-" : cell(one->second));
    }
    print_row(m.family.name, cells);
  }
}

void print_tables(const std::vector<Contestant>& field, const std::vector<Measurement>& measurements) {
  print_table("ns a cast", field, measurements,
              [](const Measured& m) { return fmt::format("{:.0f}", m.ns()); });
  std::vector<std::string> cells;
  for (const Ratio& r : kRatios) cells.emplace_back(r.heading);
  print_row("\ntime : time", cells);
  for (const Measurement& m : measurements) {
    cells.clear();
    for (const Ratio& r : kRatios) cells.push_back(ratio_text(ratio(m.report, r.top, r.bottom)));
    print_row(m.family.name, cells);
  }
  print_table("99th percentile : median, over cases", field, measurements,
              [](const Measured& m) { return fmt::format("{:.1f}", m.tail()); });
  print_table("wrong verdicts", field, measurements,
              [](const Measured& m) { return fmt::format("{}", m.wrong); });
  print_row("\ncases", {"all", "contacts"});
  for (const Measurement& m : measurements) {
    print_row(m.family.name,
              {fmt::format("{}", m.family.cases.size()), fmt::format("{}", m.family.contacts())});
  }
}

// Time over that of `rival`, with its wrong verdicts beside it. The last row has the geometric means.
void print_ratios(const std::string& rival, const std::vector<Contestant>& field,
                  const std::vector<Measurement>& measurements) {
  std::vector<std::string> cells;
  std::vector<double> logs(field.size(), 0.0);
  for (const Contestant& c : field) cells.push_back(c.name);
  cells.push_back("rival's wrong");
  print_row("\ntime over " + rival + "'s", cells);
  for (const Measurement& m : measurements) {
    cells.clear();
    for (std::size_t i = 0; i < field.size(); ++i) {
      const double one = ratio(m.report, field[i].name, rival);
      logs[i] += std::log(one);
      cells.push_back(ratio_text(one));
    }
    const auto found = m.report.find(rival);
    cells.push_back(
        found == m.report.end() ? "-" : fmt::format("{} of {}", found->second.wrong, m.family.cases.size()));
    print_row(m.family.name, cells);
  }
  cells.clear();
  for (const double one : logs)
    cells.push_back(ratio_text(std::exp(one / static_cast<double>(measurements.size()))));
  print_row("geometric mean", cells);
}

// The contestant by whose time the others' times are divided.
constexpr const char* kRival = "bullet/float";

// wrong: late contacts, too.
void print_csv(const std::string& set, const std::vector<Contestant>& field,
               const std::vector<Measurement>& measurements) {
  for (const Measurement& m : measurements) {
    for (const Contestant& c : field) {
      const auto found = m.report.find(c.name);
      if (found == m.report.end()) continue;
      const Measured& one = found->second;
      fmt::print("\"{}\",\"{}\",{},{},\"{}\",{:.1f},{:.2f},{},{:.3f}\n", set, m.family.name,
                 m.family.cases.size(), m.family.contacts(), c.name, one.ns(), one.tail(),
                 one.wrong + one.late, ratio(m.report, c.name, kRival));
    }
  }
}

struct Asked {
  FamilySize size;
  int rounds = 31;
  bool csv = false;
  std::string set, family_part, contestant_part;
};

std::vector<Measurement> measure_all(std::vector<CastFamily> families, const std::vector<Contestant>& field,
                                     const Asked& asked, const Manner& manner) {
  std::vector<Measurement> out;
  for (CastFamily& family : families) {
    if (family.name.find(asked.family_part) == std::string::npos) continue;
    Report report = measure(family, field, asked.rounds, manner);
    out.push_back({std::move(family), std::move(report)});
  }
  return out;
}

std::vector<Contestant> chosen(std::vector<Contestant> field, const Asked& asked) {
  std::erase_if(field,
                [&](const Contestant& c) { return c.name.find(asked.contestant_part) == std::string::npos; });
  return field;
}

void run_responses(const Asked& asked) {
  const std::vector<Contestant> field = chosen(response_contestants(), asked);
  for (const bool turned : {false, true}) {
    for (const bool shuffled : {false, true}) {
      const std::string manner =
          fmt::format("{}, {}", turned ? "turned" : "plain", shuffled ? "shuffled" : "fixed order");
      const std::vector<Measurement> measurements = measure_all(response_families(asked.size, turned), field,
                                                                asked, {.shuffled = shuffled, .tail = false});
      if (asked.csv) {
        print_csv("response, " + manner, field, measurements);
        continue;
      }
      fmt::print("\n---- time, normal, witnesses; {}\n", manner);
      print_table("ns a cast", field, measurements,
                  [](const Measured& m) { return fmt::format("{:.0f}", m.ns()); });
      print_ratios(kRival, field, measurements);
      print_table("wrong verdicts", field, measurements,
                  [](const Measured& m) { return fmt::format("{}", m.wrong); });
    }
  }
}

void run_verdicts(const Asked& asked) {
  const std::vector<Contestant> field = chosen(verdict_contestants(), asked);
  const std::vector<Measurement> measurements = measure_all(cast_families(asked.size), field, asked, {});
  if (asked.csv) return print_csv("verdict", field, measurements);
  fmt::print("\n---- verdicts; shuffled\n");
  print_tables(field, measurements);
}

struct GrowthRatio {
  const char *of, *with;
};
constexpr GrowthRatio kGrowthRatios[] = {{"standard/double", "standard/double+"},
                                         {"exact/double", "exact/double+"},
                                         {"gjk/double", "gjk/double+"},
                                         {"standard/float", "standard/float+"}};

void run_curved(const Asked& asked) {
  const std::vector<Contestant> field = chosen(curved_contestants(), asked);
  const std::vector<Measurement> measurements =
      measure_all(curved_families(asked.size), field, asked, {.shuffled = true, .tail = false});
  if (asked.csv) return print_csv("curved", field, measurements);
  fmt::print("\n---- curved bodies, turned: time, normal, witnesses; shuffled\n");
  print_table("ns a cast", field, measurements,
              [](const Measured& m) { return fmt::format("{:.0f}", m.ns()); });
  print_ratios(kRival, field, measurements);
  print_table("wrong verdicts", field, measurements,
              [](const Measured& m) { return fmt::format("{}", m.wrong); });
}

void run_rotating(const Asked& asked) {
  const std::vector<Contestant> field = chosen(rotating_contestants(), asked);
  const std::vector<Measurement> measurements =
      measure_all(rotating_families(asked.size), field, asked, {.shuffled = true, .tail = false});
  if (asked.csv) return print_csv("rotation", field, measurements);
  fmt::print("\n---- rotating bodies: time, normal, witnesses; shuffled\n");
  print_table("ns a cast", field, measurements,
              [](const Measured& m) { return fmt::format("{:.0f}", m.ns()); });
  print_ratios(kRival, field, measurements);
  print_table("wrong verdicts + late contacts", field, measurements,
              [](const Measured& m) { return fmt::format("{} + {}", m.wrong, m.late); });
}

// Hulls in a scene share memory and the near caches. Two hulls alone fill them by themselves.
void run_growth(const Asked& asked) {
  const std::vector<Contestant> field = chosen(growth_contestants(), asked);
  for (const bool many : {true, false}) {
    const FamilySize size{asked.size.cases, many ? std::min<std::size_t>(asked.size.shapes, 32) : 2};
    const std::vector<Measurement> measurements =
        measure_all(growth_families(size), field, asked, {.shuffled = many, .tail = false, .cold = many});
    const std::string manner =
        many ? fmt::format("{} shapes, shuffled", size.shapes) : "two shapes, fixed order";
    if (asked.csv) {
      print_csv("growth, " + manner, field, measurements);
      continue;
    }
    fmt::print("\n---- growth: time, normal, witnesses; {}\n", manner);
    print_table("ns a cast", field, measurements,
                [](const Measured& m) { return fmt::format("{:.0f}", m.ns()); });
    std::vector<std::string> cells;
    for (const GrowthRatio& r : kGrowthRatios) cells.emplace_back(r.of);
    print_row("\nwith adjacency : without", cells);
    for (const Measurement& m : measurements) {
      cells.clear();
      for (const GrowthRatio& r : kGrowthRatios) cells.push_back(ratio_text(ratio(m.report, r.with, r.of)));
      print_row(m.family.name, cells);
    }
    print_ratios(kRival, field, measurements);
    print_table("wrong verdicts", field, measurements,
                [](const Measured& m) { return fmt::format("{}", m.wrong); });
  }
}

int run(int argc, char** argv) {
  CLI::App app("Measures what a cast costs, beside Bullet's.");
  Asked asked;
  app.add_option("--cases", asked.size.cases,
                 "cases of each family, half of them hits where not all are one kind");
  app.add_option("--shapes", asked.size.shapes, "shapes in each family's pool")
      ->check(CLI::Range(2, 1 << 20));
  app.add_option("--rounds", asked.rounds, "rounds that the median is taken over")
      ->check(CLI::PositiveNumber);
  app.add_option("--set", asked.set,
                 "only this set of families: response, curved, rotation, growth or verdict")
      ->check(CLI::IsMember({"response", "curved", "rotation", "growth", "verdict"}));
  app.add_option("--family", asked.family_part, "only families whose name contains this");
  app.add_option("--only", asked.contestant_part, "only contestants whose name contains this");
  app.add_flag("--csv", asked.csv, "one line a family and contestant");
  CLI11_PARSE(app, argc, argv);

#ifndef GRAZE_BULLET_FLOAT
  fmt::print(stderr, "cast_bench: built without Bullet (Debian: libbullet-dev); only ours run\n");
#endif
  if (asked.csv) fmt::print("set,family,cases,contacts,contestant,ns,p99_over_median,wrong,over_rival\n");
  const auto wants = [&](const char* set) { return asked.set.empty() || asked.set == set; };
  if (wants("response")) run_responses(asked);
  if (wants("curved")) run_curved(asked);
  if (wants("rotation")) run_rotating(asked);
  if (wants("growth")) run_growth(asked);
  if (wants("verdict")) run_verdicts(asked);
  return 0;
}

}  // namespace
}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
