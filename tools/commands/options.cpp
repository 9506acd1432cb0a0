#include "tools/commands/options.hpp"

#include <fmt/format.h>

#include <charconv>

namespace graze::tool {

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) {
  return {[=](const std::string& text) {
            std::uint64_t value = 0;
            const char* const end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, value);
            const bool good = error == std::errc() && stop == end && least <= value && value <= most;
            return good ? std::string()
                        : fmt::format("{} is no whole number from {} to {}", text, least, most);
          },
          ""};
}

CLI::Validator number_from(double least, double most) {
  return {[=](const std::string& text) {
            double value = 0;
            const char* const end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, value);
            if (error == std::errc() && stop == end && least <= value && value <= most) return std::string();
            if (least == std::numeric_limits<double>::lowest()) return text + " is no finite number";
            return most < std::numeric_limits<double>::max()
                       ? fmt::format("{} is no number from {} to {}", text, least, most)
                       : fmt::format("{} is no number of {} or more", text, least);
          },
          ""};
}

CLI::Validator seed_number() { return whole_number(0, std::numeric_limits<std::uint64_t>::max()); }

void refuse_empty_values(CLI::App& app) {
  const CLI::Validator is_not_empty(
      [](const std::string& text) { return std::string(text.empty() ? "is given nothing" : ""); }, "");
  for (CLI::Option* option : app.get_options()) {
    if (option->get_items_expected_max() > 0) option->check(is_not_empty);
  }
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) refuse_empty_values(*command);
}

std::string shell_word(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-./:=,+@%") == std::string::npos;
  if (plain) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace graze::tool
