// The trial of the checker of rotating proofs. Proofs of drawn scenes are accepted up to 1e-9 of first
// contact. From each of them, a change that is certainly wrong makes a proof that claims a little too much.
// It is refused.
//
// "Certainly" rests on the closed form of first contact (rotating_scenes.hpp) and on separations in long
// double, whose errors are below 1e-15 here: every change goes at least kSure beyond the truth.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <map>
#include <optional>

#include "corpus/format/proof_io.hpp"
#include "oracles/checker/check_rotating_proof.hpp"
#include "tests/shared/rotating_scenes.hpp"

namespace graze::test {
namespace {

using oracle::RotatingCheckCost;
using oracle::RotatingRefusal;
using oracle::RotatingVerdict;

// Each trial is held twice: as the checker is, and in balls alone.
using oracle::Stages;

class RotatingTrial : public testing::TestWithParam<Stages> {
 protected:
  [[nodiscard]] static RotatingVerdict check(const corpus::Case& problem, const RotatingProof& proof,
                                             RotatingCheckCost* cost = nullptr) {
    return oracle::check_rotating_proof(problem, proof, cost, GetParam());
  }
};
INSTANTIATE_TEST_SUITE_P(Each, RotatingTrial, testing::Values(Stages::all, Stages::without_doubles),
                         [](const auto& instance) {
                           return instance.param == Stages::without_doubles ? "Balls" : "AsItIs";
                         });

constexpr double kInf = kInfinity<double>;
constexpr Long kSure = 1e-12L;

struct Proved {
  Scene scene;
  RotatingProof proof;
};

// Proves a hit between first contact less `gap` and first contact plus `gap`, both in time, or a miss.
[[nodiscard]] std::optional<Proved> prove(Draw& draw, bool miss, double gap) {
  Proved out{draw_scene(draw, miss), {}};
  RotatingProof& proof = out.proof;
  const double end = miss ? 1 : static_cast<double>(out.scene.first - gap);
  proof.chain = prove_chain(out.scene, end, draw);
  if (proof.chain.empty()) return {};
  proof.toi_lower = miss ? kInf : end;
  if (!miss) {
    proof.toi_upper = static_cast<double>(out.scene.first + gap);
    out.scene.write_contact(proof.toi_upper, proof);
  }
  return out;
}

[[nodiscard]] double begin_of(const RotatingProof& proof, std::size_t i) {
  return i == 0 ? 0 : proof.chain[i - 1].end;
}

[[nodiscard]] double log_uniform(Draw& draw, double low, double high) {
  return low * std::pow(high / low, draw.between(0, 1));
}

[[nodiscard]] double microseconds_each(std::clock_t time, long long count) {
  return 1e6 * static_cast<double>(time) / (CLOCKS_PER_SEC * static_cast<double>(count));
}

std::string record(const Proved& proved) {
  corpus::ProofRecord record;
  record.problem = proved.scene.problem;
  record.problem.id = "test/rotating";
  record.rotating = proved.proof;
  return corpus::write_proof(record);
}

TEST_P(RotatingTrial, TrueClaimsAreAcceptedUpToTheSlack) {
  Draw draw(1);
  RotatingCheckCost cost;
  std::clock_t time = 0;
  int hits = 0, misses = 0;
  std::array<int, 3> frames = {};
  while (hits < 1500 || misses < 500) {
    const bool miss = hits >= 1500 || (misses < 500 && draw.below(4) == 0);
    const std::optional<Proved> proved = prove(draw, miss, log_uniform(draw, 1e-9, 1e-3));
    if (!proved) continue;
    const std::clock_t start = std::clock();
    const RotatingVerdict verdict = check(proved->scene.problem, proved->proof, &cost);
    time += std::clock() - start;
    ASSERT_TRUE(verdict.accepted()) << to_string(verdict.refusal) << ": " << verdict.detail << "\n"
                                    << record(*proved);
    ++(miss ? misses : hits);
    for (const TimeSlice& slice : proved->proof.chain) ++frames[static_cast<std::size_t>(slice.frame)];
  }
  for (const int frame : frames) EXPECT_GT(frame, 2000);
  EXPECT_EQ(cost.in_double, GetParam() == Stages::without_doubles ? 0 : cost.slices);
  std::cout << hits << " hits and " << misses << " misses, " << cost.slices << " slices (" << frames[0]
            << " world, " << frames[1] << " a, " << frames[2] << " b) in " << cost.pieces << " pieces, "
            << cost.raised << " raised: " << microseconds_each(time, cost.slices)
            << " microseconds a slice\n";
}

TEST_P(RotatingTrial, LongChainsOfShortSlices) {
  Draw draw(4);
  RotatingCheckCost cost;
  std::clock_t time = 0;
  while (cost.slices < 20000) {
    std::optional<Proved> proved = prove(draw, true, 0);
    if (!proved) continue;
    // Every slice in a hundred, its axis as it is: each part holds where the whole does.
    std::vector<TimeSlice> parts;
    for (std::size_t i = 0; i < proved->proof.chain.size(); ++i) {
      const double begin = begin_of(proved->proof, i), end = proved->proof.chain[i].end;
      for (int k = 1; k <= 100; ++k) {
        parts.push_back(proved->proof.chain[i]);
        parts.back().end = k == 100 ? end : begin + (end - begin) * k / 100;
      }
    }
    proved->proof.chain = std::move(parts);
    const std::clock_t start = std::clock();
    const RotatingVerdict verdict = check(proved->scene.problem, proved->proof, &cost);
    time += std::clock() - start;
    ASSERT_TRUE(verdict.accepted()) << to_string(verdict.refusal) << ": " << verdict.detail;
  }
  std::cout << cost.slices << " slices, " << microseconds_each(time, cost.slices)
            << " microseconds a slice\n";
}

TEST_P(RotatingTrial, ProofsReadBackAsTextAreJudgedAlike) {
  Draw draw(2);
  for (int k = 0; k < 50; ++k) {
    const std::optional<Proved> proved = prove(draw, k % 4 == 0, 1e-4);
    if (!proved) continue;
    const std::string text = record(*proved);
    const corpus::ProofReadResult read = corpus::read_proofs_text(text, "p.jsonl");
    ASSERT_TRUE(read.ok()) << read.errors[0].text();
    EXPECT_EQ(corpus::write_proof(read.proofs[0]), text);
    EXPECT_TRUE(check(read.proofs[0].problem, *read.proofs[0].rotating).accepted());
  }
}

// ---- between the ends of a slice
// ---------------------------------------------------------------------------

// One slice over [0, 1] whose axis separates at both ends and dips at t = 1/2 to `dip` above contact, as
// deep below its chord as the bound allows to within a few percent.
[[nodiscard]] Proved dipping(Draw& draw, AxisFrame frame, double dip) {
  Proved out;
  corpus::Case& c = out.scene.problem;
  const double turn = draw.between(0.1, 1), reach = draw.between(1.5, 3),
               at = turn / 2 - static_cast<double>(kPi);
  // The ball starts at the angle `at` from the z axis and is lowest, below its pivot, at t = 1/2.
  const Vec3<double> arm(0, reach * std::sin(at), reach * std::cos(at));
  const Long length = wide(arm).norm();
  const Sphere<double> ball{draw.between(0.1, 1)};
  TimeSlice slice{1, Vec3<double>(0, 0, 1), frame};
  if (frame == AxisFrame::world) {  // over a plate
    c.a.shape = Box<double>{Vec3<double>(50, 50, 1)};
    c.a.position = Vec3<double>(0, 0, -1);
    c.b.shape = ball;
    c.spin_b = {Vec3<double>(turn, 0, 0), -arm};
    c.b.position = arm + Vec3<double>(0, 0, static_cast<double>(length + ball.radius + dip));
  } else {  // A below B, which stands between it and its pivot, the origin
    c.a.shape = ball;
    c.spin_a = {Vec3<double>(turn, 0, 0), -arm};
    c.a.position = arm;
    const Sphere<double> other{draw.between(0.01, 0.1)};
    c.b.shape = other;
    c.b.position = Vec3<double>(0, 0, -static_cast<double>(length - ball.radius - other.radius - dip));
    slice.axis = -arm;
  }
  if (frame == AxisFrame::b) {
    std::swap(c.a, c.b);
    std::swap(c.spin_a, c.spin_b);
    slice.axis = arm;
  }
  out.proof.toi_lower = kInf;
  out.proof.chain = {slice};
  return out;
}

TEST_P(RotatingTrial, ADipBetweenTheEndsIsFoundHoweverSmall) {
  Draw draw(5);
  int refused = 0;
  for (int k = 0; k < 3000; ++k) {
    const auto frame = static_cast<AxisFrame>(k % 3);
    const double dip = log_uniform(draw, 1e-10, 1e-3);
    const Proved above = dipping(draw, frame, dip);
    const TimeSlice& slice = above.proof.chain[0];
    const Long length = wide(slice.axis).norm();
    ASSERT_NEAR(static_cast<double>(excess(above.scene, slice, 0.5) / (length * dip)), 1, 1e-3);
    const RotatingVerdict verdict = check(above.scene.problem, above.proof);
    EXPECT_TRUE(verdict.accepted()) << verdict.detail;

    const Proved below = dipping(draw, frame, -dip);
    const TimeSlice& last = below.proof.chain[0];
    if (!(excess(below.scene, last, 0) > kSure && excess(below.scene, last, 1) > kSure)) continue;
    ASSERT_LT(excess(below.scene, last, 0.5), -kSure * wide(last.axis).norm());
    const RotatingVerdict other = check(below.scene.problem, below.proof);
    EXPECT_FALSE(other.accepted()) << record(below);
    ++refused;
  }
  EXPECT_GT(refused, 2800);
}

[[nodiscard]] Shape<double> any_shape(Draw& draw) {
  const double r = draw.between(0.1, 1), h = draw.between(0.1, 1);
  switch (draw.below(7)) {
    case 0:
      return Sphere<double>{0};
    case 1:
      return Box<double>{draw.vector(1).cwiseAbs()};
    case 2:
      return Segment<double>{draw.vector(1), draw.vector(1)};
    case 3:
      return Cylinder<double>{r, h};
    case 4:
      return Cone<double>{r, h};
    case 5:
      return Ellipsoid<double>{Vec3<double>(r, r, h)};
    default:
      return Ellipsoid<double>{draw.vector(1).cwiseAbs()};
  }
}
[[nodiscard]] corpus::Spin any_spin(Draw& draw) {
  corpus::Spin spin;
  const double rate = draw.between(0.1, 8);
  switch (draw.below(4)) {
    case 0:
      return {};
    case 1:
      spin.rotation = Vec3<double>(0, 0, rate);  // about the axis of the round shapes
      break;
    case 2:
      spin.rotation = rate * Vec3<double>(1e-3, 0, 1);
      break;
    default:
      spin.rotation = draw.vector(rate);
  }
  if (draw.below(2) == 0) spin.pivot = draw.vector(1);
  return spin;
}

// Any two bodies, any motion, any axis that separates all along: B is then rounded by what brings the least
// separation, as sampled, to a little below 0. No such slice may pass.
TEST_P(RotatingTrial, NoSliceWithAFalseInstantIsAccepted) {
  Draw draw(6);
  std::array<int, 3> refused = {};
  int inner = 0, roomy = 0, accepted = 0;
  while (*std::min_element(refused.begin(), refused.end()) < 1000) {
    Proved p;
    corpus::Case& c = p.scene.problem;
    c.a.shape = any_shape(draw);
    c.b.shape = rounded(any_shape(draw), 0.0);
    c.a.displacement = draw.vector(draw.below(2) == 0 ? 0 : 2);
    c.b.displacement = draw.below(2) == 0 ? c.a.displacement : draw.vector(2);
    c.spin_a = any_spin(draw);
    c.spin_b = draw.below(4) == 0 ? c.spin_a : any_spin(draw);
    const auto which = draw.below(3);
    const TimeSlice slice{1, draw.vector(2), static_cast<AxisFrame>(which)};
    const double length = slice.axis.norm();
    c.b.position = slice.axis / length * draw.between(1, 8) + draw.vector(1);
    Long least = kNever, at = 0;
    for (int k = 0; k <= 200; ++k) {
      const Long s = excess(p.scene, slice, Long(k) / 200);
      if (s < least) {
        least = s;
        at = Long(k) / 200;
      }
    }
    if (!(least > 0.01L * length)) continue;
    p.proof.toi_lower = kInf;
    p.proof.chain = {slice};
    const double beyond = log_uniform(draw, 1e-11, 1e-2);
    const auto round_by = [&](Long r) {
      std::get<Rounded<double>>(c.b.shape).radius = static_cast<double>(r);
    };
    round_by(least / length + beyond);
    ASSERT_LT(excess(p.scene, slice, at), -kSure * length);
    const RotatingVerdict verdict = check(c, p.proof);
    ASSERT_FALSE(verdict.accepted()) << record(p);
    ++refused[which];
    inner += at > 0 && at < 1 ? 1 : 0;
    // The samples see the least to 0.1: no point moves faster along a unit axis than 30 lengths in a time
    // of 1.
    if (!(least / length > 0.1L)) continue;
    round_by(least / length - 0.1L);
    ++roomy;
    accepted += check(c, p.proof).accepted() ? 1 : 0;
  }
  EXPECT_GT(inner, 800);
  EXPECT_GT(roomy, 2000);
  EXPECT_EQ(accepted, roomy);
  std::cout << refused[0] + refused[1] + refused[2] << " refused, " << inner
            << " of them false between the ends; " << accepted << " accepted with room\n";
}

// ---- a little too much ------------------------------------------------------------------------------------

// A change, and what the checker may say to it. Nothing: it does not apply to this proof.
struct Change {
  const char* name;
  bool of_miss;
  std::vector<RotatingRefusal> refusals;
  std::function<bool(Proved&, Draw&)> make;
};

// Is a slice false for sure at some time of [begin, end]?
[[nodiscard]] bool false_within(const Scene& scene, const TimeSlice& slice, double begin, double end) {
  for (int k = 0; k <= 16; ++k)
    if (excess(scene, slice, begin + (Long(end) - begin) * k / 16) < -kSure * wide(slice.axis).norm())
      return true;
  return false;
}

// The last slice reaches past first contact: no axis separates there.
bool stretch(Proved& p, Draw& draw) {
  TimeSlice& last = p.proof.chain.back();
  last.end = static_cast<double>(p.scene.first + log_uniform(draw, 1e-11, 1e-3));
  if (draw.below(2) == 0) p.proof.toi_lower = last.end;
  return true;
}

// The whole of [0, t_max] as a miss, through a contact.
bool stretch_to_the_end(Proved& p, Draw&) {
  p.proof.chain.back().end = 1;
  p.proof.toi_lower = kInf;
  p.proof.toi_upper = kInf;
  return true;
}

// The axis of one slice turned about a drawn direction, by the least angle that makes it false at one of its
// ends, and kSure or a little more beyond.
bool turn_an_axis(Proved& p, Draw& draw) {
  const std::size_t i = draw.below(p.proof.chain.size());
  TimeSlice& slice = p.proof.chain[i];
  const LongVec n = wide(slice.axis), about = n.cross(wide(draw.vector(1))).normalized();
  const Long at = draw.below(2) == 0 ? begin_of(p.proof, i) : slice.end;
  const Long beyond = log_uniform(draw, 2e-12, 1e-3) * n.norm();
  const auto with = [&](Long angle) {
    TimeSlice other = slice;
    other.axis = turned(angle * about, n).cast<double>();
    return other;
  };
  Long low = 0, high = kPi;  // turned round, the axis says the opposite
  if (excess(p.scene, with(high), at) > -beyond) return false;
  for (int k = 0; k < 60; ++k) {
    const Long middle = (low + high) / 2;
    (excess(p.scene, with(middle), at) > -beyond ? low : high) = middle;
  }
  slice = with(high);
  return excess(p.scene, slice, at) < -kSure * n.norm();
}

// toi_lower is one double beyond the chain.
bool beyond_the_chain(Proved& p, Draw& draw) {
  p.proof.toi_lower = std::nextafter(p.proof.chain.back().end, kInf);
  if (draw.below(2) == 0) p.proof.toi_lower += log_uniform(draw, 1e-12, 1e-3);
  return true;
}

// A slice left out: the next begins where the one before it ended, and its axis does not hold there.
bool leave_a_gap(Proved& p, Draw& draw) {
  auto& chain = p.proof.chain;
  std::vector<std::size_t> needed;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    if (false_within(p.scene, chain[i + 1], begin_of(p.proof, i), chain[i].end)) needed.push_back(i);
  if (needed.empty()) return false;
  chain.erase(chain.begin() + static_cast<std::ptrdiff_t>(needed[draw.below(needed.size())]));
  return true;
}

// Contact claimed before there is any.
bool early_contact(Proved& p, Draw& draw) {
  p.proof.toi_upper = static_cast<double>(p.scene.first - log_uniform(draw, 1e-11, 1e-3));
  if (draw.below(2) == 0) p.scene.write_contact(p.proof.toi_upper, p.proof);  // with the pairs of that time
  return true;
}

// Two balls that have parted again.
bool contact_that_ended(Proved& p, Draw& draw) {
  const Long later = p.scene.leaves + log_uniform(draw, 1e-11, 1e-3);
  if (!(later < 1)) return false;
  p.proof.toi_upper = static_cast<double>(later);
  return true;
}

// sum l_i c_i leaves the balls around it, by a weight that is a little too great.
bool shift_a_weight(Proved& p, Draw& draw) {
  RotatingProof& proof = p.proof;
  if (proof.contact_size != 2 && proof.contact_size != 3) return false;
  const Mover a = p.scene.a(), b = p.scene.b();
  const Long reach = a.radius + b.radius + p.scene.problem.target_distance;
  const auto excess_of = [&] {
    LongVec sum = LongVec::Zero();
    Long whole = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(proof.contact_size); ++i) {
      sum += Long(proof.weight[i]) * (a.place(proof.contact[i].a.vertex, proof.toi_upper) -
                                      b.place(proof.contact[i].b.vertex, proof.toi_upper));
      whole += proof.weight[i];
    }
    return sum.norm() / whole - reach;
  };
  double& weight = proof.weight[draw.below(static_cast<std::size_t>(proof.contact_size))];
  const double before = weight;
  const Long beyond = log_uniform(draw, 1e-11, 1e-3);
  double low = before, high = before + 1000;
  const auto fails = [&](double x) {
    weight = x;
    return excess_of() > beyond;
  };
  if (!fails(high)) return false;
  for (int k = 0; k < 200; ++k) (fails(low + (high - low) / 2) ? high : low) = low + (high - low) / 2;
  return fails(high) && excess_of() > kSure;
}

// Another vertex of B, or of A: all pairs lie beyond the axis, so no weights help.
bool other_points(Proved& p, Draw& draw) {
  RotatingProof& proof = p.proof;
  const Mover a = p.scene.a(), b = p.scene.b();
  const bool of_b = b.core.size() > 1 && (a.core.size() == 1 || draw.below(2) == 0);
  const std::size_t count = (of_b ? b : a).core.size();
  if (count == 1) return false;
  const auto vertex = static_cast<std::uint32_t>(draw.below(count));
  const LongVec n = p.scene.axis(p.proof.toi_upper);
  Long nearest = kNever;
  for (std::size_t i = 0; i < static_cast<std::size_t>(proof.contact_size); ++i) {
    SupportPair& pair = proof.contact[i];
    (of_b ? pair.b : pair.a).vertex = vertex;
    nearest = std::min(
        nearest, n.dot(b.place(pair.b.vertex, proof.toi_upper) - a.place(pair.a.vertex, proof.toi_upper)));
  }
  return nearest > a.radius + b.radius + p.scene.problem.target_distance + kSure;
}

// Not a weight at all.
bool spoil_weights(Proved& p, Draw& draw) {
  RotatingProof& proof = p.proof;
  if (proof.contact_size == 4) return false;  // where they are not read
  const std::size_t which = draw.below(static_cast<std::size_t>(proof.contact_size));
  switch (draw.below(4)) {
    case 0:
      proof.weight = {0, 0, 0, 0};
      break;
    case 1:
      proof.weight[which] = -proof.weight[which] - 5e-324;
      break;
    case 2:
      proof.weight[which] = std::numeric_limits<double>::quiet_NaN();
      break;
    default:
      proof.weight[which] = kInf;
  }
  return true;
}

// A miss whose chain ends one double before t_max, or a little more.
bool stop_short(Proved& p, Draw& draw) {
  TimeSlice& last = p.proof.chain.back();
  last.end = std::nextafter(1.0, 0);
  if (draw.below(2) == 0) last.end -= log_uniform(draw, 1e-15, 1e-3);
  return last.end > begin_of(p.proof, p.proof.chain.size() - 1);
}

// The axis of a slice read in another frame, where it does not separate.
bool change_a_frame(Proved& p, Draw& draw) {
  const std::size_t i = draw.below(p.proof.chain.size());
  TimeSlice& slice = p.proof.chain[i];
  slice.frame = static_cast<AxisFrame>((static_cast<std::size_t>(slice.frame) + 1 + draw.below(2)) % 3);
  return false_within(p.scene, slice, begin_of(p.proof, i), slice.end);
}

// A target distance just above the separation that a slice has at its end.
bool ask_for_more_distance(Proved& p, Draw& draw) {
  const TimeSlice& slice = p.proof.chain[draw.below(p.proof.chain.size())];
  const Long more = excess(p.scene, slice, slice.end) / wide(slice.axis).norm();
  p.scene.problem.target_distance += static_cast<double>(more + log_uniform(draw, 1e-11, 1e-3));
  return excess(p.scene, slice, slice.end) < -kSure * wide(slice.axis).norm();
}

// A motion that comes to contact sooner: the rotation a little faster.
bool turn_faster(Proved& p, Draw& draw) {
  const Long slack = p.scene.first - p.proof.toi_lower;
  const Long faster = 1 + 2 * slack / p.scene.first + log_uniform(draw, 1e-10, 1e-3);
  for (corpus::Spin* spin : {&p.scene.problem.spin_a, &p.scene.problem.spin_b})
    spin->rotation *= static_cast<double>(faster);
  p.scene.first /= faster;
  return p.scene.first < p.proof.toi_lower - 1e-12L;
}

TEST_P(RotatingTrial, WhatClaimsALittleTooMuchIsRefused) {
  using enum RotatingRefusal;
  const std::vector<RotatingRefusal> slice = {slice_false, slice_not_proved};
  const Change changes[] = {
      {"a slice stretched past first contact", false, {slice_false}, stretch},
      {"a miss claimed through a contact", false, slice, stretch_to_the_end},
      {"an axis turned", false, {slice_false}, turn_an_axis},
      {"an axis turned, of a miss", true, {slice_false}, turn_an_axis},
      {"toi_lower beyond the chain", false, {chain_too_short}, beyond_the_chain},
      {"a gap between slices", false, {slice_false}, leave_a_gap},
      {"contact before first contact", false, {contact_not_proved}, early_contact},
      {"contact that has ended", false, {contact_not_proved}, contact_that_ended},
      {"a weight shifted", false, {contact_not_proved}, shift_a_weight},
      {"points that do not touch", false, {contact_not_proved, undecided}, other_points},
      {"weights that are none", false, {weights_missing}, spoil_weights},
      {"a miss that stops short", true, {chain_too_short}, stop_short},
      {"another frame", false, {slice_false}, change_a_frame},
      {"another frame, of a miss", true, {slice_false}, change_a_frame},
      {"a greater target distance", false, {slice_false}, ask_for_more_distance},
      {"a faster turn", false, slice, turn_faster},
  };
  Draw draw(3);
  int refused = 0;
  std::map<std::string, std::map<std::string, int>> table;
  for (const Change& change : changes) {
    int made = 0;
    for (int tries = 0; made < 700 && tries < 20000; ++tries) {
      std::optional<Proved> proved = prove(draw, change.of_miss, log_uniform(draw, 1e-6, 1e-2));
      if (!proved || !change.make(*proved, draw)) continue;
      ++made;
      const RotatingVerdict verdict = check(proved->scene.problem, proved->proof);
      ASSERT_FALSE(verdict.accepted()) << change.name << "\n" << record(*proved);
      EXPECT_NE(std::count(change.refusals.begin(), change.refusals.end(), verdict.refusal), 0)
          << change.name << ": " << to_string(verdict.refusal) << ": " << verdict.detail;
      EXPECT_FALSE(verdict.detail.empty());
      EXPECT_EQ(verdict.detail.find('\n'), std::string::npos);
      ++table[change.name][to_string(verdict.refusal)];
      ++refused;
    }
    EXPECT_EQ(made, 700) << change.name;
  }
  EXPECT_GE(refused, 10000);  // the dips aside
  for (const auto& [name, counts] : table) {
    std::cout << name << ":";
    for (const auto& [refusal, count] : counts) std::cout << " " << count << " " << refusal;
    std::cout << "\n";
  }
}

}  // namespace
}  // namespace graze::test
