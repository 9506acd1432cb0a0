// The judge of the rotating casts convicts made-up answers whose fault is known, and acquits our own.
#include "properties/judge/judge.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "tests/shared/rotating_cases.hpp"

namespace graze::law {
namespace {

using corpus::Case;
using engine::Answer;
using test::dipping_bar;
using test::turning_bar;
using test::turning_bar_above;

using engine::kPlain;

const engine::Method& method(const char* name) { return *engine::find_method(engine::Kind::rotating, name); }

Judgement judged(const Case& problem, const char* name, const Answer& answer, Request request = kPlain) {
  Truth truth(problem);
  return judge(truth, method(name), answer, request, true);
}

// The judge accepts the method's own answer, and finds the named fault in it after the change.
void falls(const Case& problem, const char* name, std::string Judgement::*fault,
           const std::function<void(Answer&)>& change, Request request = kPlain) {
  Answer answer = method(name).ask(problem, {.request = request});
  const Judgement before = judged(problem, name, answer, request);
  EXPECT_FALSE(before.faulty()) << name << ": " << before.fault();
  EXPECT_FALSE(before.stalled || before.within_tolerance || before.hidden);
  change(answer);
  EXPECT_NE(judged(problem, name, answer, request).*fault, "") << name;
}

// An offset in time. The lower edge falls at about 1.4 per unit of t, and the scale is 5.7.
constexpr double kOff = 1e-9;

void become_miss(Answer& a) {
  a.outcome = Outcome::miss;
  a.toi_lower = a.toi_upper = kInfinity<double>;
}

TEST(RotatingJudge, ConvictsATimeThatIsOffByALittle) {
  for (const char* name : {"ca", "bilateral", "plan"}) {
    falls(turning_bar(), name, &Judgement::late, [](Answer& a) { a.toi_upper = a.toi_lower += kOff; });
    falls(turning_bar(), name, &Judgement::early, [](Answer& a) { a.toi_lower = a.toi_upper -= kOff; });
    falls(turning_bar(), name, &Judgement::off, [](Answer& a) { a.toi_lower -= kOff; });
    falls(turning_bar(), name, &Judgement::off, [](Answer& a) { a.toi_upper += kOff; });
    falls(turning_bar(), name, &Judgement::off, [](Answer& a) {
      a.toi_lower -= 4e-12;  // within the row, but nearer than it says
      a.distance = 0;
    });
  }
}

TEST(RotatingJudge, ConvictsAWrongVerdict) {
  falls(turning_bar(), "bilateral", &Judgement::wrong, become_miss);
  falls(dipping_bar(), "bilateral", &Judgement::wrong, become_miss);
  falls(turning_bar_above(), "bilateral", &Judgement::wrong, [](Answer& a) {
    a.outcome = Outcome::hit;
    a.toi_lower = a.toi_upper = 0.75;
  });
  falls(turning_bar(), "bilateral", &Judgement::early, [](Answer& a) {
    a.outcome = Outcome::initially_overlapping;
    a.toi_lower = a.toi_upper = 0;
  });
  falls(turning_bar(), "bilateral", &Judgement::wrong, [](Answer& a) { a.outcome = Outcome::invalid_input; });
  falls(turning_bar(), "bilateral", &Judgement::wrong,
        [](Answer& a) { std::swap(a.toi_lower, a.toi_upper = 2); });
  falls(turning_bar(), "bilateral", &Judgement::wrong, [](Answer& a) { a.toi_lower = std::nan(""); });
}

TEST(RotatingJudge, ConvictsAStallWhoseBracketIsFalseAndOnlyCountsAnother) {
  Answer stall = method("ca").ask(turning_bar(), {});
  stall.outcome = Outcome::not_converged;
  stall.toi_lower = 0.25;
  stall.toi_upper = kInfinity<double>;
  stall.distance = 0.2;
  EXPECT_TRUE(judged(turning_bar(), "ca", stall).stalled);
  EXPECT_FALSE(judged(turning_bar(), "ca", stall).faulty());
  stall.toi_lower = 0.5;
  EXPECT_NE(judged(turning_bar(), "ca", stall).late, "");
  stall.toi_lower = 0.125;
  stall.toi_upper = 0.25;
  EXPECT_NE(judged(turning_bar(), "ca", stall).early, "");
}

TEST(RotatingJudge, WhatHasNotConvergedIsOverNoLimit) {
  Answer answer = method("ca").ask(turning_bar(), {});
  answer.toi_lower -= kOff;
  EXPECT_GT(judged(turning_bar(), "ca", answer).errors.over_limit, 1);
  answer.outcome = Outcome::not_converged;
  const Judgement open = judged(turning_bar(), "ca", answer);
  EXPECT_TRUE(open.by_oracle);
  EXPECT_TRUE(std::isnan(open.errors.over_limit));
}

TEST(RotatingJudge, ConvictsNormalsAndWitnesses) {
  falls(turning_bar(), "bilateral", &Judgement::bad_contact, [](Answer& a) { a.normal *= -1; });
  falls(turning_bar(), "bilateral", &Judgement::bad_contact, [](Answer& a) { a.normal *= 1 + 1e-12; });
  falls(turning_bar(), "bilateral", &Judgement::bad_contact, [](Answer& a) {
    a.normal = Vec3<double>(1e-9, -1, 0).normalized();  // the corners of the floor are 2 to the side
  });
  falls(turning_bar(), "bilateral", &Judgement::bad_contact, [](Answer& a) { a.point_b.y() += kOff; });
  falls(turning_bar(), "bilateral", &Judgement::bad_contact, [](Answer& a) { a.point_a.z() = std::nan(""); });
}

TEST(RotatingJudge, HoldsEachRowToWhatItPromisesAboutTheUnseen) {
  Answer miss = method("steps").ask(dipping_bar(), {.time_steps = 1});
  ASSERT_EQ(miss.outcome, Outcome::miss);
  const Judgement hidden = judged(dipping_bar(), "steps", miss);
  EXPECT_TRUE(hidden.hidden);
  EXPECT_FALSE(hidden.faulty()) << hidden.fault();
  EXPECT_NEAR(hidden.errors.passed * 5.744562646538029, 0.03,
              0.01);  // the dip, over the diagonal of the floor
  miss.hidden_motion = 0.01;
  EXPECT_NE(judged(dipping_bar(), "steps", miss).wrong, "");
  EXPECT_FALSE(judged(dipping_bar(), "bilateral_published", miss).faulty());
}

TEST(RotatingJudge, OfTierCertifiedConvictsByAnythingAtAll) {
  const auto ends = [](double lower, double upper) {
    return [=](Answer& a) {
      a.toi_lower = lower;
      a.toi_upper = upper;
    };
  };
  const oracle::RotatingTruth truth(turning_bar());
  ASSERT_EQ(truth.outcome(), Outcome::hit);
  const double before = std::nextafter(truth.toi_lower(), 0.0),
               after = std::nextafter(truth.toi_upper(), 1.0);
  for (const Request request : {kPlain, Request::everything}) {
    falls(turning_bar(), "certified", &Judgement::late, ends(after, after), request);
    falls(turning_bar(), "certified", &Judgement::early, ends(before, before), request);
    falls(turning_bar(), "certified", &Judgement::off, ends(before - 1e-8, after), request);
    falls(turning_bar(), "certified", &Judgement::off, ends(before, after + 1e-8), request);
    falls(turning_bar(), "certified", &Judgement::wrong, become_miss, request);
    falls(
        turning_bar_above(), "certified", &Judgement::undecided,
        [](Answer& a) {
          a.outcome = Outcome::not_converged;
          a.toi_lower = 0;
        },
        request);
  }
}

TEST(RotatingJudge, OfTierCertifiedWantsAProofThatIsTrueAndSaysAsMuchAsTheAnswer) {
  const auto change = [](std::string Judgement::*fault, const std::function<void(Answer&)>& by) {
    falls(turning_bar(), "certified", fault, by, Request::everything);
  };
  change(&Judgement::unproved, [](Answer& a) { a.rotating_proof.reset(); });
  change(&Judgement::unproved, [](Answer& a) { a.rotating_proof->toi_lower = a.toi_lower / 2; });
  change(&Judgement::unproved, [](Answer& a) { a.rotating_proof->toi_upper = kInfinity<double>; });
  change(&Judgement::false_proof, [](Answer& a) { a.rotating_proof->toi_lower = a.toi_upper + 1e-6; });
  change(&Judgement::false_proof, [](Answer& a) {
    a.rotating_proof->toi_lower = a.toi_upper + 1e-6;
    a.rotating_proof->chain.back().end = a.toi_upper + 1e-6;
  });
  change(&Judgement::false_proof, [](Answer& a) { a.rotating_proof->toi_upper = a.toi_lower / 2; });
}

TEST(RotatingJudge, AHorizonWithoutEndIsNoQuestionForTheOracle) {
  Case problem = turning_bar();
  problem.t_max = kInfinity<double>;
  const Judgement refused = judged(problem, "bilateral", method("bilateral").ask(problem, {}));
  EXPECT_TRUE(refused.skipped);
  EXPECT_FALSE(refused.faulty());
  problem.spin_a.pivot.x() = std::nan("");
  Answer answer = method("bilateral").ask(turning_bar(), {});
  EXPECT_NE(judged(problem, "bilateral", answer).wrong, "");
}

}  // namespace
}  // namespace graze::law
