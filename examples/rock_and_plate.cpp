#include <graze/cast.hpp>
#include <graze/eigen.hpp>
#include <graze/invalid_text.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

int main() {
  std::vector<Eigen::Vector3d> points;  // in any order, those inside too. The hull copies them.
  for (int k = 0; k <= 1000; ++k) {
    const double z = 1 - k / 500.0, r = std::sqrt(1 - z * z), turn = 2.4 * k;
    points.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
  }
  const graze::Hull rock = graze::with_adjacency(points);  // plain: graze::Hull rock(points)

  Eigen::Isometry3d pose(Eigen::Translation3d(0, 0, 5));
  pose.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
  const graze::Body<double> falling = graze::body_at(rock, pose, {0, 0, -10});
  graze::Body<double> plate{.shape = graze::Box<double>{{4, 4, -0.5}}};

  graze::CastResult<double> r = graze::cast(plate, falling);
  if (r.outcome == graze::Outcome::invalid_input) {
    std::printf("refused: %s\n", to_text(r.invalid_at).c_str());
    plate.shape = graze::Box<double>{{4, 4, 0.5}};
    r = graze::cast(plate, falling);
  }
  std::printf("%s at t = %.6f\n", to_text(r.outcome).data(), r.toi_lower);
}
