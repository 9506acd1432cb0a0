// The contact claim of a rotating proof, in balls. At toi_upper the points that its pairs name, each where
// its body has carried it, meet by the weights, or their differences hold the origin strictly inside.
//
// For the oracles' own .cpp files (it includes Arb).
#pragma once

#include <algorithm>
#include <array>
#include <graze/rotating_proof.hpp>
#include <utility>

#include "oracles/checker/pair_motion.hpp"
#include "oracles/checker/tree_support.hpp"

namespace graze::oracle {

[[nodiscard]] inline bool weights_hold(const RotatingProof& proof) {
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

// Is 0 strictly inside the hull of four points? The barycentric coordinates of 0 are, up to their sum, the
// determinants of three of them, with alternating signs: inside iff all are of one sign.
[[nodiscard]] inline Answer holds_origin(const std::array<BallVec, 4>& c) {
  const std::array<Sign, 4> signs = {sign(dot(c[1], cross(c[2], c[3]))), sign(dot(c[0], cross(c[3], c[2]))),
                                     sign(dot(c[0], cross(c[1], c[3]))), sign(dot(c[0], cross(c[2], c[1])))};
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

// The points that the pairs name. The finding is holds, unnamed, point_outside, or open if a point of a
// curved part, or an offset, is too near its boundary.
struct NamedPairs {
  std::array<NamedPoint, kContactPairs> a, b;
  ContactAnswer answer;

  NamedPairs(const PairMotion& motion, const RotatingProof& proof) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(proof.contact_size); ++i) {
      a[i] = motion.a.named(proof.contact[i].a);
      b[i] = motion.b.named(proof.contact[i].b);
      for (const auto& [point, feature] :
           {std::pair(&a[i], &proof.contact[i].a), {&b[i], &proof.contact[i].b}}) {
        take_offset(*point, feature->offset);
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
  // Within the ball about the point. The rest of the ball still counts.
  static void take_offset(NamedPoint& point, const Vec3<double>& offset) {
    if (offset.isZero(0)) return;
    const BallVec o(offset);
    const Ball square = dot(o, o), most = point.radius * point.radius;
    point.inside = both(point.inside, certainly_at_most(square, most) ? Answer::yes
                                      : certainly_less(most, square)  ? Answer::no
                                                                      : Answer::unknown);
    point.radius = not_below_zero(point.radius - sqrt(square));
  }
  [[nodiscard]] bool refused() const {
    return answer.finding == ContactFinding::unnamed || answer.finding == ContactFinding::point_outside;
  }
};

[[nodiscard]] inline ContactAnswer prove_contact(const PairMotion& motion, const RotatingProof& proof) {
  const NamedPairs pairs(motion, proof);
  if (pairs.refused()) return pairs.answer;
  const PairInstant end(motion, proof.toi_upper);
  const auto size = static_cast<std::size_t>(proof.contact_size);
  std::array<BallVec, kContactPairs> c;
  std::array<Ball, kContactPairs> reach;
  ContactAnswer answer = pairs.answer;
  for (std::size_t i = 0; i < size; ++i) {
    c[i] = (end.a.place(pairs.a[i]) + BallVec(proof.contact[i].a.offset)) -
           (end.b.place(pairs.b[i]) + BallVec(proof.contact[i].b.offset));
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
  if (found != Answer::yes && size >= 4) {
    // Any length of the last tells the same: the sum by the weights is as good as their mean.
    BallVec last = c[3];
    if (size > 4) {
      last = BallVec();
      for (std::size_t i = 3; i < size; ++i) last = last + Ball(proof.weight[i]) * c[i];
    }
    if (size == 4 || weighted) found = either(found, holds_origin({c[0], c[1], c[2], last}));
  }
  if (found == Answer::yes && answer.finding == ContactFinding::open) found = Answer::unknown;
  answer.finding = found == Answer::yes  ? ContactFinding::holds
                   : found == Answer::no ? ContactFinding::apart
                                         : ContactFinding::open;
  return answer;
}

}  // namespace graze::oracle
