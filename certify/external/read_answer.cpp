#include "certify/external/read_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>

#include "certify/external/frames.hpp"
#include "corpus/format/fields.hpp"
#include "corpus/format/names.hpp"
#include "corpus/format/proof_io.hpp"
#include "engines/adapter/host_frames.hpp"

namespace graze::external {

using corpus::Fields;
using corpus::JsonValue;
using corpus::Malformed;
using engine::Answer;
using engine::Failure;
using engine::Interval;

namespace {

// A normal whose length deviates by more is not a unit vector in any scalar.
constexpr double kUnitSlack = 1e-3;

// An error in a line.
struct Bad {
  Failure kind;
  std::string what;
};

// JSON has no NaN and no infinity, but printers of numbers do: NaN, nan, Infinity, inf, with a sign or
// without, become the strings that the format has for them.
std::string with_numbers_quoted(std::string_view line) {
  static const std::map<std::string_view, std::string_view> kWords = {
      {"NaN", "nan"}, {"nan", "nan"}, {"Infinity", "inf"}, {"inf", "inf"}, {"Inf", "inf"}};
  std::string out;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size();) {
    const char c = line[i];
    if (quoted || (std::isalpha(static_cast<unsigned char>(c)) == 0 && c != '-')) {
      if (c == '\\' && quoted && i + 1 < line.size()) out += line[i++];
      if (c == '"') quoted = !quoted;
      out += line[i++];
      continue;
    }
    const bool negative = c == '-';
    std::size_t end = i + (negative ? 1 : 0);
    const std::size_t begin = end;
    while (end < line.size() && std::isalpha(static_cast<unsigned char>(line[end])) != 0) ++end;
    const auto word = kWords.find(line.substr(begin, end - begin));
    if (word == kWords.end()) {
      out += line.substr(i, std::max(end, i + 1) - i);
    } else {
      out += fmt::format("\"{}{}\"", negative && word->second == "inf" ? "-" : "", word->second);
    }
    i = std::max(end, i + 1);
  }
  return out;
}

// A number, or "nan", "inf", "-inf".
double read_any_number(const JsonValue& value, const std::string& path) {
  if (value.kind == JsonValue::Kind::string && (value.text == "nan" || value.text == "-nan"))
    return std::nan("");
  return corpus::read_extended(value, path);
}

double finite(double x, const std::string& path) {
  if (std::isnan(x)) throw Bad{Failure::non_finite, path + " is NaN"};
  if (std::isinf(x)) throw Bad{Failure::non_finite, path + " is infinite"};
  return x;
}

Vec3<double> read_vector(const Fields& fields, std::string_view key) {
  const std::string path = fields.path(key);
  const std::string form = std::string(key) + " is an array of three numbers";
  const std::vector<JsonValue>& items = corpus::read_array(fields.required(key, form), path, form);
  if (items.size() != 3) throw Malformed{path, form};
  Vec3<double> v;
  for (int i = 0; i < 3; ++i) {
    const std::string at = corpus::item_path(path, static_cast<std::size_t>(i));
    v[i] = finite(read_any_number(items[static_cast<std::size_t>(i)], at), at);
  }
  return v;
}

// A number, or a bracket.
Interval read_interval(const Fields& fields, std::string_view key) {
  const std::string path = fields.path(key);
  const std::string form = std::string(key) + " is a number, or an object with lower and upper";
  const JsonValue& value = fields.required(key, form);
  if (value.kind != JsonValue::Kind::object) {
    const double x = finite(read_any_number(value, path), path);
    return {x, x};
  }
  const Fields ends(value, path, {"lower", "upper"});
  const auto end = [&](std::string_view name) {
    const double x = read_any_number(ends.required(name, form), ends.path(name));
    if (std::isnan(x)) throw Bad{Failure::non_finite, ends.path(name) + " is NaN"};
    return x;
  };
  const Interval both{end("lower"), end("upper")};
  if (!(both.lower <= both.upper)) throw Bad{Failure::out_of_range, path + " is a bracket upside down"};
  return both;
}

// The numbers of an answer, wherever they are written.
class Said {
 public:
  virtual ~Said() = default;
  [[nodiscard]] virtual bool has(std::string_view key) const = 0;
  [[nodiscard]] virtual Interval interval(std::string_view key) const = 0;
  [[nodiscard]] virtual Vec3<double> vector(std::string_view key) const = 0;
};

class SaidInALine : public Said {
 public:
  explicit SaidInALine(const Fields& fields) : fields_(fields) {}
  [[nodiscard]] bool has(std::string_view key) const override { return fields_.optional(key) != nullptr; }
  [[nodiscard]] Interval interval(std::string_view key) const override { return read_interval(fields_, key); }
  [[nodiscard]] Vec3<double> vector(std::string_view key) const override { return read_vector(fields_, key); }

 private:
  const Fields& fields_;
};

// A field that a library leaves at NaN is not part of its answer.
class SaidInAFrame : public Said {
 public:
  explicit SaidInAFrame(const graze_engine_answer& answer) : answer_(answer) {}
  [[nodiscard]] bool has(std::string_view key) const override {
    if (const double* const v = components(key))
      return !std::isnan(v[0]) || !std::isnan(v[1]) || !std::isnan(v[2]);
    return !std::isnan(ends(key).first);
  }
  [[nodiscard]] Interval interval(std::string_view key) const override {
    const auto [lower, upper] = ends(key);
    const std::string path(key);
    if (std::isnan(lower)) throw Bad{Failure::non_finite, path + " is NaN"};
    if (std::isnan(upper)) return {finite(lower, path), lower};
    if (!(lower <= upper)) throw Bad{Failure::out_of_range, path + " is a bracket upside down"};
    return {lower, upper};
  }
  [[nodiscard]] Vec3<double> vector(std::string_view key) const override {
    const double* const from = components(key);
    Vec3<double> v;
    for (int i = 0; i < 3; ++i) v[i] = finite(from[i], fmt::format("{}[{}]", key, i));
    return v;
  }

 private:
  // The components of a vector, or nullptr if the field is not a vector.
  [[nodiscard]] const double* components(std::string_view key) const {
    if (key == "normal") return answer_.normal;
    if (key == "point_a") return answer_.point_a;
    return key == "point_b" ? answer_.point_b : nullptr;
  }
  [[nodiscard]] std::pair<double, double> ends(std::string_view key) const {
    if (key == "time") return {answer_.time, answer_.time_upper};
    if (key == "distance") return {answer_.distance, answer_.distance_upper};
    return {answer_.depth, answer_.depth_upper};
  }
  const graze_engine_answer& answer_;
};

class Reading {
 public:
  Reading(const Offer& offer, const Terms& terms) : offer_(offer), terms_(terms) {}

  Answer operator()(const adapter::frames::AnswerFrame& frame) {
    answer_.message = frame.answer.message;
    outcome(frame);
    if (answer_.declined) return answer_;
    if (!std::isnan(frame.ns)) answer_.ns = finite(frame.ns, "ns");
    numbers(SaidInAFrame(frame.answer));
    in_terms_of_the_case();
    return std::move(answer_);
  }

  Answer operator()(const JsonValue& value, std::string_view id) {
    const Fields fields(value, "",
                        {"schema", "id", "outcome", "time", "normal", "point_a", "point_b", "distance",
                         "depth", "proof", "ns", "native", "message", "iterations", "supports"});
    const std::string schema =
        corpus::read_string(fields.required("schema", "the schema is \"graze.answer/1\""), "schema");
    if (schema != "graze.answer/1")
      throw Malformed{"schema", corpus::json_quote_short(schema) + "; it is \"graze.answer/1\""};
    const std::string its = corpus::read_string(fields.required("id", "the id of the question"), "id");
    if (its != id)
      throw Bad{Failure::wrong_id, fmt::format("it answers {}, and was asked {}",
                                               corpus::json_quote_short(its), corpus::json_quote_short(id))};
    if (const JsonValue* message = fields.optional("message"))
      answer_.message = corpus::read_string(*message, "message");
    outcome(fields);
    if (answer_.declined) return answer_;
    counters(fields);
    numbers(SaidInALine(fields));
    if (offer_.holds_proof && offer_.question == Question::cast && terms_.exponent == 0) proof(fields);
    in_terms_of_the_case();
    return std::move(answer_);
  }

 private:
  [[nodiscard]] bool casts() const { return is_cast(offer_.question); }

  void numbers(const Said& said) {
    switch (offer_.question) {
      case Question::cast:
      case Question::rotating_cast:
      case Question::ray:
        times(said);
        break;
      case Question::overlap:
        break;
      case Question::distance:
        distance(said);
        break;
      case Question::penetration:
        depth(said);
        break;
    }
    contact(said);
  }

  void outcome(const adapter::frames::AnswerFrame& frame) {
    switch (frame.outcome) {
      case GRAZE_ENGINE_UNSUPPORTED:
        answer_.declined = true;
        return;
      case GRAZE_ENGINE_HIT:
        answer_.outcome = casts() ? Outcome::hit : Outcome::initially_overlapping;
        return;
      case GRAZE_ENGINE_INITIALLY_OVERLAPPING:
        answer_.outcome = Outcome::initially_overlapping;
        return;
      case GRAZE_ENGINE_MISS:
        answer_.outcome = Outcome::miss;
        return;
      case GRAZE_ENGINE_NOT_CONVERGED:
        answer_.outcome = Outcome::not_converged;
        return;
      default:
        throw Malformed{"outcome", fmt::format("{} is none of graze_engine_outcome", frame.outcome)};
    }
  }

  void outcome(const Fields& fields) {
    static constexpr std::array<std::string_view, 5> kOutcomes = {"initially_overlapping", "hit", "miss",
                                                                  "not_converged", "unsupported"};
    const std::size_t k =
        corpus::read_choice(fields.required("outcome", "an answer has an outcome"), "outcome", kOutcomes);
    answer_.declined = k == 4;
    if (!answer_.declined) answer_.outcome = static_cast<Outcome>(k);
    // A contact of a query about t = 0, whatever it is called.
    if (answer_.outcome == Outcome::hit && !casts()) answer_.outcome = Outcome::initially_overlapping;
  }

  void counters(const Fields& fields) {
    if (const JsonValue* ns = fields.optional("ns")) answer_.ns = finite(read_any_number(*ns, "ns"), "ns");
    if (const JsonValue* native = fields.optional("native")) {
      if (native->kind != JsonValue::Kind::boolean) throw Malformed{"native", "true or false"};
      answer_.native = native->boolean;
    }
    if (const JsonValue* n = fields.optional("iterations"))
      answer_.counters.iterations =
          static_cast<int>(std::min(corpus::read_index(*n, "iterations"), 1U << 30));
    if (const JsonValue* n = fields.optional("supports"))
      answer_.counters.supports = static_cast<int>(std::min(corpus::read_index(*n, "supports"), 1U << 30));
  }

  void times(const Said& said) {
    const double t_max = terms_.asked.t_max;
    switch (answer_.outcome) {
      case Outcome::miss:
        answer_.toi_lower = answer_.toi_upper = kInfinity<double>;
        return;
      case Outcome::hit: {
        if (!offer_.holds.time) {
          answer_.toi_upper = t_max;
          return;
        }
        const Interval time = said.interval("time");
        finite(time.lower, "time");
        // A time that the scalar cannot hold lies between its largest number and infinity.
        const bool is_beyond = time.lower == std::numeric_limits<float>::max() ||
                               time.lower == std::numeric_limits<double>::max();
        if (!is_beyond) finite(time.upper, "time");
        if (!(time.lower >= 0 && time.lower <= t_max))
          throw Bad{Failure::out_of_range,
                    fmt::format("the time {} is not between 0 and t_max {}", time.lower, t_max)};
        answer_.toi_lower = time.lower;
        answer_.toi_upper = time.upper;
        return;
      }
      case Outcome::not_converged: {
        answer_.toi_upper = kInfinity<double>;
        if (!said.has("time") || !offer_.holds.time) return;
        const Interval time = said.interval("time");
        answer_.toi_lower = std::clamp(time.lower, 0.0, std::numeric_limits<double>::max());
        answer_.toi_upper = std::max(answer_.toi_lower, time.upper);
        return;
      }
      default:
        return;
    }
  }

  void distance(const Said& said) {
    if (answer_.outcome == Outcome::not_converged) {
      answer_.stalled = true;
      answer_.separation = Interval{0, kInfinity<double>};
      return;
    }
    answer_.separation = Interval{};
    if (answer_.outcome != Outcome::miss || !offer_.holds_distance) return;
    answer_.separation = said.interval("distance");
    if (!(answer_.separation->lower >= 0)) throw Bad{Failure::out_of_range, "the distance is negative"};
  }

  void depth(const Said& said) {
    answer_.stalled = answer_.outcome == Outcome::not_converged;
    if (answer_.outcome != Outcome::initially_overlapping || !offer_.holds_depth) return;
    answer_.depth = said.interval("depth");
    if (!(answer_.depth->lower >= 0)) throw Bad{Failure::out_of_range, "the depth is negative"};
  }

  // The outcomes of which every answer has a normal and witnesses, if the engine's answers hold any.
  [[nodiscard]] bool has_contact() const {
    switch (offer_.question) {
      case Question::distance:
        return answer_.outcome == Outcome::miss;
      case Question::penetration:
        return answer_.outcome == Outcome::initially_overlapping;
      case Question::overlap:
        return false;
      default:
        return answer_.outcome == Outcome::hit;
    }
  }

  // A cast's start in contact: it may have them.
  [[nodiscard]] bool is_start() const { return casts() && answer_.outcome == Outcome::initially_overlapping; }

  void contact(const Said& said) {
    if (is_start()) return start(said);
    if (!has_contact()) return;
    if (offer_.holds.normal) {
      answer_.normal = said.vector("normal");
      require_unit("the normal");
    }
    if (offer_.holds.witnesses) points(said);
  }

  // For a start in contact, an engine may give no normal or a zero normal. Both mean the same.
  void start(const Said& said) {
    if (offer_.holds.normal && said.has("normal")) {
      answer_.normal = said.vector("normal");
      if (answer_.has_normal()) require_unit("the normal of a start in contact");
    }
    if (offer_.holds.witnesses && (said.has("point_a") || said.has("point_b"))) points(said);
  }

  void require_unit(const char* what) const {
    const double length = answer_.normal.norm();
    if (!(std::abs(length - 1) <= kUnitSlack))
      throw Bad{Failure::out_of_range, fmt::format("{} has length {:.9g}", what, length)};
  }

  void points(const Said& said) {
    answer_.point_a = said.vector("point_a");
    answer_.point_b = said.vector("point_b");
    answer_.has_points = true;
  }

  void proof(const Fields& fields) {
    if (const JsonValue* value = fields.optional("proof"))
      answer_.proof = corpus::read_proof(*value, "proof");
  }

  // Lengths in its unit, the bodies of the case.
  void in_terms_of_the_case() {
    const auto back = [&](double x) { return std::ldexp(x, -terms_.exponent); };
    for (Vec3<double>* point : {&answer_.point_a, &answer_.point_b}) *point = point->unaryExpr(back);
    for (std::optional<Interval>* length : {&answer_.separation, &answer_.depth}) {
      if (*length) *length = Interval{back((*length)->lower), back((*length)->upper)};
    }
    answer_.reach_a = terms_.reach_a;
    answer_.reach_b = terms_.reach_b;
    // No bound on the distance is known: a query's contact and its absence may lie the engine's margin apart.
    answer_.distance = kInfinity<double>;
    if (!terms_.swapped) return;
    std::swap(answer_.point_a, answer_.point_b);
    answer_.normal = -answer_.normal;
  }

  const Offer& offer_;
  const Terms& terms_;
  Answer answer_{.outcome = Outcome::not_converged};
};

// An error often begins with a field, such as normal[1]. A line that is too long is quoted from that field on.
std::string quote_for(std::string_view what, std::string_view line) {
  const std::string key =
      fmt::format("\"{}\"", what.substr(0, what.find_first_not_of("abcdefghijklmnopqrstuvwxyz_")));
  const std::size_t at = line.find(key);
  if (corpus::json_quote_short(line) == corpus::json_quote(line) || at == line.npos || at == 0)
    return corpus::json_quote_short(line);
  return corpus::json_quote_short(fmt::format("...{}", line.substr(at)));
}

Answer failed(Failure kind, std::string_view what, std::string_view line) {
  Answer answer;
  answer.failure = kind;
  answer.message = fmt::format("{}: {}", what, quote_for(what, line));
  return answer;
}

}  // namespace

Answer read_answer(std::string_view line, std::string_view id, const Offer& offer, const Terms& terms) {
  corpus::ParsedJson parsed = corpus::parse_json(line);
  if (parsed.error) {
    const corpus::ParsedJson again = corpus::parse_json(with_numbers_quoted(line));
    if (!again.error) parsed = again;
  }
  try {
    if (parsed.error) throw *parsed.error;
    return Reading(offer, terms)(parsed.value, id);
  } catch (const Malformed& bad) {
    return failed(Failure::garbage, bad.path.empty() ? bad.what : bad.path + ": " + bad.what, line);
  } catch (const Bad& bad) {
    return failed(bad.kind, bad.what, line);
  }
}

Answer read_answer_frame(std::string_view bytes, std::uint64_t id, const Offer& offer, const Terms& terms) {
  adapter::frames::AnswerFrame frame;
  const auto failed_by = [](Failure kind, std::string what) {
    Answer answer;
    answer.failure = kind;
    answer.message = std::move(what);
    return answer;
  };
  if (bytes.size() != sizeof frame) return failed_by(Failure::garbage, "the bytes are no answer");
  std::memcpy(&frame, bytes.data(), sizeof frame);
  if (frame.magic != adapter::frames::kAnswer) return failed_by(Failure::garbage, "the bytes are no answer");
  if (frame.id != id)
    return failed_by(Failure::wrong_id, fmt::format("it answers q{}, and was asked q{}", frame.id, id));
  frame.answer.message[sizeof frame.answer.message - 1] = '\0';
  try {
    return Reading(offer, terms)(frame);
  } catch (const Malformed& bad) {
    return failed_by(Failure::garbage, bad.path + ": " + bad.what);
  } catch (const Bad& bad) {
    return failed_by(bad.kind, bad.what);
  }
}

std::string id_of_answer(std::string_view line) {
  const corpus::ParsedJson parsed = corpus::parse_json(line);
  if (parsed.error) return {};
  const JsonValue* id = parsed.value.find("id");
  return id != nullptr && id->kind == JsonValue::Kind::string ? id->text : "";
}

}  // namespace graze::external
