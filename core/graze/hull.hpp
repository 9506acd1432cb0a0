/// @file
/// The convex hull of finitely many points, and hulls with adjacency, which are searched faster.
//
// A hull also keeps its vertices coordinate by coordinate, prepared for the support scan:
//   scan_i = (vertex_i - center) 2^-exponent.
// center_i is 0 unless the vertices' offset along axis i exceeds their extent (|middle| > 2.5 half). Then
// every difference is exact (Sterbenz 1974: b/2 <= a <= 2b makes a - b exact), so a large common offset costs
// no accuracy. The power of two brings the largest coordinate near 1, so no product in a scan overflows or
// underflows.
#pragma once

#include <graze/scalar.hpp>
#include <memory>
#include <span>
#include <vector>

namespace graze { inline namespace GRAZE_LINKAGE {

namespace detail {
template <Scalar S>
struct HullGraph;  // detail/shapes/hull_graph.hpp
}

/// The type of the points in a list of points.
///
/// @code
/// static_assert(std::same_as<graze::PointOf<std::vector<Eigen::Vector3f>>, Eigen::Vector3f>);
/// @endcode
template <class Points>
using PointOf = typename decltype(std::span(std::declval<const Points&>()))::value_type;
/// Points one after the other in memory: a vector, an array or a span of `Vec3<float>` or `Vec3<double>`, which are
/// `Eigen::Vector3f` and `Eigen::Vector3d`.
///
/// @code
/// static_assert(graze::PointList<std::vector<Eigen::Vector3f>> && graze::PointList<std::array<Eigen::Vector3d, 4>>);
/// static_assert(!graze::PointList<std::vector<double>>);  // numbers, not points
/// @endcode
template <class Points>
concept PointList = std::same_as<PointOf<Points>, Vec3<float>> || std::same_as<PointOf<Points>, Vec3<double>>;

/// The convex hull of finitely many points, in any order. Use it for meshes: a hull is a Shape.
///
/// Duplicates and interior points are allowed, and nothing is ever simplified. A hull copies its points. Copies of a
/// hull share them and never change them. A hull without points, or with a NaN or an infinite number, is
/// `invalid_input` in every query.
///
/// Coordinates are in the body's own frame and the caller's length unit. A support query scans all n vertices, 8 at a
/// time, unless the hull has adjacency (with_adjacency()).
///
/// @code
/// const std::vector<Eigen::Vector3d> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
/// const graze::Hull hull(points);  // its scalar is that of the points
/// assert(hull.size() == 4 && hull.finite() && !hull.has_adjacency());
/// assert(hull.vertices()[1] == points[1] && hull.largest() == 1);
/// @endcode
template <Scalar S>
class Hull {
 public:
  /// @cond
  // Scans run over whole blocks. The padding repeats vertex 0, which can win no tie against it.
  static constexpr std::size_t kBlock = 8;
  /// @endcond

  Hull() = default;  ///< A hull without vertices, which every query refuses.

  /// The hull of these points, which are copied: O(n) time and memory.
  explicit Hull(std::span<const Vec3<S>> vertices);
  /// The same from a list in braces.
  Hull(std::initializer_list<Vec3<S>> vertices)
      : Hull(std::span<const Vec3<S>>(vertices.begin(), vertices.size())) {}

  /// The number of vertices, duplicates and interior points included.
  [[nodiscard]] std::size_t size() const { return data_ ? data_->vertices.size() : 0; }
  /// The vertex with this index, i < size().
  [[nodiscard]] const Vec3<S>& vertex(std::size_t i) const { return data_->vertices[i]; }
  /// A view of all vertices, valid while a copy of the hull lives. A temporary hull has none.
  [[nodiscard]] std::span<const Vec3<S>> vertices() const& {
    return data_ ? std::span<const Vec3<S>>(data_->vertices) : std::span<const Vec3<S>>();
  }
  std::span<const Vec3<S>> vertices() const&& = delete;

  /// True if the boundary was derived by with_adjacency(), or verified by with_faces().
  [[nodiscard]] bool has_adjacency() const { return graph_ != nullptr; }
  /// @cond
  [[nodiscard]] const detail::HullGraph<S>& graph() const { return *graph_; }
  // Is there such a map? Known without reading the graph, which may be in no cache.
  [[nodiscard]] bool has_map() const { return has_map_; }
  // `graph` must be this hull's.
  [[nodiscard]] Hull with_graph(std::shared_ptr<const detail::HullGraph<S>> graph, bool has_map) const {
    Hull out = *this;
    out.graph_ = std::move(graph);
    out.has_map_ = has_map;
    return out;
  }

  // The prepared scan. Valid for a non-empty hull of finite vertices.
  [[nodiscard]] const S* scan(int axis) const {
    return data_->scan.data() + static_cast<std::size_t>(axis) * data_->padded;
  }
  // The same about the middle of the bounds, rounded once: for choosing among vertices, not for their
  // coordinates. Products then lose u of the extent, not of the offset.
  [[nodiscard]] const S* choice_scan(int axis) const {
    const std::vector<S>& from = data_->choice.empty() ? data_->scan : data_->choice;
    return from.data() + static_cast<std::size_t>(axis) * data_->padded;
  }
  // The same in float, for a first guess.
  [[nodiscard]] const float* approximate_scan(int axis) const {
    if constexpr (std::same_as<S, float>) {
      return choice_scan(axis);
    } else {
      return data_->guess.data() + static_cast<std::size_t>(axis) * data_->padded;
    }
  }
  [[nodiscard]] std::size_t padded_size() const { return data_->padded; }
  [[nodiscard]] const Vec3<S>& center() const { return data_->center; }
  [[nodiscard]] int exponent() const { return data_->exponent; }
  // Half extents of the bounding box, and its centre, in the units and frame of the scan.
  [[nodiscard]] const Vec3<S>& scan_half_extents() const { return data_->half; }
  [[nodiscard]] const Vec3<S>& scan_middle() const { return data_->middle; }
  // The same box by its corners, which are the scan's own numbers: half extents and middle are rounded in S.
  [[nodiscard]] const Vec3<S>& scan_low() const { return data_->scan_low; }
  [[nodiscard]] const Vec3<S>& scan_high() const { return data_->scan_high; }
  // The mean of the six vertices that are least and greatest along the axes, about `center`, in the caller's unit: a
  // point of the hull, within 8 u of double of the largest.
  [[nodiscard]] const Vec3<double>& inside() const { return data_->inside; }
  // The bounding box, in the caller's unit: the largest magnitude of a coordinate about `center`, and a bound of |x|.
  [[nodiscard]] double size_about_center() const { return data_->size; }
  [[nodiscard]] double reach_about_center() const { return data_->reach; }
  /// @endcond
  /// False if the hull is empty, or a coordinate is NaN or infinite.
  [[nodiscard]] bool finite() const { return data_ && data_->finite; }
  /// The largest magnitude of a coordinate, a length. The hull is not empty.
  [[nodiscard]] S largest() const { return data_->largest; }
  /// The least magnitude of a coordinate that is not 0, a length, or 0. The hull is not empty.
  [[nodiscard]] S smallest_nonzero() const { return data_->smallest; }
  /// True if the machine takes a coordinate for 0 that is not 0 (denormals-are-zero). The hull is not empty.
  [[nodiscard]] bool flushed() const { return data_->flushed; }

 private:
  struct Data {
    explicit Data(std::span<const Vec3<S>> given);

    // The data that every query reads first, side by side.
    std::vector<Vec3<S>> vertices;
    std::vector<float> guess;  // of a double hull
    std::size_t padded = 0;
    bool finite = true, flushed = false;
    S largest = 0, smallest = 0;
    double size = 0, reach = 0;
    Vec3<S> center = Vec3<S>::Zero();
    Vec3<double> inside = Vec3<double>::Zero();
    std::vector<S> scan;    // x..., y..., z..., each `padded` long
    std::vector<S> choice;  // choice_scan, where it differs
    Vec3<S> half = Vec3<S>::Zero(), middle = Vec3<S>::Zero();
    Vec3<S> scan_low = Vec3<S>::Zero(), scan_high = Vec3<S>::Zero();
    int exponent = 0;
  };
  std::shared_ptr<const Data> data_;
  std::shared_ptr<const detail::HullGraph<S>> graph_;
  bool has_map_ = false;
};

/// The scalar of a hull is that of its points.
template <PointList Points>
Hull(const Points&) -> Hull<typename PointOf<Points>::Scalar>;

/// A hull with adjacency, for hulls that are cast often. Answers are the same, to the bit.
///
/// From 192 vertices on, the hull gets a map from each direction to the few vertices that can be the farthest along
/// it. A support query then takes sublinear time (measured in costs.md). Smaller hulls are unaffected.
///
/// It takes about O(n log n) time to build, and 60 to 400 bytes a vertex. No adjacency is made for vertices that lie
/// in a plane, are not finite, or have a non-zero coordinate below 2^-280 of the largest. Then has_adjacency() is
/// false, and the hull works without it.
///
/// @code
/// std::vector<graze::Vec3<double>> points;
/// for (int k = 0; k < 1000; ++k) points.push_back({std::cos(0.1 * k), std::sin(0.1 * k), std::cos(0.37 * k)});
/// const graze::Hull hull = graze::with_adjacency(points);
/// assert(hull.size() == 1000 && hull.has_adjacency());
/// @endcode
template <Scalar S>
Hull<S> with_adjacency(std::span<const Vec3<S>> vertices);
/// The same from any list of points.
template <PointList Points>
auto with_adjacency(const Points& vertices) {
  using S = typename PointOf<Points>::Scalar;
  return with_adjacency<S>(std::span<const Vec3<S>>(vertices));
}

/// A hull with adjacency from faces that are known, which is cheaper than to derive it.
///
/// A face is a list of three or more vertex indices, anticlockwise as seen from outside. The faces are a hint: they
/// are verified, and ignored unless they are exactly the boundary of the hull of the vertices (has_adjacency()).
///
/// @code
/// const std::vector<graze::Vec3<double>> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
/// const std::vector<std::vector<std::uint32_t>> faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
/// assert(graze::with_faces(corners, faces).has_adjacency());
/// assert(!graze::with_faces(corners, std::vector<std::vector<std::uint32_t>>{{0, 1, 2}}).has_adjacency());
/// @endcode
template <Scalar S>
Hull<S> with_faces(std::span<const Vec3<S>> vertices, std::span<const std::vector<std::uint32_t>> faces);
/// The same from any list of points.
template <PointList Points>
auto with_faces(const Points& vertices, std::span<const std::vector<std::uint32_t>> faces) {
  using S = typename PointOf<Points>::Scalar;
  return with_faces<S>(std::span<const Vec3<S>>(vertices), faces);
}

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/shapes/hull_data.hpp>
#include <graze/detail/shapes/hull_graph.hpp>
#endif
