// Notation (cso.hpp): C = A - B grown by the target distance, h(n) its support; n unit, g(t) = -(h(n) - t n.v), the gap
// along n at time t, is what n proves. Internal lengths; what an axis has to clear beyond 0 is `margin`.
//
//   neither turns   g is linear in t: g(0) and g(T) above the margin prove all between.
//   one turns       along an axis fixed in the world or in a body, every point of the bodies stays within
//                   M t (T - t) / 2 of its chord, so sqrt(g(0)) + sqrt(g(T)) > T sqrt(M / 2) proves all between
//                   (rotating/slice.hpp).
//
// Rounding. Of h: Cso::reach_error, and 8 u of the radius and the offset, as MovingPair::error has it. n may be off its
// length by 48 u where it was turned into a body's axes: a gap is then wrong by as much of itself. n.r of a sum of three
// products, r within u: 8 u sum |n_i r_i|.
//
// The margin. A cast answers miss where the clearance exceeds the tier's width: kLinearCertifiedWidth of scale, and 2^10
// roundings of a named point, which is of points' error; of turning bodies 1e-9, or the caller's tolerance. Standard
// methods answer within kappa u scale, below 2^-36 of it (swept_box.hpp). The margins are above all of them, thrice as
// cso.scale() may be a third of scale.
#include "apart.hpp"

#include <graze/gjk/gjk.hpp>
#include <graze/rotating/slice.hpp>

#include <algorithm>

namespace graze::scene {
namespace {

constexpr double u = kUnitRoundoff<double>;
constexpr int kBudget = 24;  // supports of a search; what needs more is cast
constexpr double kTilt = 1 - 0x1p-46;

Vec3<double> zero() { return Vec3<double>::Zero(); }

// Neither body turns.
class Sliding {
 public:
  Sliding(const Body<double>& a, const Body<double>& b, const StepLimits& limits, Counters& counters)
      : cso_(a, b, limits.target_distance),
        counters_(counters),
        s_end_(cso_.moves() ? cso_.to_parameter(limits.t_end) : 0.0) {
    error_ = cso_.reach_error() + 8 * u * (cso_.radius() + cso_.offset().norm());
    margin_ = (0x1p-36 + limits.tolerance) * (3 * cso_.scale() + cso_.radius() + cso_.extent()) +
              0x1p12 * cso_.point_error();
  }

  [[nodiscard]] bool is_parted_by(const Vec3<double>& n) const {
    ++counters_.supports;
    const double gap = -n.dot(cso_.support(n).w) - cso_.radius() - error_;
    const Vec3<double>& r = cso_.direction();
    const double closing = n.dot(r) - 8 * u * n.cwiseProduct(r).cwiseAbs().sum();
    return gap * kTilt > margin_ && (gap + s_end_ * closing * (1 + 4 * u)) * kTilt > margin_;
  }

  // GJK on C swept along -r, from the hint.
  [[nodiscard]] Vec3<double> search(const Vec3<double>& hint) const {
    const Vec3<double> way = s_end_ * cso_.direction();
    const auto swept = [&](const Vec3<double>& n) {
      CsoPoint<double> p = cso_.support(n);
      if (n.dot(way) < 0) {
        p.w -= way;
        p.e = Vec3<double>::UnitX();  // tells the two ends of a sweep apart
      }
      return p;
    };
    Simplex<double> simplex;
    const Vec3<double> start = hint != zero() ? hint : Vec3<double>(way / 2 - cso_.middle());
    return gjk_distance(swept, zero(), start, simplex, 0x1p-20 * cso_.scale(), cso_.radius() + margin_,
                        kBudget, counters_)
        .n;
  }

 private:
  const Cso<double> cso_;
  Counters& counters_;
  double s_end_, error_ = 0, margin_ = 0;
};

class Turning {
 public:
  Turning(const RotatingBody<double>& a, const RotatingBody<double>& b, const StepLimits& limits,
          Counters& counters)
      : pair_(a, b, limits.target_distance), t_end_(limits.t_end), counters_(counters) {
    const Cso<double>& cso = pair_.cso();
    margin_ = (2e-9 + limits.tolerance) * (3 * cso.scale() + pair_.radius() + cso.extent());
  }

  [[nodiscard]] bool is_parted_by(const PartingAxis& by) {
    const double start = gap_at(0, by), end = start > 0 ? gap_at(t_end_, by) : 0;
    if (!(start > 0 && end > 0)) return false;
    const double bend = pair_.bend(by.frame, pair_.to_world(by.frame, by.axis), t_end_) * (1 + 0x1p-40);
    return (std::sqrt(start) + std::sqrt(end)) * (1 - 0x1p-10) > t_end_ * std::sqrt(bend / 2);
  }

  // The axis of the least distance half way, fixed where it lets points bend least.
  [[nodiscard]] bool find(PartingAxis& out) {
    pair_.place(t_end_ / 2);
    const Cso<double>& cso = pair_.cso();
    Simplex<double> simplex;
    const Vec3<double> start =
        out.is_known() ? pair_.to_world(out.frame, out.axis) : Vec3<double>(-cso.middle());
    const auto support = [&](const Vec3<double>& n) { return cso.support(n); };
    const Vec3<double> n = gjk_distance(support, zero(), start, simplex, 0x1p-20 * cso.scale(),
                                        pair_.radius() + margin_, kBudget, counters_)
                               .n;
    if (n == zero()) return false;
    const std::array<double, 3> bends = pair_.bends(n, t_end_);
    std::array<int, 3> order = {0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](int l, int r) {
      return bends[static_cast<std::size_t>(l)] < bends[static_cast<std::size_t>(r)];
    });
    std::array<Vec3<double>, 3> own;
    for (const int k : order) own[static_cast<std::size_t>(k)] = pair_.to_own(static_cast<AxisFrame>(k), n);
    for (const int k : order) {
      const PartingAxis one{own[static_cast<std::size_t>(k)], static_cast<AxisFrame>(k)};
      if (!is_parted_by(one)) continue;
      out = one;
      return true;
    }
    return false;
  }

 private:
  double gap_at(double t, const PartingAxis& by) {
    if (pair_.time() != t) pair_.place(t);
    const double gap = pair_.gap(pair_.to_world(by.frame, by.axis), counters_);
    return gap * kTilt - pair_.frame_error(by.frame) - margin_ - 8 * pair_.error();
  }

  detail::MovingPair pair_;
  double t_end_, margin_ = 0;
  Counters& counters_;
};

}  // namespace

bool stays_apart(const RotatingBody<double>& a, const RotatingBody<double>& b, const StepLimits& limits,
                 PartingAxis& hint, Counters& counters) {
  if (a.rotation == zero() && b.rotation == zero()) {
    const Sliding pair(a.body, b.body, limits, counters);
    if (hint.is_known() && hint.frame == AxisFrame::world && pair.is_parted_by(hint.axis)) return true;
    const Vec3<double> n = pair.search(hint.frame == AxisFrame::world ? hint.axis : zero());
    if (n == zero() || !pair.is_parted_by(n)) return false;
    hint = {n, AxisFrame::world};
    return true;
  }
  Turning pair(a, b, limits, counters);
  return (hint.is_known() && pair.is_parted_by(hint)) || pair.find(hint);
}

}  // namespace graze::scene
