#include "certify/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <istream>
#include <ostream>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "scene/src/parallel.hpp"

namespace graze::tool {
namespace {

using corpus::Case;
using engine::Answer;
using engine::Method;

// Takes values one by one. A structured binding names every field of a structure: with a field more it does not
// compile.
class Digest {
 public:
  [[nodiscard]] std::uint64_t value() const { return state_; }

  template <class T>
  requires(std::is_integral_v<T> || std::is_enum_v<T>) void add(T x) { word(static_cast<std::uint64_t>(x)); }
  void add(double x) { word(std::bit_cast<std::uint64_t>(x)); }
  void add(const Vec3<double>& x) { all(x[0], x[1], x[2]); }
  template <class T>
  void add(const std::optional<T>& x) {
    add(x.has_value());
    if (x) add(*x);
  }
  template <class T, std::size_t kSize>
  void add(const std::array<T, kSize>& x) {
    for (const T& one : x) add(one);
  }
  template <class T>
  void add(const std::vector<T>& x) {
    add(x.size());
    for (const T& one : x) add(one);
  }

  void add(const engine::Interval& x) {
    const auto& [lower, upper] = x;
    all(lower, upper);
  }
  void add(const InvalidAt& x) {
    const auto& [why, body, field, part, index] = x;
    all(why, body, field, part, index);
  }
  void add(const Feature& x) {
    const auto& [vertex, offset, curved] = x;
    all(vertex, offset, curved);
  }
  void add(const SupportPair& x) {
    const auto& [a, b] = x;
    all(a, b);
  }
  void add(const AxisFactor& x) {
    const auto& [kind, given, from, to] = x;
    all(kind, given, from, to);
  }
  void add(const NearestAxis& x) {
    const auto& [size, pair, time, motion] = x;
    all(size, pair, time, motion);
  }
  void add(const Proof& x) {
    const auto& [lower, has_axis, symbolic, axis, sign, factor, nearest, then, upper, size, portal,
                 of_cores] = x;
    all(lower, has_axis, symbolic, axis, sign, factor, nearest, then, upper, size, portal, of_cores);
  }
  void add(const TimeSlice& x) {
    const auto& [end, axis, frame] = x;
    all(end, axis, frame);
  }
  void add(const RotatingProof& x) {
    const auto& [lower, chain, upper, crossing, from, size, contact, weight] = x;
    all(lower, chain, upper, crossing, from, size, contact, weight);
  }
  void add(const Plan& x) {
    const auto& [effects, reasons] = x;
    all(effects, reasons);
  }
  void add(const std::string& x) {
    add(x.size());
    for (const char one : x) add(one);
  }
  void add(const Answer& x) {
    // The cost, in counters and in ns, is judged in digest_of_case or not at all.
    const auto& [outcome, invalid, invalid_at, lower, upper, normal, point_a, point_b, reach_a, reach_b,
                 distance, passed_over, proof, counters, plan, hidden_motion, rotating_proof, separation,
                 depth, t_in, t_out, normal_out, has_points, stalled, failure, message, declined, ns,
                 native] = x;
    all(outcome, invalid, invalid_at, lower, upper, normal, point_a, point_b, reach_a, reach_b, distance,
        passed_over, proof, plan, hidden_motion, rotating_proof, separation, depth, t_in, t_out, normal_out,
        has_points, stalled, failure, message, declined, native);
  }

 private:
  template <class... T>
  void all(const T&... x) {
    (add(x), ...);
  }
  // The finaliser of splitmix64, a bijection, after each word.
  void word(std::uint64_t x) {
    state_ = (state_ ^ x) + 0x9e3779b97f4a7c15;
    state_ = (state_ ^ state_ >> 30) * 0xbf58476d1ce4e5b9;
    state_ = (state_ ^ state_ >> 27) * 0x94d049bb133111eb;
    state_ ^= state_ >> 31;
  }

  std::uint64_t state_ = 0;
};

// A digest of the method's answers to all requests about case i, or 0 if the method is not asked about it.
std::uint64_t digest_of_case(const Suite& suite, std::size_t i, const Case& problem, const Method& method) {
  const std::optional<Case> asked = question_for(suite, i, problem, method);
  if (!asked) return 0;
  Digest digest;
  for (const Request request : requests_of(method.kind)) {
    digest.add(method.ask(*asked, {.request = request}));
  }
  // A judgement reads one fact about the work: whether it exceeds the guarantee.
  if (const std::optional<double> most = law::most_supports(method, *asked)) {
    const int supports = method.ask(*asked, {.request = engine::kPlain}).counters.supports;
    digest.add(supports > *most);
  }
  return std::max<std::uint64_t>(1, digest.value());
}

std::size_t place_of(const Suite& suite, const std::vector<Suite>& suites) {
  return static_cast<std::size_t>(&suite - suites.data());
}

KeptAnswer::State state_of(const law::Judgement& judgement) {
  using State = KeptAnswer::State;
  if (judgement.skipped && judgement.wrong.empty()) return State::not_judged;
  return judgement.stalled ? State::stalled : State::kept;
}

constexpr std::string_view kStates = "-.s";

}  // namespace

std::uint64_t digest_of(const Answer& answer) {
  Digest digest;
  digest.add(answer);
  return digest.value();
}

KeptAnswers::KeptAnswers(const std::vector<Suite>& suites, const std::vector<const Method*>& methods,
                         unsigned threads) {
  for (std::size_t s = 0; s < suites.size(); ++s) {
    std::vector<std::pair<const Method*, std::vector<KeptAnswer>*>> columns;
    for (const Method* method : methods) {
      if (method->kind != suites[s].kind) continue;
      std::vector<KeptAnswer>& column = answers_[{s, method->question_name()}];
      column.resize(suites[s].size());
      columns.emplace_back(method, &column);
    }
    if (columns.empty()) continue;
    scene::for_each_index(suites[s].size(), threads, [&](std::size_t i) {
      const Case problem = suites[s].at(i);
      for (const auto& [method, column] : columns) {
        (*column)[i].digest = digest_of_case(suites[s], i, problem, *method);
      }
    });
  }
}

const std::vector<KeptAnswer>& KeptAnswers::of(std::size_t suite, const Method& method) const {
  const auto found = answers_.find({suite, method.question_name()});
  if (found == answers_.end()) {
    throw std::runtime_error(
        fmt::format("no answers of {} to suite {} are kept", method.question_name(), suite));
  }
  return found->second;
}

std::vector<KeptAnswer>& KeptAnswers::of(std::size_t suite, const Method& method) {
  return const_cast<std::vector<KeptAnswer>&>(std::as_const(*this).of(suite, method));
}

std::vector<std::vector<bool>> KeptAnswers::differ_from(const KeptAnswers& kept) const {
  std::vector<std::vector<bool>> differing;
  for (const auto& [key, column] : answers_) {
    const auto found = kept.answers_.find(key);
    if (found == kept.answers_.end() || found->second.size() != column.size()) {
      throw std::runtime_error(fmt::format(
          "the answers of {} to suite {} are kept of other cases, or not at all", key.second, key.first));
    }
    differing.resize(std::max(differing.size(), key.first + 1));
    std::vector<bool>& cases = differing[key.first];
    cases.resize(column.size());
    for (std::size_t i = 0; i < column.size(); ++i) {
      if (column[i].digest != found->second[i].digest) cases[i] = true;
    }
  }
  return differing;
}

// The first line has the place, the number of cases and the method. Each further line has the digest and the state of a
// case.
void KeptAnswers::write(std::ostream& out) const {
  for (const auto& [key, column] : answers_) {
    std::string text = fmt::format("{} {} {}\n", key.first, column.size(), key.second);
    for (const KeptAnswer& one : column) {
      text += fmt::format("{:016x}{}", one.digest, static_cast<char>(one.state));
    }
    out << text << '\n';
  }
}

KeptAnswers KeptAnswers::read(std::istream& in) {
  constexpr std::size_t kDigits = 16, kLength = kDigits + 1;
  KeptAnswers kept;
  std::size_t suite = 0, count = 0;
  while (in >> suite >> count) {
    std::string name, text;
    in.get();
    std::getline(in, name);
    std::getline(in, text);
    if (!in || text.size() != kLength * count) throw std::runtime_error("kept answers break off");
    std::vector<KeptAnswer>& column = kept.answers_[{suite, name}];
    for (std::size_t i = 0; i < count; ++i) {
      const char* const digits = text.data() + kLength * i;
      KeptAnswer one;
      const auto [end, error] = std::from_chars(digits, digits + kDigits, one.digest, 16);
      if (error != std::errc{} || end != digits + kDigits || kStates.find(*end) == std::string_view::npos) {
        throw std::runtime_error("kept answers are not readable");
      }
      one.state = static_cast<KeptAnswer::State>(*end);
      column.push_back(one);
    }
  }
  if (!in.eof() || kept.answers_.empty()) throw std::runtime_error("these are no kept answers");
  return kept;
}

std::vector<std::string> judge_all(const std::vector<Suite>& suites, const Settings& settings,
                                   KeptAnswers& answers) {
  Settings all = settings;
  all.times_casts = false;
  all.judged = [&](const Suite& suite, std::size_t i, const Method& method, const law::Judgement& judgement) {
    answers.of(place_of(suite, suites), method)[i].state = state_of(judgement);
  };
  return certify(suites, all).breaches;
}

std::vector<std::string> judge_differing(const std::vector<Suite>& suites, const Settings& settings,
                                         const KeptAnswers& kept,
                                         const std::vector<std::vector<bool>>& differing) {
  bool sure = false;  // a guarantee is certain to break
  std::map<std::pair<std::size_t, const Method*>, std::size_t> stalls;
  Settings some = settings;
  some.times_casts = false;
  some.stop = [&] { return sure || settings.stop(); };
  some.leaves_out = [&](const Suite& suite, std::size_t i) {
    const std::size_t s = place_of(suite, suites);
    return s >= differing.size() || i >= differing[s].size() || !differing[s][i];
  };
  some.judged = [&](const Suite& suite, std::size_t, const Method& method, const law::Judgement& judgement) {
    if (method.guarantee == nullptr) return;
    std::size_t& stalled = stalls[{place_of(suite, suites), &method}];
    stalled += judgement.stalled ? 1 : 0;
    const double most = method.guarantee->stall_cap * static_cast<double>(suite.size());
    sure = sure || judgement.faulty() || static_cast<double>(stalled) > most;
  };
  const Certification certification = certify(suites, some);
  std::vector<std::string> lines;
  // Tallies come by method, then by suite of the method's kind.
  std::map<const Method*, std::size_t> next;
  for (Tally tally : certification.tallies) {
    std::size_t& s = next[tally.method];
    while (suites[s].kind != tally.method->kind) ++s;
    const std::vector<KeptAnswer>& column = kept.of(s, *tally.method);
    for (std::size_t i = 0; i < column.size(); ++i) {
      if (column[i].state == KeptAnswer::State::not_judged || !some.leaves_out(suites[s], i)) continue;
      ++tally.cases;
      tally.stalled += column[i].state == KeptAnswer::State::stalled ? 1 : 0;
    }
    ++s;
    for (std::string& line : breaches(tally)) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace graze::tool
