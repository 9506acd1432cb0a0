#include "properties/draw_meeting.hpp"

#include <cmath>

#include "corpus/families/draw.hpp"

namespace graze::law {

Vec3<double> carried(const Body<double>& body, const corpus::Spin& spin, const Quaternion<double>& turn,
                     double t, const Vec3<double>& x) {
  const Vec3<double> pivot = corpus::rotate(body.orientation, spin.pivot);
  const Vec3<double> arm = corpus::rotate(body.orientation, x) - pivot;
  return corpus::rotate(turn, arm) + pivot + t * body.displacement;
}

double draw_beside(corpus::Random& random) {
  const double beside = std::scalbn(1.0, random.once_in(2) ? -8 : -24);
  return random.once_in(2) ? beside : -beside;
}

}  // namespace graze::law
