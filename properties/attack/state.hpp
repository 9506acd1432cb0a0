// The state of a run of the attack, so that it can be stopped, resumed, and added to others'.
#pragma once

#include <filesystem>
#include <string>

#include "properties/attack/attack.hpp"

namespace graze::attack {

// One of `of` shares of all rounds: the rounds with the numbers share, share + of, share + 2 of, ...
struct Share {
  std::uint64_t share = 0, of = 1;
};

struct State {
  std::uint64_t seed = 1;
  Share share;
  Settings settings;
  std::uint64_t rounds = 0;  // of the share that are done
  double seconds = 0;
  Tally tally;

  [[nodiscard]] std::uint64_t next() const { return share.share + rounds * share.of; }
};

// Throws std::runtime_error, one line, for a file that cannot be read or written or has another format.
[[nodiscard]] State read_state(const std::filesystem::path& path);
// Whole or not at all: what was there before stays until the new one is written.
void write_state(const std::filesystem::path& path, const State& state);

// The reason why a run of these settings cannot resume that state. Empty if it can.
[[nodiscard]] std::string difference(const State& wanted, const State& found);

// The table in Markdown.
[[nodiscard]] std::string table_of(const State& state);

}  // namespace graze::attack
