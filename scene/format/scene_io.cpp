#include "scene/format/scene_io.hpp"

#include <map>

#include "corpus/format/case_json.hpp"
#include "corpus/format/names.hpp"
#include "corpus/format/shape_json.hpp"

namespace graze::scene {
namespace {

using corpus::Fields;
using corpus::JsonValue;
using corpus::Malformed;

constexpr std::array<std::string_view, 3> kRequestNames = {"normal", "witnesses", "proof"};
constexpr std::array<std::string_view, 2> kProbeAsks = {"first", "all"};

template <class Enum, std::size_t kCount>
constexpr std::array<std::string_view, kCount> names_of() {
  std::array<std::string_view, kCount> names;
  for (std::size_t k = 0; k < kCount; ++k) names[k] = to_text(static_cast<Enum>(k));
  return names;
}
constexpr auto kAskNames = names_of<Ask, kAsks>();

// Shapes that bodies share by name.
using Shapes = std::map<std::string, Shape<double>>;

std::string read_name(const Fields& fields, std::map<std::string, std::string>& taken) {
  const std::string path = fields.path("name");
  std::string name = corpus::read_string(fields.required("name", "a name of its own, a string"), path);
  if (name.empty()) throw Malformed{path, "an empty name; a name of its own"};
  const auto [at, fresh] = taken.emplace(name, path);
  if (!fresh) {
    throw Malformed{path, corpus::json_quote_short(name) + " is named by " + at->second +
                              " already; each has its own name"};
  }
  return name;
}

Shape<double> read_shape_of(const Fields& fields, const Shapes& shapes) {
  const std::string path = fields.path("shape");
  const JsonValue& value = fields.required("shape", "a shape, or the name of one in shapes");
  if (value.kind != JsonValue::Kind::string) return corpus::read_shape(value, path);
  const auto found = shapes.find(value.text);
  if (found != shapes.end()) return found->second;
  std::string known;
  for (const auto& [name, shape] : shapes) {
    if (known.size() > 200) {
      known += ", ...";
      break;
    }
    known += (known.empty() ? "" : ", ") + corpus::json_quote_short(name);
  }
  throw Malformed{path, "unknown shape " + corpus::json_quote_short(value.text) +
                            (known.empty() ? "; shapes names none" : "; shapes names " + known)};
}

void read_vector(const Fields& fields, std::string_view key, Vec3<double>& target) {
  if (const JsonValue* value = fields.optional(key)) {
    target = corpus::read_vec3(*value, fields.path(key), std::string(key) + " is an array of three numbers");
  }
}

Filter read_filter(const Fields& fields) {
  Filter out;
  const auto bits = [&](std::string_view key, std::uint32_t& target) {
    const JsonValue* value = fields.optional(key);
    if (value == nullptr) return;
    if (value->kind != JsonValue::Kind::number || !value->is_integer || value->number < 0 ||
        value->number > 4294967295.0) {
      throw Malformed{fields.path(key),
                      corpus::describe(*value) + "; 32 bits, as an integer from 0 to 4294967295"};
    }
    target = static_cast<std::uint32_t>(value->number);
  };
  bits("group", out.group);
  bits("mask", out.mask);
  return out;
}

RotatingBody<double> read_motion(const Fields& fields, const Shapes& shapes) {
  RotatingBody<double> out;
  out.body.shape = read_shape_of(fields, shapes);
  read_vector(fields, "position", out.body.position);
  if (const JsonValue* q = fields.optional("orientation")) {
    out.body.orientation = corpus::read_orientation(*q, fields.path("orientation"));
  }
  read_vector(fields, "displacement", out.body.displacement);
  read_vector(fields, "rotation", out.rotation);
  read_vector(fields, "pivot", out.pivot);
  return out;
}

double read_time(const Fields& fields, double otherwise) {
  const JsonValue* value = fields.optional("t_max");
  if (value == nullptr) return otherwise;
  const std::string path = fields.path("t_max");
  const double t = corpus::read_extended(*value, path);
  if (t < 0) throw Malformed{path, corpus::json_number(t) + " is negative; zero or more"};
  return t;
}

Member read_member(const Fields& fields, const Shapes& shapes, std::map<std::string, std::string>& taken) {
  Member out;
  out.name = read_name(fields, taken);
  out.body = read_motion(fields, shapes);
  out.filter = read_filter(fields);
  return out;
}

void read_probe_rest(const Fields& fields, Probe& probe) {
  probe.filter = read_filter(fields);
  if (const JsonValue* ask = fields.optional("ask")) {
    probe.first_only = corpus::read_choice(*ask, fields.path("ask"), kProbeAsks) == 0;
  }
}

Probe read_ray(const Fields& fields, std::map<std::string, std::string>& taken) {
  Probe out;
  out.name = read_name(fields, taken);
  Body<double>& body = out.body.body;
  body.shape = Point<double>{};
  constexpr std::string_view kForm = "an array of three numbers";
  body.position = corpus::read_vec3(fields.required("origin", kForm), fields.path("origin"), kForm);
  body.displacement =
      corpus::read_vec3(fields.required("displacement", kForm), fields.path("displacement"), kForm);
  out.t_max = read_time(fields, kInfinity<double>);
  read_probe_rest(fields, out);
  return out;
}

Probe read_cast(const Fields& fields, const Shapes& shapes, std::map<std::string, std::string>& taken) {
  Probe out;
  out.name = read_name(fields, taken);
  out.body = read_motion(fields, shapes);
  out.t_max = read_time(fields, 1);
  read_probe_rest(fields, out);
  return out;
}

Request read_request(const JsonValue& value, const std::string& path) {
  Request out = Request::verdict;
  const auto& items = corpus::read_array(value, path, "an array of normal, witnesses and proof");
  for (std::size_t k = 0; k < items.size(); ++k) {
    const std::size_t bit = corpus::read_choice(items[k], corpus::item_path(path, k), kRequestNames);
    out = out | static_cast<Request>(1u << bit);
  }
  return out;
}

template <class Read>
void for_each_item(const Fields& fields, std::string_view key, const Read& read) {
  const JsonValue* value = fields.optional(key);
  if (value == nullptr) return;
  const std::string path = fields.path(key);
  const auto& items = corpus::read_array(*value, path, "an array of objects");
  for (std::size_t k = 0; k < items.size(); ++k) read(items[k], corpus::item_path(path, k));
}

void read_options(const Fields& fields, Options& options) {
  if (const JsonValue* tier = fields.optional("tier")) {
    options.tier = static_cast<Tier>(corpus::read_choice(*tier, fields.path("tier"), corpus::kTierNames));
  }
  if (const JsonValue* ask = fields.optional("ask")) {
    options.ask = static_cast<Ask>(corpus::read_choice(*ask, fields.path("ask"), kAskNames));
  }
  if (const JsonValue* request = fields.optional("request")) {
    options.request = read_request(*request, fields.path("request"));
  }
  options.t_max = read_time(fields, 1);
  if (!(options.t_max < kInfinity<double>)) {
    throw Malformed{fields.path("t_max"), "infinite; a step has an end, only a ray or a cast needs none"};
  }
  const auto length = [&](std::string_view key, double& target) {
    if (const JsonValue* value = fields.optional(key)) {
      target = corpus::read_not_negative(*value, fields.path(key));
    }
  };
  length("target_distance", options.target_distance);
  length("tolerance", options.tolerance);
}

constexpr std::array<std::string_view, 1> kSchemas = {kSceneSchema};

Document document_from(const JsonValue& value) {
  if (std::string held = corpus::held_by_another_schema(value, kSchemas); !held.empty())
    throw Malformed{"", std::move(held)};
  const Fields fields(value, "",
                      {"schema", "id", "comment", "tier", "ask", "request", "t_max", "target_distance",
                       "tolerance", "shapes", "bodies", "rays", "casts"});
  (void)corpus::read_choice(fields.required("schema", "\"graze.scene/1\""), "schema", kSchemas);
  Document out;
  out.id = corpus::read_string(fields.required("id", "a name for the scene"), "id");
  if (out.id.empty()) throw Malformed{"id", "an empty string; a name for the scene"};
  if (const JsonValue* comment = fields.optional("comment"))
    out.comment = corpus::read_string(*comment, "comment");
  read_options(fields, out.options);
  Shapes shapes;
  std::map<std::string, std::string> shape_names, body_names, probe_names;
  for_each_item(fields, "shapes", [&](const JsonValue& item, const std::string& path) {
    const Fields named(item, path, {"name", "shape"});
    const std::string name = read_name(named, shape_names);
    shapes.emplace(
        name, corpus::read_shape(named.required("shape", "the shape of that name"), named.path("shape")));
  });
  for_each_item(fields, "bodies", [&](const JsonValue& item, const std::string& path) {
    const Fields body(
        item, path,
        {"name", "shape", "position", "orientation", "displacement", "rotation", "pivot", "group", "mask"});
    out.scene.bodies.push_back(read_member(body, shapes, body_names));
  });
  for_each_item(fields, "rays", [&](const JsonValue& item, const std::string& path) {
    const Fields one(item, path, {"name", "origin", "displacement", "t_max", "group", "mask", "ask"});
    out.scene.probes.push_back(read_ray(one, probe_names));
  });
  for_each_item(fields, "casts", [&](const JsonValue& item, const std::string& path) {
    const Fields one(item, path,
                     {"name", "shape", "position", "orientation", "displacement", "rotation", "pivot",
                      "t_max", "group", "mask", "ask"});
    out.scene.probes.push_back(read_cast(one, shapes, probe_names));
  });
  return out;
}

std::string filter_text(const Filter& filter) {
  std::string text;
  if (filter.group != 1) text += ", \"group\": " + std::to_string(filter.group);
  if (filter.mask != ~std::uint32_t{0}) text += ", \"mask\": " + std::to_string(filter.mask);
  return text;
}

// The fields of a body, after its name.
std::string motion_text(const RotatingBody<double>& moving) {
  const std::string body = corpus::write_body(moving.body, {moving.rotation, moving.pivot});
  return body.substr(1, body.size() - 2);
}

bool is_ray(const Probe& probe) {
  return std::holds_alternative<Point<double>>(probe.body.body.shape) && !(probe.t_max < kInfinity<double>);
}

template <class Item, class Write>
std::string list_text(const char* key, const std::vector<Item>& items, const Write& write) {
  std::string text;
  for (const Item& item : items) {
    const std::string one = write(item);
    if (!one.empty()) text += std::string(text.empty() ? "" : ",") + "\n  " + one;
  }
  return text.empty() ? "" : std::string(",\n \"") + key + "\": [" + text + "]";
}

}  // namespace

ReadResult read_scene_text(std::string_view text, const std::string& name) {
  ReadResult out;
  const corpus::ParsedJson parsed = corpus::parse_json(text);
  if (parsed.error) {
    out.errors.push_back({name, 0, parsed.error->path, parsed.error->what});
    return out;
  }
  try {
    Document document = document_from(parsed.value);
    if (std::string why = why_invalid(document.scene, document.options); !why.empty()) {
      out.errors.push_back({name, 0, "", why});
      return out;
    }
    out.document = std::move(document);
  } catch (const Malformed& error) {
    out.errors.push_back({name, 0, error.path, error.what});
  }
  return out;
}

ReadResult read_scene_file(const std::string& path) {
  const corpus::FileText file = corpus::read_whole_file(path);
  if (!file.error.empty()) return {{}, {{path, 0, "", file.error}}};
  return read_scene_text(file.text, path);
}

std::string write_scene(const Document& document) {
  const Options& options = document.options;
  std::string text =
      "{\"schema\": " + corpus::json_quote(kSceneSchema) + ", \"id\": " + corpus::json_quote(document.id);
  if (!document.comment.empty()) text += ",\n \"comment\": " + corpus::json_quote(document.comment);
  text += ",\n \"tier\": " + corpus::json_quote(to_text(options.tier)) +
          ", \"ask\": " + corpus::json_quote(to_text(options.ask)) +
          ", \"t_max\": " + corpus::json_number(options.t_max);
  std::string request;
  for (std::size_t k = 0; k < kRequestNames.size(); ++k) {
    if (!asks_for(options.request, static_cast<Request>(1u << k))) continue;
    request += (request.empty() ? "" : ", ") + corpus::json_quote(kRequestNames[k]);
  }
  text += ", \"request\": [" + request + "]";
  if (options.target_distance != 0) {
    text += ", \"target_distance\": " + corpus::json_number(options.target_distance);
  }
  if (options.tolerance != 0) text += ", \"tolerance\": " + corpus::json_number(options.tolerance);
  text += list_text("bodies", document.scene.bodies, [](const Member& member) {
    return "{\"name\": " + corpus::json_quote(member.name) + ", " + motion_text(member.body) +
           filter_text(member.filter) + "}";
  });
  const auto asked = [](const Probe& probe) {
    return filter_text(probe.filter) + (probe.first_only ? "" : ", \"ask\": \"all\"") + "}";
  };
  text += list_text("rays", document.scene.probes, [&](const Probe& probe) {
    if (!is_ray(probe)) return std::string();
    return "{\"name\": " + corpus::json_quote(probe.name) +
           ", \"origin\": " + corpus::write_vec3(probe.body.body.position) +
           ", \"displacement\": " + corpus::write_vec3(probe.body.body.displacement) + asked(probe);
  });
  text += list_text("casts", document.scene.probes, [&](const Probe& probe) {
    if (is_ray(probe)) return std::string();
    return "{\"name\": " + corpus::json_quote(probe.name) + ", " + motion_text(probe.body) +
           ", \"t_max\": " + corpus::json_number(probe.t_max) + asked(probe);
  });
  return text + "}\n";
}

}  // namespace graze::scene
