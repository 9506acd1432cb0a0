// Hashes of answers (FNV-1a), with all that is in them: outcome, numbers by their bits, proof, counters.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <graze/cast_all.hpp>
#include <graze/distance.hpp>
#include <graze/line.hpp>
#include <graze/overlap.hpp>
#include <graze/penetration.hpp>
#include <graze/rotating_result.hpp>
#include <graze/scene.hpp>
#include <graze/swept_overlap.hpp>
#include <map>
#include <string>

namespace graze::bits {

class Hash {
 public:
  template <class... T>
  void all(const T&... x) {
    (add(x), ...);
  }
  template <class T>
  requires(std::is_integral_v<T> || std::is_enum_v<T>) void add(T x) { word(static_cast<std::uint64_t>(x)); }
  // A NaN has many bits.
  void add(double x) {
    std::uint64_t bits = ~std::uint64_t{0};
    if (x == x) std::memcpy(&bits, &x, sizeof bits);  // std::bit_cast is not everywhere
    word(bits);
  }
  void add(float x) { add(static_cast<double>(x)); }
  template <Scalar S>
  void add(const Vec3<S>& x) {
    all(x[0], x[1], x[2]);
  }
  template <class T, std::size_t N>
  void add(const std::array<T, N>& list) {
    for (const T& one : list) add(one);
  }
  template <class T>
  void add(const std::vector<T>& list) {
    for (const T& one : list) add(one);
  }
  template <class T>
  void add(const std::optional<T>& x) {
    add(x.has_value());
    if (x) add(*x);
  }
  void add(const Feature& x) { all(x.vertex, x.offset, x.curved); }
  void add(const SupportPair& x) { all(x.a, x.b); }
  void add(const AxisFactor& x) { all(x.kind, x.given, x.from, x.to); }
  void add(const NearestAxis& x) { all(x.size, x.pair, x.time, x.motion); }
  void add(const Proof& x) {
    all(x.toi_lower, x.has_axis, x.symbolic, x.axis, x.axis_sign, x.factor, x.nearest, x.then, x.toi_upper);
    all(x.portal_size, x.of_cores);
    for (int i = 0; i < x.portal_size; ++i) add(x.portal[static_cast<std::size_t>(i)]);
  }
  void add(const TimeSlice& x) { all(x.end, x.axis, x.frame); }
  void add(const RotatingProof& x) {
    all(x.toi_lower, x.chain, x.toi_upper, x.crossing, x.contact_from, x.contact_size);
    for (std::size_t i = 0; i < static_cast<std::size_t>(x.contact_size); ++i) all(x.contact[i], x.weight[i]);
  }
  void add(const Counters& x) {
    all(x.iterations, x.supports, x.gjk_iterations, x.portal_steps, x.exact_decisions, x.poses);
  }
  template <Scalar S>
  void add(const CastResult<S>& x) {
    all(x.outcome, x.invalid, x.method, x.toi_lower, x.toi_upper, x.distance, x.passed_over);
    all(x.normal, x.point_a, x.point_b, x.proof, x.counters);
  }
  template <Scalar S>
  void add(const RotatingResult<S>& x) {
    all(x.outcome, x.invalid, x.plan.effects, x.plan.reasons, x.toi_lower, x.toi_upper, x.distance);
    all(x.passed_over, x.hidden_motion, x.normal, x.point_a, x.point_b, x.proof, x.counters);
  }
  template <Scalar S>
  void add(const LineResult<S>& x) {
    all(x.outcome, x.invalid, x.in_lower, x.in_upper, x.out_lower, x.out_upper, x.normal_in, x.normal_out,
        x.counters);
  }
  template <Scalar S>
  void add(const OverlapResult<S>& x) {
    all(x.outcome, x.invalid, x.normal, x.counters);
  }
  template <Scalar S>
  void add(const SweptOverlapResult<S>& x) {
    all(x.outcome, x.invalid, x.normal, x.counters);
  }
  template <Scalar S>
  void add(const DistanceResult<S>& x) {
    all(x.invalid, x.lower, x.upper, x.stalled, x.normal, x.point_a, x.point_b, x.counters);
  }
  template <Scalar S>
  void add(const PenetrationResult<S>& x) {
    all(x.outcome, x.invalid, x.lower, x.upper, x.stalled, x.normal, x.point_a, x.point_b, x.counters);
  }
  void add(const scene::RayAnswer& x) { all(x.outcome, x.toi_lower, x.toi_upper, x.normal, x.point); }
  void add(const scene::Event& x) {
    all(x.a, x.b, x.outcome, x.toi_lower, x.toi_upper, x.distance, x.effects, x.reasons, x.normal, x.point_a,
        x.point_b);
    if (x.proof) all(x.proof->linear, x.proof->rotating);
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }
  void show(bool on) { shown_ = on; }

 private:
  void word(std::uint64_t x) {
    if (shown_) std::printf("  %016llx\n", static_cast<unsigned long long>(x));
    for (int i = 0; i < 8; ++i) value_ = (value_ ^ (x >> (8 * i) & 0xff)) * 0x100000001b3u;
  }
  std::uint64_t value_ = 0xcbf29ce484222325u;
  bool shown_ = false;
};

// A line for each group of answers.
class Table {
 public:
  // traced: the group whose answers are printed one by one, to find the first that differs. Empty: none. shown: the
  // number of the one whose words are printed.
  Table(bool exact_only, std::string traced, long shown)
      : exact_only_(exact_only), traced_(std::move(traced)), shown_(shown) {}
  [[nodiscard]] bool exact_only() const { return exact_only_; }

  template <Scalar S, class Answer>
  void add(const char* query, const Answer& answer) {
    const std::string name = std::string(query) + (sizeof(S) == 8 ? ", double" : ", float");
    Group& group = groups_[name];
    ++group.answers;
    group.hash.show(name == traced_ && group.answers == shown_);
    group.hash.add(answer);
    if (name == traced_)
      std::printf("%ld %016llx\n", group.answers, static_cast<unsigned long long>(group.hash.value()));
  }
  void count(const char* query, const Counters& counters) {
    groups_[std::string(query) + ", work"].hash.add(counters);
  }
  void print() const {
    long answers = 0;
    for (const auto& [name, group] : groups_) {
      std::printf("%016llx %6ld  %s\n", static_cast<unsigned long long>(group.hash.value()), group.answers,
                  name.c_str());
      answers += group.answers;
    }
    std::printf("%ld answers\n", answers);
  }

 private:
  struct Group {
    Hash hash;
    long answers = 0;
  };
  bool exact_only_;
  std::string traced_;
  long shown_;
  std::map<std::string, Group> groups_;
};

}  // namespace graze::bits
