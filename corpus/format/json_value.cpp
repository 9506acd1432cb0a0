#include "corpus/format/json_value.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace graze::corpus {
namespace {

// Longest stretch of foreign text repeated in a message (bytes).
constexpr std::size_t kMaxQuoted = 60;
constexpr std::size_t kMaxParserMessage = 200;

// nlohmann's own words, without its prefix "[json.exception.parse_error.101] ".
std::string plain_message(std::string message) {
  if (const auto end = message.find("] "); end != std::string::npos) message.erase(0, end + 2);
  if (message.size() > kMaxParserMessage) message = message.substr(0, kMaxParserMessage) + "...";
  return message;
}

// Builds the tree from the parser's events. The parser keeps its own stack on the heap, so the depth of a
// text costs no recursion here, and the tree is never deeper than kMaxJsonDepth.
class TreeBuilder {
 public:
  JsonValue root;
  std::optional<Malformed> error;

  bool null() { return add({}); }
  bool boolean(bool value) {
    JsonValue v;
    v.kind = JsonValue::Kind::boolean;
    v.boolean = value;
    return add(std::move(v));
  }
  bool number_integer(std::int64_t value) { return add_number(static_cast<double>(value), true); }
  bool number_unsigned(std::uint64_t value) { return add_number(static_cast<double>(value), true); }
  bool number_float(double value, const std::string& text) {
    return add_number(value, text.find_first_of(".eE") == std::string::npos);
  }
  bool string(std::string& value) {
    JsonValue v;
    v.kind = JsonValue::Kind::string;
    v.text = std::move(value);
    return add(std::move(v));
  }
  bool binary(std::vector<std::uint8_t>&) { return false; }
  bool start_object(std::size_t) { return open(JsonValue::Kind::object); }
  bool start_array(std::size_t) { return open(JsonValue::Kind::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    JsonValue& object = *stack_.back();
    if (object.find(name) != nullptr) {
      return fail("the field " + json_quote_short(name) + " appears twice; each field at most once", &name);
    }
    if (object.keys.size() >= kMaxJsonFields) {
      return fail("more than " + std::to_string(kMaxJsonFields) +
                  " fields in one object; no schema has as many");
    }
    object.keys.push_back(std::move(name));
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& exception) {
    const bool overflow = exception.id == 406;
    error =
        Malformed{overflow ? path() : "", overflow ? "a number beyond the largest double; finite numbers only"
                                                   : "not JSON: " + plain_message(exception.what())};
    return false;
  }

 private:
  bool fail(std::string what, const std::string* next_key = nullptr) {
    error = Malformed{path(next_key), std::move(what)};
    return false;
  }

  // The place that the next value goes to.
  JsonValue& slot() {
    if (stack_.empty()) return root;
    return stack_.back()->items.emplace_back();
  }
  bool add(JsonValue value) {
    slot() = std::move(value);
    return true;
  }
  bool add_number(double value, bool is_integer) {
    JsonValue v;
    v.kind = JsonValue::Kind::number;
    v.number = value;
    v.is_integer = is_integer;
    return add(std::move(v));
  }
  bool open(JsonValue::Kind kind) {
    if (stack_.size() >= static_cast<std::size_t>(kMaxJsonDepth)) {
      return fail("nested deeper than " + std::to_string(kMaxJsonDepth) + " levels; no shape needs as many");
    }
    JsonValue& place = slot();
    place.kind = kind;
    // Pointers into the tree stay valid: only the last element of a container is ever open, and its
    // container grows only after it was closed.
    stack_.push_back(&place);
    return true;
  }
  bool close() {
    stack_.pop_back();
    return true;
  }

  // The place of the parser, cut after some levels: the head says where to look. At a key, it is that key's
  // field. Otherwise it is the last field of the object, which is complete.
  std::string path(const std::string* next_key = nullptr) const {
    constexpr std::size_t kMaxLevels = 8;
    std::string p;
    for (std::size_t i = 0; i < stack_.size(); ++i) {
      if (i == kMaxLevels) return p + "...";
      const JsonValue& level = *stack_[i];
      if (level.kind == JsonValue::Kind::array) {
        const bool inside = i + 1 < stack_.size();
        p += "[" + std::to_string(level.items.size() - (inside ? 1 : 0)) + "]";
      } else if (!level.keys.empty()) {
        const bool is_next = next_key != nullptr && i + 1 == stack_.size();
        const std::string& name = is_next ? *next_key : level.keys.back();
        p += (p.empty() ? "" : ".") + (name.size() > kMaxQuoted ? json_quote_short(name) : name);
      }
    }
    // A key may hold anything, and a message is one line.
    for (char& c : p) c = static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    return p;
  }

  std::vector<JsonValue*> stack_;
};

// The parser takes a NUL byte for the end of the text and would not read the rest. The result is empty if
// there is no NUL byte.
std::string nul_byte_of(std::string_view text) {
  const std::size_t at = text.find('\0');
  if (at == std::string_view::npos) return {};
  const std::string_view before = text.substr(0, at);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t column = at - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0
  return "a NUL byte at " + (line > 1 ? "line " + std::to_string(line) + ", " : std::string()) + "column " +
         std::to_string(column) + "; JSON is text without one";
}

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == key) return &items[i];
  }
  return nullptr;
}

ParsedJson parse_json(std::string_view text) {
  if (std::string nul = nul_byte_of(text); !nul.empty()) return {{}, Malformed{"", "not JSON: " + nul}};
  TreeBuilder builder;
  const bool complete = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  if (!complete && !builder.error) builder.error = Malformed{"", "not JSON"};
  return {std::move(builder.root), std::move(builder.error)};
}

std::string json_quote(std::string_view text) {
  return nlohmann::json(std::string(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_quote_short(std::string_view text) {
  if (text.size() <= kMaxQuoted) return json_quote(text);
  return json_quote(std::string(text.substr(0, kMaxQuoted)) + "...");
}

std::string json_number(double x) {
  if (std::isnan(x)) return "\"nan\"";
  if (std::isinf(x)) return x > 0 ? "\"inf\"" : "\"-inf\"";
  if (x == 0) return std::signbit(x) ? "-0.0" : "0";
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
  return std::string(buffer, end);
}

nlohmann::ordered_json parse_document(std::string_view text) {
  try {
    if (const std::string nul = nul_byte_of(text); !nul.empty())
      throw std::runtime_error("is no JSON: " + nul);
    return nlohmann::ordered_json::parse(text);
  } catch (const nlohmann::ordered_json::parse_error& error) {
    throw std::runtime_error("is no JSON: " + plain_message(error.what()));
  }
}

std::string document_text(const nlohmann::ordered_json& document, int indent) {
  return document.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace graze::corpus
