// The oracles give the same answer in every floating-point environment of the caller, and restore it.
#include <gtest/gtest.h>

#include "corpus/format/case_io.hpp"
#include "oracles/truth/bracket_truth.hpp"
#include "oracles/truth/closed_form.hpp"
#include "oracles/truth/derive.hpp"
#include "oracles/truth/linear_truth.hpp"
#include "oracles/truth/penetration_truth.hpp"
#include "oracles/truth/rotating_truth.hpp"
#include "tests/oracles/arithmetic/environments.hpp"

namespace graze::oracle {
namespace {

using corpus::Case;
using V = Vec3<double>;

// Two turned boxes that meet at a time and places that no doubles are.
Case falling_box() {
  Case problem;
  problem.id = "test/falling";
  problem.family = "test";
  problem.a.shape = Box<double>{V(1, 2, 3)};
  problem.a.orientation = {1, 2, 3, 4};
  problem.b.shape = Box<double>{V(0.3, 0.5, 0.7)};
  problem.b.orientation = {3, -1, 2, 5};
  problem.b.position = V(9, 1, -2);
  problem.b.displacement = V(-9, -0.5, 1);
  return problem;
}

// In contact from the start: 5e-324 is a time, and after it.
template <class Truth>
void expect_a_time_after_the_start(Case problem) {
  problem.b.position = problem.a.position;
  for (const auto& [name, order, given_back] :
       test::in_every_environment([&] { return Truth(problem).compare(5e-324); })) {
    EXPECT_EQ(order, 1) << name;
    EXPECT_TRUE(given_back) << name;
  }
}

template <class Ask>
void expect_the_same_everywhere(const Ask& ask) {
  const auto found = test::in_every_environment(ask);
  for (const auto& [name, result, given_back] : found) {
    EXPECT_EQ(result, found[0].result) << name;
    EXPECT_TRUE(given_back) << name;
  }
}
void add(std::vector<double>& all, const Enclosure& x) { all.insert(all.end(), {x.low, x.high}); }

template <class Truth>
std::vector<double> times_of(const Truth& truth) {
  std::vector<double> all = {static_cast<double>(truth.outcome()), truth.toi_lower(), truth.toi_upper()};
  for (const Enclosure& x :
       {truth.scale(), truth.clearance(), truth.depth(), truth.distance_at(0.3), truth.depth_before(0.9),
        truth.backward_error(0.6), truth.lateness(0.8), truth.normal_error(V(0.6, 0, 0.8))})
    add(all, x);
  all.push_back(truth.compare(5e-324));
  return all;
}

TEST(Environment, LinearTruth) {
  expect_the_same_everywhere([] { return times_of(LinearTruth(falling_box())); });
  expect_a_time_after_the_start<LinearTruth>(falling_box());
}

TEST(Environment, BracketTruth) {
  Case problem = falling_box();
  problem.b.shape = Cylinder<double>{0.5, 0.7};
  expect_the_same_everywhere([&] { return times_of(BracketTruth(problem)); });
  expect_a_time_after_the_start<BracketTruth>(problem);
}

TEST(Environment, RotatingTruth) {
  Case problem = falling_box();
  problem.spin_b.rotation = V(1, 2, -1);
  expect_the_same_everywhere([&] { return times_of(RotatingTruth(problem)); });
  expect_a_time_after_the_start<RotatingTruth>(problem);
}

TEST(Environment, PenetrationTruth) {
  Case problem = falling_box();
  problem.b.position = V(0.5, 0.25, 1);
  expect_the_same_everywhere([&] {
    const PenetrationTruth truth(problem);
    std::vector<double> all = {truth.nearest_depth()};
    for (const Enclosure& x : {truth.depth(), truth.depth_error(0.3), truth.reach(V(1, 2, 3)),
                               truth.depth_after(V(0.1, 0, 5e-324)), truth.distance_after(V(9, 0, 0))})
      add(all, x);
    return all;
  });
}

TEST(Environment, WhatIsDerivedAndClosedForms) {
  Case problem = falling_box();
  expect_the_same_everywhere([&] {
    problem.expect = derive_expectation(problem);
    return corpus::write_case(problem);
  });
  problem.b.shape = Sphere<double>{0.3};
  expect_the_same_everywhere([&] {
    const auto form = ClosedForm::of(problem);
    return form ? std::pair(form->toi_lower(), form->toi_upper()) : std::pair(-1.0, -1.0);
  });
  EXPECT_TRUE(ClosedForm::of(problem));
}

}  // namespace
}  // namespace graze::oracle
