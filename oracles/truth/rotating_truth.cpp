// Decides exactly: contact at t = 0 of polytopes and rounded ones, if balls leave it open (LinearTruth).
// Brackets only: everything else.
// Costs, milliseconds of one core, mean (worst) of 60 random pairs of all kinds of shapes, 192 bits:
//   turn              slices of a verdict   verdict     clearance or depth
//   none              18                    2.5 (10)    2
//   a few radians     23                    4.3 (33)    3
//   some 200 radians  103                   10 (45)     30
//   A pair that slides in contact without depth ends undecided after 4,096 slices, 0.4 s. The whole budget
//   is 10 s.
// Cannot be trusted: to answer at all where clearance or depth is below the width, where a flat A - B passes
//   through the origin, or beyond its budget. There the answer is not_converged, undecided. Its answers are proved.
//
// The march. At a time t with the bodies apart along an axis, the slice [t, t'] is as long as the bound of
// rotating_pair.hpp allows, and the next axis is sought at t'. If the axis closes in at a rate r, the slice
// ends with a tenth of the gap left. If the bodies graze, slices grow with the root of the gap. Once the
// distance is below a quarter of the width w, toi_lower is fixed, and slices prove only that the depth stays
// below 0.9 w. They end as soon as an overlap is proved, toi_upper, or the bodies come apart. If the
// remaining rotation is more than a radian, whole turns are tried first: the swept sets of all rotations only
// translate, and one axis may then serve for any number of turns.
#include "oracles/truth/rotating_truth.hpp"

#include <cmath>
#include <queue>
#include <stdexcept>
#include <vector>

#include "oracles/arithmetic/default_environment.hpp"
#include "oracles/curved/rotating_pair.hpp"
#include "oracles/truth/by_time.hpp"
#include "oracles/truth/case_truth.hpp"
#include "oracles/truth/unbounded.hpp"

namespace graze::oracle {
namespace {

// Distances are as good as this part of themselves.
constexpr double kRelativeGap = 0x1p-45;
// The greatest depth that an open slice may hide, and the distance at which slices are open, both over the
// width.
constexpr double kDeepest = 0.9, kNearest = 0.25;
// Slices that may pass with the bodies closer than can be told: where they slide, these are short.
constexpr int kOpenSlices = 4096;
// Nodes of a subdivision for a clearance or a depth.
constexpr int kNodes = 200;

void refuse_what_is_no_case(const corpus::Case& problem, double width) {
  if (!(problem.t_max >= 0) || std::isinf(problem.t_max)) {
    throw std::invalid_argument("t_max: it is below 0, infinite or NaN");
  }
  if (!(problem.target_distance >= 0) || std::isinf(problem.target_distance)) {
    throw std::invalid_argument("target_distance: it is below 0, infinite or NaN");
  }
  if (problem.start_policy != corpus::StartPolicy::report) {
    throw std::invalid_argument("start_policy: pass_over has no meaning where bodies turn");
  }
  if (!(width >= RotatingTruth::kLeastWidth && width <= RotatingTruth::kGreatestWidth)) {
    throw std::invalid_argument("width: it is outside 1e-16 .. 1e-3");
  }
}

// A slice of time and a bound of what is sought over it.
struct Node {
  Ball from, to;
  double value = 0;
};

}  // namespace

struct RotatingTruth::Impl {
  corpus::Case problem;
  double width;
  int budget;
  long bits = 192;
  std::optional<RotatingPair> pair;
  Ball end, fine, near, scale;  // T, width scale, and the distance beyond which a double's axis serves
  double turn = 0;              // radians that the two bodies turn together over [0, T]

  Outcome outcome = Outcome::not_converged;
  bool contact = false, out_of_budget = false;
  std::string reason;
  Ball lower, upper;
  int slices = 0;
  std::vector<Node> proved;  // [0, T] of a miss: lower bounds of the distance
  Vec3<double> axis = Vec3<double>::UnitX();
  mutable std::optional<Enclosure> clearance, depth;
  ByTime distances, depths;

  Impl(const corpus::Case& given, double asked, int most, bool searches = true);
  void measure();
  void march();
  [[nodiscard]] Contact contact_at(const PairPose& pose, double slack = RotatingPair::kAnyDepth) const {
    return pair->contact(pose, axis, fine, near, slack);
  }
  struct Step {
    PairPose to;
    SliceBound slice;
  };
  [[nodiscard]] std::optional<Step> step(const PairPose& from, Turning turning, const Ball& least,
                                         double first_try);
  [[nodiscard]] PairPose past_whole_turns(PairPose from);
  void choose_axis(const PairPose& now, const PairPose& before, Turning turning, const Contact& found);
  void decide_contact(const Ball& at, const std::optional<Ball>& open_from);
  void leave_open(const Ball& from, std::string why);
  [[nodiscard]] std::optional<bool> in_contact_at_rest() const;

  [[nodiscard]] Enclosure least_distance() const;
  [[nodiscard]] Enclosure greatest_depth(const Ball& from, const Ball& to) const;
  [[nodiscard]] double slice_bound(const Vec3<double>& n, bool at_end, const PairPose& from,
                                   const PairPose& to) const;
};

RotatingTruth::Impl::Impl(const corpus::Case& given, double asked, int most, bool searches)
    : problem(given), width(asked), budget(most) {
  refuse_what_is_no_case(given, asked);
  {
    const WorkingPrecision precision(bits);
    measure();
  }
  // 192 bits resolve a width of 1e-14 and squares of features of its size. The bits lost to a smaller width,
  // and to coordinates beyond the scale, are added.
  const double size = scale.low_double();
  const double speed = norm(pair->b().velocity() - pair->a().velocity()).high_double() * problem.t_max;
  const double largest = pair->magnitude() + speed;
  const double lost = size > 0 ? std::log2(std::max(1.0, largest / size)) : 0;
  bits += 2 * static_cast<long>(std::min(lost, 2000.0) + std::max(0.0, std::log2(1e-14 / width)));
  const WorkingPrecision precision(bits);
  measure();
  if (searches) march();
}

void RotatingTruth::Impl::measure() {
  pair.emplace(problem);
  end = problem.t_max;
  scale = pair->scale();
  fine = (Ball(width) * scale).high();
  near = (Ball(0x1p-36) * scale).high();
  turn = ((norm(pair->a().rotation()) + norm(pair->b().rotation())) * end).high_double();
}

// The longest slice from there that the axis proves s > least over, starting with `first_try`.
std::optional<RotatingTruth::Impl::Step> RotatingTruth::Impl::step(const PairPose& from, Turning turning,
                                                                   const Ball& least, double first_try) {
  constexpr int kTries = 64, kPatient = 48;
  double h = first_try;
  for (int i = 0; i < kTries && slices < budget; ++i) {
    Ball t = (from.t + Ball(h)).mid();
    if (!mid_less(t, end)) t = end;
    if (!mid_less(from.t, t)) return {};
    ++slices;
    Step next{pair->at(t), {}};
    next.slice = pair->over(axis, false, turning, from, next.to);
    if (next.slice.exceeds(least)) return next;
    const double s0 = (next.slice.s0 - least).mid_double(), s1 = (next.slice.s1 - least).mid_double();
    if (!(s0 > 0)) return {};
    h = next.slice.duration.mid_double();
    // As a part of h: where the bound alone would let s fall to 0, and where the chord does.
    const double by_curve = std::sqrt(s0 / (0.5 * next.slice.bound.mid_double())) / h;
    const double by_chord = 0.9 * s0 / (s0 - s1);
    double shorter = 0.9;
    if (s1 > 0) {
      shorter = 0.95 * (by_curve + std::sqrt(s1 / s0) * by_curve);
    } else {
      shorter = by_curve < 1 ? std::max(by_chord, 0.5 * by_curve) : by_chord;
    }
    // If s grows by nearly as much as the bound subtracts, each try gains only a tenth, whatever is left.
    h *= std::min(shorter, i < kPatient ? 0.9 : 0.5);
  }
  return {};
}

// As far as bodies that have swept all they turn through stay apart.
PairPose RotatingTruth::Impl::past_whole_turns(PairPose from) {
  constexpr int kRounds = 8;
  for (int i = 0; i < kRounds && mid_less(from.t, end); ++i) {
    const Nearest3 found = pair->turned_distance(from.t, near, 0.25);
    ++slices;
    if (!found.lower.is_positive()) break;
    const BallVec n = found.axis.mid();
    const Ball s0 = pair->turned_separation(n, from.t), at_end = pair->turned_separation(n, end);
    Ball to = end, s1 = at_end;
    if (!at_end.is_positive()) {
      to = (from.t + Ball(0.99) * (end - from.t) * s0 / (s0 - at_end)).mid();
      s1 = pair->turned_separation(n, to);
    }
    if (!s0.is_positive() || !s1.is_positive() || !mid_less(from.t, to)) break;
    const bool far = mid_less(Ball(0x1p-6) * (end - from.t), to - from.t);
    proved.push_back({from.t, to, min(s0, s1).low_double()});
    from = pair->at(to);
    if (!far) break;
  }
  return from;
}

// The best of the one that was found and the last slice's, as it stands now.
void RotatingTruth::Impl::choose_axis(const PairPose& now, const PairPose& before, Turning turning,
                                      const Contact& found) {
  if (found.kind == Contact::Kind::apart) {
    axis = found.axis;
    return;
  }
  const BallVec last(axis);
  Ball most;
  bool any = false;
  for (const BallVec& n : {pair->turned(last, before, now, turning), BallVec(found.axis)}) {
    if (!norm(n).is_positive()) continue;
    const Ball s = pair->separation(n, now);
    if (any && !mid_less(most, s)) continue;
    any = true;
    most = s;
    axis = n.mid_double();
  }
}

void RotatingTruth::Impl::march() {
  PairPose now = pair->at(0), before = now;
  Turning turning = Turning::world;
  std::optional<Ball> open_from;
  double last = problem.t_max;
  int open_slices = 0;
  int next_turns = 0;  // whole turns are tried at 1, 2, 4, ... slices
  while (true) {
    if (slices >= next_turns && turn * ((end - now.t) / end).mid_double() > 1) {
      now = past_whole_turns(now);
      next_turns = 2 * slices + 1;
      before = now;
    }
    const Contact found = contact_at(now);
    if (found.kind == Contact::Kind::overlapping) return decide_contact(now.t, open_from);
    const bool open =
        found.kind == Contact::Kind::open || certainly_at_most(found.upper, Ball(kNearest) * fine);
    if (open && !open_from) {
      open_from = now.t;
      if (now.t.is_zero() && in_contact_at_rest() == true) return decide_contact(0, {});
    }
    if (!mid_less(now.t, end)) break;
    choose_axis(now, before, turning, found);
    const BallVec n(axis);
    turning = pair->steadiest(n, now, end);
    const Ball least = open ? -(Ball(kDeepest) * fine) : Ball(0);
    const int tried = slices;
    const std::optional<Step> next =
        open_slices > kOpenSlices
            ? std::nullopt
            : step(now, turning, least, std::min(4 * last, (end - now.t).high_double()));
    if (!next) {
      out_of_budget = true;
      const std::string when = " slices, at t = " + std::to_string(now.t.mid_double());
      return leave_open(open_from ? *open_from : now.t,
                        open_slices > kOpenSlices ? "clearance and depth are below the width for " +
                                                        std::to_string(open_slices) + when
                                                  : "the budget ends after " + std::to_string(slices) + when);
    }
    if (open) open_slices += slices - tried;
    last = next->slice.duration.mid_double();
    proved.push_back({now.t, next->to.t, next->slice.least().low_double()});
    before = std::move(now);
    now = next->to;
  }
  if (open_from) return leave_open(*open_from, "clearance and depth are below the width");
  outcome = Outcome::miss;
}

// LinearTruth knows contact of exact bodies at t = 0.
std::optional<bool> RotatingTruth::Impl::in_contact_at_rest() const {
  if (!is_exact_body(problem.a.shape) || !is_exact_body(problem.b.shape)) return {};
  corpus::Case rest = problem;
  rest.spin_a = rest.spin_b = {};
  rest.a.displacement.setZero();
  rest.b.displacement.setZero();
  return LinearTruth(rest).outcome() == Outcome::initially_overlapping;
}

void RotatingTruth::Impl::leave_open(const Ball& from, std::string why) {
  lower = from;
  arb_pos_inf(upper.get());
  reason = std::move(why);
}

void RotatingTruth::Impl::decide_contact(const Ball& at, const std::optional<Ball>& open_from) {
  contact = true;
  upper = at;
  lower = open_from ? *open_from : at;
  outcome = Outcome::hit;
  if (!lower.is_zero()) return;
  if (upper.is_zero()) {
    outcome = Outcome::initially_overlapping;
    return;
  }
  if (!in_contact_at_rest()) {  // exact bodies in contact at t = 0 were met before
    outcome = Outcome::not_converged;
    reason = "contact is proved; whether at t = 0 already is open";
  }
}

// A lower bound of s over the slice, by an axis as it stands at one of its ends.
double RotatingTruth::Impl::slice_bound(const Vec3<double>& n, bool at_end, const PairPose& from,
                                        const PairPose& to) const {
  const PairPose& at = at_end ? to : from;
  const Turning turning = pair->steadiest(BallVec(n), at, at_end ? from.t : to.t);
  return pair->over(n, at_end, turning, from, to).least().low_double();
}

Enclosure RotatingTruth::Impl::least_distance() const {
  const auto higher = [](const Node& l, const Node& r) { return l.value > r.value; };
  std::priority_queue<Node, std::vector<Node>, decltype(higher)> open(higher, proved);
  double least = kInf;
  for (int i = 0; i < kNodes; ++i) {
    const Node node = open.top();
    if (least <= (1 + kSlack) * node.value || least <= fine.low_double()) break;
    open.pop();
    const Ball middle = (Ball(0.5) * (node.from + node.to)).mid();
    const PairPose from = pair->at(node.from), mid = pair->at(middle), to = pair->at(node.to);
    const Nearest3 found = pair->distance(mid, fine, kSlack / 4);
    least = std::min(least, found.upper.high_double());
    Node left{node.from, middle, node.value}, right{middle, node.to, node.value};
    const Ball length = norm(found.axis);
    if (length.is_positive()) {
      const Vec3<double> n = ((Ball(1) / length) * found.axis).mid_double();
      left.value = std::max(left.value, slice_bound(n, true, from, mid));
      right.value = std::max(right.value, slice_bound(n, false, mid, to));
    }
    open.push(left);
    open.push(right);
  }
  return {open.top().value, least};
}

Enclosure RotatingTruth::Impl::greatest_depth(const Ball& first, const Ball& last) const {
  const auto lower_first = [](const Node& l, const Node& r) { return l.value < r.value; };
  std::priority_queue<Node, std::vector<Node>, decltype(lower_first)> open(lower_first);
  double shown = 0;
  // The depth there, and an axis that the bodies are no deeper along.
  const auto look = [&](const PairPose& pose) {
    const Contact found = contact_at(pose, kSlack / 4);
    if (found.kind == Contact::Kind::overlapping) shown = std::max(shown, found.lower.low_double());
    return found.axis.isZero(0) ? axis : found.axis;
  };
  const auto bound = [&](const Vec3<double>& n, bool at_end, const PairPose& from, const PairPose& to) {
    return std::max(0.0, -slice_bound(n, at_end, from, to));
  };
  {
    const PairPose from = pair->at(first), to = pair->at(last);
    open.push({first, last, bound(look(to), true, from, to)});
  }
  for (int i = 0; i < kNodes; ++i) {
    const Node node = open.top();
    if (node.value <= (1 + kSlack) * shown || node.value <= fine.low_double()) break;
    open.pop();
    const Ball middle = (Ball(0.5) * (node.from + node.to)).mid();
    const PairPose from = pair->at(node.from), mid = pair->at(middle), to = pair->at(node.to);
    const Vec3<double> n = look(mid);
    open.push({node.from, middle, std::min(node.value, bound(n, true, from, mid))});
    open.push({middle, node.to, std::min(node.value, bound(n, false, mid, to))});
  }
  return {shown, std::max(shown, open.top().value)};
}

RotatingTruth::RotatingTruth(const corpus::Case& problem, double width, int budget) {
  const DefaultEnvironment environment;
  impl_ = std::make_unique<Impl>(problem, width, budget);
}
RotatingTruth::~RotatingTruth() = default;
RotatingTruth::RotatingTruth(RotatingTruth&&) noexcept = default;
RotatingTruth& RotatingTruth::operator=(RotatingTruth&&) noexcept = default;

Outcome RotatingTruth::outcome() const { return impl_->outcome; }
bool RotatingTruth::contact_proved() const { return impl_->contact; }
bool RotatingTruth::budget_ended() const { return impl_->out_of_budget; }
const std::string& RotatingTruth::reason() const { return impl_->reason; }
int RotatingTruth::slices() const { return impl_->slices; }

double RotatingTruth::toi_lower() const {
  const DefaultEnvironment environment;
  if (impl_->outcome == Outcome::miss) return kInf;
  return std::max(0.0, impl_->lower.low_double());
}

double RotatingTruth::toi_upper() const {
  const DefaultEnvironment environment;
  return impl_->contact ? impl_->upper.high_double() : kInf;
}

int RotatingTruth::compare(double t) const {
  const DefaultEnvironment environment;
  if (std::isnan(t)) throw std::invalid_argument("compare: NaN is not a time");
  if (impl_->outcome == Outcome::miss) return -1;
  if (std::isinf(t)) return t < 0 ? -1 : (impl_->contact ? 1 : 0);
  if (impl_->outcome == Outcome::initially_overlapping) return t < 0 ? -1 : (t > 0 ? 1 : 0);
  if (t < 0 || certainly_less(Ball(t), impl_->lower)) return -1;
  return certainly_less(impl_->upper, Ball(t)) ? 1 : 0;
}

Enclosure RotatingTruth::scale() const {
  const DefaultEnvironment environment;
  return impl_->scale.enclosure();
}

Enclosure RotatingTruth::clearance() const {
  const DefaultEnvironment environment;
  if (impl_->contact) return {};
  if (!impl_->clearance) {
    const WorkingPrecision precision(impl_->bits);
    if (impl_->outcome == Outcome::miss) {
      impl_->clearance = impl_->proved.empty() ? distance_at(0) : impl_->least_distance();
    } else {
      impl_->clearance = {0, distance_at(toi_lower()).high};
    }
  }
  return *impl_->clearance;
}

Enclosure RotatingTruth::depth() const {
  const DefaultEnvironment environment;
  if (impl_->outcome == Outcome::miss) return {};
  if (!impl_->depth) {
    const WorkingPrecision precision(impl_->bits);
    impl_->depth = impl_->greatest_depth(impl_->lower, impl_->end);
  }
  return *impl_->depth;
}

Enclosure RotatingTruth::distance_at(double t) const {
  const DefaultEnvironment environment;
  if (!std::isfinite(t)) return kUnbounded;
  return impl_->distances.at(t, [&]() -> Enclosure {
    const WorkingPrecision precision(impl_->bits);
    const Nearest3 found = impl_->pair->distance(impl_->pair->at(t), impl_->fine, kRelativeGap);
    return {found.lower.low_double(), found.upper.high_double()};
  });
}

Enclosure RotatingTruth::depth_at(double t) const {
  const DefaultEnvironment environment;
  if (!std::isfinite(t)) return kUnbounded;
  const WorkingPrecision precision(impl_->bits);
  const Contact found = impl_->contact_at(impl_->pair->at(t), kSlack / 4);
  if (found.kind == Contact::Kind::apart) return {};
  const double low = found.kind == Contact::Kind::overlapping ? found.lower.low_double() : 0.0;
  return {low, found.depth.high_double()};
}

Enclosure RotatingTruth::depth_before(double t) const {
  const DefaultEnvironment environment;
  if (std::isnan(t)) return kUnbounded;
  if (t <= 0 || compare(t) < 0) return {};
  if (t >= impl_->problem.t_max) return depth();
  return impl_->depths.at(t, [&] {
    const WorkingPrecision precision(impl_->bits);
    return impl_->greatest_depth(impl_->lower, t);
  });
}

Enclosure RotatingTruth::backward_error(double t) const {
  const DefaultEnvironment environment;
  if (!std::isfinite(t) || t < 0) return kUnbounded;
  const Enclosure distance = distance_at(t);
  const Enclosure depth = depth_before(t);
  return {std::max(distance.low, depth.low), std::max(distance.high, depth.high)};
}

Enclosure RotatingTruth::lateness(double t) const {
  const DefaultEnvironment environment;
  if (std::isnan(t)) return kUnbounded;
  const int order = compare(t);
  if (order < 0) return {};
  const Enclosure late = depth_before(t);
  return {order > 0 ? late.low : 0, late.high};
}

Enclosure RotatingTruth::normal_error(const Vec3<double>& n) const {
  const DefaultEnvironment environment;
  if (impl_->outcome == Outcome::miss || !finite(n) || n.isZero(0)) return kUnbounded;
  if (!impl_->contact) return {0, kInf};
  const WorkingPrecision precision(impl_->bits);
  const Ball toi = hull_of(impl_->lower, impl_->upper);
  const PairPose pose = impl_->pair->at(toi);
  const BallVec axis(n);
  const Ball error = impl_->pair->set(pose)(axis).reach / norm(axis);
  return {std::max(0.0, error.low_double()), std::max(0.0, error.high_double())};
}

Enclosure RotatingTruth::distance_from_body(char body, double t, const Vec3<double>& world_point) const {
  const DefaultEnvironment environment;
  if (body != 'a' && body != 'b') throw std::invalid_argument("a body is 'a' or 'b'");
  if (!std::isfinite(t) || !finite(world_point)) return kUnbounded;
  const WorkingPrecision precision(impl_->bits);
  BallVec point;
  {
    const WorkingPrecision exact(ARF_PREC_EXACT);
    point = BallVec(world_point) - BallVec(impl_->problem.a.position);
  }
  const Nearest3 found =
      impl_->pair->distance_from_body(body, impl_->pair->at(t), point, impl_->fine, kRelativeGap);
  return {found.lower.low_double(), found.upper.high_double()};
}

RotatingTruth::RotatingTruth(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

RotatingTruth RotatingTruth::of_proved(const corpus::Case& problem, double lower, double upper,
                                       double width) {
  const DefaultEnvironment environment;
  if (!(lower >= 0 && lower <= upper && upper <= problem.t_max))
    throw std::invalid_argument("a proved bracket is an interval of times up to t_max");
  auto impl = std::make_unique<Impl>(problem, width, kDefaultBudget, false);
  impl->lower = lower;
  impl->upper = upper;
  impl->contact = true;
  impl->outcome = upper == 0 ? Outcome::initially_overlapping : Outcome::hit;
  return RotatingTruth(std::move(impl));
}

}  // namespace graze::oracle
