#include "certify/external/declaration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "corpus/format/fields.hpp"

namespace graze::external {

using corpus::Fields;
using corpus::JsonValue;
using corpus::Malformed;

namespace {

constexpr std::array<std::string_view, 6> kQuestions = {"cast",    "rotating_cast", "ray",
                                                        "overlap", "distance",      "penetration"};
constexpr std::array<std::string_view, 14> kShapes = {"point", "segment",   "triangle", "sphere",   "capsule",
                                                      "box",   "ellipsoid", "hull",     "cylinder", "cone",
                                                      "posed", "rounded",   "sum",      "hull_of"};
constexpr std::array<std::string_view, 6> kHeld = {"time",     "normal", "witnesses",
                                                   "distance", "depth",  "proof"};
constexpr std::array<std::string_view, 3> kTouching = {"either", "contact", "miss"};
constexpr std::array<std::string_view, 2> kStartNormals = {"any", "least_penetration"};
constexpr std::array<std::string_view, 2> kScalars = {"float", "double"};
constexpr std::array<std::string_view, 2> kMotions = {"both", "relative"};

bool read_flag(const JsonValue& value, const std::string& path) {
  if (value.kind != JsonValue::Kind::boolean) throw Malformed{path, describe(value) + "; true or false"};
  return value.boolean;
}

bool flag_or(const Fields& fields, std::string_view key, bool usual) {
  const JsonValue* value = fields.optional(key);
  return value == nullptr ? usual : read_flag(*value, fields.path(key));
}

std::optional<double> length(const Fields& fields, std::string_view key) {
  const JsonValue* value = fields.optional(key);
  if (value == nullptr) return {};
  return corpus::read_not_negative(*value, fields.path(key));
}

std::string text_or_nothing(const Fields& fields, std::string_view key) {
  const JsonValue* value = fields.optional(key);
  return value == nullptr ? "" : corpus::read_string(*value, fields.path(key));
}

Offer read_offer(std::string_view name, const JsonValue& value, const std::string& path) {
  Offer offer;
  const auto known = std::find(kQuestions.begin(), kQuestions.end(), name);
  if (known == kQuestions.end()) throw Malformed{path, "is no query; it is " + corpus::joined(kQuestions)};
  offer.question = static_cast<Question>(known - kQuestions.begin());
  const Fields fields(
      value, path,
      {"answers", "tolerance", "relative_tolerance", "kappa", "touching", "early", "starts", "stalls",
       "target_distance", "pass_over", "start_normal", "own_frames", "most_supports"});
  constexpr std::string_view kForm = "answers is an array of what an answer holds beside its outcome";
  const std::string where = fields.path("answers");
  const std::vector<JsonValue>& held = corpus::read_array(fields.required("answers", kForm), where, kForm);
  for (std::size_t i = 0; i < held.size(); ++i) {
    switch (corpus::read_choice(held[i], corpus::item_path(where, i), kHeld)) {
      case 0:
        offer.holds.time = true;
        break;
      case 1:
        offer.holds.normal = true;
        break;
      case 2:
        offer.holds.witnesses = true;
        break;
      case 3:
        offer.holds_distance = true;
        break;
      case 4:
        offer.holds_depth = true;
        break;
      default:
        offer.holds_proof = true;
        break;
    }
  }
  // Contact without a distance is the query overlap.
  if (offer.question == Question::distance && !offer.holds_distance)
    throw Malformed{where, "answers to distance hold \"distance\""};
  if (offer.question == Question::penetration && !offer.holds_depth)
    throw Malformed{where, "answers to penetration hold \"depth\""};
  offer.tolerance = length(fields, "tolerance");
  offer.relative_tolerance = length(fields, "relative_tolerance");
  offer.kappa = length(fields, "kappa");
  if (const JsonValue* touching = fields.optional("touching")) {
    offer.touching =
        static_cast<engine::Touching>(corpus::read_choice(*touching, fields.path("touching"), kTouching));
  }
  if (const JsonValue* normal = fields.optional("start_normal")) {
    const std::string at = fields.path("start_normal");
    offer.start_normal = static_cast<engine::StartNormal>(corpus::read_choice(*normal, at, kStartNormals));
    if (!is_cast(offer.question) || !offer.holds.normal)
      throw Malformed{at, "is about casts and rays whose answers hold \"normal\""};
  }
  offer.own_frames = length(fields, "own_frames").value_or(0);
  offer.early = length(fields, "early").value_or(0);
  offer.starts = flag_or(fields, "starts", true);
  offer.stalls = length(fields, "stalls").value_or(0);
  if (offer.stalls > 1) throw Malformed{fields.path("stalls"), "a fraction of a family is at most 1"};
  if (const JsonValue* most = fields.optional("most_supports")) {
    const std::string at = fields.path("most_supports");
    const std::size_t count = corpus::read_index(*most, at);
    if (count == 0 || count > std::size_t{std::numeric_limits<int>::max()})
      throw Malformed{at, "a whole number from 1 to 2147483647"};
    offer.most_supports = static_cast<int>(count);
  }
  offer.takes_target_distance = flag_or(fields, "target_distance", false);
  offer.takes_pass_over = flag_or(fields, "pass_over", false);
  return offer;
}

std::string read_name(const Fields& fields) {
  constexpr std::string_view kForm = "a name is made of letters, digits and . _ -";
  std::string name = corpus::read_string(fields.required("name", kForm), fields.path("name"));
  const auto is_good = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-';
  };
  if (name.empty() || name.size() > 64 || !std::all_of(name.begin(), name.end(), is_good))
    throw Malformed{fields.path("name"), corpus::json_quote_short(name) + "; " + std::string(kForm)};
  return name;
}

Declaration read_declared(const JsonValue& value) {
  const Fields fields(
      value, "",
      {"schema", "name", "version", "about", "scalar", "shapes", "queries", "margin", "lengths",
       "infinite_t_max", "motion", "pivots", "most_turn", "most_aspect", "most_vertices", "timed"});
  const std::string schema =
      corpus::read_string(fields.required("schema", "the schema is \"graze.engine/1\""), "schema");
  if (schema != "graze.engine/1")
    throw Malformed{"schema", corpus::json_quote_short(schema) + "; it is \"graze.engine/1\""};
  Declaration out;
  out.name = read_name(fields);
  out.version = text_or_nothing(fields, "version");
  out.about = text_or_nothing(fields, "about");
  out.scalar =
      kScalars[corpus::read_choice(fields.required("scalar", "float or double"), "scalar", kScalars)];
  constexpr std::string_view kShapesForm = "shapes is an array of one or more types of the case format";
  const std::vector<JsonValue>& shapes =
      corpus::read_array(fields.required("shapes", kShapesForm), "shapes", kShapesForm);
  if (shapes.empty()) throw Malformed{"shapes", "an empty array; " + std::string(kShapesForm)};
  for (std::size_t i = 0; i < shapes.size(); ++i)
    out.shapes.emplace_back(kShapes[corpus::read_choice(shapes[i], corpus::item_path("shapes", i), kShapes)]);
  constexpr std::string_view kQueriesForm = "queries is an object with one or more queries";
  const JsonValue& queries = fields.required("queries", kQueriesForm);
  const bool is_object = queries.kind == JsonValue::Kind::object;
  if (!is_object || queries.items.empty())
    throw Malformed{"queries", (is_object ? "an object without one" : describe(queries)) + "; " +
                                   std::string(kQueriesForm) + ": " + corpus::joined(kQuestions)};
  for (std::size_t i = 0; i < queries.items.size(); ++i)
    out.offers.push_back(
        read_offer(queries.keys[i], queries.items[i], corpus::child_path("queries", queries.keys[i])));
  out.margin = length(fields, "margin").value_or(0);
  if (const JsonValue* lengths = fields.optional("lengths")) {
    constexpr std::string_view kForm = "lengths is [least, most], 0 < least <= most / 2";
    const std::vector<JsonValue>& both = corpus::read_array(*lengths, "lengths", kForm);
    if (both.size() != 2) throw Malformed{"lengths", describe(*lengths) + "; " + std::string(kForm)};
    out.lengths = {.least = corpus::read_number(both[0], "lengths[0]"),
                   .most = corpus::read_number(both[1], "lengths[1]")};
    // A power of two brings any scale into a range that is as wide as one.
    if (!(0 < out.lengths->least && out.lengths->least <= out.lengths->most / 2))
      throw Malformed{"lengths", std::string(kForm)};
  }
  out.infinite_t_max = flag_or(fields, "infinite_t_max", false);
  if (const JsonValue* motion = fields.optional("motion"))
    out.relative_motion = corpus::read_choice(*motion, "motion", kMotions) == 1;
  out.pivots = flag_or(fields, "pivots", true);
  out.most_turn = length(fields, "most_turn");
  out.most_aspect = length(fields, "most_aspect");
  if (const JsonValue* most = fields.optional("most_vertices"))
    out.most_vertices = corpus::read_index(*most, "most_vertices");
  out.timed = flag_or(fields, "timed", false);
  return out;
}

}  // namespace

std::string_view to_text(Question question) { return kQuestions[static_cast<std::size_t>(question)]; }

bool Declaration::takes(std::string_view shape) const {
  return std::find(shapes.begin(), shapes.end(), shape) != shapes.end();
}

std::span<const std::string_view> shape_names() { return kShapes; }

Declaration parse_declaration(std::string_view line) {
  const corpus::ParsedJson parsed = corpus::parse_json(line);
  try {
    if (parsed.error) throw *parsed.error;
    return read_declared(parsed.value);
  } catch (const Malformed& bad) {
    throw std::runtime_error(bad.path.empty() ? bad.what : bad.path + ": " + bad.what);
  }
}

}  // namespace graze::external
