#include "properties/generate/rotating.hpp"

#include <array>
#include <cmath>

#include "corpus/families/draw.hpp"
#include "corpus/families/turning.hpp"
#include "properties/edit/case.hpp"
#include "properties/generate/case.hpp"
#include "properties/generate/far.hpp"
#include "properties/generate/meeting.hpp"
#include "properties/generate/propeller.hpp"
#include "properties/generate/tip_contact.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Random;
using corpus::Spin;

namespace {

enum class Manner { free, slow, many_turns, as_one, unseen, unturned, lash, propeller, far_rods, far_arms };

class TurningDrawing {
 public:
  explicit TurningDrawing(Random& random) : random_(random) {
    constexpr std::array kManners = {
        Manner::free,     Manner::free,     Manner::free,       Manner::free,      Manner::free,
        Manner::slow,     Manner::slow,     Manner::as_one,     Manner::as_one,    Manner::as_one,
        Manner::unseen,   Manner::unseen,   Manner::many_turns, Manner::unturned,  Manner::lash,
        Manner::lash,     Manner::lash,     Manner::lash,       Manner::propeller, Manner::propeller,
        Manner::far_rods, Manner::far_rods, Manner::far_arms,   Manner::far_arms};
    manner_ = kManners[random_.below(kManners.size())];
  }

  Case turn(Case problem) {
    problem.family = "drawn rotating";
    // The policy and the rays are sometimes kept: they are answered if no rotation is visible.
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
      place_lash(random_, lash_, problem, turn_a_, turn_b_, meeting_ * horizon);
    } else if (manner_ == Manner::propeller) {
      place_propeller(random_, turns_a_ > 0, problem, horizon);
    } else if (manner_ == Manner::far_rods) {
      place_far_rods(random_, problem, meeting_ * horizon);
    } else if (manner_ == Manner::far_arms) {
      place_far_arms(random_, problem);
    } else if (!random_.once_in(3)) {
      place(problem, meeting_ * horizon);
    } else if (random_.once_in(3)) {
      // At a place where the bounds may never meet.
      problem.b.position[random_.integer(0, 2)] += random_.once_in(2) ? 32 : -32;
    }
    // A horizon that is not a sum of few powers of two, so that quotients by it round. It is drawn from a
    // copy, so that the next case is the same as if this one had kept its own.
    Random aside = random_;
    if (!linear_only && aside.once_in(4)) problem.t_max *= aside.once_in(2) ? 0.7 : 1.3;
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

  // Up to the meeting.
  void choose_turns() {
    if (manner_ == Manner::unturned) return;
    if (manner_ == Manner::lash) {
      lash_ = draw_lash(random_);
      (lash_.is_a ? turn_a_ : turn_b_) = draw_turn_of(lash_, random_);
      if (random_.once_in(4)) (lash_.is_a ? turn_b_ : turn_a_) = some_turn();
      return;
    }
    if (manner_ == Manner::propeller) {
      const bool is_a = random_.once_in(2);
      (is_a ? turn_a_ : turn_b_) = some_turn();
      (is_a ? turns_a_ : turns_b_) = random_.integer(1, 8);
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
    // Small integers are easy to read. The bodies then meet at another time, or nowhere.
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

  // Exactly, except for B's pivot in one of four cases. In two of three, B moves along their common axis, so
  // that in the frame that rotates with them its motion is linear, and meets at t.
  void as_one(Case& problem, double t) {
    Vec3<double> apart = Vec3<double>::Zero();
    if (!random_.once_in(3)) {
      const int axis = random_.integer(0, 2);
      problem.spin_a.rotation = random_.integer(1, 6) * Vec3<double>::Unit(axis);
      const int by = random_.integer(1, 4);
      apart[axis] = random_.once_in(2) ? by : -by;
    }
    if (!random_.once_in(4)) {
      problem.a.orientation = problem.b.orientation = {};
      if (random_.once_in(2)) problem.a.position = problem.a.position.array().round();
    }
    const Vec3<double> a = corpus::rotate(problem.a.orientation, draw_feature(random_, problem.a.shape)),
                       b = corpus::rotate(problem.b.orientation, draw_feature(random_, problem.b.shape));
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

  void place(Case& problem, double t) {
    const bool now = t == 0;
    const Quaternion<double> still;
    const Vec3<double> a =
        carried(problem.a, problem.spin_a, now ? still : turn_a_, t, draw_feature(random_, problem.a.shape));
    const Vec3<double> b =
        carried(problem.b, problem.spin_b, now ? still : turn_b_, t, draw_feature(random_, problem.b.shape));
    problem.b.position = problem.a.position + a - b;
    if (random_.once_in(4)) {
      const double beside = draw_beside(random_);
      problem.b.position[random_.integer(0, 2)] += beside;
    }
  }

  Random& random_;
  Manner manner_ = Manner::free;
  Lash lash_;
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
