#include <graze/rotating_cast.hpp>

#include <cstdio>

int main() {
  // The bat swings by 2 radians about the end of its handle, while a ball flies in.
  const graze::RotatingBody<double> bat{
      .body = {.shape = graze::Capsule<double>{0.03, 0.4}}, .rotation = {2, 0, 0}, .pivot = {0, 0, -0.4}};
  const graze::RotatingBody<double> ball{
      .body = {.shape = graze::Sphere<double>{0.037}, .position = {0, -2, 0}, .displacement = {0, 3, 0}},
      .rotation = {0, 0, 300}};

  const graze::RotatingResult<double> r = graze::cast(bat, ball, {.tier = graze::Tier::certified});

  if (r.outcome != graze::Outcome::hit) return 1;
  std::printf("%.10f <= t <= %.10f, simulated: %s\n", r.toi_lower, r.toi_upper,
              to_text(r.plan.effects).data());
  return r.plan.has(graze::PlanReason::unseen_spin_b) ? 0 : 1;  // the spin of a ball cannot be seen
}
