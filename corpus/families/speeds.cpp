// speeds: a random pair whose motion is slow or fast, over a horizon as long or as short, or without end.
// Hardness: k = |log10 |v| / size|, to about one for a path of some sizes. The speed |v| is 10^k or 10^-k
// times a speed that arrives within a unit of time, and t_max is 10^-k or 10^k, rounded. One case in sixteen
// rests.
//
// Slow ones go down to 10^-50 (every component is 0 or at least 10^-60, where the domain ends), fast ones up
// to 10^30. Beyond 10^30 coordinates are doubles, since a float has no such number. Difficulties: |v| and n.v
// compared with an absolute bound, |v|^2 that vanishes, t times v and v times t_max.
#include <cmath>

#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

constexpr int kLastFast = 30;
// The least value of the domain (validate.hpp), with room for a rounding.
constexpr double kLeast = 1.0001e-60;

void fill_speeds(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const int k = static_cast<int>(hardness);
  if (k > kLastFast && draw.coordinates == Coordinates::floats) draw.coordinates = Coordinates::doubles;
  problem.a.shape = draw.shape(4, random.integer(4, 12));
  problem.b.shape = draw.shape(4, random.integer(4, 12));
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  aim(draw, problem, 4);
  if (random.once_in(6)) problem.t_max = kInfinity<double>;
  vary_time_scale(draw, problem);

  const bool fast = k <= kLastFast && random.once_in(2);
  const double factor = power_of_ten(fast ? k : -k);
  const bool rests = random.once_in(16);
  for (Vec3<double>* velocity : {&problem.a.displacement, &problem.b.displacement}) {
    for (int i = 0; i < 3; ++i) {
      const double x = rests ? 0 : draw.real((*velocity)[i] * factor);
      (*velocity)[i] = std::abs(x) < kLeast ? 0 : x;
    }
  }
  if (problem.t_max < kInfinity<double>) problem.t_max = draw.real(problem.t_max / factor);
  maybe_swap(draw, problem);
}

constexpr double kSpeedsLevels[] = {0, 1, 2, 3, 5, 8, 12, 16, 20, 25, 30, 40, 50};

}  // namespace

const Family family::speeds{
    .name = "speeds",
    .sentence = "Very slow and very fast motion over very long and very short times.",
    .hardness_meaning = "k: |v| is 10^k or 10^-k of what arrives within a unit of time",
    .levels = kSpeedsLevels,
    .fill = fill_speeds,
    .picture = {12, 3},
};

}  // namespace graze::corpus
