// The crossing claim of a rotating proof, in balls: the origin passes through the triangle of three pairs
// between contact_from and toi_upper.
//
// Let c_i(t) = a_i - b_i, n a vector, W_k = n.(c_i x c_j) for (i, j, k) cyclic, and d = det(c_0, c_1, c_2).
// Then
//   W_0 c_0 + W_1 c_1 + W_2 c_2 = d n:
// If d != 0, the W_k / d are the coordinates of n in the c_k, by Cramer's rule. Both sides are polynomials,
// so the identity holds for d = 0 too. While the three W_k are of one sign, with W their sum, the line {s n}
// meets the triangle of the c_k, a part of C, at (d / W) n. The quotient d / W is continuous in t, since the
// c_k are. If d is above 0 at one end of the time and below at the other, or 0 at either, then it is 0 at
// some time between, and the origin is in C. Radii and a target distance only make C larger. The only
// condition on n is that it is one vector all the time.
//
// The checker takes for n the normal of the triangle in the middle of the time, rounded, and shows the signs
// of the W_k with balls that hold the c_k at all times of a piece. With h half of the piece, c(t) is within
// h^2 / 2 (|w_A|^2 |x_A| + |w_B|^2 |x_B|) of c + (t - t_mid) c'. The velocity c' is small for bodies on long arms
// that rotate almost as one, although each moves fast.
//
// For the oracles' own .cpp files (it includes Arb).
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "oracles/checker/check_rotating_proof.hpp"
#include "oracles/checker/contact_claim.hpp"

namespace graze::oracle {

class CrossingClaim {
 public:
  CrossingClaim(const PairMotion& motion, const RotatingProof& proof)
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

    const Sign side = sign(height_part(n, middle, 0));
    if (side == Sign::unknown) return {.finding = ContactFinding::open};
    ContactAnswer answer = pierced(side == Sign::negative ? -n : n);
    if (answer.finding == ContactFinding::holds) answer = changes_side(n);
    if (answer.finding == ContactFinding::holds) answer.finding = pairs_.answer.finding;
    return answer;
  }

 private:
  using Triangle3 = std::array<BallVec, 3>;

  // The place of the pairs at the times in a ball. The bodies' common motion is taken out before t enters.
  [[nodiscard]] Triangle3 triangle(const Ball& t) const {
    const BallMotion::Pose a = motion_.a.at(t), b = motion_.b.at(t);
    const BallVec between = apart_ + t * velocity_;
    Triangle3 c;
    for (std::size_t i = 0; i < 3; ++i)
      c[i] = a.turn(pairs_.a[i].from_pivot) - b.turn(pairs_.b[i].from_pivot) + between;
    return c;
  }
  // The places at all times from begin to end, exact balls.
  [[nodiscard]] Triangle3 triangle_over(const Ball& begin, const Ball& end) const {
    const Ball middle = middle_of(begin, end), half = max(end - middle, middle - begin).high(),
               way = hull_of(-half, half);
    const BallMotion::Pose a = motion_.a.at(middle), b = motion_.b.at(middle);
    const BallVec &w_a = motion_.a.rotation(), &w_b = motion_.b.rotation();
    const BallVec between = apart_ + middle * velocity_;
    Triangle3 c;
    for (std::size_t i = 0; i < 3; ++i) {
      const BallVec x = a.turn(pairs_.a[i].from_pivot), y = b.turn(pairs_.b[i].from_pivot);
      const BallVec speed = cross(w_a, x) - cross(w_b, y) + velocity_;
      const Ball bend =
                     (Ball(0.5) * half * half * (dot(w_a, w_a) * norm(x) + dot(w_b, w_b) * norm(y))).high(),
                 about = hull_of(-bend, bend);
      c[i] = x - y + between + way * speed + BallVec{about, about, about};
    }
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
      if (holds_line(n, triangle_over(begin, end)) == Answer::yes) continue;
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
    const Sign before = sign(first), after = sign(last);
    if (before == Sign::zero || after == Sign::zero) return {};
    if (before == Sign::unknown || after == Sign::unknown) return {.finding = ContactFinding::open};
    if (before != after) return {};
    const auto height = [&](const Triangle3& c, const Ball& det) {
      return (det / (height_part(n, c, 0) + height_part(n, c, 1) + height_part(n, c, 2))).mid_double();
    };
    return {.finding = ContactFinding::one_side, .first = height(begin, first), .last = height(end, last)};
  }

  const PairMotion& motion_;
  NamedPairs pairs_;
  BallVec apart_, velocity_;  // of A's pivot from B's
  Ball from_, to_;
};

}  // namespace graze::oracle
