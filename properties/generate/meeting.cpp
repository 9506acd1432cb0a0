#include "properties/generate/meeting.hpp"

#include <cmath>

#include "corpus/families/draw.hpp"
#include "corpus/support_value.hpp"
#include "properties/edit/case.hpp"

namespace graze::law {

Vec3<double> carried(const Body<double>& body, const corpus::Spin& spin, const Quaternion<double>& turn,
                     double t, const Vec3<double>& x) {
  const Vec3<double> pivot = corpus::rotate(body.orientation, spin.pivot);
  const Vec3<double> arm = corpus::rotate(body.orientation, x) - pivot;
  return corpus::rotate(turn, arm) + pivot + t * body.displacement;
}

Vec3<double> draw_vector(corpus::Random& random, double size) {
  Vec3<double> v;
  for (int i = 0; i < 3; ++i) v[i] = random.uniform(-size, size);
  return v;
}

Quaternion<double> draw_orientation(corpus::Random& random) {
  Quaternion<double> q;
  const bool plain = random.once_in(3);
  for (double* x : {&q.w, &q.x, &q.y, &q.z}) *x = plain ? random.integer(1, 4) : random.uniform(-1, 1);
  return q;
}

Vec3<double> draw_feature(corpus::Random& random, const Shape<double>& shape) {
  constexpr std::size_t kMost = 64;
  if (const auto vertices = exact_vertices(shape, kMost); vertices && !vertices->empty()) {
    return (*vertices)[random.below(vertices->size())];
  }
  const corpus::Bounds box = corpus::bounds(shape);
  Vec3<double> x = (box.low + box.high) / 2;
  const int i = random.integer(0, 2);
  x[i] = random.once_in(2) ? box.low[i] : box.high[i];
  return x;
}

double draw_beside(corpus::Random& random) {
  const double beside = std::scalbn(1.0, random.once_in(2) ? -8 : -24);
  return random.once_in(2) ? beside : -beside;
}

}  // namespace graze::law
