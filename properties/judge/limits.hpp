// The tolerances of a guarantee for one question, in lengths. This is the one place where a guarantee is applied to a
// case.
//
// Notation   u the unit roundoff of the method, kappa of its guarantee, v a velocity of one body against the other,
//            scale as docs/reference/guarantees.md has it.
//
//                           standard          certified                     exact
//   limit                   kappa u scale     0                             0
//   wide                    limit             width scale                   0
//   rounding of times       -                 of float                      both scalars
//
// A third-party engine declares its limit as a sum of three lengths, kappa u scale, one over scale and one as it is. By
// a further length its times may be early. An engine that declares none has no limit.
//
// The first two include the rounding errors beyond the scale of bodies that lie far out in their local frames
// (properties/judge/own_frames.hpp). For rotating bodies the rounding of times counts in every tier, and a guarantee,
// or the question's tolerance, may grant the bracket a width of its own. A method without a guarantee promises nothing:
// its limits are infinite.
#pragma once

#include "engines/guarantees.hpp"
#include "engines/method.hpp"

namespace graze::law {

struct Limits {
  double limit = 0;      // depth of a contact that may be missed, and distance of bodies reported as touching
  double wide = 0;       // distance from contact that either end of a bracket may have
  double early = 0;      // additional distance before contact that a time may have
  double contact = 0;    // of normals and witnesses
  double contact_u = 0;  // the same for unit vectors, over 1
  engine::Unseen may_miss = engine::Unseen::nothing, may_be_late = engine::Unseen::nothing;
  bool strict = false;  // tier certified: any proved contradiction is a fault
  bool rounds_times = false, contact_rounds_times = false;
  double unit_roundoff = 0;
  double speed = 0;  // no point of one body moves faster against one of the other (length per unit of t)
  double scale = 0;

  // The cost of rounding a finite time outward by two places, a length.
  [[nodiscard]] double rounding_at(double t) const;
  [[nodiscard]] double wide_at(double t) const { return wide + (rounds_times ? rounding_at(t) : 0); }
  [[nodiscard]] double contact_at(double t) const {
    return contact + (contact_rounds_times ? rounding_at(t) : 0);
  }
};

// `seen`: the case as the method sees it. `scale`: a length. `tolerance`: as requested, over scale. `slack`: a length
// that the question itself is off by.
[[nodiscard]] Limits limits_of(const engine::Method& method, const corpus::Case& seen, double scale,
                               double tolerance = 0, double slack = 0);

// kappa of the method's guarantee for this kind of case, infinite without one. The same for its contacts.
[[nodiscard]] double kappa(const engine::Method& method, const corpus::Case& problem);
[[nodiscard]] double contact_kappa(const engine::Method& method, const corpus::Case& problem);

// The scale of docs/reference/guarantees.md, in rounded doubles.
[[nodiscard]] double scale_of(const corpus::Case& problem);
// No point of one body moves faster relative to one of the other: the displacement, and the rotation at the
// arm of the farthest corner of the body's bounds from the pivot.
[[nodiscard]] double top_speed_of(const corpus::Case& problem);
// The reference length of a limit, from the scale of the pair. A line also meets C behind its start, up to the target
// distance back.
[[nodiscard]] double scale_of_question(corpus::Query query, double target_distance, double scale_of_pair);

}  // namespace graze::law
