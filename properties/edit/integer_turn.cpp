#include "properties/edit/integer_turn.hpp"

#include "properties/edit/case.hpp"

namespace graze::law {

using corpus::Case;

namespace {

constexpr std::array<IntegerQuaternion, 24> kPermutations = {{
    {1, 0, 0, 0},  {0, 1, 0, 0},  {0, 0, 1, 0},   {0, 0, 0, 1},   {1, 1, 0, 0},   {1, -1, 0, 0},
    {1, 0, 1, 0},  {1, 0, -1, 0}, {1, 0, 0, 1},   {1, 0, 0, -1},  {0, 1, 1, 0},   {0, 1, -1, 0},
    {0, 1, 0, 1},  {0, 1, 0, -1}, {0, 0, 1, 1},   {0, 0, 1, -1},  {1, 1, 1, 1},   {1, 1, 1, -1},
    {1, 1, -1, 1}, {1, -1, 1, 1}, {1, 1, -1, -1}, {1, -1, 1, -1}, {1, -1, -1, 1}, {1, -1, -1, -1},
}};
constexpr std::array<IntegerQuaternion, 8> kPythagorean = {{
    {2, 1, 0, 0},
    {1, 0, -2, 0},
    {3, 0, 0, 1},
    {1, 2, 2, 0},
    {2, 1, -1, 1},
    {4, 0, 1, 0},
    {1, 2, -3, 4},
    {0, 2, 3, 5},
}};

// The sum of integers times given numbers, if no step of it rounds.
template <std::size_t N>
std::optional<double> combination(const std::array<int, N>& factors, const std::array<double, N>& x) {
  double sum = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const auto term = exact_product(factors[i], x[i]);
    const auto next = term ? exact_sum(sum, *term) : std::nullopt;
    if (!next) return std::nullopt;
    sum = *next;
  }
  return sum;
}

class Turn {
 public:
  explicit Turn(const IntegerQuaternion& p) : p_(p) {
    const auto [w, x, y, z] = p;
    norm_ = w * w + x * x + y * y + z * z;
    rows_ = {{{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
              {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
              {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}}};
  }

  [[nodiscard]] Vec3<double> vector(const Vec3<double>& v) {
    Vec3<double> out;
    for (int i = 0; i < 3; ++i) {
      out[i] = kept(combination(rows_[static_cast<std::size_t>(i)], {v[0], v[1], v[2]}));
    }
    return out;
  }
  // p q.
  [[nodiscard]] Quaternion<double> quaternion(const Quaternion<double>& q) {
    const auto [w, x, y, z] = p_;
    const std::array<double, 4> given = {q.w, q.x, q.y, q.z};
    return {kept(combination<4>({w, -x, -y, -z}, given)), kept(combination<4>({x, w, -z, y}, given)),
            kept(combination<4>({y, z, w, -x}, given)), kept(combination<4>({z, -y, x, w}, given))};
  }
  [[nodiscard]] double length(double x) { return kept(exact_product(norm_, x)); }
  [[nodiscard]] bool exact() const { return exact_; }

 private:
  double kept(const std::optional<double>& x) {
    exact_ = exact_ && x;
    return x.value_or(0);
  }

  IntegerQuaternion p_;
  int norm_ = 1;
  std::array<std::array<int, 3>, 3> rows_ = {};
  bool exact_ = true;
};

bool is_of_vertices(const Shape<double>& shape) {
  return std::holds_alternative<Segment<double>>(shape) || std::holds_alternative<Triangle<double>>(shape) ||
         std::holds_alternative<Hull<double>>(shape);
}

void turn_vertices(Shape<double>& shape, Turn& turn) {
  if (auto* segment = std::get_if<Segment<double>>(&shape)) {
    for (Vec3<double>* x : {&segment->a, &segment->b}) *x = turn.vector(*x);
  } else if (auto* triangle = std::get_if<Triangle<double>>(&shape)) {
    for (Vec3<double>* x : {&triangle->a, &triangle->b, &triangle->c}) *x = turn.vector(*x);
  } else if (const auto* hull = std::get_if<Hull<double>>(&shape)) {
    std::vector<Vec3<double>> vertices(hull->vertices().begin(), hull->vertices().end());
    for (Vec3<double>& x : vertices) x = turn.vector(x);
    shape = hull->has_adjacency() ? with_adjacency<double>(vertices)
                                  : Hull<double>(std::span<const Vec3<double>>(vertices));
  }
}

}  // namespace

IntegerQuaternion axis_permutation(std::uint64_t k) { return kPermutations[k % kPermutations.size()]; }
IntegerQuaternion pythagorean(std::uint64_t k) { return kPythagorean[k % kPythagorean.size()]; }

std::optional<Case> turned_by(const Case& problem, const IntegerQuaternion& p, bool in_place) {
  Turn turn(p);
  Case other = problem;
  other.expect.reset();
  auto longer = [&](Slot slot, double x) { return is_length(slot) ? turn.length(x) : x; };
  for (Body<double>* body : {&other.a, &other.b}) {
    if (in_place && body->orientation.is_identity() && is_of_vertices(body->shape)) {
      turn_vertices(body->shape, turn);
    } else {
      body->shape = map_shape(body->shape, longer);
      body->orientation = turn.quaternion(body->orientation);
    }
    body->position = turn.vector(body->position);
    body->displacement = turn.vector(body->displacement);
  }
  other.target_distance = turn.length(problem.target_distance);
  if (!turn.exact() || !in_domain(other)) return std::nullopt;
  return other;
}

}  // namespace graze::law
