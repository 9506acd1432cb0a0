// Vectors of three doubles for the fast and exact searches, and their products.
//
// Each product is rounded on its own (machine.hpp), so that no compiler fuses it with a sum.
#pragma once

#include <graze/detail/numeric/machine.hpp>
#include <graze/scalar.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Three doubles, as scalars: packets of two and one cost more than they save.
struct Triple {
  double x, y, z;  // not set unless given

  [[nodiscard]] double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  [[nodiscard]] Vec3<double> vector() const { return {x, y, z}; }
  friend Triple operator-(const Triple& a, const Triple& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Triple operator+(const Triple& a, const Triple& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Triple operator-(const Triple& a) { return {-a.x, -a.y, -a.z}; }
  friend Triple operator*(double s, const Triple& a) { return {fl(s * a.x), fl(s * a.y), fl(s * a.z)}; }
};
template <Scalar S>
Triple triple(const Vec3<S>& v) {
  return {double(v[0]), double(v[1]), double(v[2])};
}
inline double dot(const Triple& a, const Triple& b) { return fl(a.x * b.x) + fl(a.y * b.y) + fl(a.z * b.z); }
inline Triple cross(const Triple& a, const Triple& b) {
  return {fl(a.y * b.z) - fl(a.z * b.y), fl(a.z * b.x) - fl(a.x * b.z), fl(a.x * b.y) - fl(a.y * b.x)};
}
inline Triple scaled_by_axis(const Triple& a, const Triple& b) {
  return {fl(a.x * b.x), fl(a.y * b.y), fl(a.z * b.z)};
}
inline Triple magnitude(const Triple& a) { return {std::abs(a.x), std::abs(a.y), std::abs(a.z)}; }
inline double sum(const Triple& a) { return a.x + a.y + a.z; }
// As std::min and std::max, by value: compilers make branches of those, which nothing foretells.
inline double lesser(double a, double b) { return b < a ? b : a; }
inline double greater(double a, double b) { return a < b ? b : a; }
inline double largest(const Triple& a) {
  return greater(greater(std::abs(a.x), std::abs(a.y)), std::abs(a.z));
}
// The axis along which a triple of magnitudes is largest.
inline int largest_axis(const Triple& size) {
  const int second = int(!(size.x > size.y)), third = int(!(greater(size.x, size.y) > size.z));
  return third << 1 | (second & ~third);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
