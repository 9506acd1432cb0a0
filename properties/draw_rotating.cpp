#include "properties/draw_rotating.hpp"

#include <array>
#include <cmath>

#include "corpus/families/turning.hpp"
#include "corpus/support_value.hpp"
#include "properties/case_edit.hpp"
#include "properties/draw_case.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Random;
using corpus::Spin;

namespace {

enum class Manner { free, slow, many_turns, as_one, unseen, unturned, lash };

class TurningDrawing {
 public:
  explicit TurningDrawing(Random& random) : random_(random) {
    constexpr std::array kManners = {
        Manner::free,       Manner::free,     Manner::free,   Manner::free,   Manner::free,   Manner::slow,
        Manner::slow,       Manner::as_one,   Manner::as_one, Manner::as_one, Manner::unseen, Manner::unseen,
        Manner::many_turns, Manner::unturned, Manner::lash,   Manner::lash,   Manner::lash,   Manner::lash};
    manner_ = kManners[random_.below(kManners.size())];
  }

  Case turn(Case problem) {
    problem.family = "drawn rotating";
    // The policy and the rays stay now and then: they are answered where no turn is seen.
    const bool linear_only = manner_ == Manner::unseen && random_.once_in(8);
    if (!linear_only) {
      if (std::isinf(problem.t_max)) problem.t_max = 1;
      problem.start_policy = corpus::StartPolicy::report;
    }
    choose_turns();
    constexpr std::array kTimes = {0.0, 0.25, 0.5, 0.5, 0.75, 1.0, 1.0, 1.5};
    const double horizon = problem.t_max > 0 && std::isfinite(problem.t_max) ? problem.t_max : 1;
    meeting_ = kTimes[random_.below(kTimes.size())];
    if (manner_ == Manner::lash && meeting_ == 0) meeting_ = 0.5;
    const double pace = (meeting_ > 0 ? meeting_ : 1) * horizon;
    give(problem.spin_a, turn_a_, turns_a_, pace);
    give(problem.spin_b, turn_b_, turns_b_, pace);
    if (manner_ == Manner::unseen) unseen(problem);
    if (manner_ == Manner::as_one) {
      as_one(problem, meeting_ * horizon);
    } else if (manner_ == Manner::lash) {
      lash(problem, meeting_ * horizon);
    } else if (!random_.once_in(3)) {
      place(problem, meeting_ * horizon);
    } else if (random_.once_in(3)) {
      // Where the bounds may never meet.
      problem.b.position[random_.integer(0, 2)] += random_.once_in(2) ? 32 : -32;
    }
    return problem;
  }

 private:
  Quaternion<double> some_turn() {
    Quaternion<double> q;
    do {
      for (double* x : {&q.w, &q.x, &q.y, &q.z}) *x = random_.integer(-3, 3);
      if (random_.once_in(3)) q.x = q.y = 0;  // about an axis: ties
    } while (q.is_identity());
    return q;
  }

  // About the axis of the lash.
  Quaternion<double> turn_about_axis() {
    Quaternion<double> q;
    q.w = random_.integer(-2, 3);
    (axis_ == 0 ? q.x : axis_ == 1 ? q.y : q.z) = random_.integer(1, 3) * (random_.once_in(2) ? 1 : -1);
    return q;
  }

  // Up to the meeting.
  void choose_turns() {
    if (manner_ == Manner::unturned) return;
    if (manner_ == Manner::lash) {
      lashes_a_ = random_.once_in(2);
      axis_ = random_.integer(0, 2);
      (lashes_a_ ? turn_a_ : turn_b_) = turn_about_axis();
      if (random_.once_in(4)) (lashes_a_ ? turn_b_ : turn_a_) = some_turn();
      return;
    }
    turn_a_ = random_.once_in(4) ? Quaternion<double>{} : some_turn();
    turn_b_ = random_.once_in(4) ? Quaternion<double>{} : some_turn();
    if (manner_ == Manner::slow) {
      // Angles of 2^-1 .. 2^-30.
      for (Quaternion<double>* q : {&turn_a_, &turn_b_}) q->w = std::scalbn(8, random_.integer(0, 28));
    }
    if (manner_ == Manner::many_turns) {
      turns_a_ = turn_a_.is_identity() ? 0 : random_.integer(0, 8);
      turns_b_ = turn_b_.is_identity() ? 0 : random_.integer(0, 8);
      if (random_.once_in(8)) turns_b_ *= 20;
    }
  }

  void give(Spin& spin, const Quaternion<double>& turn, int turns, double pace) {
    spin.rotation = corpus::rotation_vector(turn, turns) / pace;
    // Small integers are easy to read; they meet at another time, or nowhere.
    if (random_.once_in(4)) spin.rotation = spin.rotation.array().round();
    switch (random_.below(6)) {
      case 0:
      case 1:
        for (int i = 0; i < 3; ++i) spin.pivot[i] = random_.integer(-4, 4);
        break;
      case 2:
        for (int i = 0; i < 3; ++i) spin.pivot[i] = random_.uniform(-4, 4);
        break;
      case 3:
        for (int i = 0; i < 3; ++i) spin.pivot[i] = random_.integer(-64, 64);
        break;
      default:
        break;
    }
  }

  // Exactly, but in one of four cases for B's pivot; two in three have B moving along their common axis, so
  // that in the frame that turns with them its motion is linear, and meets at t.
  void as_one(Case& problem, double t) {
    Vec3<double> apart = Vec3<double>::Zero();
    if (!random_.once_in(3)) {
      const int axis = random_.integer(0, 2);
      problem.spin_a.rotation = random_.integer(1, 6) * Vec3<double>::Unit(axis);
      apart[axis] = random_.integer(1, 4) * (random_.once_in(2) ? 1 : -1);
    }
    if (!random_.once_in(4)) {
      problem.a.orientation = problem.b.orientation = {};
      if (random_.once_in(2)) problem.a.position = problem.a.position.array().round();
    }
    const Vec3<double> a = corpus::rotate(problem.a.orientation, feature(problem.a.shape)),
                       b = corpus::rotate(problem.b.orientation, feature(problem.b.shape));
    if (!random_.once_in(3)) problem.b.position = problem.a.position + a - b - t * apart;
    if (const std::optional<Case> alike = moved_as_one(problem)) {
      problem = *alike;
      if (random_.once_in(4)) problem.spin_b.pivot[0] += 0x1p-20;
    } else {
      problem.spin_b.rotation = problem.spin_a.rotation;
      problem.b.displacement = problem.a.displacement;
    }
    problem.b.displacement += apart;
  }

  void unseen(Case& problem) {
    for (const bool first : {true, false}) {
      if (random_.once_in(4)) continue;
      Body<double>& body = first ? problem.a : problem.b;
      if (random_.once_in(2)) body.orientation = {};
      if (const auto spun = with_unseen_turn(problem, first, random_.bits())) {
        problem = *spun;
      } else {
        body.shape = Sphere<double>{static_cast<double>(random_.integer(0, 4))};
        if (const auto ball = with_unseen_turn(problem, first, random_.bits())) problem = *ball;
      }
    }
    if (random_.once_in(3)) problem.b.displacement = problem.a.displacement;
  }

  // A vertex, or a point on a side of the bounds.
  Vec3<double> feature(const Shape<double>& shape) {
    constexpr std::size_t kMost = 64;
    if (const auto vertices = exact_vertices(shape, kMost); vertices && !vertices->empty()) {
      return (*vertices)[random_.below(vertices->size())];
    }
    const corpus::Bounds box = corpus::bounds(shape);
    Vec3<double> x = (box.low + box.high) / 2;
    const int i = random_.integer(0, 2);
    x[i] = random_.once_in(2) ? box.low[i] : box.high[i];
    return x;
  }

  // Where the point x of the body is at the meeting, less its position.
  static Vec3<double> carried(const Body<double>& body, const Spin& spin, const Quaternion<double>& turn,
                              double t, const Vec3<double>& x) {
    const Vec3<double> pivot = corpus::rotate(body.orientation, spin.pivot);
    const Vec3<double> arm = corpus::rotate(body.orientation, x) - pivot;
    return corpus::rotate(turn, arm) + pivot + t * body.displacement;
  }

  void place(Case& problem, double t) {
    const bool now = t == 0;
    const Quaternion<double> still;
    const Vec3<double> a =
        carried(problem.a, problem.spin_a, now ? still : turn_a_, t, feature(problem.a.shape));
    const Vec3<double> b =
        carried(problem.b, problem.spin_b, now ? still : turn_b_, t, feature(problem.b.shape));
    problem.b.position = problem.a.position + a - b;
    if (random_.once_in(4)) {
      const double beside = std::scalbn(1.0, random_.once_in(2) ? -8 : -24);
      problem.b.position[random_.integer(0, 2)] += random_.once_in(2) ? beside : -beside;
    }
  }

  // In a plane across the lash's axis, the handle first, or last; thin beside its length.
  Shape<double> whip(const Vec3<double>& handle, const Vec3<double>& tip) {
    const Vec3<double> across = Vec3<double>::Unit(axis_) * std::scalbn(1.0, -random_.integer(2, 12)),
                       third = (random_.once_in(2) ? tip : handle) + across;
    switch (random_.below(8)) {
      case 0:
      case 1:
        return Segment<double>{handle, tip};
      case 2:
        return Segment<double>{tip, handle};
      case 3:
      case 4:
        return Triangle<double>{handle, third, tip};
      case 5:
        return Triangle<double>{tip, handle, third};
      default: {
        std::vector<Vec3<double>> vertices = {handle, tip};
        if (random_.once_in(2)) vertices.insert(vertices.begin() + random_.integer(0, 2), third);
        if (random_.once_in(2)) vertices.insert(vertices.begin(), Vec3<double>((handle + tip) / 2 - across));
        if (random_.once_in(2)) std::swap(vertices.front(), vertices.back());
        return Hull<double>(std::span<const Vec3<double>>(vertices));
      }
    }
  }

  // Of the body at the meeting, less its position: the corner that is first in the way of what comes along n.
  // A body without corners, and every second one, becomes a ball.
  Vec3<double> front(Body<double>& body, const Spin& spin, const Quaternion<double>& turn, double t,
                     const Vec3<double>& n) {
    constexpr std::size_t kMost = 64;
    const auto corners = exact_vertices(body.shape, kMost);
    if (!corners || corners->empty() || random_.once_in(2)) {
      const double radius = random_.integer(0, 3);
      body.shape = Sphere<double>{radius};
      return carried(body, spin, turn, t, Vec3<double>::Zero()) - radius * n;
    }
    Vec3<double> first = carried(body, spin, turn, t, corners->front());
    for (const Vec3<double>& corner : *corners) {
      const Vec3<double> x = carried(body, spin, turn, t, corner);
      if (n.dot(x) < n.dot(first)) first = x;
    }
    return first;
  }

  // One body is long and thin and turns about its end, square to itself, and its other end meets the other
  // body's front: the point of contact moves along the normal, as fast as any point of the body may.
  void lash(Case& problem, double t) {
    Body<double>&moving = lashes_a_ ? problem.a : problem.b, &other = lashes_a_ ? problem.b : problem.a;
    Spin &spin = lashes_a_ ? problem.spin_a : problem.spin_b,
         &its = lashes_a_ ? problem.spin_b : problem.spin_a;
    Vec3<double> handle = Vec3<double>::Zero();
    if (random_.once_in(2)) {
      for (int i = 0; i < 3; ++i) handle[i] = random_.integer(-4, 4);
    }
    const Vec3<double> arm = random_.integer(2, 24) * Vec3<double>::Unit((axis_ + random_.integer(1, 2)) % 3),
                       tip = handle + arm;
    moving.shape = whip(handle, tip);
    moving.orientation = random_.once_in(2) ? Quaternion<double>{} : turn_about_axis();
    spin.pivot = handle;
    if (!random_.once_in(3)) moving.displacement = other.displacement;

    const Quaternion<double>&turn = lashes_a_ ? turn_a_ : turn_b_, &its_turn = lashes_a_ ? turn_b_ : turn_a_;
    const Vec3<double> path =
        corpus::rotate(turn, spin.rotation.cross(corpus::rotate(moving.orientation, arm)));
    const Vec3<double> ahead = path.isZero(0) ? Vec3<double>::Unit(axis_) : Vec3<double>(path / path.norm());
    moving.position =
        other.position + front(other, its, its_turn, t, ahead) - carried(moving, spin, turn, t, tip);
    if (random_.once_in(4)) {
      const double beside = std::scalbn(1.0, random_.once_in(2) ? -8 : -24);
      moving.position += (random_.once_in(2) ? beside : -beside) * ahead;
    }
  }

  Random& random_;
  Manner manner_ = Manner::free;
  bool lashes_a_ = false;
  int axis_ = 0;
  Quaternion<double> turn_a_, turn_b_;
  int turns_a_ = 0, turns_b_ = 0;
  double meeting_ = 0;
};

}  // namespace

Case draw_rotating(Random& random, int size) {
  Case problem = draw_case(random, size);
  TurningDrawing drawing(random);
  Case turned = drawing.turn(problem);
  // Sums of far exponents may end below the domain.
  return in_domain(turned) ? turned : problem;
}

}  // namespace graze::law
