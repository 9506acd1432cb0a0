// Bilateral advancement as published: Catto, Continuous Collision, GDC 2013. It is the baseline for safe bilateral
// advancement, and it may miss an intermediate contact.
//
// From a time t_1 with the bodies apart, the closest features give an axis. The deepest points along it at the end
// t_2 of the rest of the step are pushed back to the root of their own separation, until no point is nearer than the
// target at t_2. Then t_1 becomes t_2. A step at whose end the bodies are apart along the axis counts as free of
// contact, whatever they did in between. The axis is fixed in the world for vertices and edges. If the closest
// feature is a face, the axis rotates with its body.
//
// The slides stop at a linear slop. This version stops at the tolerance that the caller passes, over scale.
#pragma once

#include <graze/detail/rotating/march.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct PublishedLimits {
  double end = 1;
  double target = 0, tolerance = 0;  // internal length: contact is a distance within tolerance of target
  int budget = 0;
  int outer = 20, push_backs = 8, root_steps = 50;  // the published limits
};

class PublishedBilateral {
 public:
  PublishedBilateral(MovingPair& pair, const PublishedLimits& limits, Counters& counters)
      : pair_(pair), limits_(limits), counters_(counters) {}

  March operator()() {
    double t = 0;
    for (int i = 0; i < limits_.outer; ++i) {
      ++counters_.iterations;
      pair_.place(t);
      const Nearest near = nearest(pair_, out_.closest, 0, limits_.tolerance / 4, limits_.budget, counters_);
      out_.lower = t;
      out_.apart = near.apart;
      out_.closest = near.simplex;
      out_.n = near.n;
      if (near.apart < limits_.target + limits_.tolerance || near.n == Vec3<double>::Zero())
        return touching(t);
      set_axis(near);
      const double next = advance(t);
      if (next >= limits_.end) {
        out_.outcome = Outcome::miss;
        out_.lower = kInfinity<double>;
        return out_;
      }
      if (!(next > t)) return touching(t);
      t = next;
    }
    return out_;
  }

 private:
  March touching(double t) {
    out_.outcome = t > 0 ? Outcome::hit : Outcome::initially_overlapping;
    out_.upper = t;
    return out_;
  }

  // The axis rotates with the face's body: the one whose three closest points are distinct vertices.
  void set_axis(const Nearest& near) {
    const auto distinct = [&](auto vertex) {
      int count = 0;
      for (int i = 0; i < near.simplex.size; ++i) {
        bool seen = false;
        for (int j = 0; j < i; ++j) {
          seen = seen || vertex(near.simplex.point[static_cast<std::size_t>(i)]) ==
                             vertex(near.simplex.point[static_cast<std::size_t>(j)]);
        }
        count += seen ? 0 : 1;
      }
      return count;
    };
    const bool face_a = distinct([](const CsoPoint<double>& p) { return p.vertex_a; }) == 3;
    const bool face_b = distinct([](const CsoPoint<double>& p) { return p.vertex_b; }) == 3;
    frame_ = face_a ? AxisFrame::a : face_b ? AxisFrame::b : AxisFrame::world;
    const Side<double>& side = frame_ == AxisFrame::b ? pair_.cso().side_b() : pair_.cso().side_a();
    own_ = frame_ == AxisFrame::world ? near.n : side.to_own(near.n);
  }
  [[nodiscard]] Vec3<double> axis() const {
    if (frame_ == AxisFrame::world) return own_;
    return (frame_ == AxisFrame::a ? pair_.cso().side_a() : pair_.cso().side_b()).to_world(own_);
  }

  // The deepest pair along the axis at t, and its separation.
  double deepest(double t, CsoPoint<double>& pair) {
    pair_.place(t);
    ++counters_.supports;
    const Vec3<double> n = axis();
    pair = pair_.cso().support(n);
    return -dot(n, pair.w) - pair_.radius();
  }
  // The separation of one pair of points at t.
  double separation(double t, const CsoPoint<double>& pair) {
    pair_.place(t);
    const Cso<double>& cso = pair_.cso();
    const Vec3<double> n = axis();
    const auto& a = cso.side_a();
    const auto& b = cso.side_b();
    const Vec3<double> x_a = a.support(a, a.to_own(n), &pair.vertex_a).x;
    const Vec3<double> x_b = b.support(b, b.to_own(Vec3<double>(-n)), &pair.vertex_b).x;
    return dot(n, b.to_world(x_b) + cso.offset() - a.to_world(x_a)) - pair_.radius();
  }

  double advance(double t_1) {
    double t_2 = limits_.end;
    for (int push = 0; push < limits_.push_backs; ++push) {
      CsoPoint<double> pair;
      const double s_2 = deepest(t_2, pair);
      if (s_2 > limits_.target + limits_.tolerance) return t_2;
      if (s_2 > limits_.target - limits_.tolerance) return t_2;
      const double s_1 = separation(t_1, pair);
      if (s_1 <= limits_.target + limits_.tolerance) return t_1;
      // The root, by secant and bisection steps alternately.
      double low = t_1, high = t_2, s_low = s_1, s_high = s_2;
      for (int i = 0; i < limits_.root_steps; ++i) {
        const double t = i % 2 == 1 ? low + (limits_.target - s_low) * (high - low) / (s_high - s_low)
                                    : low + (high - low) / 2;
        const double s = separation(t, pair);
        if (std::abs(s - limits_.target) < limits_.tolerance) {
          t_2 = t;
          break;
        }
        if (s > limits_.target) {
          low = t;
          s_low = s;
        } else {
          high = t;
          s_high = s;
        }
        t_2 = low;
      }
    }
    return t_2;
  }

  MovingPair& pair_;
  const PublishedLimits& limits_;
  Counters& counters_;
  March out_;
  Vec3<double> own_ = Vec3<double>::Zero();
  AxisFrame frame_ = AxisFrame::world;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
