// A small JSON tree, in the order of the text, with features that case files need and a general parser lacks:
//   - a bound on nesting (checked while parsing, before anything is built on the stack),
//   - duplicate keys as errors,
//   - numbers beyond the largest double as errors,
//   - every error as a value of one line.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace graze::corpus {

struct JsonValue {
  enum class Kind { null, boolean, number, string, array, object };

  Kind kind = Kind::null;
  bool boolean = false;
  double number = 0;              // the double nearest to the decimal
  bool is_integer = false;        // the number was written without a point or an exponent
  std::string text;               // text of a string
  std::vector<JsonValue> items;   // items of an array, or the values of an object
  std::vector<std::string> keys;  // keys of an object: items[i] is the value of keys[i]

  [[nodiscard]] const JsonValue* find(std::string_view key) const;
};

// The error in a text, with its place if it is known: the path of a field, such as a.shape.vertices[3].
struct Malformed {
  std::string path;
  std::string what;
};

// The deepest nesting that is read. A case needs 5 levels, and at most 2 more for every nested combinator.
inline constexpr int kMaxJsonDepth = 64;
// The most fields that one object may have. The largest object of the schemas has fewer than 24.
inline constexpr std::size_t kMaxJsonFields = 64;

struct ParsedJson {
  JsonValue value;
  std::optional<Malformed> error;
};

[[nodiscard]] ParsedJson parse_json(std::string_view text);

// A JSON string literal of `text`. Bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string json_quote(std::string_view text);
// json_quote, cut to a length fit for an error message.
[[nodiscard]] std::string json_quote_short(std::string_view text);
// The shortest decimal that reads back to the same bits. Infinities and NaN are the JSON strings "inf",
// "-inf" and "nan".
[[nodiscard]] std::string json_number(double x);

// Reads our own documents, in the library's type. Its parser and its writer cost two seconds of compilation
// in each file that names them, so they are compiled once here. Throws std::runtime_error: "is no JSON", and
// where.
[[nodiscard]] nlohmann::ordered_json parse_document(std::string_view text);
// On one line, or with `indent` spaces a level. Bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string document_text(const nlohmann::ordered_json& document, int indent = -1);

}  // namespace graze::corpus
