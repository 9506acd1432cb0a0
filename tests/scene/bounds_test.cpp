// The bounds of a scene contain the true sets: swept boxes contain the bodies, at every time, and the meeting
// of two boxes contains every time at which they meet. Against ball arithmetic, on inputs that they were not
// written for.
#include <gtest/gtest.h>
#include <graze/scene/swept_box.hpp>
#include <graze/scene/tree.hpp>

#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/bound_truth.hpp"
#include "tests/bounds/describe.hpp"

namespace graze::test {
namespace {

using oracle::WorkingPrecision;
using scene::Meeting;
using scene::SweptBox;

Ball chord(double at_start, double at_end, const Ball& s) {
  return Ball(at_start) + s * (Ball(at_end) - Ball(at_start));
}
Ball component(const BallVec& x, int i) { return i == 0 ? x.x : i == 1 ? x.y : x.z; }

// Points of the body that leave its box at the fraction s of [0, t_end].
int points_outside(const RotatingBody<double>& given, const TrueBody& truth, const SweptBox& box, double s,
                   double t_end) {
  const Ball at(s), t = Ball(s) * Ball(t_end), r = radius_of(given.body.shape);
  int outside = 0;
  for (const BallVec& arm : truth.arms) {
    const BallVec x = truth.place(arm, t);
    for (int i = 0; i < 3; ++i) {
      outside += certainly_less(chord(box.high0[i], box.high1[i], at), component(x, i) + r) ? 1 : 0;
      outside += certainly_less(component(x, i) - r, chord(box.low0[i], box.low1[i], at)) ? 1 : 0;
    }
  }
  return outside;
}

TEST(SweptBoxBounds, NoPointLeavesTheBoxAtAnyTime) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(22);
  int looked = 0, turning = 0, shown = 0;
  for (int k = 0; k < rounds(400); ++k) {
    const HostileScene scene = draw.scene();
    for (const RotatingBody<double>* given : {&scene.a, &scene.b}) {
      const SweptBox box = scene::swept_box(*given, scene.t_end, 0);
      if (!(box.high0 - box.low0).allFinite() || !(box.high1 - box.low1).allFinite()) continue;
      const TrueBody truth(*given);
      turning += truth.turns ? 1 : 0;
      for (const double s : {0.0, 1.0, 0.5, 0.125 * (k % 8), 0x1p-20}) {
        ++looked;
        const int outside = points_outside(*given, truth, box, s, scene.t_end);
        if (outside > 0 && ++shown <= 3) {
          ADD_FAILURE() << outside << " coordinates are outside at s = " << s << "\n" << describe(scene);
        }
      }
    }
  }
  EXPECT_GT(looked, 3000);
  EXPECT_GT(turning, 300);
}

// Numbers near each other, so that differences cancel and roots lie anywhere.
double near(Draw& draw, double x) {
  return x * (1 + draw.between(-8, 8) * 0x1p-52) + draw.between(-1, 1) * draw.between(0, 1) * 0.25;
}

TEST(MeetingBounds, NoTimeAtWhichBoxesMeetIsLeftOut) {
  const WorkingPrecision precision(kTruthBits);
  Draw draw{23};
  int roots = 0, never = 0;
  for (int k = 0; k < rounds(20000); ++k) {
    const double e = draw.between(-3, 3);
    const double p0 = near(draw, e), q0 = near(draw, e), p1 = near(draw, e), q1 = near(draw, e);
    // On one axis, p's upper end comes from the left towards q's lower end. They meet where p(s) >= q(s).
    const Ball gap0 = Ball(p0) - Ball(q0), gap1 = Ball(p1) - Ball(q1);
    SweptBox p{Vec3<double>::Constant(-9), Vec3<double>::Constant(9), Vec3<double>::Constant(-9),
               Vec3<double>::Constant(9)};
    SweptBox q = p;
    p.high0[0] = p0;
    p.high1[0] = p1;
    q.low0[0] = q0;
    q.low1[0] = q1;
    for (const Meeting& found : {scene::meeting(p, q), scene::meeting(q, p)}) {
      EXPECT_TRUE(found.begin == 0 || !gap0.is_nonnegative());
      EXPECT_TRUE(found.end >= 1 || !gap1.is_nonnegative());
      if (gap0.is_nonnegative() == gap1.is_nonnegative()) {
        never += gap0.is_nonnegative() ? 0 : 1;
        EXPECT_EQ(found.possible(), gap0.is_nonnegative());
        continue;
      }
      ++roots;
      const Ball root = gap0 / (gap0 - gap1);
      EXPECT_FALSE(certainly_less(root, Ball(found.begin))) << p0 << " " << q0 << " " << p1 << " " << q1;
      EXPECT_FALSE(certainly_less(Ball(found.end), root)) << p0 << " " << q0 << " " << p1 << " " << q1;
    }
  }
  EXPECT_GT(roots, 1000);
  EXPECT_GT(never, 1000);
}

// A tree finds every pair of boxes that may meet, and no other: held against all pairs.
TEST(TreeBounds, FindsThePairsThatMeetAndNoOthers) {
  Draw draw{24};
  std::size_t pairs = 0;
  for (int round = 0; round < rounds(60); ++round) {
    std::vector<scene::Tree::Item> items;
    const int count = 1 + static_cast<int>(draw.between(0, 200));
    for (int k = 0; k < count; ++k) {
      const bool large = k % 17 == 0, fast = k % 5 == 0, same = k % 7 == 0 && k > 0;
      const auto vector = [&](double most) {
        return Vec3<double>(draw.between(-most, most), draw.between(-most, most), draw.between(-most, most));
      };
      scene::Tree::Item item;
      const Vec3<double> c = vector(10), way = vector(fast ? 40 : 1);
      const Vec3<double> h = Vec3<double>::Constant(large ? draw.between(1, 10) : draw.between(0, 0.5));
      item.box = same ? items.back().box : SweptBox{c - h, c + h, c + way - h, c + way + h};
      item.index = static_cast<std::uint32_t>(k);
      item.group = 1u << (k % 3);
      item.mask = round % 2 == 0 ? ~0u : 1u << (k % 2) | 4u;
      items.push_back(item);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found, expected;
    const scene::Tree tree(items);
    for (std::size_t k = 0; k < items.size(); ++k) {
      tree.for_each_meeting(tree.items()[k], k + 1, [&](const scene::Tree::Item& other, double) {
        found.emplace_back(std::minmax(tree.items()[k].index, other.index));
        return true;
      });
      for (std::size_t l = k + 1; l < items.size(); ++l) {
        if (!scene::may_meet(items[k], items[l].group, items[l].mask)) continue;
        if (scene::meeting(items[k].box, items[l].box).possible()) expected.emplace_back(k, l);
      }
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
    pairs += expected.size();
  }
  EXPECT_GT(pairs, 5000u);
}

}  // namespace
}  // namespace graze::test
