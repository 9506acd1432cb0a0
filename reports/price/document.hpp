// The measurements of graze price, as they are written, read, drawn and compared: graze.price/1
// (docs/schemas/graze.price.schema.json describes each field).
//
// Times are nanoseconds per call. Errors are lengths over the scale of the question. NaN means that there is no such
// number, and is written as null.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "corpus/case.hpp"

namespace graze::price {

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct Times {
  double median = 0, mean = 0, p95 = 0, p99 = 0, worst = 0;
};
// The spread of a value that each round measures once.
struct Spread {
  double median = 0, low = 0, high = 0;
};
struct ErrorQuantiles {
  double median = kNone, p99 = kNone, worst = kNone;
};
struct Work {
  double mean = kNone, worst = kNone;
};
struct Failures {
  std::size_t not_converged = 0, no_time = 0, refused = 0;
};

// One contender on the cases of a table.
struct Row {
  std::string label, question, method, scalar, tier, request;
  double tolerance = 0;
  bool ours = true;
  std::size_t asked = 0;
  std::optional<Times> time = {};
  std::optional<Spread> ratio = {};
  ErrorQuantiles backward = {}, forward = {}, width = {};
  Failures failures = {};
  std::size_t wrong = 0, late = 0, proved = 0;
  double denied = kNone, late_by = kNone;
  Work iterations = {}, supports = {};
  bool on_front = false;
  std::string worst_case = {}, slowest_case = {};
};

struct TruthCounts {
  std::size_t exact = 0, bracket = 0, proof = 0, open = 0;
};

// A case that a row names.
struct Shown {
  std::string id, outcome;
  std::optional<std::pair<double, double>> toi = {};
  std::string written = {};  // as JSON, empty if it is too large to be kept
};

enum class Part : std::uint8_t { family, growth, request, query };

struct PriceTable {
  Part part = Part::family;
  std::string series = {};
  double x = kNone;
  std::string x_name = {}, name = {}, group = {}, kind = {}, title = {}, sentence = {};
  std::size_t cases = 0;
  TruthCounts truth = {};
  std::string baseline = {};
  std::vector<Row> rows = {};
  std::vector<Shown> shown = {};

  [[nodiscard]] const Row* find(const std::string& label) const;
};

struct Machine {
  std::string processor, compiler, build;
  std::size_t cores = 0;
  double load = kNone;
};

struct Sentence {
  std::string topic, text;
};

// The contender recommended for a user (reports/price/advice.hpp), over the cases of `tables` tables. An empty label
// means that none of them keeps the rule.
struct Advice {
  std::string user = {}, wants = {}, bodies = {};  // "a game", its requirement, "that rotate"
  std::string label = {}, call = {}, baseline = {};
  Spread cost = {};                      // over the baseline's time: the tables' geometric mean, and the ends
  double worst = kNone, denied = kNone;  // error over scale, distance of wrong verdicts from a tie
  std::size_t tables = 0, asked = 0, wrong = 0;
  std::string because = {};
};

struct Document {
  std::string version, effort;
  std::uint64_t seed = 1;
  int rounds = 1;
  bool finished = true;
  double seconds = 0;
  Machine machine = {};
  std::vector<PriceTable> tables = {};
  std::vector<Advice> advice = {};
  std::vector<Sentence> sentences = {};

  [[nodiscard]] const PriceTable* find(const std::string& name) const;
};

// One line. Throws std::runtime_error, one line that names the field, for text that is no such document.
[[nodiscard]] std::string write_document(const Document& document);
[[nodiscard]] Document read_document(const std::string& text, const std::string& file);
// A line of names, then one a row of every table.
[[nodiscard]] std::string csv_of(const Document& document);

// The processor, the compiler and the load of this machine.
[[nodiscard]] Machine this_machine();

}  // namespace graze::price
