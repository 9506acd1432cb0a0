#include "corpus/format/proof_io.hpp"

#include "corpus/format/case_json.hpp"
#include "corpus/format/names.hpp"
#include "corpus/format/shape_json.hpp"

namespace graze::corpus {
namespace {

constexpr std::string_view kSchema = "graze.proof/1";
constexpr std::string_view kCurvedForm =
    "curved is an array of at most two points, each of an ellipsoid, a cylinder or a cone";
static_assert(kCurvedParts == 2);
constexpr std::string_view kAxisForm =
    "an axis is an array of three numbers, or an object {\"sign\", \"cross\"} with the two factors of n";
constexpr std::string_view kCrossForm = "cross is an array of two factors";
constexpr std::string_view kNearest = "nearest";
constexpr std::string_view kNearestForm = "nearest is an array of one to three pairs {\"a\", \"b\"}";
constexpr std::string_view kThen = "then";
constexpr std::string_view kCores = "cores";
constexpr std::string_view kMotion = to_text(AxisFactor::Kind::motion);
constexpr std::string_view kFactorForm =
    "a factor is an array of three numbers, \"motion\", or an object {\"from\", \"to\"} of support pairs";
constexpr std::string_view kPortalForm = "a portal is an array of at most four pairs {\"a\", \"b\"}";
constexpr std::string_view kChain = "chain";
constexpr std::string_view kChainForm =
    "a chain is an array of slices {\"end\", \"axis\", \"frame\"}, the first from t = 0 on";
constexpr std::string_view kContactForm =
    "contact is an array of at most six weighted pairs {\"a\", \"b\", \"weight\"}";
constexpr std::string_view kContactFrom = "contact_from";
constexpr auto kAxisFrameNames = core_names<AxisFrame, 3>();

Feature read_feature(const JsonValue& value, const std::string& path) {
  const Fields fields(value, path, {"vertex", "offset", "curved"});
  Feature feature;
  feature.vertex = read_index(fields.required("vertex", "the index of a vertex, 0 for a point or a sphere"),
                              fields.path("vertex"));
  if (const JsonValue* offset = fields.optional("offset")) {
    feature.offset = read_vec3(*offset, fields.path("offset"), "an offset is an array of three numbers");
  }
  if (const JsonValue* curved = fields.optional("curved")) {
    const std::string where = fields.path("curved");
    const std::vector<JsonValue>& points = read_array(*curved, where, kCurvedForm);
    if (points.size() > feature.curved.size()) {
      throw Malformed{where, describe(*curved) + "; " + std::string(kCurvedForm)};
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      feature.curved[i] = read_vec3(points[i], item_path(where, i), "a point is an array of three numbers");
    }
  }
  return feature;
}

SupportPair read_pair(const JsonValue& value, const std::string& path) {
  const Fields fields(value, path, {"a", "b"});
  return {read_feature(fields.required("a", "a point of body a"), fields.path("a")),
          read_feature(fields.required("b", "a point of body b"), fields.path("b"))};
}

AxisFactor read_factor(const JsonValue& value, const std::string& path) {
  AxisFactor factor;
  if (value.kind == JsonValue::Kind::string && value.text == kMotion) {
    factor.kind = AxisFactor::Kind::motion;
  } else if (value.kind == JsonValue::Kind::object) {
    const Fields fields(value, path, {"from", "to"});
    factor.kind = AxisFactor::Kind::difference;
    factor.from = read_pair(fields.required("from", "a support pair {\"a\", \"b\"}"), fields.path("from"));
    factor.to = read_pair(fields.required("to", "a support pair {\"a\", \"b\"}"), fields.path("to"));
  } else {
    factor.given = read_vec3(value, path, kFactorForm);
  }
  return factor;
}

// At most as many as there is room for. Returns how many.
template <std::size_t N>
int read_pairs(const JsonValue& value, const std::string& path, std::string_view right,
               std::array<SupportPair, N>& out) {
  const std::vector<JsonValue>& pairs = read_array(value, path, right);
  if (pairs.size() > N) throw Malformed{path, describe(value) + "; " + std::string(right)};
  for (std::size_t i = 0; i < pairs.size(); ++i) out[i] = read_pair(pairs[i], item_path(path, i));
  return static_cast<int>(pairs.size());
}

void read_nearest(const JsonValue& value, const std::string& path, Proof& proof) {
  const Fields fields(value, path, {kNearest, "time", kMotion, kThen});
  NearestAxis& nearest = proof.nearest;
  const JsonValue& pairs = fields.required(kNearest, kNearestForm);
  nearest.size = read_pairs(pairs, fields.path(kNearest), kNearestForm, nearest.pair);
  if (nearest.size == 0)
    throw Malformed{fields.path(kNearest), describe(pairs) + "; " + std::string(kNearestForm)};
  nearest.time = read_number(fields.required("time", "a time"), fields.path("time"));
  if (const JsonValue* motion = fields.optional(kMotion)) {
    if (motion->kind != JsonValue::Kind::boolean)
      throw Malformed{fields.path(kMotion), describe(*motion) + "; true if the foot may lie along v too"};
    nearest.motion = motion->boolean;
  }
  if (const JsonValue* then = fields.optional(kThen)) {
    proof.then = true;
    proof.factor[0] = read_factor(*then, fields.path(kThen));
  }
}

void read_axis(const JsonValue& value, const std::string& path, Proof& proof) {
  proof.has_axis = true;
  if (value.kind != JsonValue::Kind::object) {
    proof.axis = read_vec3(value, path, kAxisForm);
    return;
  }
  if (value.find(kNearest) != nullptr) {
    proof.symbolic = true;
    read_nearest(value, path, proof);
    return;
  }
  const Fields fields(value, path, {"sign", "cross"});
  proof.symbolic = true;
  const JsonValue& sign = fields.required("sign", "1 or -1");
  if (sign.kind != JsonValue::Kind::number || (sign.number != 1 && sign.number != -1)) {
    throw Malformed{fields.path("sign"), describe(sign) + "; the sign of an axis is 1 or -1"};
  }
  proof.axis_sign = sign.number < 0 ? -1 : 1;
  const std::string where = fields.path("cross");
  const JsonValue& cross = fields.required("cross", kCrossForm);
  const std::vector<JsonValue>& factors = read_array(cross, where, kCrossForm);
  if (factors.size() != proof.factor.size()) {
    throw Malformed{where, describe(cross) + "; " + std::string(kCrossForm)};
  }
  for (std::size_t i = 0; i < factors.size(); ++i) {
    proof.factor[i] = read_factor(factors[i], item_path(where, i));
  }
}

}  // namespace

Proof read_proof(const JsonValue& value, const std::string& path) {
  const Fields fields(value, path, {"toi_lower", "axis", "toi_upper", "portal", kCores});
  Proof proof;
  proof.toi_lower =
      read_extended(fields.required("toi_lower", "a time, or \"inf\" for a miss"), fields.path("toi_lower"));
  if (const JsonValue* axis = fields.optional("axis")) {
    read_axis(*axis, fields.path("axis"), proof);
  }
  proof.toi_upper = read_extended(fields.required("toi_upper", "a time, or \"inf\" for no claim"),
                                  fields.path("toi_upper"));
  const JsonValue* portal = fields.optional("portal");
  const JsonValue* cores = fields.optional(kCores);
  if (portal != nullptr && cores != nullptr)
    throw Malformed{fields.path(kCores), "the proof has a portal already; it is one of the two"};
  proof.of_cores = cores != nullptr;
  if (proof.of_cores) portal = cores;
  if (portal != nullptr) {
    const std::string where = fields.path(proof.of_cores ? kCores : "portal");
    proof.portal_size = read_pairs(*portal, where, kPortalForm, proof.portal);
  }
  return proof;
}

namespace {

TimeSlice read_slice(const JsonValue& value, const std::string& path) {
  const Fields fields(value, path, {"end", "axis", "frame"});
  TimeSlice slice;
  slice.end = read_number(fields.required("end", "the time at which the slice ends"), fields.path("end"));
  slice.axis = read_vec3(fields.required("axis", "three numbers"), fields.path("axis"),
                         "the axis of a slice is an array of three numbers");
  if (const JsonValue* frame = fields.optional("frame")) {
    slice.frame = static_cast<AxisFrame>(read_choice(*frame, fields.path("frame"), kAxisFrameNames));
  }
  return slice;
}

RotatingProof read_rotating_proof(const JsonValue& value, const std::string& path) {
  const Fields fields(value, path, {"toi_lower", kChain, "toi_upper", "contact", kContactFrom});
  RotatingProof proof;
  proof.toi_lower =
      read_extended(fields.required("toi_lower", "a time, or \"inf\" for a miss"), fields.path("toi_lower"));
  const std::string chain = fields.path(kChain);
  const std::vector<JsonValue>& slices = read_array(fields.required(kChain, kChainForm), chain, kChainForm);
  proof.chain.reserve(slices.size());
  for (std::size_t i = 0; i < slices.size(); ++i) {
    proof.chain.push_back(read_slice(slices[i], item_path(chain, i)));
  }
  proof.toi_upper = read_extended(fields.required("toi_upper", "a time, or \"inf\" for no claim"),
                                  fields.path("toi_upper"));
  if (const JsonValue* from = fields.optional(kContactFrom)) {
    proof.crossing = true;
    proof.contact_from = read_number(*from, fields.path(kContactFrom));
  }
  const JsonValue* contact = fields.optional("contact");
  if (contact == nullptr) return proof;
  const std::string where = fields.path("contact");
  const std::vector<JsonValue>& pairs = read_array(*contact, where, kContactForm);
  if (pairs.size() > proof.contact.size()) {
    throw Malformed{where, describe(*contact) + "; " + std::string(kContactForm)};
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::string item = item_path(where, i);
    const Fields pair(pairs[i], item, {"a", "b", "weight"});
    proof.contact[i] = {read_feature(pair.required("a", "a point of body a"), pair.path("a")),
                        read_feature(pair.required("b", "a point of body b"), pair.path("b"))};
    const JsonValue* weight = proof.crossing ? pair.optional("weight")
                                             : &pair.required("weight", "the weight of the pair, 0 or more");
    if (weight != nullptr) proof.weight[i] = read_number(*weight, pair.path("weight"));
    ++proof.contact_size;
  }
  return proof;
}

StatedBracket read_bracket(const JsonValue& value, const std::string& path) {
  const Fields fields(value, path, {"lower", "upper"});
  StatedBracket toi;
  toi.lower = read_extended(fields.required("lower", "a time"), fields.path("lower"));
  toi.upper = read_extended(fields.required("upper", "a time, or \"inf\""), fields.path("upper"));
  if (!(toi.lower <= toi.upper)) {
    throw Malformed{path, "lower is above upper; lower <= time of impact <= upper"};
  }
  return toi;
}

ProofRecord read_record(const JsonValue& value) {
  const Fields fields(value, "", {"schema", "case", "method", "scalar", "tier", "outcome", "toi", "proof"});
  const JsonValue& schema = fields.required("schema", "\"graze.proof/1\"");
  if (read_string(schema, "schema") != kSchema) {
    throw Malformed{"schema", describe(schema) + "; this version reads " + json_quote(kSchema)};
  }
  ProofRecord record;
  record.problem =
      case_from_json(fields.required("case", "the case that the proof is about, in full"), "case");
  record.method = read_string(fields.required("method", "the name of the method"), "method");
  record.scalar = read_string(fields.required("scalar", "\"float\" or \"double\""), "scalar");
  if (const JsonValue* tier = fields.optional("tier")) {
    record.tier = static_cast<Tier>(read_choice(*tier, "tier", kTierNames));
  }
  record.outcome = static_cast<Outcome>(
      read_choice(fields.required("outcome", "one of " + joined(kOutcomeNames)), "outcome", kOutcomeNames));
  if (const JsonValue* toi = fields.optional("toi")) record.toi = read_bracket(*toi, "toi");
  const JsonValue& proof = fields.required("proof", "an object with toi_lower and toi_upper");
  if (proof.find(kChain) != nullptr) {
    record.rotating = read_rotating_proof(proof, "proof");
  } else {
    record.proof = read_proof(proof, "proof");
  }
  return record;
}

std::string write_feature(const Feature& feature) {
  std::string text = "{\"vertex\": " + std::to_string(feature.vertex);
  if (is_set(feature.offset)) text += ", \"offset\": " + write_vec3(feature.offset);
  // Points up to the last that is not zero.
  std::size_t points = kCurvedParts;
  while (points > 0 && !is_set(feature.curved[points - 1])) --points;
  for (std::size_t i = 0; i < points; ++i) {
    text += (i == 0 ? ", \"curved\": [" : ", ") + write_vec3(feature.curved[i]);
  }
  if (points > 0) text += "]";
  return text + "}";
}

std::string write_pair(const SupportPair& pair) {
  return "{\"a\": " + write_feature(pair.a) + ", \"b\": " + write_feature(pair.b) + "}";
}

std::string write_pairs(std::span<const SupportPair> pairs, int size) {
  std::string text = "[";
  for (int i = 0; i < size; ++i) text += (i > 0 ? ", " : "") + write_pair(pairs[static_cast<std::size_t>(i)]);
  return text + "]";
}

std::string write_factor(const AxisFactor& factor) {
  switch (factor.kind) {
    case AxisFactor::Kind::given:
      return write_vec3(factor.given);
    case AxisFactor::Kind::motion:
      return json_quote(kMotion);
    case AxisFactor::Kind::difference:
      break;
  }
  return "{\"from\": " + write_pair(factor.from) + ", \"to\": " + write_pair(factor.to) + "}";
}

std::string write_linear(const Proof& proof) {
  std::string text = "{\"toi_lower\": " + json_number(proof.toi_lower);
  if (proof.has_axis) text += ", \"axis\": " + write_axis(proof);
  text += ", \"toi_upper\": " + json_number(proof.toi_upper) +
          (proof.of_cores ? ", \"cores\": " : ", \"portal\": ");
  return text + write_pairs(proof.portal, proof.portal_size) + "}";
}

std::string write_rotating(const RotatingProof& proof) {
  std::string text = "{\"toi_lower\": " + json_number(proof.toi_lower) + ", \"chain\": [";
  for (std::size_t i = 0; i < proof.chain.size(); ++i) {
    const TimeSlice& slice = proof.chain[i];
    text += (i > 0 ? ", " : "") + ("{\"end\": " + json_number(slice.end)) +
            ", \"axis\": " + write_vec3(slice.axis);
    if (slice.frame != AxisFrame::world) {
      text += ", \"frame\": " + json_quote(kAxisFrameNames[static_cast<std::size_t>(slice.frame)]);
    }
    text += "}";
  }
  text += "], \"toi_upper\": " + json_number(proof.toi_upper);
  if (proof.crossing) text += ", \"contact_from\": " + json_number(proof.contact_from);
  text += ", \"contact\": [";
  for (std::size_t i = 0; i < static_cast<std::size_t>(proof.contact_size); ++i) {
    text += (i > 0 ? ", " : "") + ("{\"a\": " + write_feature(proof.contact[i].a)) +
            ", \"b\": " + write_feature(proof.contact[i].b);
    if (!proof.crossing || proof.weight[i] != 0) text += ", \"weight\": " + json_number(proof.weight[i]);
    text += "}";
  }
  return text + "]}";
}

}  // namespace

std::string write_axis(const Proof& proof) {
  if (!proof.symbolic) return write_vec3(proof.axis);
  if (const NearestAxis& nearest = proof.nearest; nearest.size > 0) {
    std::string text = "{\"nearest\": " + write_pairs(nearest.pair, nearest.size) +
                       ", \"time\": " + json_number(nearest.time);
    if (nearest.motion) text += ", \"motion\": true";
    if (proof.then) text += ", \"then\": " + write_factor(proof.factor[0]);
    return text + "}";
  }
  return "{\"sign\": " + std::to_string(proof.axis_sign) + ", \"cross\": [" + write_factor(proof.factor[0]) +
         ", " + write_factor(proof.factor[1]) + "]}";
}

namespace {

bool is_case(const JsonValue& value) {
  const JsonValue* schema = value.kind == JsonValue::Kind::object ? value.find("schema") : nullptr;
  return schema != nullptr && schema->kind == JsonValue::Kind::string &&
         (schema->text == kCaseSchema || schema->text == kSecondCaseSchema);
}

}  // namespace

ProofReadResult read_proofs_text(std::string_view text, const std::string& name) {
  ProofReadResult result;
  std::vector<TextLine> lines = split_lines(text);
  // An object over many lines, as a case's file is: no line of it is one.
  if (lines.size() > 1 && parse_json(lines[0].text).error && !parse_json(text).error) {
    lines = {{lines[0].number, text}};
  }
  int cases = 0, first_case = 0;
  std::string schema_of_first;
  for (const TextLine& line : lines) {
    const ParsedJson parsed = parse_json(line.text);
    if (parsed.error) {
      result.errors.push_back({name, line.number, parsed.error->path, parsed.error->what});
      continue;
    }
    if (is_case(parsed.value)) {
      if (++cases == 1) {
        first_case = line.number;
        schema_of_first = parsed.value.find("schema")->text;
      }
      continue;
    }
    try {
      result.proofs.push_back(read_record(parsed.value));
      result.proofs.back().line = line.number;
    } catch (const Malformed& error) {
      result.errors.push_back({name, line.number, error.path, error.what});
    }
  }
  if (cases > 0) {
    result.errors.push_back({name, first_case, "schema",
                             "holds " + (cases == 1 ? "a case" : std::to_string(cases) + " cases") + " (" +
                                 schema_of_first +
                                 "), not proofs (graze.proof/1); `graze cast --proof PROOFS "
                                 "CASES` writes the proofs of a file of cases"});
  }
  if (result.proofs.empty() && result.errors.empty()) {
    result.errors.push_back({name, 0, "", "holds no proof; one JSON object a line, schema graze.proof/1"});
  }
  return result;
}

ProofReadResult read_proofs_file(const std::filesystem::path& path) {
  FileText file = read_whole_file(path.string());
  if (!file.error.empty()) return {{}, {{path.string(), 0, "", std::move(file.error)}}};
  return read_proofs_text(file.text, path.string());
}

std::string write_proof(const Proof& proof) { return write_linear(proof); }

std::string write_proof(const ProofRecord& record) {
  return "{\"schema\": \"graze.proof/1\", \"case\": " + write_case(record.problem) +
         ", \"method\": " + json_quote(record.method) + ", \"scalar\": " + json_quote(record.scalar) +
         (record.tier ? ", \"tier\": " + json_quote(kTierNames[static_cast<std::size_t>(*record.tier)])
                      : "") +
         ", \"outcome\": " + json_quote(name_of(record.outcome)) +
         (record.toi ? ", \"toi\": {\"lower\": " + json_number(record.toi->lower) +
                           ", \"upper\": " + json_number(record.toi->upper) + "}"
                     : "") +
         ", \"proof\": " + (record.rotating ? write_rotating(*record.rotating) : write_linear(record.proof)) +
         "}";
}

}  // namespace graze::corpus
