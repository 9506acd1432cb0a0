// A robot's link swings up past a shelf. At which angle must the joint stop, if it must?
//
// The certified tier proves its bracket for the true shapes and the true rotation, so a planner may stop at `toi_lower`,
// and needs no margin for the method. A miss has a proof too.
#include <graze/rotating_cast.hpp>

#include <cmath>
#include <cstdio>

int main() {
  constexpr double kLength = 0.8, kRadius = 0.04;  // of the link, metres
  constexpr double kMargin = 0.005;                // what the planner keeps clear
  constexpr double kUnderside = 0.45;              // height of the shelf above the joint
  constexpr double kSwing = 1.2;                   // radians

  // The link lies along x from its joint, the origin. In its own frame it lies along z about its middle.
  const graze::RotatingBody<double> link{.body = {.shape = graze::Capsule<double>{kRadius, kLength / 2},
                                                  .position = {kLength / 2, 0, 0},
                                                  .orientation = {1, 0, 1, 0}},  // z to x: 90 degrees about y
                                         .rotation = {0, -kSwing, 0},
                                         .pivot = {0, 0, -kLength / 2}};

  // The link reaches the shelf's edge if the edge is no farther from the joint than this.
  const double reach = std::sqrt(std::pow(kLength + kRadius + kMargin, 2) - std::pow(kUnderside, 2));
  for (const double edge : {0.6, reach - 1e-6, reach + 1e-6}) {
    const graze::RotatingBody<double> shelf{.body = {.shape = graze::Box<double>{{0.15, 0.5, 0.01}},
                                                     .position = {edge + 0.15, 0, kUnderside + 0.01}}};
    const auto proved = graze::cast(
        link, shelf,
        {.tier = graze::Tier::certified, .request = graze::Request::everything, .target_distance = kMargin});
    const auto sampled = graze::cast(
        link, shelf,
        {.method = graze::RotatingMethod::time_steps, .target_distance = kMargin, .time_steps = 16});

    std::printf("edge at %.6f m: ", edge);
    if (proved.outcome == graze::Outcome::hit) {
      std::printf("stop at %.9f rad (within %.0e)\n", proved.toi_lower * kSwing,
                  (proved.toi_upper - proved.toi_lower) * kSwing);
    } else {
      std::printf("%s, proved by %zu axes\n", to_text(proved.outcome).data(),
                  proved.proof ? proved.proof->chain.size() : 0);
    }
    std::printf("  16 poses say %s, and cannot see a motion of %.3f m\n", to_text(sampled.outcome).data(),
                sampled.hidden_motion);
  }
}
