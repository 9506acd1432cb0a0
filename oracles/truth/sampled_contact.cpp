// Decides exactly: nothing.
// Brackets only: nothing. It proves contact at a time.
// Costs: 20 to 60 microseconds for a time at which the bodies are apart, some hundred for a contact.
// Cannot be trusted: to find a contact that lasts for less than the time between two looks, or is less deep
//   than kFine of the scale.
#include "oracles/truth/sampled_contact.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "oracles/curved/rotating_pair.hpp"

namespace graze::oracle {
namespace {

// Over scale: overlaps this deep are told from none.
constexpr double kFine = 1e-12;
// Steps towards the time of a nearest approach, of each of the kApproaches nearest ones.
constexpr int kSteps = 6, kApproaches = 2;

}  // namespace

struct SampledContact::Impl {
  double end;
  long bits = 192;
  std::optional<RotatingPair> pair;
  Ball fine, near;
  Vec3<double> axis = Vec3<double>::UnitX();
  double earliest = kInfinity<double>;

  explicit Impl(const corpus::Case& problem) : end(problem.t_max) {
    if (!(end >= 0) || std::isinf(end)) {
      throw std::invalid_argument("t_max: it is below 0, infinite or NaN");
    }
    if (!(problem.target_distance >= 0) || std::isinf(problem.target_distance)) {
      throw std::invalid_argument("target_distance: it is below 0, infinite or NaN");
    }
    {
      const WorkingPrecision precision(bits);
      pair.emplace(problem);
    }
    // As in RotatingTruth: the bits lost to coordinates beyond the scale are added.
    const double size = pair->scale().low_double();
    const double largest =
        pair->magnitude() + norm(pair->b().velocity() - pair->a().velocity()).high_double() * end;
    const double lost = size > 0 ? std::log2(std::max(1.0, largest / size)) : 0;
    bits += 2 * static_cast<long>(std::min(lost, 2000.0));
    const WorkingPrecision precision(bits);
    pair.emplace(problem);
    fine = (Ball(kFine) * pair->scale()).high();
    near = (Ball(0x1p-36) * pair->scale()).high();
  }

  // A lower bound on the separation along the axis that was found. It is 0 if that is not known, or not so.
  double look(double t) {
    const WorkingPrecision precision(bits);
    const PairPose pose = pair->at(Ball(t));
    const Contact found = pair->contact(pose, axis, fine, near, RotatingPair::kAnyDepth);
    if (found.kind == Contact::Kind::overlapping) {
      earliest = std::min(earliest, t);
      return 0;
    }
    if (found.kind == Contact::Kind::open) return 0;
    axis = found.axis;
    return found.lower.low_double();
  }

  struct Look {
    double t = 0, gap = 0;
  };

  // Smaller steps about the middle one of three looks, whose gap is the least.
  void approach(Look before, Look middle, Look after) {
    for (int i = 0; i < kSteps && std::isinf(earliest); ++i) {
      const bool left = middle.t - before.t > after.t - middle.t;
      const double t = left ? before.t + (middle.t - before.t) / 2 : middle.t + (after.t - middle.t) / 2;
      const Look now{t, look(t)};
      if (now.gap < middle.gap) {
        (left ? after : before) = middle;
        middle = now;
      } else {
        (left ? before : after) = now;
      }
    }
  }

  void search(int times) {
    // Multiples of the golden ratio: evenly spread, and never in step with whole turns.
    constexpr double kGolden = 0.6180339887498949;
    std::vector<Look> looks = {{0, 0}, {end, 0}};
    for (int k = 1; k + 1 < times; ++k) {
      const double part = kGolden * k;
      looks.push_back({(part - std::floor(part)) * end, 0});
    }
    std::sort(looks.begin(), looks.end(), [](const Look& l, const Look& r) { return l.t < r.t; });
    for (Look& one : looks) {
      one.gap = look(one.t);
      if (std::isfinite(earliest)) return;
    }
    std::vector<std::size_t> nearest;
    for (std::size_t i = 1; i + 1 < looks.size(); ++i) {
      if (looks[i].gap <= looks[i - 1].gap && looks[i].gap <= looks[i + 1].gap) nearest.push_back(i);
    }
    std::sort(nearest.begin(), nearest.end(),
              [&](std::size_t l, std::size_t r) { return looks[l].gap < looks[r].gap; });
    for (std::size_t i = 0; i < nearest.size() && i < kApproaches; ++i) {
      const std::size_t k = nearest[i];
      approach(looks[k - 1], looks[k], looks[k + 1]);
    }
  }
};

SampledContact::SampledContact(const corpus::Case& problem) : impl_(std::make_unique<Impl>(problem)) {}
SampledContact::~SampledContact() = default;
SampledContact::SampledContact(SampledContact&&) noexcept = default;
SampledContact& SampledContact::operator=(SampledContact&&) noexcept = default;

void SampledContact::search(int times) { impl_->search(times); }
bool SampledContact::look_at(double t) {
  impl_->look(t);
  return impl_->earliest <= t;
}
double SampledContact::earliest() const { return impl_->earliest; }

}  // namespace graze::oracle
