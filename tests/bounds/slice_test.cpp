// Every proof of a march is true, against balls (slice.hpp, march.hpp): along a slice's axis the bodies are
// apart at every sampled time, and at a proved contact they are not apart.
#include <gtest/gtest.h>

#include <graze/detail/rotating/march.hpp>

#include "oracles/curved/rotating_pair.hpp"
#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/bound_truth.hpp"
#include "tests/bounds/describe.hpp"

namespace graze::test {
namespace {

using detail::MovingPair;
using oracle::BallMotion;
using oracle::WorkingPrecision;

// The gap along an axis of a chain at t, over |axis|, world lengths.
Ball gap_along(const BallMotion& a, const BallMotion& b, const TimeSlice& slice, const Ball& t,
               double target) {
  const BallMotion::Pose of_a = a.at(t), of_b = b.at(t);
  const BallVec start(slice.axis);
  const BallVec n = slice.frame == AxisFrame::a   ? of_a.turn(start)
                    : slice.frame == AxisFrame::b ? of_b.turn(start)
                                                  : start;
  return -(of_a.support(n).reach + of_b.support(-n).reach) / norm(n) - Ball(target);
}

// B flies at A from where it is, so that slices end at a contact as often as not.
void bring_on(HostileScene& scene, HostileDraw& draw) {
  const Vec3<double> way = scene.a.body.position - scene.b.body.position;
  const Vec3<double> to = way + draw.plain().vector<double>(0.5 * way.norm());
  scene.b.body.displacement = scene.a.body.displacement + to / scene.t_end;
  for (int i = 0; i < 3; ++i) {
    double& x = scene.b.body.displacement[i];
    if (std::abs(x) < 1e-60) x = 0;
    if (std::abs(x) > 1e60) x = std::copysign(1e60, x);
  }
}

TEST(SliceBounds, AnAxisOfAChainKeepsTheBodiesApart) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(71);
  int slices = 0, turned = 0, hits = 0, wrong_slices = 0, wrong_contacts = 0;
  std::vector<double> least;  // of the gaps looked at within a slice, over the scale
  std::string failures;
  for (int i = 0; i < rounds(1000); ++i) {
    HostileScene scene = draw.scene();
    if (draw.chance(0.5)) bring_on(scene, draw);
    MovingPair pair(scene.a, scene.b, scene.target);
    detail::MarchLimits limits;
    limits.advance = draw.chance(0.8) ? detail::Advance::bilateral : detail::Advance::conservative;
    limits.end = scene.t_end;
    limits.stop = std::max(4 * pair.error(), draw.chance(0.5) ? 1e-9 * pair.scale() : 0.0);
    limits.budget = 1500;
    limits.record = true;
    limits.may_sweep = {detail::has_plain_ball<double>(scene.a.body.shape),
                        detail::has_plain_ball<double>(scene.b.body.shape)};
    Counters counters;
    const detail::March march = detail::march(pair, limits, counters);
    const Vec3<double>& reference = scene.a.body.position;
    const BallMotion a(scene.a.body, {scene.a.rotation, scene.a.pivot}, reference);
    const BallMotion b(scene.b.body, {scene.b.rotation, scene.b.pivot}, reference);
    double begin = 0;
    for (std::size_t k = 0; k < march.chain.size(); ++k) {
      const TimeSlice& slice = march.chain[k];
      const double from = begin, length = slice.end - from;
      begin = slice.end;
      // The last are the nearest to a contact.
      if (k >= 6 && k + 6 < march.chain.size()) continue;
      ++slices;
      turned += slice.frame != AxisFrame::world;
      Ball lowest(kInfinity<double>);
      for (const double part : {0.0, draw.plain().between(0, 1), 0.5, draw.plain().between(0.9, 1), 1.0}) {
        const Ball t = part == 1 ? Ball(slice.end) : Ball(from) + Ball(part) * Ball(length);
        const Ball gap = gap_along(a, b, slice, t, scene.target);
        lowest = min(lowest, gap);
        if (gap.is_positive()) continue;
        if (++wrong_slices <= 3) {
          std::ostringstream out;
          out << std::hexfloat << "  slice " << k << " [" << from << ", " << slice.end << "] frame "
              << static_cast<int>(slice.frame) << " part " << part << " gap " << gap.mid_double() << "\n";
          failures += out.str() + describe(scene, slice.axis, t.mid_double());
        }
      }
      if (lowest.is_positive()) {
        least.push_back((lowest * two_to(-pair.cso().length_exponent())).mid_double() / pair.error());
      }
    }
    if (!march.contact.proved || march.contact.crossing || hits >= rounds(60)) continue;
    ++hits;
    corpus::Case problem;
    problem.a = scene.a.body;
    problem.b = scene.b.body;
    problem.spin_a = {scene.a.rotation, scene.a.pivot};
    problem.spin_b = {scene.b.rotation, scene.b.pivot};
    problem.t_max = scene.t_end;
    problem.target_distance = scene.target;
    const oracle::RotatingPair judge(problem);
    const auto pose = judge.at(Ball(march.upper));
    const Ball fine = judge.scale() * two_to(-60);
    const oracle::Contact there = judge.contact(pose, march.n, fine, fine, 0.5);
    if (there.kind == oracle::Contact::Kind::apart && ++wrong_contacts <= 3) {
      failures += "  contact: apart by " + std::to_string(there.lower.mid_double()) + "\n" +
                  describe(scene, march.n, march.upper);
    }
  }
  std::sort(least.begin(), least.end());
  std::printf("slices: %d, %d along turned axes; %d contacts\n", slices, turned, hits);
  ASSERT_GE(least.size(), 100u);
  std::printf("bound | SliceSearch, least gap of a slice over error() | %d | %d | %.9g | %.3g | %.3g\n",
              slices, wrong_slices, least.front(), least[least.size() / 2], least.back());
  EXPECT_EQ(wrong_slices, 0) << failures;
  EXPECT_EQ(wrong_contacts, 0) << failures;
  EXPECT_GE(slices, rounds(500));
  EXPECT_GE(turned, rounds(50));
  EXPECT_GE(hits, rounds(40));
}

}  // namespace
}  // namespace graze::test
