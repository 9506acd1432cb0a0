// The form of the proof, then its chain, slice by slice, then its contact.
//
// A slice is tried in double (slice_filter.hpp), then in balls. With s(t) = min over B(t) of
// n(t).b - max over A(t) of n(t).a and M a bound on how fast the slope of any point's n(t).x(t) changes, s
// lies at most M (t - t_0)(t_1 - t)/2 below its chord on [t_0, t_1] (ball_motion.hpp proves it; in the frame
// of a body the points are taken relative to the path of its pivot, which cancels in s). The slice wants s -
// m |n| > 0. A piece that the bound leaves open is cut in the middle; near a contact at t* that the bodies
// approach with a speed, halves as short as t* - t suffice, so pieces grow with the logarithm of the gap
// only.
#include "oracles/check_rotating_proof.hpp"

#include <cstdio>
#include <memory>

#include "oracles/filters_hold.hpp"
#include "oracles/slice_filter.hpp"
#include "oracles/whole_turns.hpp"

namespace graze::oracle {
namespace {

constexpr std::array<long, 3> kBits = {128, 256, 512};

[[nodiscard]] std::string text(double x) {
  char buffer[80];
  std::snprintf(buffer, sizeof buffer, "%a (%.17g)", x, x);
  return buffer;
}

// ---- the form ---------------------------------------------------------------------------------------------

[[nodiscard]] RotatingVerdict malformed(std::string what) {
  return {RotatingRefusal::malformed, std::move(what)};
}

[[nodiscard]] RotatingVerdict read_proof(const RotatingProof& proof) {
  if (!(proof.toi_lower >= 0)) return malformed("toi_lower is NaN or below zero");
  if (!(proof.toi_upper >= 0)) return malformed("toi_upper is NaN or below zero");
  double begin = 0;
  for (std::size_t i = 0; i < proof.chain.size(); ++i) {
    const TimeSlice& slice = proof.chain[i];
    const std::string name = "slice " + std::to_string(i);
    if (!all_finite(slice.axis)) return malformed(name + " has a NaN or an infinite axis");
    if (!(slice.end < kInfinity<double>)) return malformed(name + " has an end that is NaN or infinite");
    if (!(slice.end >= begin))
      return malformed(name + " ends at " + text(slice.end) + ", before it begins, at " + text(begin));
    if (slice.frame != AxisFrame::world && slice.frame != AxisFrame::a && slice.frame != AxisFrame::b)
      return malformed(name + " has a frame of no known kind");
    begin = slice.end;
  }
  if (proof.contact_size < 0 || proof.contact_size > 4) return malformed("a contact_size outside 0..4");
  if (proof.crossing) {
    if (proof.contact_size != 3)
      return malformed("a crossing of " + std::to_string(proof.contact_size) +
                       " pairs, where three are needed");
    if (!(proof.contact_from >= 0)) return malformed("contact_from is NaN or below zero");
    if (!(proof.contact_from < proof.toi_upper))
      return malformed("a crossing from " + text(proof.contact_from) + ", not before toi_upper, " +
                       text(proof.toi_upper));
  }
  for (int i = 0; i < proof.contact_size; ++i) {
    const SupportPair& pair = proof.contact[static_cast<std::size_t>(i)];
    for (const Feature* f : {&pair.a, &pair.b}) {
      const std::string name = "contact pair " + std::to_string(i);
      if (!f->offset.isZero(0)) return malformed(name + " has an offset, which a moving point cannot have");
      for (const Vec3<double>& x : f->curved)
        if (!all_finite(x)) return malformed(name + " has a NaN or an infinite point of a curved part");
    }
  }
  return {};
}

[[nodiscard]] RotatingVerdict refuse_case(const Entry& entry) {
  const RotatingRefusal refusal = entry.refusal == Refusal::malformed     ? RotatingRefusal::malformed
                                  : entry.refusal == Refusal::unsupported ? RotatingRefusal::unsupported
                                                                          : RotatingRefusal::out_of_range;
  return {refusal, entry.reason};
}

// The two shapes, and what their doors say.
struct Trees {
  Door of_a, of_b;
  PartTree a, b;

  explicit Trees(const corpus::Case& problem)
      : of_a(door(problem.a, problem.spin_a)),
        of_b(door(problem.b, problem.spin_b)),
        a(problem.a, of_a),
        b(problem.b, of_b) {}

 private:
  [[nodiscard]] static Door door(const Body<double>& body, const corpus::Spin& spin) {
    Door door;
    for (const Vec3<double>& x : {body.position, body.displacement, spin.rotation, spin.pivot})
      door.vector(x);
    return door;
  }
};

// Is it a case that the checker reads, with the vertices that the proof names?
[[nodiscard]] RotatingVerdict read_case(const corpus::Case& problem, const Trees& trees,
                                        const RotatingProof& proof) {
  if (!(problem.t_max >= 0)) return malformed("t_max is NaN or below zero");
  if (!(problem.target_distance >= 0 && problem.target_distance < kInfinity<double>))
    return malformed("target_distance is NaN, infinite or below zero");
  const std::array<Entry, 2> entries = {trees.of_a.entry(), trees.of_b.entry()};
  for (const Refusal grave : {Refusal::malformed, Refusal::unsupported})
    for (const Entry& entry : entries)
      if (entry.refusal == grave) return refuse_case(entry);
  for (int i = 0; i < proof.contact_size; ++i) {
    const SupportPair& pair = proof.contact[static_cast<std::size_t>(i)];
    if (pair.a.vertex >= trees.a.vertex_count() || pair.b.vertex >= trees.b.vertex_count())
      return malformed("contact pair " + std::to_string(i) +
                       " has an index beyond the vertices of its shape");
  }
  // A lower bound above 0, which is checked as well, says that the start is not in contact: then no policy
  // applies.
  if (problem.start_policy == corpus::StartPolicy::pass_over && proof.toi_upper < kInfinity<double> &&
      !(proof.toi_lower > 0))
    return {RotatingRefusal::unsupported,
            "an upper bound under the policy pass_over, which a leaving start voids"};
  for (const Entry& entry : entries)
    if (entry.refusal != Refusal::none) return refuse_case(entry);
  Door target;
  target.number(problem.target_distance);
  if (target.entry().refusal != Refusal::none)
    return {RotatingRefusal::out_of_range, "target_distance outside 1e-60 .. 1e60"};
  return {};
}

[[nodiscard]] RotatingVerdict chain_reaches(const corpus::Case& problem, const RotatingProof& proof) {
  if (!(proof.toi_lower > 0)) return {};
  const bool miss = proof.toi_lower == kInfinity<double>;
  const double needed = miss ? problem.t_max : proof.toi_lower;
  const double reached = proof.chain.empty() ? 0 : proof.chain.back().end;
  if (!proof.chain.empty() && reached >= needed) return {};
  return {RotatingRefusal::chain_too_short, "the chain ends at " + text(reached) + ", before " +
                                                (miss ? "t_max, " : "toi_lower, ") + text(needed)};
}

// ---- the motion, at one precision -------------------------------------------------------------------------

struct Motion {
  BallMotion a, b;
  std::optional<SweptBody> swept_a, swept_b;
  Ball target_distance;

  explicit Motion(const corpus::Case& problem)
      : a(problem.a, problem.spin_a, problem.a.position),
        b(problem.b, problem.spin_b, problem.a.position),
        swept_a(SweptBody::of(problem.a.shape, a)),
        swept_b(SweptBody::of(problem.b.shape, b)),
        target_distance(problem.target_distance) {}
};

struct Instant {
  double t;
  BallMotion::Pose a, b;

  Instant(const Motion& motion, double at) : t(at), a(motion.a.at(at)), b(motion.b.at(at)) {}
};

// ---- one slice --------------------------------------------------------------------------------------------

enum class SliceFinding { holds, is_false, open, too_many_pieces };

struct SliceAnswer {
  SliceFinding finding = SliceFinding::holds;
  double at = 0;      // is_false, open: a time where s - m |n| is not positive, or not known to be
  double excess = 0;  // about s - m |n| there
};

class Slice {
 public:
  Slice(const Motion& motion, const TimeSlice& slice, double begin, RotatingCheckCost& cost)
      : motion_(motion),
        n_(slice.axis),
        frame_(slice.frame),
        margin_(motion.target_distance * norm(n_)),
        bound_(bound(begin, slice.end)),
        cost_(cost) {}

  [[nodiscard]] SliceAnswer prove(const Instant& begin, const Instant& end) const {
    const Ball first = excess(begin), last = excess(end);
    if (!first.is_positive()) return not_positive(begin.t, first);
    if (!last.is_positive()) return not_positive(end.t, last);
    if (!holds(begin.t, end.t, first, last) && holds_by_whole_turns(begin, end)) return {};
    struct Piece {
      double begin, end;
      Ball first, last;
    };
    std::vector<Piece> open;
    open.push_back({begin.t, end.t, first, last});
    for (int pieces = 1; !open.empty();) {
      const Piece piece = std::move(open.back());
      open.pop_back();
      if (holds(piece.begin, piece.end, piece.first, piece.last)) continue;
      const double middle = piece.begin + (piece.end - piece.begin) / 2;
      if (!(piece.begin < middle && middle < piece.end) || ++pieces > kMostPieces)
        return {SliceFinding::too_many_pieces, piece.begin, piece.first.mid_double()};
      ++cost_.pieces;
      const Ball between = excess(Instant(motion_, middle));
      if (!between.is_positive()) return not_positive(middle, between);
      open.push_back({middle, piece.end, between, piece.last});
      open.push_back({piece.begin, middle, piece.first, between});
    }
    return {};
  }

 private:
  // s - m |n|
  [[nodiscard]] Ball excess(const Instant& now) const {
    const BallVec n = frame_ == AxisFrame::a ? now.a.turn(n_) : frame_ == AxisFrame::b ? now.b.turn(n_) : n_;
    return -(now.a.support(n).reach + now.b.support(-n).reach) - margin_;
  }

  // M_A + M_B over [begin, end].
  [[nodiscard]] Ball bound(double begin, double end) const {
    switch (frame_) {
      case AxisFrame::world:
        return motion_.a.second_bound(n_) + motion_.b.second_bound(n_);
      case AxisFrame::a:
        return second_bound_turning(motion_.a, motion_.b, n_, begin, end);
      case AxisFrame::b:
        break;
    }
    return second_bound_turning(motion_.b, motion_.a, n_, begin, end);
  }

  [[nodiscard]] bool holds(double begin, double end, const Ball& first, const Ball& last) const {
    if (begin == end) return true;
    return chord_stays_positive(first, last, bound_, Ball(end) - Ball(begin));
  }

  // With one body, or both, at all angles at once; the other one's turn alone bends the separation.
  [[nodiscard]] bool holds_by_whole_turns(const Instant& begin, const Instant& end) const {
    if (frame_ != AxisFrame::world) return false;
    for (const auto& [a, b] : {std::pair(true, false), std::pair(false, true), std::pair(true, true)}) {
      if ((a && !motion_.swept_a) || (b && !motion_.swept_b)) continue;
      const auto excess_at = [&, a = a, b = b](const Instant& now) {
        const Ball of_a = a ? motion_.swept_a->reach(motion_.a, n_, now.t) : now.a.support(n_).reach;
        const Ball of_b = b ? motion_.swept_b->reach(motion_.b, -n_, now.t) : now.b.support(-n_).reach;
        return -(of_a + of_b) - margin_;
      };
      const Ball bound =
          (a ? Ball(0) : motion_.a.second_bound(n_)) + (b ? Ball(0) : motion_.b.second_bound(n_));
      const Ball first = excess_at(begin), last = excess_at(end);
      if (first.is_positive() && last.is_positive() &&
          chord_stays_positive(first, last, bound, Ball(end.t) - Ball(begin.t)))
        return true;
    }
    return false;
  }

  [[nodiscard]] static SliceAnswer not_positive(double t, const Ball& excess) {
    const bool no = certainly_at_most(excess, Ball(0));
    return {no ? SliceFinding::is_false : SliceFinding::open, t, excess.mid_double()};
  }

  const Motion& motion_;
  BallVec n_;
  AxisFrame frame_;
  Ball margin_;  // m |n|
  Ball bound_;   // M_A + M_B
  RotatingCheckCost& cost_;
};

// ---- contact ----------------------------------------------------------------------------------------------

[[nodiscard]] bool weights_hold(const RotatingProof& proof) {
  double most = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(proof.contact_size); ++i) {
    if (!(proof.weight[i] >= 0 && proof.weight[i] < kInfinity<double>)) return false;
    most = std::max(most, proof.weight[i]);
  }
  return most > 0;
}

// The last three of crossings alone.
enum class ContactFinding { holds, unnamed, point_outside, apart, open, beside, one_side, too_many_pieces };

struct ContactAnswer {
  ContactFinding finding = ContactFinding::holds;
  int pair = 0;                    // unnamed, point_outside
  double distance = 0, reach = 0;  // apart, open: about |sum l_i c_i| and sum l_i (r_i + m), sum l_i = 1
  double at = 0;                   // beside, too_many_pieces, about
  double first = 0, last = 0;      // one_side: about the height at contact_from and at toi_upper
};

[[nodiscard]] Sign sign_of(const Ball& x) {
  if (x.is_positive()) return Sign::positive;
  if (x.is_negative()) return Sign::negative;
  return x.is_zero() ? Sign::zero : Sign::unknown;
}

// Is 0 strictly inside the hull of four points? The barycentric coordinates of 0 are, up to their sum, the
// determinants of three of them, with alternating signs: inside iff all are of one sign.
[[nodiscard]] Answer holds_origin(const std::array<BallVec, 4>& c) {
  const std::array<Sign, 4> signs = {
      sign_of(dot(c[1], cross(c[2], c[3]))), sign_of(dot(c[0], cross(c[3], c[2]))),
      sign_of(dot(c[0], cross(c[1], c[3]))), sign_of(dot(c[0], cross(c[2], c[1])))};
  Answer answer = Answer::yes;
  for (const Sign s : signs) {
    const Answer same = s == Sign::zero ? Answer::no
                        : s == Sign::unknown || signs[0] == Sign::unknown
                            ? Answer::unknown
                            : (s == signs[0] ? Answer::yes : Answer::no);
    answer = both(answer, same);
  }
  return answer;
}

// The points that the pairs name; finding: holds, unnamed, point_outside, or open where a point of a curved
// part is too near its boundary.
struct NamedPairs {
  std::array<NamedPoint, 4> a, b;
  ContactAnswer answer;

  NamedPairs(const Motion& motion, const RotatingProof& proof) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(proof.contact_size); ++i) {
      a[i] = motion.a.named(proof.contact[i].a);
      b[i] = motion.b.named(proof.contact[i].b);
      for (const NamedPoint* point : {&a[i], &b[i]}) {
        const bool unnamed = point->curved_parts > kCurvedParts;
        if (unnamed || point->inside == Answer::no) {
          answer.finding = unnamed ? ContactFinding::unnamed : ContactFinding::point_outside;
          answer.pair = static_cast<int>(i);
          return;
        }
        if (point->inside == Answer::unknown) answer.finding = ContactFinding::open;
      }
    }
  }
  [[nodiscard]] bool refused() const {
    return answer.finding == ContactFinding::unnamed || answer.finding == ContactFinding::point_outside;
  }
};

[[nodiscard]] ContactAnswer prove_contact(const Motion& motion, const RotatingProof& proof) {
  const NamedPairs pairs(motion, proof);
  if (pairs.refused()) return pairs.answer;
  const Instant end(motion, proof.toi_upper);
  const auto size = static_cast<std::size_t>(proof.contact_size);
  std::array<BallVec, 4> c;
  std::array<Ball, 4> reach;
  ContactAnswer answer = pairs.answer;
  for (std::size_t i = 0; i < size; ++i) {
    c[i] = end.a.place(pairs.a[i]) - end.b.place(pairs.b[i]);
    reach[i] = pairs.a[i].radius + pairs.b[i].radius + motion.target_distance;
  }

  const bool weighted = weights_hold(proof);
  Answer found = Answer::no;
  if (weighted) {
    BallVec sum;
    Ball room, whole;
    for (std::size_t i = 0; i < size; ++i) {
      const Ball l = proof.weight[i];
      sum = sum + l * c[i];
      room.add_product(l, reach[i]);
      whole += l;
    }
    const Ball square = dot(sum, sum), room_square = room * room;
    found = certainly_at_most(square, room_square) ? Answer::yes
            : certainly_less(room_square, square)  ? Answer::no
                                                   : Answer::unknown;
    answer.distance = (sqrt(square) / whole).mid_double();
    answer.reach = (room / whole).mid_double();
  }
  if (found != Answer::yes && size == 4) found = either(found, holds_origin(c));
  if (found == Answer::yes && answer.finding == ContactFinding::open) found = Answer::unknown;
  answer.finding = found == Answer::yes  ? ContactFinding::holds
                   : found == Answer::no ? ContactFinding::apart
                                         : ContactFinding::open;
  return answer;
}

// Contact by crossing. Let c_i(t) = a_i - b_i, n a vector, W_k = n.(c_i x c_j) for (i, j, k) cyclic, and
// d = det(c_0, c_1, c_2). Then
//   W_0 c_0 + W_1 c_1 + W_2 c_2 = d n:
// where d != 0 the W_k / d are the coordinates of n in the c_k, by Cramer's rule; both sides are polynomials.
// So while the three W_k are of one sign, with W their sum, the line {s n} meets the triangle of the c_k, a
// part of C, at (d / W) n. d / W is continuous in t, since the c_k are; if d is above 0 at one end of the
// time and below at the other, or 0 at either, then it is 0 at some time between, and the origin is in C.
// Radii and a target distance only make C larger. Nothing is asked of n but that it is one vector all the
// time.
//
// The checker takes for n the normal of the triangle in the middle of the time, rounded, and shows the signs
// of the W_k with balls for t that cover the whole of it.
class Crossing {
 public:
  Crossing(const Motion& motion, const RotatingProof& proof)
      : motion_(motion),
        pairs_(motion, proof),
        apart_(motion.a.pivot() - motion.b.pivot()),
        velocity_(motion.a.velocity() - motion.b.velocity()),
        from_(proof.contact_from),
        to_(proof.toi_upper) {}

  [[nodiscard]] ContactAnswer prove() const {
    if (pairs_.refused()) return pairs_.answer;
    const Triangle3 middle = triangle(middle_of(from_, to_));
    const BallVec normal = cross(middle[1] - middle[0], middle[2] - middle[0]);
    if (normal.is_zero())
      return {.finding = ContactFinding::beside, .at = middle_of(from_, to_).mid_double()};
    const Ball length = norm(normal);
    if (!length.is_positive()) return {.finding = ContactFinding::open};
    const BallVec n((Ball(1) / length * normal).mid_double());

    const Sign side = sign_of(height_part(n, middle, 0));
    if (side == Sign::unknown) return {.finding = ContactFinding::open};
    ContactAnswer answer = pierced(side == Sign::negative ? -n : n);
    if (answer.finding == ContactFinding::holds) answer = changes_side(n);
    if (answer.finding == ContactFinding::holds) answer.finding = pairs_.answer.finding;
    return answer;
  }

 private:
  using Triangle3 = std::array<BallVec, 3>;

  // Where the pairs hold at the times in a ball. The bodies' common motion is taken out before t enters.
  [[nodiscard]] Triangle3 triangle(const Ball& t) const {
    const BallMotion::Pose a = motion_.a.at(t), b = motion_.b.at(t);
    const BallVec between = apart_ + t * velocity_;
    Triangle3 c;
    for (std::size_t i = 0; i < 3; ++i)
      c[i] = a.turn(pairs_.a[i].from_pivot) - b.turn(pairs_.b[i].from_pivot) + between;
    return c;
  }
  [[nodiscard]] static Ball middle_of(const Ball& begin, const Ball& end) {
    return (Ball(0.5) * (begin + end)).mid();
  }
  // W_k
  [[nodiscard]] static Ball height_part(const BallVec& n, const Triangle3& c, std::size_t k) {
    return dot(n, cross(c[(k + 1) % 3], c[(k + 2) % 3]));
  }
  // Are the three W_k above 0?
  [[nodiscard]] static Answer holds_line(const BallVec& n, const Triangle3& c) {
    Answer answer = Answer::yes;
    for (std::size_t k = 0; k < 3; ++k) {
      const Ball w = height_part(n, c, k);
      answer = both(answer, w.is_positive()                 ? Answer::yes
                            : certainly_at_most(w, Ball(0)) ? Answer::no
                                                            : Answer::unknown);
    }
    return answer;
  }

  // At every time?
  [[nodiscard]] ContactAnswer pierced(const BallVec& n) const {
    std::vector<std::array<Ball, 2>> open;
    open.push_back({from_, to_});
    for (int pieces = 1; !open.empty();) {
      const auto [begin, end] = std::move(open.back());
      open.pop_back();
      const Ball middle = middle_of(begin, end);
      const Answer now = holds_line(n, triangle(middle));
      if (now == Answer::no) return {.finding = ContactFinding::beside, .at = middle.mid_double()};
      if (now == Answer::unknown) return {.finding = ContactFinding::open};
      if (holds_line(n, triangle(hull_of(begin, end))) == Answer::yes) continue;
      if (++pieces > kMostPieces)
        return {.finding = ContactFinding::too_many_pieces, .at = middle.mid_double()};
      open.push_back({middle, end});
      open.push_back({begin, middle});
    }
    return {};
  }

  [[nodiscard]] ContactAnswer changes_side(const BallVec& n) const {
    const Triangle3 begin = triangle(from_), end = triangle(to_);
    const Ball first = dot(begin[0], cross(begin[1], begin[2])), last = dot(end[0], cross(end[1], end[2]));
    const Sign before = sign_of(first), after = sign_of(last);
    if (before == Sign::zero || after == Sign::zero) return {};
    if (before == Sign::unknown || after == Sign::unknown) return {.finding = ContactFinding::open};
    if (before != after) return {};
    const auto height = [&](const Triangle3& c, const Ball& det) {
      return (det / (height_part(n, c, 0) + height_part(n, c, 1) + height_part(n, c, 2))).mid_double();
    };
    return {.finding = ContactFinding::one_side, .first = height(begin, first), .last = height(end, last)};
  }

  const Motion& motion_;
  NamedPairs pairs_;
  BallVec apart_, velocity_;  // of A's pivot from B's
  Ball from_, to_;
};

// ---- the claims -------------------------------------------------------------------------------------------

class Claims {
 public:
  Claims(const corpus::Case& problem, const Trees& trees, const RotatingProof& proof, RotatingCheckCost& cost)
      : problem_(problem), trees_(trees), proof_(proof), cost_(cost) {}

  [[nodiscard]] RotatingVerdict chain() {
    if (proof_.chain.empty()) return {};
    std::optional<SliceFilter> filter;
    SliceFilter::Instant first;
    if (filters_hold()) {
      const WorkingPrecision working(kBits[0]);
      const Motion& motion = at_precision(0);
      filter.emplace(problem_, trees_.a, trees_.b, motion.a, motion.b);
      first = filter->at(0);
    }
    double begin = 0;
    for (std::size_t i = 0; i < proof_.chain.size(); ++i) {
      const TimeSlice& slice = proof_.chain[i];
      if (slice.axis.isZero(0))
        return {RotatingRefusal::axis_missing, "slice " + std::to_string(i) + " has a zero axis"};
      ++cost_.slices;
      bool proved = false;
      if (filter) {
        const WorkingPrecision working(kBits[0]);
        const SliceFilter::Instant last = filter->at(slice.end);
        proved = filter->proves(slice, first, last, kMostPieces, cost_.pieces);
        first = last;
      }
      if (proved) {
        ++cost_.in_double;
      } else if (const SliceAnswer answer = in_balls(slice, begin); answer.finding != SliceFinding::holds) {
        return refuse(i, begin, answer);
      }
      begin = slice.end;
    }
    return {};
  }

  [[nodiscard]] RotatingVerdict contact() {
    if (!(proof_.toi_upper < kInfinity<double>)) return {};
    if (proof_.contact_size == 0)
      return {RotatingRefusal::contact_missing,
              "toi_upper " + text(proof_.toi_upper) + " needs a pair of points in contact"};
    if (proof_.toi_upper > problem_.t_max)
      return {RotatingRefusal::upper_beyond_end,
              "toi_upper " + text(proof_.toi_upper) + " exceeds t_max, " + text(problem_.t_max)};
    if (!proof_.crossing && proof_.contact_size < 4 && !weights_hold(proof_))
      return {RotatingRefusal::weights_missing,
              "fewer than four pairs need finite weights of at least 0, one of them above it"};
    ContactAnswer answer{ContactFinding::open};
    for (std::size_t k = 0; k < kBits.size() && answer.finding == ContactFinding::open; ++k) {
      const WorkingPrecision working(kBits[k]);
      if (k == 1) ++cost_.raised;
      const Motion& motion = at_precision(k);
      answer = proof_.crossing ? Crossing(motion, proof_).prove() : prove_contact(motion, proof_);
    }
    return refuse(answer);
  }

 private:
  [[nodiscard]] const Motion& at_precision(std::size_t k) {
    if (!motions_[k]) motions_[k] = std::make_unique<Motion>(problem_);
    return *motions_[k];
  }

  [[nodiscard]] SliceAnswer in_balls(const TimeSlice& slice, double begin) {
    SliceAnswer answer{SliceFinding::open};
    for (std::size_t k = 0; k < kBits.size() && answer.finding == SliceFinding::open; ++k) {
      const WorkingPrecision working(kBits[k]);
      if (k == 1) ++cost_.raised;
      ++cost_.pieces;
      const Motion& motion = at_precision(k);
      answer = Slice(motion, slice, begin, cost_).prove(Instant(motion, begin), Instant(motion, slice.end));
    }
    return answer;
  }

  [[nodiscard]] RotatingVerdict refuse(std::size_t i, double begin, const SliceAnswer& answer) const {
    const TimeSlice& slice = proof_.chain[i];
    const std::string name = "slice " + std::to_string(i) + ", [" + text(begin) + ", " + text(slice.end) +
                             "]: at t = " + text(answer.at) +
                             " the separation along its axis less the target distance is about " +
                             text(answer.excess);
    if (answer.finding == SliceFinding::is_false)
      return {RotatingRefusal::slice_false, name + ", not above 0"};
    if (answer.finding == SliceFinding::open)
      return {RotatingRefusal::undecided,
              name + ", too near 0 for " + std::to_string(kBits.back()) + " bits"};
    return {RotatingRefusal::slice_not_proved,
            name + "; " + std::to_string(kMostPieces) + " pieces do not show that it stays above 0"};
  }

  [[nodiscard]] RotatingVerdict refuse(const ContactAnswer& answer) const {
    const std::string values = "at toi_upper " + text(proof_.toi_upper) + " the weighted points are about " +
                               text(answer.distance) + " apart, with a reach of about " + text(answer.reach);
    const std::string seen =
        "the crossing from " + text(proof_.contact_from) + " to " + text(proof_.toi_upper) + ": ";
    const std::string line = "at t = " + text(answer.at) + " the line through the origin along its normal ";
    switch (answer.finding) {
      case ContactFinding::holds:
        return {};
      case ContactFinding::beside:
        return {RotatingRefusal::crossing_not_proved, seen + line + "does not pass inside the triangle"};
      case ContactFinding::one_side:
        return {RotatingRefusal::crossing_not_proved,
                seen + "the triangle is on one side of the origin at both ends, at heights of about " +
                    text(answer.first) + " and " + text(answer.last)};
      case ContactFinding::too_many_pieces:
        return {RotatingRefusal::crossing_not_proved,
                seen + std::to_string(kMostPieces) + " pieces do not show that near t = " + text(answer.at) +
                    " the line through the origin along its normal stays inside the triangle"};
      case ContactFinding::unnamed:
        return malformed("contact pair " + std::to_string(answer.pair) +
                         " has a point on a way with more than " + std::to_string(kCurvedParts) +
                         " curved parts, which a feature cannot name");
      case ContactFinding::point_outside:
        return {RotatingRefusal::point_outside,
                "a curved point of contact pair " + std::to_string(answer.pair) + " lies outside its shape"};
      case ContactFinding::apart:
        return {
            RotatingRefusal::contact_not_proved,
            weights_hold(proof_) ? values : "the origin is not strictly inside the hull of the four pairs"};
      case ContactFinding::open:
        break;
    }
    return {RotatingRefusal::undecided, (proof_.crossing ? seen : values + ", ") + "too close for " +
                                            std::to_string(kBits.back()) + " bits"};
  }

  const corpus::Case& problem_;
  const Trees& trees_;
  const RotatingProof& proof_;
  RotatingCheckCost& cost_;
  std::array<std::unique_ptr<Motion>, kBits.size()> motions_;
};

}  // namespace

const char* to_string(RotatingRefusal refusal) {
  switch (refusal) {
    case RotatingRefusal::none:
      return "accepted";
    case RotatingRefusal::malformed:
      return "malformed";
    case RotatingRefusal::unsupported:
      return "unsupported";
    case RotatingRefusal::out_of_range:
      return "out_of_range";
    case RotatingRefusal::chain_too_short:
      return "chain_too_short";
    case RotatingRefusal::axis_missing:
      return "axis_missing";
    case RotatingRefusal::slice_false:
      return "slice_false";
    case RotatingRefusal::slice_not_proved:
      return "slice_not_proved";
    case RotatingRefusal::contact_missing:
      return "contact_missing";
    case RotatingRefusal::upper_beyond_end:
      return "upper_beyond_end";
    case RotatingRefusal::point_outside:
      return "point_outside";
    case RotatingRefusal::weights_missing:
      return "weights_missing";
    case RotatingRefusal::contact_not_proved:
      return "contact_not_proved";
    case RotatingRefusal::crossing_not_proved:
      return "crossing_not_proved";
    case RotatingRefusal::undecided:
      return "undecided";
  }
  return "unknown refusal";
}

RotatingVerdict check_rotating_proof(const corpus::Case& problem, const RotatingProof& proof,
                                     RotatingCheckCost* cost) {
  if (RotatingVerdict form = read_proof(proof); !form.accepted()) return form;
  const Trees trees(problem);
  if (RotatingVerdict form = read_case(problem, trees, proof); !form.accepted()) return form;
  if (RotatingVerdict reach = chain_reaches(problem, proof); !reach.accepted()) return reach;
  RotatingCheckCost ignored;
  Claims claims(problem, trees, proof, cost != nullptr ? *cost : ignored);
  if (RotatingVerdict chain = claims.chain(); !chain.accepted()) return chain;
  return claims.contact();
}

}  // namespace graze::oracle
