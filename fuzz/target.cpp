#include "fuzz/target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "corpus/format/case_io.hpp"
#include "fuzz/codec.hpp"
#include "properties/edit/case.hpp"
#include "properties/laws/reach.hpp"

namespace graze::fuzz {

namespace {

constexpr std::size_t kChoiceBytes = 8;

// FNV-1a (Fowler, Noll, Vo), its bits spread.
std::uint64_t hash_of_bytes(std::span<const std::uint8_t> bytes) {
  std::uint64_t h = 0xcbf29ce484222325u;
  for (const std::uint8_t byte : bytes) h = (h ^ byte) * 0x100000001b3u;
  return law::mix(h);
}

}  // namespace

Input input_of(std::span<const std::uint8_t> bytes) {
  Decoded decoded = decode_with_tail(bytes);
  const std::span<const std::uint8_t> tail = decoded.tail;
  std::uint64_t choice = hash_of_bytes(bytes.first(bytes.size() - tail.size()));
  for (std::size_t i = 0; i < std::min(tail.size(), kChoiceBytes); ++i) {
    choice ^= static_cast<std::uint64_t>(tail[i]) << (8 * i);
  }
  return {.problem = std::move(decoded.problem), .choice = choice, .tail = tail};
}

std::optional<Bytes> bytes_of(const corpus::Case& problem, const Input& like) {
  std::optional<Bytes> bytes = encode(problem);
  if (!bytes) return std::nullopt;
  const std::uint64_t first = hash_of_bytes(*bytes) ^ like.choice;
  for (std::size_t i = 0; i < kChoiceBytes; ++i)
    bytes->push_back(static_cast<std::uint8_t>(first >> (8 * i)));
  if (like.tail.size() > kChoiceBytes) {
    bytes->insert(bytes->end(), like.tail.begin() + kChoiceBytes, like.tail.end());
  }
  return bytes;
}

Judged judge(std::span<const std::uint8_t> bytes) {
  Judged judged = kTarget.judge_text ? kTarget.judge_text(bytes) : kTarget.judge(input_of(bytes));
  judged.known = judged.finding && law::is_known_breach(judged.finding->law, judged.finding->method);
  if (judged.known) judged.finding.reset();
  return judged;
}

namespace {

// The numbers of each kind of field, in the order of map_scalars.
std::string hexfloats(const corpus::Case& problem) {
  std::string text;
  for (const double x : law::scalars(problem)) text += fmt::format(" {:a}", x);
  return text;
}

}  // namespace

std::string report(const Finding& finding) {
  std::string text = heading(finding);
  if (kTarget.judge) {
    text += fmt::format("case: {}\nnumbers:{}\n", corpus::write_case(finding.problem),
                        hexfloats(finding.problem));
    text += "look: graze show case.json --method all --out case.html, the case saved as case.json\n";
  }
  return text + finding.sides;
}

void add(Judged& judged, std::string_view law, std::string_view method, const law::LawResult& said,
         const corpus::Case& problem) {
  if (said.holding == law::Holding::not_applicable) return;
  judged.reached = true;
  if (said.holding == law::Holding::broken && !judged.finding) {
    judged.finding = Finding{std::string(law), std::string(method), said.reason, problem, {}};
  }
}

}  // namespace graze::fuzz
