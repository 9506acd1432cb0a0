// Finds the vertices of a hull that can be the farthest along a direction, as a short list for every cell of
// directions.
//
//   R = diag(largest |p_i| of a vertex p),   q = R^-1 p,   d' = R d, so that d'.q = d.p
//   cell: d' / |d'_i| for the largest component i, on one of the six faces of a cube, in one of k x k squares
//
// Vertex v is not in a cell's list if some vertex x is higher along each of the square's four corners c,
//   c.(q_x - q_v) > margin.
// A direction of the cell is, except for its length, a mean of the corners, so x is higher along it by as much. An x
// that is not in the list itself is lower than another in its turn. An x that is in it is higher than v.
//
// So the first of its list with the greatest rounded height is the first of all the hull's, to the bit, in spite of
// the omitted vertices. Let u be that of float, and B = 3 >= sum |c_i q_i|. All of it scales with d. A height
// computed in floats from floats is within 3 u B. Coordinates in double or about another middle differ by u B
// (hull.hpp), and a direction rounded to floats by u B. This is 5 u B for each of two vertices, and margin = 13 u B.
//
// The cell of a direction is computed in floats. d rounds, R d does, and so does the quotient, whose divisor is
// within 2^-11 of 1 / d'_i and made less by 2^-11. Then 1 is added. A coordinate on the cube is therefore within
// 2^-10 - 2^-14 of its own. So squares are larger by kEdge = 2^-10 on every side than those that are looked up. 2^-14
// is left for callers that know their direction only to this precision.
//
// The map is made by halving squares. The list of each square is made from that of the square that it is a quarter
// of. This continues while more than one list in 16 does not fit a slot, and all of them are below kEntries a vertex.
// A list that does not fit costs one more cache miss, and its length is not predicted. For rings and clusters of
// points some lists stay long. The x that are tried are the greatest along nine directions of the square.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <graze/detail/numeric/machine.hpp>
#include <graze/scalar.hpp>
#include <vector>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

class DirectionMap {
 public:
  // Lists are in whole blocks, padded with copies of their first entry, which win no tie against it. Short lists all
  // have one length, which leaves the machine no branch to predict.
  static constexpr std::size_t kBlock = 8, kSlot = 16;

  // Vertices in the order of the hull. Coordinates as the hull's guess scan has them, by axis, each `size` long.
  struct List {
    const float* xyz;
    const std::uint32_t* vertex;
    std::size_t size;
  };

  static constexpr float kLeastReach = 0x1p-60F;

  DirectionMap() = default;
  // `x`, `y`, `z`: the guess scan of n points, finite, their largest magnitude along each axis at
  // least kLeastReach.
  DirectionMap(const float* x, const float* y, const float* z, std::size_t n);

  // Nothing is known: lists would be longer than half the hull, on average.
  [[nodiscard]] bool empty() const { return k_ == 0; }
  // The reach of the guess scan: the largest magnitude of a coordinate along each axis.
  [[nodiscard]] const std::array<float, 3>& reach() const { return scale_; }
  // Along d. False where nothing is known: the largest component is not between 2^-80 and 2^80 when multiplied with the
  // reach.
  [[nodiscard, gnu::always_inline]] bool find(float x, float y, float z, List& out) const;

  [[nodiscard]] std::uint32_t squares_along_edge() const { return k_; }
  [[nodiscard]] std::size_t bytes() const {
    return slots_.size() * sizeof(Slot) + points_.size() * sizeof(float) +
           vertices_.size() * sizeof(std::uint32_t);
  }

 private:
  static constexpr double kEdge = 0x1p-10;
  static constexpr float kInner = 1 - 0x1p-11F;
  static constexpr double kMargin = 13 * kUnitRoundoff<float>;  // over B
  // Squares along an edge, and entries of all lists over vertices.
  static constexpr std::size_t kMost = 16, kEntries = 16;

  // A short list. If the last vertex is kLong, the position of a long one, in entries: vertex[0] to vertex[1].
  struct alignas(64) Slot {
    std::array<float, 3 * kSlot> xyz;
    std::array<std::uint32_t, kSlot> vertex;
  };
  static constexpr std::uint32_t kLong = 0xffffffff;

  // 1 / x, within 2^-11 of it.
  [[nodiscard]] static float reciprocal(float x) {
#if defined(__SSE2__)
    return _mm_cvtss_f32(_mm_rcp_ss(_mm_set_ss(x)));
#else
    return 1 / x;
#endif
  }

  struct Square {
    std::size_t axis, side;  // of the cube: +-axis
    double u, v, width;      // its least corner, along axis + 1 and axis + 2
  };
  using Candidates = std::vector<std::uint32_t>;

  [[nodiscard]] static Square square_of(std::size_t cell, std::size_t k) {
    const std::size_t face = cell / (k * k), row = cell / k % k, column = cell % k;
    const double width = 2 / static_cast<double>(k);
    return {face / 2, face % 2, -1 + fl(width * static_cast<double>(row)),
            -1 + fl(width * static_cast<double>(column)), width};
  }
  [[nodiscard]] static std::size_t padded(std::size_t size) {
    return size <= kSlot ? kSlot : (size + kBlock - 1) / kBlock * kBlock;
  }
  [[nodiscard]] static bool often_long(const std::vector<Candidates>& lists) {
    return 16 * std::count_if(lists.begin(), lists.end(),
                              [](const Candidates& l) { return l.size() > kSlot; }) >
           std::ssize(lists);
  }
  [[nodiscard]] static std::size_t entries_of(const std::vector<Candidates>& lists) {
    std::size_t out = 0;
    for (const Candidates& list : lists) out += padded(list.size());
    return out;
  }
  // The lists of squares half as wide.
  [[nodiscard]] static std::vector<Candidates> divided(const std::vector<Vec3<double>>& q, std::size_t k,
                                                       const std::vector<Candidates>& lists);
  [[nodiscard]] static Candidates of_square(const std::vector<Vec3<double>>& q, const Square& square,
                                            const Candidates& from);

  std::array<float, 3> scale_ = {1, 1, 1};  // D^-1: half extents
  std::uint32_t k_ = 0;
  float half_ = 0, inner_ = 0;  // k/2, and less than that by kInner
  std::vector<Slot> slots_;     // of every cell
  std::vector<float> points_;   // of long lists: all x, all y, all z
  std::vector<std::uint32_t> vertices_;
};

inline bool DirectionMap::find(float x, float y, float z, List& out) const {
  const float d[5] = {x * scale_[0], y * scale_[1], z * scale_[2], x * scale_[0], y * scale_[1]};
  const float a = std::abs(d[0]), b = std::abs(d[1]), c = std::abs(d[2]);
  const float ab = std::max(a, b), most = std::max(ab, c), all = a + b + c;
  if (!(all >= 0x1p-80F && all <= 0x1p80F)) [[unlikely]]
    return false;
  // By signs, not by branches: directions come in any order.
  const unsigned last = static_cast<unsigned>(c > ab), second = static_cast<unsigned>(b > a) & ~last,
                 axis = second + 2 * last;
  const float scaled = inner_ * reciprocal(most);
  const auto at = [&](float t) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(fl(t * scaled) + half_));
  };
  const std::uint32_t face = 2 * axis + (detail::bit_cast<std::uint32_t>(d[axis]) >> 31);
  const Slot& slot = slots_[(face * k_ + at(d[axis + 1])) * k_ + at(d[axis + 2])];
  if (slot.vertex[kSlot - 1] != kLong) [[likely]] {
    out = {slot.xyz.data(), slot.vertex.data(), kSlot};
  } else {
    const std::size_t begin = slot.vertex[0], end = slot.vertex[1];
    out = {points_.data() + 3 * begin, vertices_.data() + begin, end - begin};
  }
  return true;
}

inline DirectionMap::DirectionMap(const float* x, const float* y, const float* z, std::size_t n) {
  GRAZE_ASSERT(n > 0);
  std::vector<Vec3<double>> q;
  Vec3<double> most = Vec3<double>::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    q.emplace_back(x[i], y[i], z[i]);
    most = most.cwiseMax(q.back().cwiseAbs());
  }
  GRAZE_ASSERT(most.minCoeff() >= double(kLeastReach));
  for (int i = 0; i < 3; ++i) scale_[static_cast<std::size_t>(i)] = static_cast<float>(most[i]);
  for (Vec3<double>& one : q) one = one.cwiseQuotient(most);

  Candidates all(n);
  for (std::uint32_t i = 0; i < n; ++i) all[i] = i;
  std::size_t k = 1;
  std::vector<Candidates> lists;
  for (std::size_t face = 0; face < 6; ++face) lists.push_back(of_square(q, square_of(face, 1), all));
  while (k < kMost && often_long(lists)) {
    std::vector<Candidates> finer = divided(q, k, lists);
    if (entries_of(finer) > kEntries * n) break;
    k *= 2;
    lists = std::move(finer);
  }
  if (2 * entries_of(lists) > n * lists.size()) return;
  k_ = static_cast<std::uint32_t>(k);
  half_ = 0.5F * static_cast<float>(k_);
  inner_ = half_ * kInner;
  for (const Candidates& list : lists) {
    const std::size_t size = padded(list.size());
    const auto entry = [&](std::size_t i) { return list[i < list.size() ? i : 0]; };
    Slot& slot = slots_.emplace_back();
    float* xyz = slot.xyz.data();
    std::uint32_t* vertex = slot.vertex.data();
    if (size > kSlot) {
      const std::size_t begin = vertices_.size();
      slot = {};
      slot.vertex[0] = static_cast<std::uint32_t>(begin);
      slot.vertex[1] = static_cast<std::uint32_t>(begin + size);
      slot.vertex[kSlot - 1] = kLong;
      points_.resize(3 * (begin + size));
      vertices_.resize(begin + size);
      xyz = points_.data() + 3 * begin;
      vertex = vertices_.data() + begin;
    }
    for (std::size_t i = 0; i < size; ++i) {
      xyz[i] = x[entry(i)];
      xyz[size + i] = y[entry(i)];
      xyz[2 * size + i] = z[entry(i)];
      vertex[i] = entry(i);
    }
  }
}

inline std::vector<DirectionMap::Candidates> DirectionMap::divided(const std::vector<Vec3<double>>& q,
                                                                   std::size_t k,
                                                                   const std::vector<Candidates>& lists) {
  const std::size_t finer = 2 * k;
  std::vector<Candidates> out;
  for (std::size_t cell = 0; cell < 6 * finer * finer; ++cell) {
    const std::size_t face = cell / (finer * finer), row = cell / finer % finer, column = cell % finer;
    out.push_back(of_square(q, square_of(cell, finer), lists[(face * k + row / 2) * k + column / 2]));
  }
  return out;
}

inline DirectionMap::Candidates DirectionMap::of_square(const std::vector<Vec3<double>>& all,
                                                        const Square& square, const Candidates& from) {
  constexpr std::size_t kCorners = 4;
  using Heights = std::array<double, kCorners>;
  const auto i = static_cast<int>(square.axis), j = (i + 1) % 3, l = (i + 2) % 3;
  const double sign = square.side == 0 ? 1 : -1;
  const double u[2] = {square.u - kEdge, square.u + square.width + kEdge};
  const double v[2] = {square.v - kEdge, square.v + square.width + kEdge};
  std::vector<Heights> height;
  for (const std::uint32_t one : from) {
    const Vec3<double>& q = all[one];
    const double base = sign * q[i];
    height.push_back({base + fl(u[0] * q[j]) + fl(v[0] * q[l]), base + fl(u[0] * q[j]) + fl(v[1] * q[l]),
                      base + fl(u[1] * q[j]) + fl(v[0] * q[l]), base + fl(u[1] * q[j]) + fl(v[1] * q[l])});
  }
  // The corners, the middles of the edges, and the middle.
  constexpr std::size_t kTried = 9;
  constexpr std::array<Heights, kTried> kWeights = {{{1, 0, 0, 0},
                                                     {0, 1, 0, 0},
                                                     {0, 0, 1, 0},
                                                     {0, 0, 0, 1},
                                                     {1, 1, 0, 0},
                                                     {0, 0, 1, 1},
                                                     {1, 0, 1, 0},
                                                     {0, 1, 0, 1},
                                                     {1, 1, 1, 1}}};
  std::array<std::size_t, kTried> greatest{};
  for (std::size_t t = 0; t < kTried; ++t) {
    double top = -kInfinity<double>;
    for (std::size_t m = 0; m < height.size(); ++m) {
      double h = 0;
      for (std::size_t c = 0; c < kCorners; ++c) h += fl(kWeights[t][c] * height[m][c]);
      if (!(h > top)) continue;
      top = h;
      greatest[t] = m;
    }
  }
  // B = 3, and 1 + kEdge of it, twice.
  constexpr double kBelow = 3 * kMargin * (1 + 4 * kEdge);
  Candidates out;
  for (std::size_t m = 0; m < height.size(); ++m) {
    const bool lower = std::any_of(greatest.begin(), greatest.end(), [&](std::size_t x) {
      for (std::size_t c = 0; c < kCorners; ++c) {
        if (!(height[x][c] - height[m][c] > kBelow)) return false;
      }
      return true;
    });
    if (!lower) out.push_back(from[m]);
  }
  return out;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
