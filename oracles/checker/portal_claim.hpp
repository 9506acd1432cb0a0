// The claim that a portal proves, over any of the checker's arithmetics. Is there a point of P =
// hull{p_1..p_k}, k <= 4, at s v (within m of it) for some s in [0, U]?  Here p_i = a_i - b_i and U = min(T,
// toi_upper). Points come scaled by w = wA wB > 0. In a portal of cores m is R = r_A + r_B + m.
//
// m = 0. {s : s v in P} is an interval [s0, s1], and its ends are basic solutions of a linear program: each
// comes from a subset of the points whose projections along v are affinely independent and hold 0:
//   a point       v x p = 0                                      s = p_c / v_c
//   a segment     0 between two opposite projections             s = (-g_ij p_i + g_ii p_j)_c / ((g_ii - g_ij) v_c)
//   a triangle    0 in it, o_ij, o_jk, o_ki of one sign or zero  s = sum o_jk p_i,c / (sum o v_c)
// Here c is any axis along which v_c != 0, o_ij = v.(p_i x p_j), and g_ij = (v x p_i).(v x p_j). The claim
// holds iff the subsets give some s <= U and some s >= 0. It is off the path iff there is no subset.
//
// m > 0. If P and the segment [0, U v] are disjoint, their distance is that of two faces at a foot point
// inside both. The pairs of faces are an end with a point, an edge or the triangle of P, and the segment with
// a point or an edge of P. Every foot inside gives the distance of two points of the sets, so the claim holds
// iff one such squared distance is <= m^2.
#pragma once

#include <graze/proof.hpp>
#include <optional>

#include "oracles/checker/posed_exact.hpp"

namespace graze::oracle {

// The points of a portal, all w times what they stand for, w > 0.
template <class N>
struct PortalPoints {
  Triple<N> at[4];
  int size = 0;
  bool weighted = false;  // w differs from 1
  N weight = N(1);
  N balls = N(0);          // of a portal of cores: r_A + r_B, which is added to m
  bool has_balls = false;  // r_A + r_B > 0

  [[nodiscard]] N weigh(const N& s) const { return weighted ? weight * s : s; }
  [[nodiscard]] Triple<N> weigh(const Triple<N>& s) const { return weighted ? scaled(weight, s) : s; }
};

struct PathQuestion {
  const Vec3<double>& displacement_a;
  const Vec3<double>& displacement_b;
  double horizon;          // U
  double target_distance;  // m
  // Does the claim hold for this U as well? Only if no ball is about the points.
  std::optional<double> lowered = {};
};

enum class PortalFinding { holds, off_path, beyond, unknown };

struct PortalFindings {
  PortalFinding claim, lowered = PortalFinding::beyond;

  [[nodiscard]] friend bool is_open(const PortalFindings& found) {
    return found.claim == PortalFinding::unknown || found.lowered == PortalFinding::unknown;
  }
};

template <class N>
class PortalClaim {
 public:
  PortalClaim(const PathQuestion& ask, PortalPoints<N> points)
      : portal_(std::move(points)),
        horizon_(ask.horizon),
        lowered_(ask.lowered),
        rounded_(ask.target_distance > 0 || portal_.has_balls),
        radius_(portal_.balls + N(ask.target_distance)),
        velocity_(difference<N>(ask.displacement_b, ask.displacement_a)) {
    // The largest component of v. Its sign is exact, being that of one rounded difference.
    const Vec3<double> v = ask.displacement_b - ask.displacement_a;
    v.cwiseAbs().maxCoeff(&axis_);
    moving_ = v[axis_] != 0;
    backward_ = v[axis_] < 0;
    if (!moving_) {
      // The path is the origin: that is in P iff it is s u, s in [0, 0], for any direction u.
      axis_ = 0;
      velocity_ = {N(1), N(0), N(0)};
      horizon_ = 0;
      if (lowered_) lowered_ = 0;
    }
  }

  [[nodiscard]] PortalFindings decide() const {
    const Crossing crossing = cross_path();
    PortalFindings found{finding(crossing)};
    if (lowered_) found.lowered = exact_finding(crossing, crossing.before_lowered);
    return found;
  }

 private:
  struct Crossing {
    Answer found = Answer::no, before_end = Answer::no, before_lowered = Answer::no, after_start = Answer::no;
  };

  // m = 0
  [[nodiscard]] PortalFinding exact_finding(const Crossing& crossing, Answer before_end) const {
    const Answer on_time = both(before_end, crossing.after_start);
    if (on_time == Answer::yes) return PortalFinding::holds;
    if (crossing.found == Answer::unknown || on_time == Answer::unknown) return PortalFinding::unknown;
    return crossing.found == Answer::yes && moving_ ? PortalFinding::beyond : PortalFinding::off_path;
  }
  [[nodiscard]] PortalFinding finding(const Crossing& crossing) const {
    if (!rounded_) return exact_finding(crossing, crossing.before_end);
    const Answer on_time = both(crossing.before_end, crossing.after_start);
    if (on_time == Answer::yes) return PortalFinding::holds;
    const Answer near = either(on_time, near_path(true));
    if (near == Answer::yes) return PortalFinding::holds;
    const Answer near_line = moving_ ? either(crossing.found, near_path(false)) : Answer::no;
    if (near == Answer::unknown || near_line == Answer::unknown) return PortalFinding::unknown;
    return near_line == Answer::yes ? PortalFinding::beyond : PortalFinding::off_path;
  }

  // One subset that holds 0, at s = numerator / (denominator v_c w), denominator of the given sign.
  void add(Crossing& crossing, const N& numerator, const N& denominator, bool negative) const {
    const bool flip = negative != backward_;
    const Sign start_sign = sign(numerator);
    crossing.found = Answer::yes;
    crossing.after_start =
        either(crossing.after_start, flip ? at_most_zero(start_sign) : at_least_zero(start_sign));
    const auto before = [&](double horizon) {
      const Sign s = sign(numerator - denominator * portal_.weigh(velocity_[axis_] * horizon));
      return flip ? at_least_zero(s) : at_most_zero(s);
    };
    crossing.before_end = either(crossing.before_end, before(horizon_));
    if (lowered_) crossing.before_lowered = either(crossing.before_lowered, before(*lowered_));
  }

  [[nodiscard]] Crossing cross_path() const {
    constexpr Crossing undecided{Answer::unknown, Answer::unknown, Answer::unknown, Answer::unknown};
    Crossing crossing;
    Triple<N> arm[4];  // v x p_i
    for (int i = 0; i < portal_.size; ++i) arm[i] = cross(velocity_, portal_.at[i]);
    N turn[4][4];  // o_ij, i < j
    Sign turn_sign[4][4];
    bool on_line_possible[4] = {true, true, true, true};  // no o_ij shows that p_i is off the line
    for (int i = 0; i < portal_.size; ++i) {
      for (int j = i + 1; j < portal_.size; ++j) {
        turn[i][j] = dot(arm[i], portal_.at[j]);
        turn_sign[i][j] = sign(turn[i][j]);
        if (turn_sign[i][j] == Sign::unknown) return undecided;
        if (turn_sign[i][j] != Sign::zero) on_line_possible[i] = on_line_possible[j] = false;
      }
    }
    for (int i = 0; i < portal_.size; ++i) {
      if (!on_line_possible[i]) continue;
      const Sign x = sign(arm[i].x), y = sign(arm[i].y), z = sign(arm[i].z);
      const Answer off = either(either(nonzero(x), nonzero(y)), nonzero(z));
      if (off == Answer::unknown) return undecided;
      if (off == Answer::no) add(crossing, portal_.at[i][axis_], N(1), false);
    }
    for (int i = 0; i < portal_.size; ++i) {
      for (int j = i + 1; j < portal_.size; ++j) {
        if (turn_sign[i][j] != Sign::zero) continue;
        const N g = dot(arm[i], arm[j]);
        const Answer opposite = is_negative(sign(g));
        if (opposite == Answer::unknown) return undecided;
        if (opposite == Answer::no) continue;
        const N g_ii = dot(arm[i], arm[i]);
        add(crossing, g_ii * portal_.at[j][axis_] - g * portal_.at[i][axis_], g_ii - g, false);
      }
    }
    for (int i = 0; i < portal_.size; ++i) {
      for (int j = i + 1; j < portal_.size; ++j) {
        for (int k = j + 1; k < portal_.size; ++k) {
          // o_ki = -o_ik
          const Sign ij = turn_sign[i][j], jk = turn_sign[j][k], ki = negated(turn_sign[i][k]);
          const bool any_negative = ij == Sign::negative || jk == Sign::negative || ki == Sign::negative;
          const bool any_positive = ij == Sign::positive || jk == Sign::positive || ki == Sign::positive;
          if (any_negative == any_positive) continue;  // 0 outside, or no triangle if all are zero
          const N total = turn[i][j] + turn[j][k] - turn[i][k];
          add(crossing,
              turn[j][k] * portal_.at[i][axis_] - turn[i][k] * portal_.at[j][axis_] +
                  turn[i][j] * portal_.at[k][axis_],
              total, any_negative);
        }
      }
    }
    return crossing;
  }

  // Is P within m of [0, U v] (bounded), or of the line through 0 along v? P may be taken to meet neither.
  [[nodiscard]] Answer near_path(bool bounded) const {
    const N m = portal_.weigh(radius_);
    const N m_sq = m * m;
    const bool has_length = !bounded || horizon_ > 0;
    const Triple<N> along =
        !has_length ? Triple<N>{} : -(bounded ? portal_.weigh(scaled(N(horizon_), velocity_)) : velocity_);
    Answer near = Answer::no;
    const auto consider = [&near](Answer answer) { near = either(near, answer); };
    if (bounded) {
      for (int end = 0; end < (has_length ? 2 : 1) && near != Answer::yes; ++end) {
        Triple<N> z[4];
        for (int i = 0; i < portal_.size; ++i) z[i] = end == 0 ? portal_.at[i] : portal_.at[i] + along;
        for (int i = 0; i < portal_.size; ++i) {
          consider(at_most_zero(sign(dot(z[i], z[i]) - m_sq)));
          for (int j = i + 1; j < portal_.size; ++j) {
            consider(near_edge(z[i], z[j] - z[i], m_sq, true));
            for (int k = j + 1; k < portal_.size; ++k)
              consider(near_patch(z[i], z[j] - z[i], z[k] - z[i], m_sq, Patch::triangle));
          }
        }
      }
    }
    if (has_length) {
      for (int i = 0; i < portal_.size && near != Answer::yes; ++i) {
        consider(near_edge(portal_.at[i], along, m_sq, bounded));
        for (int j = i + 1; j < portal_.size; ++j)
          consider(near_patch(portal_.at[i], portal_.at[j] - portal_.at[i], along, m_sq,
                              bounded ? Patch::parallelogram : Patch::strip));
      }
    }
    return near;
  }

  // Is 0 within m of z + t d, with its foot at t in [0, 1] if bounded?  |z|^2 - (z.d)^2 / d.d <= m^2.
  [[nodiscard]] static Answer near_edge(const Triple<N>& z, const Triple<N>& d, const N& m_sq, bool bounded) {
    const N dd = dot(d, d), zd = dot(z, d);
    Answer answer = at_most_zero(sign((dot(z, z) - m_sq) * dd - zd * zd));
    if (answer == Answer::no) return answer;
    answer = both(answer, is_positive(sign(dd)));
    if (bounded) answer = both(answer, both(at_most_zero(sign(zd)), at_least_zero(sign(zd + dd))));
    return answer;
  }

  enum class Patch { triangle, parallelogram, strip };  // strip: unbounded along the second direction

  // Is 0 within m of z + alpha d + beta e, with its foot inside the patch?  With g = d x e:
  // (z.g)^2 / g.g <= m^2,  alpha = A / g.g, beta = B / g.g by the normal equations.
  [[nodiscard]] static Answer near_patch(const Triple<N>& z, const Triple<N>& d, const Triple<N>& e,
                                         const N& m_sq, Patch patch) {
    const Triple<N> g = cross(d, e);
    const N gg = dot(g, g), zg = dot(z, g);
    Answer answer = at_most_zero(sign(zg * zg - m_sq * gg));
    if (answer == Answer::no) return answer;
    const N dd = dot(d, d), de = dot(d, e), ee = dot(e, e), zd = dot(z, d), ze = dot(z, e);
    const N alpha = ze * de - zd * ee, beta = zd * de - ze * dd;
    answer = both(answer, both(is_positive(sign(gg)), at_least_zero(sign(alpha))));
    if (patch == Patch::triangle) {
      answer = both(answer, both(at_least_zero(sign(beta)), at_most_zero(sign(alpha + beta - gg))));
    } else {
      answer = both(answer, at_most_zero(sign(alpha - gg)));
      if (patch == Patch::parallelogram)
        answer = both(answer, both(at_least_zero(sign(beta)), at_most_zero(sign(beta - gg))));
    }
    return answer;
  }

  [[nodiscard]] static constexpr Answer nonzero(Sign s) {
    return s == Sign::unknown ? Answer::unknown : s == Sign::zero ? Answer::no : Answer::yes;
  }
  [[nodiscard]] static constexpr Sign negated(Sign s) {
    return s == Sign::unknown ? s : static_cast<Sign>(-static_cast<int>(s));
  }

  PortalPoints<N> portal_;
  double horizon_;
  std::optional<double> lowered_;
  bool rounded_;
  N radius_;  // m, or R for a portal of cores
  Triple<N> velocity_;
  int axis_ = 0;
  bool moving_ = true, backward_ = false;
};

// The points of a proof about two leaves.
template <class N>
[[nodiscard]] PortalPoints<N> portal_points(const Solid& a, const Solid& b, const Proof& proof) {
  const Pair<N> pair(a, b);
  PortalPoints<N> points;
  points.size = proof.portal_size;
  points.weighted = pair.weighted;
  points.weight = pair.weight;
  if (proof.of_cores) {
    points.balls = N(a.radius) + N(b.radius);
    points.has_balls = a.radius > 0 || b.radius > 0;
  }
  for (int i = 0; i < points.size; ++i) {
    const SupportPair& s = proof.portal[static_cast<std::size_t>(i)];
    points.at[i] = difference_point(pair, a, b, s.a, s.b);
  }
  return points;
}

}  // namespace graze::oracle
