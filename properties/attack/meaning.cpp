#include "properties/attack/meaning.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "properties/edit/case.hpp"

namespace graze::attack {
namespace {

using corpus::Case;
using corpus::Spin;

// Axes of a body that rotates about them stay where they are.
bool along(const Vec3<double>& n, const Vec3<double>& w) {
  const Vec3<double> u = n / n.cwiseAbs().maxCoeff(), v = w / w.cwiseAbs().maxCoeff();
  return u.cross(v).cwiseAbs().maxCoeff() <= kSameDirection;
}

struct Direction {
  Vec3<double> n;

  // Zero and non-finite vectors stay as they are.
  explicit Direction(const Vec3<double>& given) : n(given) {
    const double most = given.cwiseAbs().maxCoeff();
    if (most > 0 && std::isfinite(most)) n = given / most;
  }
  [[nodiscard]] bool same_as(const Direction& other) const {
    return (n - other.n).cwiseAbs().maxCoeff() <= kSameDirection;
  }
};

class Writer {
 public:
  explicit Writer(Meaning& out) : out_(out) {}

  void exact(double x) { out_.parts.push_back({x, false}); }
  void rounded(double x) { out_.parts.push_back({x, true}); }
  void point(const Vec3<double>& x) {
    for (int i = 0; i < 3; ++i) exact(x[i]);
  }
  void direction(const Direction& of) {
    for (int i = 0; i < 3; ++i) rounded(of.n[i]);
  }
  void feature(const Feature& of) {
    exact(of.vertex);
    point(of.offset);
    for (const Vec3<double>& x : of.curved) point(x);
  }
  void pair(const SupportPair& of) {
    feature(of.a);
    feature(of.b);
  }

 private:
  Meaning& out_;
};

void write_case(Writer& out, Case problem) {
  for (const bool first : {true, false}) {
    Spin& spin = first ? problem.spin_a : problem.spin_b;
    if (spin.rotation.isZero(0)) spin.pivot.setZero();
    Quaternion<double>& q = (first ? problem.a : problem.b).orientation;
    double most = 0;
    for (const double x : {q.w, q.x, q.y, q.z}) most = std::max(most, std::abs(x));
    if (most > 0 && std::isfinite(most)) {
      double least = std::ldexp(1.0, -std::ilogb(most));
      for (const double x : {q.z, q.y, q.x, q.w})
        if (x != 0) least = std::copysign(least, x);
      for (double* x : {&q.w, &q.x, &q.y, &q.z}) *x *= least;
    }
    for (const std::uint32_t part : law::outline((first ? problem.a : problem.b).shape)) out.exact(part);
  }
  law::visit_scalars(problem, [&](law::Slot, double x) { out.exact(x); });
  out.exact(static_cast<double>(problem.start_policy));
}

// A slice holds the direction in world axes of t = 0. Two slices are one if these are the same.
void write_chain(Writer& out, const Case& problem, const RotatingProof& proof) {
  struct Normal {
    double end;
    Direction axis;
    AxisFrame frame;
  };
  std::vector<Normal> normal;
  double begin = 0;
  for (const TimeSlice& slice : proof.chain) {
    if (slice.end == begin && !normal.empty()) continue;
    begin = slice.end;
    AxisFrame frame = slice.frame;
    if (frame != AxisFrame::world && !slice.axis.isZero(0)) {
      const Vec3<double>& w = (frame == AxisFrame::a ? problem.spin_a : problem.spin_b).rotation;
      if (w.isZero(0) || along(slice.axis, w)) frame = AxisFrame::world;
    }
    const Direction axis(slice.axis);
    if (!normal.empty() && normal.back().frame == frame && normal.back().axis.same_as(axis)) {
      normal.back().end = slice.end;
    } else {
      normal.push_back({slice.end, axis, frame});
    }
  }
  out.exact(static_cast<double>(normal.size()));
  for (const Normal& slice : normal) {
    out.exact(slice.end);
    out.direction(slice.axis);
    out.exact(static_cast<double>(slice.frame));
  }
}

struct Weighted {
  SupportPair pair;
  double weight = 0;
  Meaning written;
};

bool comes_before(const Meaning& l, const Meaning& r) {
  return std::lexicographical_compare(l.parts.begin(), l.parts.end(), r.parts.begin(), r.parts.end(),
                                      [](const auto& x, const auto& y) { return x.x < y.x; });
}

void write_pairs(Writer& out, std::vector<Weighted> pairs) {
  for (Weighted& one : pairs) Writer(one.written).pair(one.pair);
  std::sort(pairs.begin(), pairs.end(),
            [](const Weighted& l, const Weighted& r) { return comes_before(l.written, r.written); });
  out.exact(static_cast<double>(pairs.size()));
  for (const Weighted& one : pairs) {
    out.pair(one.pair);
    out.rounded(one.weight);
  }
}

void write_contact(Writer& out, const RotatingProof& proof) {
  const auto size =
      static_cast<std::size_t>(std::clamp(proof.contact_size, 0, static_cast<int>(kContactPairs)));
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i) sum += proof.weight[i];
  // With more than four, `pairs` may hold the origin by themselves, and `mean` hold it by their mean.
  std::vector<Weighted> pairs, mean;
  for (std::size_t i = 0; i < size; ++i) {
    // Three of a crossing and those that may hold the origin inside count without a weight.
    const double weight = proof.crossing ? 0 : proof.weight[i] / sum;
    if (size >= 4 || proof.crossing || weight != 0)
      (size > 4 && i >= 3 ? mean : pairs).push_back({proof.contact[i], weight, {}});
  }
  out.exact(proof.crossing ? proof.contact_from : -1);
  write_pairs(out, std::move(pairs));
  write_pairs(out, std::move(mean));
}

void write_factors(Writer& out, const Proof& proof) {
  struct Factor {
    Meaning written;
    double sign = 1;
  };
  const auto factor_of = [](const AxisFactor& of) {
    Factor factor;
    Writer writer(factor.written);
    writer.exact(static_cast<double>(of.kind));
    if (of.kind == AxisFactor::Kind::given) writer.direction(Direction(of.given));
    if (of.kind == AxisFactor::Kind::difference) {
      Meaning from, to;
      Writer(from).pair(of.from);
      Writer(to).pair(of.to);
      if (comes_before(to, from)) {
        std::swap(from, to);
        factor.sign = -1;
      }
      for (const Meaning* one : {&from, &to})
        factor.written.parts.insert(factor.written.parts.end(), one->parts.begin(), one->parts.end());
    }
    return factor;
  };
  Factor first = factor_of(proof.factor[0]), second = factor_of(proof.factor[1]);
  double sign = proof.axis_sign * first.sign * second.sign;
  if (comes_before(second.written, first.written)) {
    std::swap(first, second);
    sign = -sign;
  }
  out.exact(sign);
  for (const Factor* one : {&first, &second})
    for (const Meaning::Part& part : one->written.parts)
      part.rounded ? out.rounded(part.x) : out.exact(part.x);
}

// The foot is on the plane, line or point through all pairs, whichever is first.
void write_nearest(Writer& out, const Proof& proof) {
  const NearestAxis& nearest = proof.nearest;
  out.exact(nearest.motion ? 0 : nearest.time);
  out.exact(nearest.motion);
  std::vector<Weighted> pairs;
  for (int i = 0; i < std::clamp(nearest.size, 0, 3); ++i)
    pairs.push_back({nearest.pair[static_cast<std::size_t>(i)], 0, {}});
  write_pairs(out, std::move(pairs));
  out.exact(proof.then);
  if (!proof.then) return;
  const AxisFactor& factor = proof.factor[0];
  out.exact(static_cast<double>(factor.kind));
  if (factor.kind == AxisFactor::Kind::given) out.direction(Direction(factor.given));
  if (factor.kind != AxisFactor::Kind::difference) return;
  out.pair(factor.from);
  out.pair(factor.to);
}

void write_linear(Writer& out, const Proof& proof) {
  out.exact(proof.toi_lower);
  out.exact(proof.toi_upper);
  if (proof.toi_lower > 0) {
    const bool nearest = proof.symbolic && proof.nearest.size > 0;
    out.exact(proof.has_axis ? 1 + proof.symbolic + nearest : 0);
    if (proof.has_axis && proof.symbolic) nearest ? write_nearest(out, proof) : write_factors(out, proof);
    if (proof.has_axis && !proof.symbolic) out.direction(Direction(proof.axis));
  }
  if (!(proof.toi_upper < kInfinity<double>)) return;
  out.exact(proof.of_cores);
  std::vector<Weighted> pairs;
  for (int i = 0; i < std::clamp(proof.portal_size, 0, 4); ++i)
    pairs.push_back({proof.portal[static_cast<std::size_t>(i)], 0, {}});
  write_pairs(out, std::move(pairs));
}

}  // namespace

Meaning meaning_of(const corpus::ProofRecord& record, bool with_statement) {
  Meaning meaning;
  Writer out(meaning);
  write_case(out, record.problem);
  if (with_statement) {
    out.exact(static_cast<double>(record.outcome));
    out.exact(record.tier ? static_cast<double>(*record.tier) : -1);
    out.exact(record.toi ? record.toi->lower : -1);
    out.exact(record.toi ? record.toi->upper : -1);
  }
  if (record.rotating) {
    out.exact(record.rotating->toi_lower);
    out.exact(record.rotating->toi_upper);
    write_chain(out, record.problem, *record.rotating);
    if (record.rotating->toi_upper < kInfinity<double>) write_contact(out, *record.rotating);
  } else {
    write_linear(out, record.proof);
  }
  return meaning;
}

bool same(const Meaning& one, const Meaning& other) {
  return std::equal(one.parts.begin(), one.parts.end(), other.parts.begin(), other.parts.end(),
                    [](const Meaning::Part& l, const Meaning::Part& r) {
                      return l.rounded && r.rounded ? !(std::abs(l.x - r.x) > kSameDirection) : l.x == r.x;
                    });
}

bool has_a_time(const corpus::ProofRecord& record) {
  const double t_max = record.problem.t_max, never = kInfinity<double>;
  // Each statement leaves the times of an interval. All times beyond the step count as never.
  double from = 0, to = never;
  const auto keep = [&](double least, double most) {
    from = std::max(from, least > t_max ? never : least);
    to = std::min(to, most > t_max ? never : most);
  };
  if (record.rotating) {
    keep(record.rotating->toi_lower, record.rotating->toi_upper);
  } else {
    keep(record.proof.toi_lower, record.proof.toi_upper);
  }
  if (record.outcome == Outcome::initially_overlapping) keep(0, 0);
  if (record.outcome == Outcome::hit) {
    keep(std::numeric_limits<double>::denorm_min(), std::min(t_max, std::numeric_limits<double>::max()));
  }
  if (record.outcome == Outcome::miss) keep(never, never);
  // For a miss, methods state the time from which they have searched, or nothing.
  if (record.toi) keep(record.outcome == Outcome::miss ? 0 : record.toi->lower, record.toi->upper);
  return from <= to;
}

}  // namespace graze::attack
