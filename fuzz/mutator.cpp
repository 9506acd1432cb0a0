#include "fuzz/mutator.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "corpus/curate/location.hpp"
#include "corpus/families.hpp"
#include "corpus/format/case_io.hpp"
#include "engines/method.hpp"
#include "fuzz/placing.hpp"
#include "properties/edit/case.hpp"

namespace graze::fuzz {

namespace {

using corpus::Case;
using corpus::Random;
using law::Slot;

// Moves of one kind see a body by these.
constexpr auto kBodies = {&Case::a, &Case::b};

// The case with number `which` replaced by f(slot, number).
template <class F>
Case with_number(const Case& problem, std::size_t which, const F& f) {
  std::size_t at = 0;
  return law::map_scalars(problem, [&](Slot slot, double x) { return at++ == which ? f(slot, x) : x; });
}

bool never_negative(Slot slot) {
  return slot == Slot::extent || slot == Slot::horizon || slot == Slot::target;
}

// To the last bit where tier exact answers, else within rounding. Quick: mutation must not cost more than judgement, as
// tier certified does for curved shapes.
engine::Answer first_contact(const Case& linear) {
  return engine::find_method(engine::Kind::linear, engine::is_exact_question(linear) ? "exact" : "gjk")
      ->ask(linear, {});
}

class Mover {
 public:
  Mover(Case problem, Random& random) : case_(std::move(problem)), random_(random) {}

  // False where the move does not apply.
  bool apply(Move move) {
    switch (move) {
      case Move::one_ulp:
        return one_ulp();
      case Move::copy:
        return copy();
      case Move::scale:
        return scale();
      case Move::snap:
        return snap();
      case Move::touch:
        return touch();
      case Move::duplicate:
        return duplicate();
      case Move::drop:
        return drop();
      case Move::flatten:
        return flatten();
      case Move::align:
        return align();
      case Move::start:
        return start();
      case Move::turn:
        return turn();
      case Move::swap_in:
        return swap_in();
    }
    return false;
  }
  [[nodiscard]] const Case& result() const { return case_; }

 private:
  Body<double>& any_body() { return random_.once_in(2) ? case_.a : case_.b; }
  int any_axis() { return static_cast<int>(random_.below(3)); }
  double any_of(std::initializer_list<double> choices) {
    return choices.begin()[random_.below(choices.size())];
  }

  bool one_ulp() {
    const std::size_t count = law::scalars(case_).size();
    const double towards = random_.once_in(2) ? kInfinity<double> : -kInfinity<double>;
    case_ = with_number(case_, random_.below(count), [&](Slot slot, double x) {
      if (x == 0 || !std::isfinite(x)) return x;
      const double y = std::nextafter(x, towards);
      return never_negative(slot) ? std::abs(y) : y;
    });
    return true;
  }

  bool copy() {
    const std::vector<double> numbers = law::scalars(case_);
    double given = numbers[random_.below(numbers.size())];
    if (random_.once_in(4)) given = -given;
    if (random_.once_in(4) && given != 0) given = std::nextafter(given, kInfinity<double>);
    case_ = with_number(case_, random_.below(numbers.size()),
                        [&](Slot slot, double) { return never_negative(slot) ? std::abs(given) : given; });
    return true;
  }

  bool scale() {
    const int k = random_.once_in(4) ? random_.integer(-40, 40) : random_.integer(-4, 4);
    const auto by_power = [&](Slot slot, double x) { return law::is_length(slot) ? std::scalbn(x, k) : x; };
    switch (random_.below(3)) {
      case 0:
        case_ = law::map_scalars(case_, by_power);
        return true;
      case 1: {
        Body<double>& body = any_body();
        body.shape = law::map_shape(body.shape, by_power);
        return true;
      }
      default:
        for (const auto body : kBodies) (case_.*body).displacement *= std::scalbn(1.0, k);
        return true;
    }
  }

  // Onto a point of A that is a vertex, on an edge, or on a plane of three vertices.
  Vec3<double> target_of(const std::vector<Vec3<double>>& points, const Vec3<double>& from) {
    const Vec3<double>& p = points[random_.below(points.size())];
    const Vec3<double>& q = points[random_.below(points.size())];
    const Vec3<double>& r = points[random_.below(points.size())];
    const double s = any_of({0, 0.5, 0.25, 1});
    switch (random_.below(3)) {
      case 0:
        return p;
      case 1:
        return p + s * (q - p);
      default: {
        // The foot of the perpendicular.
        const Vec3<double> n = (q - p).cross(r - p);
        const double square = n.squaredNorm();
        return square > 0 ? Vec3<double>(from - n * (n.dot(from - p) / square)) : p;
      }
    }
  }

  bool snap() {
    const bool first = random_.once_in(2);
    Body<double>&moving = first ? case_.a : case_.b, &fixed = first ? case_.b : case_.a;
    const std::vector<Vec3<double>> own = feature_points(moving), other = feature_points(fixed);
    if (own.empty() || other.empty()) return false;
    const std::size_t which = random_.below(own.size());
    const Vec3<double> target = target_of(other, own[which]);
    if (random_.once_in(2)) return move_vertex(moving, which, own.size(), target);
    const bool at_contact = random_.once_in(2);
    // On the path, at a time: the motion brings the two together.
    const double t = at_contact && std::isfinite(case_.t_max) ? any_of({0.5, 1, 0.25}) * case_.t_max : 0;
    moving.position += (target - own[which]) - t * (moving.displacement - fixed.displacement);
    return true;
  }

  // The vertex alone, in the body's frame. Only of shapes that have their vertices as numbers.
  bool move_vertex(Body<double>& body, std::size_t which, std::size_t count, const Vec3<double>& target) {
    const Vec3<double> place = into_body(body, target);
    std::size_t at = 0;
    bool found = false;
    const auto to_place = [&](Slot slot, double x) {
      if (slot != Slot::vertex) return x;
      const std::size_t vertex = at / 3, axis = at % 3;
      ++at;
      if (vertex != which) return x;
      found = true;
      return place[static_cast<int>(axis)];
    };
    const Shape<double> shape = law::map_shape(body.shape, to_place);
    if (!found || at != 3 * count) return false;
    body.shape = shape;
    return true;
  }

  bool touch() {
    if (!law::in_domain(case_)) return false;
    Case linear = case_;
    linear.spin_a = linear.spin_b = {};
    linear.query = corpus::Query::cast;
    if (random_.once_in(2)) {
      const engine::Answer answer = first_contact(linear);
      if (answer.outcome != Outcome::hit) return false;
      // So that first contact is at the start, at the end, or in the middle.
      const double t = answer.toi_lower, keep = any_of({0, 1, 0.5});
      const double horizon = std::isfinite(case_.t_max) ? case_.t_max : 1;
      case_.b.position += (t - keep * horizon) * law::velocity(case_);
      return true;
    }
    for (const engine::Method& method : engine::methods(engine::Kind::query)) {
      if (method.query != corpus::Query::distance || method.scalar != "double") continue;
      linear.query = corpus::Query::distance;
      const engine::Answer answer = method.answer(linear);
      if (!answer.has_points) return false;
      case_.b.position += answer.point_a - answer.point_b;
      return true;
    }
    return false;
  }

  bool duplicate() {
    auto* hull = std::get_if<Hull<double>>(&any_body().shape);
    if (hull == nullptr || hull->size() == 0) return false;
    std::vector<Vec3<double>> vertices(hull->vertices().begin(), hull->vertices().end());
    Vec3<double> once_more = vertices[random_.below(vertices.size())];
    if (random_.once_in(2)) {
      double& x = once_more[any_axis()];
      if (x != 0) x = std::nextafter(x, random_.once_in(2) ? 0 : 2 * x);
    }
    vertices.insert(vertices.begin() + static_cast<std::ptrdiff_t>(random_.below(vertices.size() + 1)),
                    once_more);
    *hull = rebuilt(*hull, vertices);
    return true;
  }

  bool drop() {
    auto* hull = std::get_if<Hull<double>>(&any_body().shape);
    if (hull == nullptr || hull->size() < 2) return false;
    std::vector<Vec3<double>> vertices(hull->vertices().begin(), hull->vertices().end());
    vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(random_.below(vertices.size())));
    *hull = rebuilt(*hull, vertices);
    return true;
  }

  bool flatten() {
    Body<double>& body = any_body();
    const std::size_t axis = random_.below(3);
    std::size_t vertex = 0, extent = 0;
    std::optional<double> level;
    const bool nearly = random_.once_in(3);
    bool changed = false;
    const auto to_level = [&](Slot slot, double x) {
      if (slot == Slot::vertex && vertex++ % 3 == axis) {
        if (!level) level = x;
        changed = true;
        // Nearly: half of them one unit off the plane.
        return nearly && random_.once_in(2) && *level != 0 ? std::nextafter(*level, 2 * *level) : *level;
      }
      if (slot == Slot::extent && extent++ % 3 == axis) {
        changed = true;
        return nearly ? std::scalbn(x, -30) : 0.0;
      }
      return x;
    };
    body.shape = law::map_shape(body.shape, to_level);
    return changed;
  }

  bool align() {
    Body<double>& body = any_body();
    Body<double>& other = &body == &case_.a ? case_.b : case_.a;
    const int axis = any_axis();
    switch (random_.below(6)) {
      case 0:
        body.orientation = {};
        return true;
      case 1:
        body.orientation = other.orientation;
        return true;
      case 2: {
        // A right angle about an axis, exactly.
        Vec3<double> about = Vec3<double>::Zero();
        about[axis] = random_.once_in(2) ? 1 : -1;
        body.orientation = {1, about[0], about[1], about[2]};
        return true;
      }
      case 3:
        body.position[axis] = other.position[axis];
        return true;
      case 4:
        // The motion along an axis, or across it.
        for (int i = 0; i < 3; ++i) {
          if ((i == axis) == random_.once_in(2)) body.displacement[i] = other.displacement[i];
        }
        return true;
      default: {
        // Along an edge of the other body, so that it slides.
        const std::vector<Vec3<double>> points = feature_points(other);
        if (points.size() < 2) return false;
        body.displacement =
            points[random_.below(points.size())] - points[random_.below(points.size())] + other.displacement;
        return true;
      }
    }
  }

  bool start() {
    switch (random_.below(4)) {
      case 0:
        case_.t_max = any_of({0, 1, 0.5, 2, kInfinity<double>});
        return true;
      case 1:
        case_.target_distance = any_of({0, 0, 0.5, 1, 0x1p-20});
        return true;
      case 2:
        case_.start_policy =
            case_.start_policy == StartPolicy::report ? StartPolicy::pass_over : StartPolicy::report;
        return true;
      default: {
        if (!law::in_domain(case_)) return false;
        Case linear = case_;
        linear.spin_a = linear.spin_b = {};
        linear.query = corpus::Query::cast;
        const engine::Answer answer = first_contact(linear);
        if (answer.outcome != Outcome::hit) return false;
        case_.t_max = random_.once_in(2) ? answer.toi_lower : answer.toi_upper;
        return true;
      }
    }
  }

  bool turn() {
    corpus::Spin& spin = random_.once_in(2) ? case_.spin_a : case_.spin_b;
    const corpus::Spin& other = &spin == &case_.spin_a ? case_.spin_b : case_.spin_a;
    const Body<double>& body = &spin == &case_.spin_a ? case_.a : case_.b;
    constexpr double kQuarter = 0x1.921fb54442d18p+0;  // pi / 2, rounded
    switch (random_.below(5)) {
      case 0:
        spin = {};
        return true;
      case 1:
        spin.rotation.setZero();
        spin.rotation[any_axis()] = any_of({kQuarter, -kQuarter, 2 * kQuarter, 1, 0x1p-20});
        return true;
      case 2:
        spin.rotation = other.rotation;
        return true;
      case 3:
        spin.rotation *= any_of({-1, 0.5, 2, 0x1p-10});
        return true;
      default: {
        const std::vector<Vec3<double>> points = feature_points(body);
        if (points.empty()) return false;
        spin.pivot = into_body(body, points[random_.below(points.size())]);
        return true;
      }
    }
  }

  // Curated cases if the source tree is available, and families' cases anywhere.
  static const std::vector<Case>& curated() {
    static const std::vector<Case> kCases = [] {
      std::vector<Case> cases = corpus::read_directory(corpus::corpus_directory() / "cases").cases;
      std::erase_if(cases, [](const Case& one) { return !encode(one); });
      return cases;
    }();
    return kCases;
  }
  Case any_case() {
    const std::vector<Case>& cases = curated();
    if (!cases.empty() && !random_.once_in(4)) return cases[random_.below(cases.size())];
    const auto families = corpus::families();
    const corpus::Family& family = families[random_.below(families.size())];
    return family.generate(family.levels[random_.below(family.levels.size())], random_.below(1000));
  }

  bool swap_in() {
    const Case other = any_case();
    const Body<double>& given = random_.once_in(2) ? other.a : other.b;
    if (random_.once_in(2)) {
      any_body() = given;
    } else {
      any_body().shape = given.shape;
    }
    return true;
  }

  static Hull<double> rebuilt(const Hull<double>& hull, const std::vector<Vec3<double>>& vertices) {
    return hull.has_adjacency() ? with_adjacency<double>(vertices)
                                : Hull<double>(std::span<const Vec3<double>>(vertices));
  }

  Case case_;
  Random& random_;
};

Bytes with_tail(Bytes bytes, std::span<const std::uint8_t> tail, Random& random) {
  const std::size_t size = bytes.size();
  bytes.insert(bytes.end(), tail.begin(), tail.end());
  if (!random.once_in(4)) return bytes;
  const auto changed = static_cast<std::uint8_t>(random.bits());
  if (tail.empty()) {
    bytes.push_back(changed);
  } else {
    bytes[size + random.below(tail.size())] = changed;
  }
  return bytes;
}

}  // namespace

std::optional<Case> moved(Move move, const Case& problem, Random& random) {
  Mover mover(problem, random);
  if (!mover.apply(move)) return std::nullopt;
  // Numbers that were bad before may stay so. A move adds none.
  if (law::in_domain(problem) && !law::in_domain(mover.result())) return std::nullopt;
  return mover.result();
}

std::optional<Bytes> mutated(std::span<const std::uint8_t> bytes, std::size_t most, std::uint64_t seed) {
  Random random(seed);
  const Decoded decoded = decode_with_tail(bytes, Adjacency::left_out);
  Case problem = decoded.problem;
  bool any = false;
  const int moves = random.once_in(2) ? 1 : random.integer(2, 3);
  for (int i = 0, tries = 0; i < moves && tries < 8; ++tries) {
    const Move move = static_cast<Move>(random.below(kMoveNames.size()));
    // A turn is for rotating bodies. Linear cases would set it aside.
    if (move == Move::turn && !law::has_spin(problem) && !random.once_in(8)) continue;
    std::optional<Case> next = moved(move, problem, random);
    if (!next) continue;
    problem = *std::move(next);
    any = true;
    ++i;
  }
  if (!any) return std::nullopt;
  std::optional<Bytes> encoded = encode(problem, decoded.asks_adjacency);
  if (!encoded) return std::nullopt;
  Bytes out = with_tail(*std::move(encoded), decoded.tail, random);
  return out.size() <= most ? std::optional(std::move(out)) : std::nullopt;
}

std::optional<Bytes> crossed(std::span<const std::uint8_t> one, std::span<const std::uint8_t> other,
                             std::size_t most, std::uint64_t seed) {
  Random random(seed);
  const Decoded first = decode_with_tail(one, Adjacency::left_out),
                second = decode_with_tail(other, Adjacency::left_out);
  Case child = first.problem;
  switch (random.below(4)) {
    case 0:
      child.b = second.problem.b;
      child.spin_b = second.problem.spin_b;
      break;
    case 1:
      child.b.shape = second.problem.a.shape;
      break;
    case 2:
      child.a.displacement = second.problem.a.displacement;
      child.b.displacement = second.problem.b.displacement;
      child.spin_a = second.problem.spin_a;
      child.spin_b = second.problem.spin_b;
      break;
    default:
      child.a.shape = second.problem.a.shape;
      child.b.shape = second.problem.b.shape;
      break;
  }
  const bool asks = first.asks_adjacency && (second.asks_adjacency || random.once_in(2));
  std::optional<Bytes> encoded = encode(child, asks);
  if (!encoded) return std::nullopt;
  Bytes out = with_tail(*std::move(encoded), random.once_in(2) ? first.tail : second.tail, random);
  return out.size() <= most ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace graze::fuzz
