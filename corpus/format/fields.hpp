// Reading typed fields out of a JsonValue. Every reader throws Malformed, which names the path of the field,
// what was wrong and what would be right. Code that reads a document catches it.
#pragma once

#include <initializer_list>
#include <span>

#include "corpus/case.hpp"
#include "corpus/format/json_value.hpp"

namespace graze::corpus {

[[nodiscard]] std::string child_path(const std::string& path, std::string_view key);
[[nodiscard]] std::string item_path(const std::string& path, std::size_t index);

// An object whose fields are all known: any other field is an error, found before anything is read.
class Fields {
 public:
  Fields(const JsonValue& value, std::string path, std::initializer_list<std::string_view> known);

  // `right` says what the field must be. It ends the message when the field is missing.
  [[nodiscard]] const JsonValue& required(std::string_view key, std::string_view right) const;
  [[nodiscard]] const JsonValue* optional(std::string_view key) const { return value_.find(key); }
  [[nodiscard]] std::string path(std::string_view key) const { return child_path(path_, key); }

 private:
  const JsonValue& value_;
  std::string path_;
};

// Describes a document whose schema is known and is not one of `own`: "holds a scene (graze.scene/1); graze
// scene answers it". Otherwise the result is empty.
[[nodiscard]] std::string held_by_another_schema(const JsonValue& value,
                                                 std::span<const std::string_view> own);

// A description of a value in words, for the first half of a message: `a string`, `an array of 2`.
[[nodiscard]] std::string describe(const JsonValue& value);

// A finite double: a JSON number, or a hexfloat string such as "0x1.8p+1".
[[nodiscard]] double read_number(const JsonValue& value, const std::string& path);
// A finite double, or "inf" or "-inf".
[[nodiscard]] double read_extended(const JsonValue& value, const std::string& path);
[[nodiscard]] double read_not_negative(const JsonValue& value, const std::string& path);
// `right` says what the array is, such as `a position is an array of three numbers`.
[[nodiscard]] Vec3<double> read_vec3(const JsonValue& value, const std::string& path, std::string_view right);
[[nodiscard]] std::string read_string(const JsonValue& value, const std::string& path);
[[nodiscard]] const std::vector<JsonValue>& read_array(const JsonValue& value, const std::string& path,
                                                       std::string_view right);
// An index 0 .. 2^32 - 1.
[[nodiscard]] std::uint32_t read_index(const JsonValue& value, const std::string& path);
// One of `names`: its position in the list.
[[nodiscard]] std::size_t read_choice(const JsonValue& value, const std::string& path,
                                      std::span<const std::string_view> names);

// "x, y or z"
[[nodiscard]] std::string joined(std::span<const std::string_view> names);

}  // namespace graze::corpus
