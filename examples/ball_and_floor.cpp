#include <graze/cast.hpp>

#include <cstdio>

int main() {
  const graze::Body<double> floor{.shape = graze::Box<double>{{500, 500, 500}}, .position = {0, -500, 0}};
  const graze::Body<double> ball{
      .shape = graze::Sphere<double>{0.5166}, .position = {3, 10, -7}, .displacement = {0, -20, 0}};

  const graze::CastResult<double> r = graze::cast(floor, ball, {.request = graze::Request::everything});

  if (r.outcome != graze::Outcome::hit) return 1;
  std::printf("touch at t = %.17g, normal (%g, %g, %g)\n", r.toi_lower, r.normal[0], r.normal[1],
              r.normal[2]);
  std::printf("proved: %.17g <= TOI <= %.17g\n", r.proof->toi_lower, r.proof->toi_upper);
}
