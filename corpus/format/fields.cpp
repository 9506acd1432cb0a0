#include "corpus/format/fields.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "corpus/format/names.hpp"

namespace graze::corpus {
namespace {

constexpr std::string_view kNumberForms = "a finite decimal, or a hexfloat string such as \"0x1.8p+1\"";

// [+-] 0x digits [. digits] p [+-] digits: then strtod rounds it to nearest and reads no more than this.
bool is_hexfloat(const std::string& s) {
  std::size_t i = 0;
  const auto digits = [&](auto is_digit) {
    const std::size_t start = i;
    while (i < s.size() && is_digit(static_cast<unsigned char>(s[i]))) ++i;
    return i - start;
  };
  const auto hex = [](unsigned char c) { return std::isxdigit(c) != 0; };
  const auto decimal = [](unsigned char c) { return std::isdigit(c) != 0; };
  const auto sign = [&] { i += i < s.size() && (s[i] == '+' || s[i] == '-') ? 1 : 0; };
  sign();
  if (s.compare(i, 2, "0x") != 0) return false;
  i += 2;
  std::size_t mantissa = digits(hex);
  if (i < s.size() && s[i] == '.') {
    ++i;
    mantissa += digits(hex);
  }
  if (mantissa == 0 || i >= s.size() || s[i] != 'p') return false;
  ++i;
  sign();
  return digits(decimal) > 0 && i == s.size();
}

}  // namespace

std::string child_path(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

std::string item_path(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

std::string joined(std::span<const std::string_view> names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
    text += names[i];
  }
  return text;
}

std::string held_by_another_schema(const JsonValue& value, std::span<const std::string_view> own) {
  struct Held {
    std::string_view schema, what, reader;
  };
  constexpr Held kHeld[] = {
      {kCaseSchema, "a case", "graze cast answers it"},
      {kSecondCaseSchema, "a case", "graze cast answers it"},
      {"graze.scene/1", "a scene", "graze scene answers it"},
      {"graze.events/1", "the events of a scene", "graze scene --json writes it"},
      {"graze.proof/1", "a proof", "graze check checks it"},
      {"graze.question/1", "a question", "graze serve answers it"},
      {"graze.answer/1", "an answer", "graze judge judges it"},
      {"graze.engine/1", "what an engine says of itself", "graze judge --engine-file reads it"},
      {"graze.campaign/2", "the state of a campaign", "graze merge reads it"},
      {"graze.price/1", "what graze price measured", "graze compare reads it"},
      {"graze.certification/1", "what was counted", "graze certify --json writes it"},
      {"graze.guarantees/1", "a table of guarantees", "graze certify --guarantees reads it"},
  };
  const JsonValue* schema = value.kind == JsonValue::Kind::object ? value.find("schema") : nullptr;
  if (schema == nullptr || schema->kind != JsonValue::Kind::string) return {};
  if (std::find(own.begin(), own.end(), schema->text) != own.end()) return {};
  for (const Held& held : kHeld) {
    if (schema->text == held.schema)
      return std::string("holds ").append(held.what) + " (" + schema->text + "); " + std::string(held.reader);
  }
  return {};
}

std::string describe(const JsonValue& value) {
  switch (value.kind) {
    case JsonValue::Kind::null:
      return "null";
    case JsonValue::Kind::boolean:
      return value.boolean ? "true" : "false";
    case JsonValue::Kind::number:
      return "the number " + json_number(value.number);
    case JsonValue::Kind::string:
      return "the string " + json_quote_short(value.text);
    case JsonValue::Kind::array:
      return "an array of " + std::to_string(value.items.size());
    case JsonValue::Kind::object:
      return "an object";
  }
  return "unknown";
}

Fields::Fields(const JsonValue& value, std::string path, std::initializer_list<std::string_view> known)
    : value_(value), path_(std::move(path)) {
  const std::span<const std::string_view> names(known.begin(), known.size());
  if (value.kind != JsonValue::Kind::object) {
    throw Malformed{path_, describe(value) + "; an object with the fields " + joined(names)};
  }
  for (const std::string& name : value.keys) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw Malformed{path_, "unknown field " + json_quote_short(name) + "; known fields: " + joined(names)};
    }
  }
}

const JsonValue& Fields::required(std::string_view key, std::string_view right) const {
  const JsonValue* found = value_.find(key);
  if (found == nullptr) throw Malformed{path(key), "missing; " + std::string(right)};
  return *found;
}

double read_number(const JsonValue& value, const std::string& path) {
  if (value.kind == JsonValue::Kind::number) return value.number;
  if (value.kind == JsonValue::Kind::string && is_hexfloat(value.text)) {
    const double x = std::strtod(value.text.c_str(), nullptr);
    if (std::isfinite(x)) return x;
    throw Malformed{path, describe(value) + " is beyond the largest double; finite numbers only"};
  }
  throw Malformed{path, describe(value) + "; " + std::string(kNumberForms)};
}

double read_extended(const JsonValue& value, const std::string& path) {
  if (value.kind == JsonValue::Kind::string && value.text == "inf") return kInfinity<double>;
  if (value.kind == JsonValue::Kind::string && value.text == "-inf") return -kInfinity<double>;
  return read_number(value, path);
}

double read_not_negative(const JsonValue& value, const std::string& path) {
  const double x = read_number(value, path);
  if (x < 0) throw Malformed{path, json_number(x) + " is negative; zero or more"};
  return x;
}

Vec3<double> read_vec3(const JsonValue& value, const std::string& path, std::string_view right) {
  if (value.kind == JsonValue::Kind::null) throw Malformed{path, "missing; " + std::string(right)};
  if (value.kind != JsonValue::Kind::array || value.items.size() != 3) {
    throw Malformed{path, describe(value) + "; " + std::string(right)};
  }
  Vec3<double> v;
  for (int i = 0; i < 3; ++i) v[i] = read_number(value.items[i], item_path(path, i));
  return v;
}

std::string read_string(const JsonValue& value, const std::string& path) {
  if (value.kind != JsonValue::Kind::string) throw Malformed{path, describe(value) + "; a string"};
  return value.text;
}

const std::vector<JsonValue>& read_array(const JsonValue& value, const std::string& path,
                                         std::string_view right) {
  if (value.kind != JsonValue::Kind::array)
    throw Malformed{path, describe(value) + "; " + std::string(right)};
  return value.items;
}

std::uint32_t read_index(const JsonValue& value, const std::string& path) {
  const bool integer = value.kind == JsonValue::Kind::number && value.is_integer;
  if (!integer || value.number < 0 || value.number > 4294967295.0) {
    throw Malformed{path, describe(value) + "; an index is an integer from 0"};
  }
  return static_cast<std::uint32_t>(value.number);
}

std::size_t read_choice(const JsonValue& value, const std::string& path,
                        std::span<const std::string_view> names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (value.kind == JsonValue::Kind::string && value.text == names[i]) return i;
  }
  throw Malformed{path, describe(value) + "; one of " + joined(names)};
}

}  // namespace graze::corpus
