// Is a hull, or its support, built wrongly?
//
//   1. Decode. The points are the vertices of A, of B, or of both. If there are fewer than four, they are all numbers
//      of the case in threes.
//   2. Choose float or double by the choice. The points are brought into the range that the building guarantees.
//   3. CGAL's hull of the same points judges adjacency, vertices, supports and hints (hull_law.hpp).
#include "fuzz/hull_law.hpp"
#include "fuzz/target.hpp"
#include "properties/edit/case.hpp"

namespace graze::fuzz {

namespace {

using Points = std::vector<Vec3<double>>;

void add_threes(const std::vector<double>& numbers, Points& points) {
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
}

void add_vertices(const Shape<double>& shape, Points& points) {
  constexpr std::size_t kMost = 128;
  if (const auto exact = law::exact_vertices(shape, kMost)) {
    points.insert(points.end(), exact->begin(), exact->end());
    return;
  }
  std::vector<double> numbers;
  const auto collect = [&](law::Slot slot, double x) {
    if (slot == law::Slot::vertex) numbers.push_back(x);
    return x;
  };
  (void)law::map_shape(shape, collect);
  add_threes(numbers, points);
}

template <Scalar S>
Judged judge_points(const Input& input, const Points& points) {
  const std::vector<Vec3<S>> question = as_hull_question<S>(points);
  corpus::Random random(input.choice);
  Judged judged;
  judged.reached = judged.by_oracle = !question.empty();
  if (!judged.reached) return judged;
  std::string fault = hull_fault<S>(question, random);
  if (!fault.empty()) {
    judged.finding = {"hull_is_built_right",
                      sizeof(S) == sizeof(double) ? "double" : "float",
                      std::move(fault),
                      input.problem,
                      {}};
  }
  return judged;
}

Judged judge_building(const Input& input) {
  Points points;
  const std::uint64_t which = input.choice % 4;
  if (which != 1) add_vertices(input.problem.a.shape, points);
  if (which != 0) add_vertices(input.problem.b.shape, points);
  if (points.size() < 4) add_threes(law::scalars(input.problem), points);
  return input.choice / 4 % 4 == 0 ? judge_points<float>(input, points) : judge_points<double>(input, points);
}

}  // namespace

const Target kTarget = {.name = "hull_building", .judge = &judge_building};

}  // namespace graze::fuzz
