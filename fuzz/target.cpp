#include "fuzz/target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "corpus/case_io.hpp"
#include "fuzz/codec.hpp"
#include "properties/case_edit.hpp"

namespace graze::fuzz {

Input input_of(std::span<const std::uint8_t> bytes) {
  Decoded decoded = decode_with_tail(bytes);
  Input input{.problem = std::move(decoded.problem), .choice = 0, .tail = decoded.tail};
  if (decoded.tail.empty()) {
    input.choice = law::hash_of(input.problem);
  } else {
    const std::size_t size = std::min<std::size_t>(decoded.tail.size(), 8);
    for (std::size_t i = 0; i < size; ++i) {
      input.choice |= static_cast<std::uint64_t>(decoded.tail[i]) << (8 * i);
    }
  }
  return input;
}

std::optional<Bytes> bytes_of(const corpus::Case& problem, const Input& like) {
  std::optional<Bytes> bytes = encode(problem);
  if (!bytes) return std::nullopt;
  if (like.tail.empty()) {
    for (int i = 0; i < 8; ++i) bytes->push_back(static_cast<std::uint8_t>(like.choice >> (8 * i)));
  } else {
    bytes->insert(bytes->end(), like.tail.begin(), like.tail.end());
  }
  return bytes;
}

Judged judge(std::span<const std::uint8_t> bytes) {
  return kTarget.judge_text ? kTarget.judge_text(bytes) : kTarget.judge(input_of(bytes));
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
  std::string text = fmt::format("target: {}\nlaw: {}\nmethod: {}\nfault: {}\n", kTarget.name, finding.law,
                                 finding.method, finding.fault);
  if (kTarget.judge) {
    text += fmt::format("case: {}\nnumbers:{}\n", corpus::write_case(finding.problem),
                        hexfloats(finding.problem));
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
