// Products of Eigen's vectors and matrices with the same bits on every machine.
//
// Eigen adds up a product in an order that depends on the processor, and a compiler may fuse a product with the sum
// that it goes into (machine.hpp). So core forms its products here: each is rounded on its own, and sums go from the
// left, (x_0 y_0 + x_1 y_1) + x_2 y_2. Sums and quotients of single coefficients stay Eigen's, which rounds each once.
//
// The operator * is found before Eigen's in namespace detail, as it takes the type of an expression itself and Eigen's
// takes its base. A test compares the bits of answers (tests/bits).
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <concepts>
#include <graze/detail/numeric/machine.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// An expression of Eigen's with a size that is known to the compiler.
template <class V>
concept FixedExpression = requires(const V* v) {
  []<class Base>(const Eigen::MatrixBase<Base>*) {}(v);
  requires std::floating_point<typename V::Scalar>;
  requires int(V::SizeAtCompileTime) != Eigen::Dynamic;
};
template <class T, class V>
concept FactorOf = std::same_as<T, typename V::Scalar> || std::integral<T>;

template <FixedExpression V, FactorOf<V> T>
[[nodiscard, gnu::always_inline]] inline typename V::PlainObject operator*(T factor, const V& given) {
  using S = typename V::Scalar;
  const S s = static_cast<S>(factor);
  const auto& v = given.eval();
  if constexpr (V::SizeAtCompileTime == 3) {
    return {fl(s * v[0]), fl(s * v[1]), fl(s * v[2])};
  } else {
    typename V::PlainObject out;
    for (Eigen::Index i = 0; i < V::SizeAtCompileTime; ++i) out(i) = fl(s * v(i));
    return out;
  }
}
template <FixedExpression V, FactorOf<V> T>
[[nodiscard, gnu::always_inline]] inline typename V::PlainObject operator*(const V& v, T s) {
  return s * v;
}
template <FixedExpression V, FactorOf<V> T>
[[gnu::always_inline]] inline V& operator*=(V& v, T s) {
  return v = s * v;
}

template <FixedExpression V, FixedExpression W>
[[nodiscard, gnu::always_inline]] inline typename V::Scalar dot(const V& v, const W& w) {
  static_assert(int(V::SizeAtCompileTime) == int(W::SizeAtCompileTime));
  const auto& x = v.eval();
  const auto& y = w.eval();
  typename V::Scalar sum = fl(x[0] * y[0]);
  if constexpr (V::SizeAtCompileTime > 1) sum += fl(x[1] * y[1]);
  if constexpr (V::SizeAtCompileTime > 2) sum += fl(x[2] * y[2]);
  static_assert(V::SizeAtCompileTime <= 3);
  return sum;
}
// The product of two matrices, or of a matrix and a vector.
template <FixedExpression L, FixedExpression R>
requires(int(L::ColsAtCompileTime) == int(R::RowsAtCompileTime)) [[nodiscard, gnu::always_inline]] inline auto
operator*(const L& left, const R& right) {
  Eigen::Matrix<typename L::Scalar, L::RowsAtCompileTime, R::ColsAtCompileTime> out;
  const auto& l = left.eval();
  const auto& r = right.eval();
  for (Eigen::Index j = 0; j < out.cols(); ++j) {
    for (Eigen::Index i = 0; i < out.rows(); ++i) {
      typename L::Scalar sum = fl(l(i, 0) * r(0, j));
      for (Eigen::Index k = 1; k < l.cols(); ++k) sum += fl(l(i, k) * r(k, j));
      out(i, j) = sum;
    }
  }
  return out;
}
template <FixedExpression V, FixedExpression W>
[[nodiscard, gnu::always_inline]] inline typename V::PlainObject cross(const V& v, const W& w) {
  const auto& x = v.eval();
  const auto& y = w.eval();
  return {fl(x[1] * y[2]) - fl(x[2] * y[1]), fl(x[2] * y[0]) - fl(x[0] * y[2]),
          fl(x[0] * y[1]) - fl(x[1] * y[0])};
}
// The product of each coordinate with its own.
template <FixedExpression V, FixedExpression W>
[[nodiscard, gnu::always_inline]] inline typename V::PlainObject scaled_by_axis(const V& v, const W& w) {
  return {fl(v[0] * w[0]), fl(v[1] * w[1]), fl(v[2] * w[2])};
}

template <FixedExpression V>
[[nodiscard, gnu::always_inline]] inline typename V::Scalar squared_norm(const V& v) {
  const auto& x = v.eval();
  return dot(x, x);
}
// For assertions: the squared norm of a rounded unit vector is within this of 1.
inline constexpr double kNearUnit = 1e-3;
template <FixedExpression V>
[[nodiscard, gnu::always_inline]] inline typename V::Scalar norm(const V& v) {
  return square_root(squared_norm(v));
}
// Scaled first, so no square vanishes or overflows.
template <FixedExpression V>
[[nodiscard]] inline typename V::Scalar scaled_norm(const V& v) {
  const typename V::Scalar most = v.cwiseAbs().maxCoeff();
  return most > 0 ? most * norm(v / most) : most;
}
// |x| + |y| + |z|.
template <FixedExpression V>
[[nodiscard, gnu::always_inline]] inline typename V::Scalar norm_1(const V& v) {
  const auto& x = v.eval();
  return std::abs(x[0]) + std::abs(x[1]) + std::abs(x[2]);
}

namespace exact {  // whose own products would hide these
using detail::cross;
using detail::dot;
using detail::norm;
using detail::norm_1;
using detail::squared_norm;
using detail::operator*;
}  // namespace exact

}}}  // namespace graze::GRAZE_LINKAGE::detail
