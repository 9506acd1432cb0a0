// Represents one body in exact arithmetic: the vertices of a polytope, and the extent of a cylinder, a cone or an
// ellipsoid. Use it to decide contact at t = 0 if doubles cannot.
//
//   a body is its core and a ball:   core = polytope (any combinators), or one curved leaf that posings and
//                                    roundings lead to
//   leaf's own frame                 x = q' (p - p0) q / |q|^2 for each posing on the way: rational, with a weight
// A point is in a leaf by signs of rational numbers (x the own coordinates, w their weight):
//   cylinder    x^2 + y^2 <= r^2 w^2,  z^2 <= h^2 w^2
//   cone        4 h^2 (x^2 + y^2) <= r^2 (h w - z)^2,  z^2 <= h^2 w^2
//   ellipsoid   sum (r_j r_k x_i)^2 <= (r_1 r_2 r_3 w)^2, with x_i = 0 for r_i = 0
// Its extent along n is a rational number plus the root of one:
//   cylinder    h |n_z| + r |n_xy|
//   cone        max(h n_z, -h n_z + r |n_xy|)
//   ellipsoid   |(r_i n_i)|
// Frame: world axes, the caller's lengths.
#pragma once

#include <graze/detail/proving/named_point.hpp>
#include <graze/detail/search/exact/exact_nearest.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The root of x >= 0, rounded up by less than 2^-250 of itself. It is exact if it is a dyadic number of up to 250
// bits. Computed by Newton steps, each a double: a step gains 49 bits, and two of them may be spent on the grid.
inline exact::Dyadic root_up(const exact::Dyadic& x) {
  using exact::Dyadic;
  if (x.sign() <= 0 || !x.valid()) return {};
  // If x is a square, its root is a multiple of 2^grid, and no step leaves that grid before it has to.
  const int grid = x.grid() >> 1, order = x.order() >> 1;
  const auto on_grid = [&](double step, int shift) {
    const int above = shift - grid;
    if (above < 0 || above > 52) return step;
    const double whole = std::ldexp(std::round(std::ldexp(step, above)), -above);
    return whole != 0 ? whole : step;
  };
  const double first = square_root(x.leading() * (x.order() % 2 != 0 ? 2.0 : 1.0));
  Dyadic root = Dyadic(on_grid(first, order)).times_power_of_two(order);
  for (int step = 0; step < 8; ++step) {
    const Dyadic rest = x - root * root;
    if (rest.sign() == 0) return root;
    const int shift = rest.order() - root.order() - 1;
    root = root + Dyadic(on_grid(rest.leading() / root.leading(), shift)).times_power_of_two(shift);
  }
  if ((x - root * root).sign() > 0) root = root + Dyadic(1).times_power_of_two(root.order() - 251);
  return root;
}

// A sum of a rational number and roots of rational ones: its sign. Each root is >= 0.
inline int sign_of_root_sum(const exact::Dyadic& whole, const exact::Dyadic& x, bool& valid) {
  const exact::Dyadic rest = x - whole * whole;
  valid = valid && rest.valid();
  if (whole.sign() >= 0) return whole.sign() > 0 || x.sign() > 0 ? 1 : 0;
  return rest.sign();
}
inline int sign_of_root_sum(const exact::Dyadic& whole, const exact::Dyadic& x, const exact::Dyadic& y,
                            bool& valid) {
  if (x.sign() == 0) return sign_of_root_sum(whole, y, valid);
  if (y.sign() == 0) return sign_of_root_sum(whole, x, valid);
  if (whole.sign() >= 0) return 1;
  // x + y + 2 root(x y) against whole^2
  return sign_of_root_sum(x + y - whole * whole, (x * y).times_power_of_two(2), valid);
}
inline int sign_of_root_sum(const exact::Dyadic& whole, const exact::Dyadic& x, const exact::Dyadic& y,
                            const exact::Dyadic& z, bool& valid) {
  if (x.sign() == 0) return sign_of_root_sum(whole, y, z, valid);
  if (y.sign() == 0) return sign_of_root_sum(whole, x, z, valid);
  if (z.sign() == 0) return sign_of_root_sum(whole, x, y, valid);
  if (whole.sign() >= 0) return 1;
  // root x + root y against |whole| - root z, which is below 0 or may be squared as well
  const exact::Dyadic square = whole * whole;
  valid = valid && square.valid();
  if ((square - z).sign() <= 0) return 1;
  return sign_of_root_sum(x + y - square - z, (x * y).times_power_of_two(2),
                          (square * z).times_power_of_two(2), valid);
}

// How far a core reaches along n: (whole + root(under)) / weight.
struct ExactReach {
  exact::Dyadic whole, under, weight = exact::Dyadic(1);
};

// The cylinder, cone or ellipsoid that a shape is, and how it is posed in the world.
template <Scalar S>
class ExactLeaf {
  using Dyadic3 = exact::Dyadic3;

 public:
  enum class Kind : std::uint8_t { none, cylinder, cone, ellipsoid };

  explicit ExactLeaf(const Body<S>& body) {
    path_.push_back({wide(body.position), as_double(body.orientation)});
    follow(body.shape);
  }
  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] double radius() const { return size_[0]; }
  [[nodiscard]] double half_height() const { return size_[2]; }
  [[nodiscard]] const Vec3<double>& radii() const { return size_; }  // of an ellipsoid
  [[nodiscard]] bool is_full_ellipsoid() const { return kind_ == Kind::ellipsoid && size_.minCoeff() > 0; }

  [[nodiscard]] exact::Exact to_own(exact::Exact x) const {
    for (const auto& [position, q] : path_) {
      x.add(exact::Exact::of(position), true);
      if (!q.is_identity()) exact::ExactTurn{{q.w, -q.x, -q.y, -q.z}}(x);
    }
    return x;
  }
  [[nodiscard]] exact::Exact to_world(exact::Exact x) const {
    for (auto one = path_.rbegin(); one != path_.rend(); ++one) {
      if (!one->q.is_identity()) exact::ExactTurn{one->q}(x);
      x.add(exact::Exact::of(one->position), false);
    }
    return x;
  }
  // A direction in the leaf's own axes, with its weight.
  [[nodiscard]] exact::Exact turn_to_own(const exact::Dyadic3& n) const {
    exact::Exact out;
    out.x = n;
    for (const auto& [position, q] : path_) {
      if (!q.is_identity()) exact::ExactTurn{{q.w, -q.x, -q.y, -q.z}}(out);
    }
    return out;
  }
  [[nodiscard]] exact::Dyadic3 turn_to_world(const exact::Dyadic3& n) const {
    exact::Exact out;
    out.x = n;
    for (auto one = path_.rbegin(); one != path_.rend(); ++one) {
      if (!one->q.is_identity()) exact::ExactTurn{one->q}(out);
    }
    return out.x;
  }
  [[nodiscard]] exact::Dyadic3 axis(int i) const {
    exact::Dyadic3 out;
    out[static_cast<std::size_t>(i)] = exact::Dyadic(1);
    return turn_to_world(out);
  }

  // n: own axes, of any weight.
  [[nodiscard]] ExactReach reach(const exact::Dyadic3& n) const {
    using exact::Dyadic;
    ExactReach out;
    if (kind_ == Kind::ellipsoid) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Dyadic part = Dyadic(size_[static_cast<int>(i)]) * n[i];
        out.under = out.under + part * part;
      }
      return out;
    }
    const Dyadic r(radius()), h(half_height());
    const Dyadic up = h * n[2], across = r * r * (n[0] * n[0] + n[1] * n[1]);
    if (kind_ == Kind::cone && is_apex(n)) {
      out.whole = up;
    } else {
      out.whole = kind_ == Kind::cone || up.sign() < 0 ? -up : up;
      out.under = across;
    }
    return out;
  }
  // For a cone: is its apex the farthest point along n?
  [[nodiscard]] bool is_apex(const exact::Dyadic3& n) const {
    const exact::Dyadic r(radius()), up = exact::Dyadic(2 * half_height()) * n[2];
    return up.sign() >= 0 && (up * up - r * r * (n[0] * n[0] + n[1] * n[1])).sign() >= 0;
  }

  // A point of the leaf near `own`: the nearest one, moved inwards by 2^-250 if it is irrational. For a cylinder or a
  // cone.
  [[nodiscard]] exact::Exact nearest(const exact::Exact& own) const {
    using exact::Dyadic;
    const Dyadic& w = own.weight;
    const Dyadic r(radius()), h(half_height()), top = h * w;
    const Dyadic square = own.x[0] * own.x[0] + own.x[1] * own.x[1];
    const bool over_base = (square - r * r * w * w).sign() <= 0;
    const Dyadic z = (own.x[2] - top).sign() > 0 ? top : (own.x[2] + top).sign() < 0 ? -top : own.x[2];
    if (over_base && (kind_ == Kind::cylinder || (own.x[2] + top).sign() <= 0)) {
      exact::Exact out = own;
      out.x[2] = z;
      return out;
    }
    const bool on_axis = square.sign() == 0;
    const Dyadic across = on_axis ? Dyadic(1) : root_up(square);
    if (kind_ == Kind::cylinder)
      return weighted({r * own.x[0] * w, r * own.x[1] * w, z * across}, across * w);
    // On the line from the apex to the rim, s of the way.
    const Dyadic length = (r * r + (h * h).times_power_of_two(2)) * w;
    if (length.sign() == 0) return weighted({Dyadic(), Dyadic(), h}, Dyadic(1));
    Dyadic s = (h * (top - own.x[2])).times_power_of_two(1);
    if (!on_axis) s = s + across * r;
    if (s.sign() < 0) s = Dyadic();
    if ((s - length).sign() > 0) s = length;
    return weighted({r * s * own.x[0], r * s * own.x[1], h * (length - s.times_power_of_two(1)) * across},
                    length * across);
  }
  // Points of the leaf that are farthest along n, own axes, or nearly so: one point, or the ends of a line if it lies
  // flat. Cylinders and cones: `s` is the fraction of the way from the end at +h to the other. It is ignored for an
  // ellipsoid.
  [[nodiscard]] exact::Exact along(const exact::Dyadic3& n, double s) const {
    using exact::Dyadic;
    if (kind_ == Kind::ellipsoid) {
      const Dyadic length = root_up(reach(n).under);
      if (length.sign() == 0) return {};
      Dyadic3 x;
      for (std::size_t i = 0; i < 3; ++i) {
        const Dyadic r(size_[static_cast<int>(i)]);
        x[i] = r * r * n[i];
      }
      return weighted(x, length);
    }
    const Dyadic r(radius()), h(half_height());
    Dyadic across = root_up(n[0] * n[0] + n[1] * n[1]);
    if (across.sign() == 0) across = Dyadic(1);
    const Dyadic out = kind_ == Kind::cylinder ? r : r * Dyadic(s);
    const Dyadic z = h * (Dyadic(1) - Dyadic(s).times_power_of_two(1));
    return weighted({out * n[0], out * n[1], z * across}, across);
  }

  // The normal at a point of the border at which the leaf has only one, in own axes, of any length.
  [[nodiscard]] Dyadic3 normal_at(const exact::Exact& own) const {
    using exact::Dyadic;
    if (kind_ == Kind::ellipsoid) {
      Dyadic3 out;
      for (std::size_t i = 0; i < 3; ++i) {
        const Dyadic across = Dyadic(size_[int((i + 1) % 3)]) * Dyadic(size_[int((i + 2) % 3)]);
        out[i] = own.x[i] * across * across;
      }
      return out;
    }
    const Dyadic top = Dyadic(half_height()) * own.weight;
    if ((own.x[2] + top).sign() == 0) return {Dyadic(), Dyadic(), Dyadic(-1)};
    if (kind_ == Kind::cylinder) {
      if ((own.x[2] - top).sign() == 0) return {Dyadic(), Dyadic(), Dyadic(1)};
      return {own.x[0], own.x[1], Dyadic()};
    }
    const Dyadic r(radius()), h(2 * half_height());
    return {h * h * own.x[0], h * h * own.x[1], r * r * (top - own.x[2])};
  }

  // -1 inside, 0 on the border, 1 outside. `smooth`: on the border, and the leaf has one normal there.
  [[nodiscard]] int side_of(const exact::Exact& own, bool& smooth, bool& valid) const {
    using exact::Dyadic;
    const Dyadic& w = own.weight;
    smooth = true;
    if (kind_ == Kind::ellipsoid) {
      smooth = is_full_ellipsoid();
      Dyadic sum, all = w;
      for (std::size_t i = 0; i < 3; ++i) {
        Dyadic part = own.x[i];
        if (size_[static_cast<int>(i)] == 0) {
          if (part.sign() != 0) return 1;
          continue;
        }
        for (std::size_t j = 0; j < 3; ++j) {
          if (j != i && size_[static_cast<int>(j)] > 0) part = part * Dyadic(size_[static_cast<int>(j)]);
        }
        all = all * Dyadic(size_[static_cast<int>(i)]);
        sum = sum + part * part;
      }
      const Dyadic rest = sum - all * all;
      valid = valid && rest.valid();
      return smooth ? rest.sign() : std::max(rest.sign(), 0);
    }
    const Dyadic r = Dyadic(radius()) * w, h = Dyadic(half_height()) * w;
    const Dyadic square = own.x[0] * own.x[0] + own.x[1] * own.x[1];
    const int below = (-h - own.x[2]).sign();  // > 0: below the base
    int above = (own.x[2] - h).sign(), across = 0;
    if (kind_ == Kind::cylinder) {
      const Dyadic rest = square - r * r;
      valid = valid && rest.valid();
      across = rest.sign();
    } else {
      const Dyadic from_apex = h - own.x[2], twice = (Dyadic(half_height()) * w).times_power_of_two(1);
      // 4 h^2 square against r^2 (h - z)^2, both times w^2
      const Dyadic left = twice * twice * square, right = Dyadic(radius()) * from_apex;
      const Dyadic rest = left - right * right * w * w;
      valid = valid && rest.valid();
      across = rest.sign();
      // A disc: a point in its plane lies below its apex as well.
      if (half_height() == 0) across = (square - r * r).sign();
    }
    if (below > 0 || above > 0 || across > 0) return 1;
    const int borders = (below == 0) + (kind_ == Kind::cylinder && above == 0) + (across == 0);
    smooth = borders == 1 && !(kind_ == Kind::cone && above == 0) && radius() > 0 && half_height() > 0;
    return borders > 0 || !(radius() > 0) || !(half_height() > 0) ? 0 : -1;
  }

 private:
  static exact::Exact weighted(const Dyadic3& x, const exact::Dyadic& weight) {
    exact::Exact out;
    out.x = x;
    out.weight = weight;
    out.weighted = true;
    return out;
  }
  struct Step {
    Vec3<double> position;
    Quaternion<double> q;
  };
  void follow(const Shape<S>& shape) {
    std::visit(Overloaded{[&](const Cylinder<S>& s) {
                            kind_ = Kind::cylinder;
                            size_ = {double(s.radius), double(s.radius), double(s.half_height)};
                          },
                          [&](const Cone<S>& s) {
                            kind_ = Kind::cone;
                            size_ = {double(s.radius), double(s.radius), double(s.half_height)};
                          },
                          [&](const Ellipsoid<S>& s) {
                            kind_ = Kind::ellipsoid;
                            size_ = wide(s.radii);
                          },
                          [&](const Posed<S>& s) {
                            path_.push_back({wide(s.position), as_double(s.orientation)});
                            follow(s.shape->shape);
                          },
                          [&](const Rounded<S>& s) { follow(s.shape->shape); }, [](const auto&) {}},
               shape);
  }

  Kind kind_ = Kind::none;
  Vec3<double> size_ = Vec3<double>::Zero();
  std::vector<Step> path_;
};

// The radius of the ball in a shape. `valid` becomes false for a hull of parts whose radii differ.
template <Scalar S>
exact::Dyadic exact_ball(const Shape<S>& shape, bool& valid) {
  using exact::Dyadic;
  return std::visit(Overloaded{[](const Sphere<S>& s) { return Dyadic(double(s.radius)); },
                               [](const Capsule<S>& s) { return Dyadic(double(s.radius)); },
                               [&](const Posed<S>& s) { return exact_ball<S>(s.shape->shape, valid); },
                               [&](const Rounded<S>& s) {
                                 return exact_ball<S>(s.shape->shape, valid) + Dyadic(double(s.radius));
                               },
                               [&](const Sum<S>& s) {
                                 Dyadic total;
                                 for (const auto& part : s.shapes)
                                   total = total + exact_ball<S>(part->shape, valid);
                                 return total;
                               },
                               [&](const HullOf<S>& s) {
                                 const Dyadic first = exact_ball<S>(s.shapes.front()->shape, valid);
                                 for (const auto& part : s.shapes) {
                                   valid = valid && (exact_ball<S>(part->shape, valid) - first).sign() == 0;
                                 }
                                 return first;
                               },
                               [](const auto&) { return Dyadic(); }},
                    shape);
}

// The vertices of a polytope, or of a rounded one's core, that are farthest along n, exactly. One of them unless
// `all` is set. n: the shape's own axes, of any length but 0. A step between two vertices of a leaf takes no
// rotation.
template <Scalar S>
std::vector<std::uint32_t> exact_farthest(const Shape<S>& shape, const exact::Dyadic3& n, bool all,
                                          bool& valid) {
  using exact::Dyadic;
  using exact::Exact;
  using List = std::vector<std::uint32_t>;
  // height(k): n.x of the k-th of `count`, minus that of the best so far.
  const auto best_of = [&](const List& candidates, const auto& rise) {
    List out;
    for (const std::uint32_t k : candidates) {
      const int sign = out.empty() ? 1 : rise(out.front(), k);
      if (sign > 0) out = {k};
      if (sign == 0 && all) out.push_back(k);
    }
    return out;
  };
  const auto sign_of = [&](const Dyadic& x) {
    valid = valid && x.valid();
    return x.sign();
  };
  const auto of_points = [&](std::uint32_t count, const auto& point, const List& candidates) {
    List every;
    for (std::uint32_t k = 0; candidates.empty() && k < count; ++k) every.push_back(k);
    return best_of(candidates.empty() ? every : candidates, [&](std::uint32_t from, std::uint32_t to) {
      return sign_of(exact::dot(n, Exact::of(point(to), point(from)).x));
    });
  };
  return std::visit(
      Overloaded{[&](const Posed<S>& s) {
                   const Quaternion<double> q = as_double(s.orientation);
                   Exact own;
                   own.x = n;
                   if (!q.is_identity()) exact::ExactTurn{{q.w, -q.x, -q.y, -q.z}}(own);
                   return exact_farthest<S>(s.shape->shape, own.x, all, valid);
                 },
                 [&](const Rounded<S>& s) { return exact_farthest<S>(s.shape->shape, n, all, valid); },
                 [&](const Sum<S>& s) {
                   List out = {0};
                   for (const auto& part : s.shapes) {
                     const auto count = static_cast<std::uint32_t>(vertex_count<S>(part->shape));
                     const List own = exact_farthest<S>(part->shape, n, all, valid);
                     List more;
                     for (const std::uint32_t before : out) {
                       for (const std::uint32_t k : own) more.push_back(before * count + k);
                     }
                     out = std::move(more);
                   }
                   return out;
                 },
                 [&](const HullOf<S>& s) {
                   List candidates;
                   std::uint32_t before = 0;
                   for (const auto& part : s.shapes) {
                     for (const std::uint32_t k : exact_farthest<S>(part->shape, n, all, valid))
                       candidates.push_back(before + k);
                     before += static_cast<std::uint32_t>(vertex_count<S>(part->shape));
                   }
                   return best_of(candidates, [&](std::uint32_t from, std::uint32_t to) {
                     const Vec3<double>* no_curve = nullptr;
                     Exact step = exact_point<S>(shape, to, no_curve);
                     step.add(exact_point<S>(shape, from, no_curve), true);
                     return sign_of(exact::dot(n, step.x));
                   });
                 },
                 [&](const Box<S>& s) {
                   List out = {0};
                   for (std::size_t i = 0; i < 3; ++i) {
                     const int sign = s.half_extents[static_cast<int>(i)] > 0 ? sign_of(n[i]) : 0;
                     const std::uint32_t bit = 1u << i;
                     const std::size_t size = out.size();
                     for (std::size_t j = 0; j < size; ++j) {
                       if (sign == 0 && all) out.push_back(out[j] | bit);
                       if (sign > 0) out[j] |= bit;
                     }
                   }
                   return out;
                 },
                 [&](const Hull<S>& s) {
                   // Doubles leave those whose heights about the centre may tie: the direction is within 2^-51 per
                   // coordinate of at most 2, and three products and sums round.
                   const Vec3<double> d = direction_of(n), center = wide(s.center());
                   const auto count = static_cast<std::uint32_t>(s.size());
                   std::vector<double> height(count);
                   double most = -kInfinity<double>;
                   for (std::uint32_t k = 0; k < count; ++k) {
                     height[k] = dot(d, wide(s.vertex(k)) - center);
                     most = std::max(most, height[k]);
                   }
                   const double slack = 0x1p-45 * s.reach_about_center();
                   List near;
                   for (std::uint32_t k = 0; k < count; ++k) {
                     if (height[k] >= most - slack) near.push_back(k);
                   }
                   return of_points(
                       count, [&](std::uint32_t k) { return wide(s.vertex(k)); }, near);
                 },
                 [&](const auto&) {
                   Body<S> leaf;
                   leaf.shape = shape;
                   return of_points(static_cast<std::uint32_t>(vertex_count(shape)),
                                    [&](std::uint32_t k) { return exact::given_vertex(leaf, k); }, {});
                 }},
      shape);
}
// The farthest vertices of a body along n in world axes.
template <Scalar S>
std::vector<std::uint32_t> exact_farthest(const Body<S>& body, const exact::Dyadic3& n, bool all,
                                          bool& valid) {
  const Quaternion<double> q = as_double(body.orientation);
  exact::Exact own;
  own.x = n;
  if (!q.is_identity()) exact::ExactTurn{{q.w, -q.x, -q.y, -q.z}}(own);
  return exact_farthest<S>(body.shape, own.x, all, valid);
}

template <Scalar S>
class ExactBody {
 public:
  ExactBody(const Body<S>& body, const Side<double>& side, double rounding)
      : body_(body), side_(side), rounding_(rounding), leaf_(body) {
    valid_ = true;
    ball_ = exact_ball<S>(body.shape, valid_);
    is_polytope_ = valid_ && !is_curved(body.shape);
    const std::uint64_t count = vertex_count(body.shape);
    valid_ = valid_ && (is_polytope_ ? count <= kMostVertices : leaf_.kind() != ExactLeaf<S>::Kind::none);
    count_ = static_cast<std::uint32_t>(count);
  }
  // False: nothing is known of it.
  [[nodiscard]] bool valid() const { return valid_; }
  [[nodiscard]] bool is_polytope() const { return is_polytope_; }
  [[nodiscard]] const ExactLeaf<S>& leaf() const { return leaf_; }
  [[nodiscard]] const exact::Dyadic& ball() const { return ball_; }

  [[nodiscard]] exact::Exact vertex(std::uint32_t k) const {
    Feature feature;
    feature.vertex = k;
    return exact_point<S>(body_, feature);
  }
  // Rounded: in world axes about the side's centre, internal length.
  [[nodiscard]] Vec3<double> rounded_vertex(std::uint32_t k) const {
    return side_.to_world(side_.support(side_, Vec3<double>(Vec3<double>::UnitX()), &k).x);
  }
  // The vertices that reach farthest along n, up to `slack` of internal length.
  [[nodiscard]] std::vector<std::uint32_t> farthest(const Vec3<double>& n, double slack) const {
    const Vec3<double> own = side_.to_own(unit(n));
    std::vector<double> height(count_);
    double most = -kInfinity<double>;
    for (std::uint32_t k = 0; k < count_; ++k) {
      height[k] = dot(own, side_.support(side_, own, &k).x);
      most = std::max(most, height[k]);
    }
    std::vector<std::uint32_t> out;
    for (std::uint32_t k = 0; k < count_; ++k) {
      if (height[k] >= most - slack) out.push_back(k);
    }
    return out;
  }
  // A vertex that reaches farthest along n, exactly.
  [[nodiscard]] std::uint32_t farthest(const exact::Dyadic3& n, bool& valid) const {
    return exact_farthest(body_, n, false, valid).front();
  }
  // The extent of the core along n in world axes.
  [[nodiscard]] ExactReach reach(const exact::Dyadic3& n, bool& valid) const {
    if (is_polytope_) {
      const exact::Exact x = vertex(farthest(n, valid));
      return {exact::dot(n, x.x), {}, x.weight};
    }
    const exact::Exact center = leaf_.to_world({}), own = leaf_.turn_to_own(n);
    ExactReach out = leaf_.reach(own.x);
    out.whole = out.whole * center.weight + exact::dot(n, center.x) * own.weight;
    out.under = out.under * center.weight * center.weight;
    out.weight = center.weight * own.weight;
    return out;
  }

 private:
  // More are left to the search: a vertex in exact arithmetic takes a microsecond.
  static constexpr std::uint64_t kMostVertices = 4096;

  const Body<S>& body_;
  const Side<double>& side_;
  double rounding_;  // two heights of vertices along a unit vector are off by less, internal length
  ExactLeaf<S> leaf_;
  exact::Dyadic ball_;
  std::uint32_t count_ = 0;
  bool valid_ = true, is_polytope_ = false;
};

// The sign of h(n) + R |n|: h over the difference of the cores, R the balls and the target distance. n: from A to B.
template <Scalar S>
int sign_of_reach(const ExactBody<S>& a, const ExactBody<S>& b, const exact::Dyadic3& n,
                  const exact::Dyadic& radius, bool& valid) {
  const ExactReach x = a.reach(n, valid), y = b.reach(minus(n), valid);
  const exact::Dyadic whole = x.whole * y.weight + y.whole * x.weight, ball = radius * x.weight * y.weight;
  return sign_of_root_sum(whole, x.under * y.weight * y.weight, y.under * x.weight * x.weight,
                          ball * ball * exact::dot(n, n), valid);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
