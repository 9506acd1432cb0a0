#include "reports/price/document.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "corpus/format/json_value.hpp"

namespace graze::price {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSchema = "graze.price/1";
constexpr const char* kParts[] = {"family", "growth", "request", "query"};

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json json_of(const std::optional<Times>& time) {
  if (!time) return nullptr;
  return {{"median", time->median},
          {"mean", time->mean},
          {"p95", time->p95},
          {"p99", time->p99},
          {"worst", time->worst}};
}
Json json_of(const std::optional<Spread>& spread) {
  if (!spread) return nullptr;
  return {{"median", spread->median}, {"low", spread->low}, {"high", spread->high}};
}
Json json_of(const ErrorQuantiles& errors) {
  return {{"median", number(errors.median)}, {"p99", number(errors.p99)}, {"worst", number(errors.worst)}};
}
Json json_of(const Work& work) { return {{"mean", number(work.mean)}, {"worst", number(work.worst)}}; }

Json json_of(const Row& row) {
  return {{"label", row.label},
          {"question", row.question},
          {"method", row.method},
          {"scalar", row.scalar},
          {"tier", row.tier},
          {"tolerance", row.tolerance},
          {"request", row.request},
          {"ours", row.ours},
          {"asked", row.asked},
          {"time", json_of(row.time)},
          {"ratio", json_of(row.ratio)},
          {"backward", json_of(row.backward)},
          {"forward", json_of(row.forward)},
          {"width", json_of(row.width)},
          {"failures",
           {{"not_converged", row.failures.not_converged},
            {"no_time", row.failures.no_time},
            {"refused", row.failures.refused}}},
          {"wrong", row.wrong},
          {"denied", number(row.denied)},
          {"late", row.late},
          {"late_by", number(row.late_by)},
          {"proved", row.proved},
          {"iterations", json_of(row.iterations)},
          {"supports", json_of(row.supports)},
          {"on_front", row.on_front},
          {"worst_case", row.worst_case},
          {"slowest_case", row.slowest_case}};
}

Json json_of(const PriceTable& table) {
  Json rows = Json::array(), shown = Json::array();
  for (const Row& row : table.rows) rows.push_back(json_of(row));
  for (const Shown& one : table.shown) {
    shown.push_back({{"id", one.id},
                     {"outcome", one.outcome},
                     {"toi", one.toi ? Json::array({one.toi->first, one.toi->second}) : Json(nullptr)},
                     {"case", one.written.empty() ? Json(nullptr) : corpus::parse_document(one.written)}});
  }
  return {{"part", kParts[static_cast<std::size_t>(table.part)]},
          {"series", table.series},
          {"x", number(table.x)},
          {"x_name", table.x_name},
          {"name", table.name},
          {"group", table.group},
          {"kind", table.kind},
          {"title", table.title},
          {"sentence", table.sentence},
          {"cases", table.cases},
          {"truth",
           {{"exact", table.truth.exact},
            {"bracket", table.truth.bracket},
            {"proof", table.truth.proof},
            {"open", table.truth.open}}},
          {"baseline", table.baseline},
          {"rows", std::move(rows)},
          {"shown", std::move(shown)}};
}

Json json_of(const Advice& one) {
  const bool takes = !one.label.empty();
  return {{"user", one.user},
          {"wants", one.wants},
          {"bodies", one.bodies},
          {"label", takes ? Json(one.label) : Json(nullptr)},
          {"call", takes ? Json(one.call) : Json(nullptr)},
          {"baseline", one.baseline},
          {"cost", takes ? json_of(std::optional(one.cost)) : Json(nullptr)},
          {"worst", number(one.worst)},
          {"denied", number(one.denied)},
          {"tables", one.tables},
          {"asked", one.asked},
          {"wrong", one.wrong},
          {"because", one.because}};
}

// A value of the document, and its place for error messages.
class Reader {
 public:
  Reader(const Json& value, std::string path) : value_(value), path_(std::move(path)) {}

  [[nodiscard]] Reader at(const char* field) const {
    if (!value_.is_object()) fail("is no object");
    const auto found = value_.find(field);
    const std::string path = path_.empty() ? field : path_ + "." + field;
    if (found == value_.end()) throw std::runtime_error(path + ": missing");
    return {*found, path};
  }
  [[nodiscard]] bool has(const char* field) const { return value_.is_object() && value_.contains(field); }
  [[nodiscard]] std::string text() const {
    if (!value_.is_string()) fail("is no text");
    return value_.get<std::string>();
  }
  [[nodiscard]] bool flag() const {
    if (!value_.is_boolean()) fail("is neither true nor false");
    return value_.get<bool>();
  }
  [[nodiscard]] double number() const {
    if (!value_.is_number()) fail("is no number");
    return value_.get<double>();
  }
  [[nodiscard]] double number_or_none() const { return value_.is_null() ? kNone : number(); }
  [[nodiscard]] std::size_t count() const {
    if (!value_.is_number_unsigned()) fail("is no whole number of 0 or more");
    return value_.get<std::size_t>();
  }
  [[nodiscard]] bool is_null() const { return value_.is_null(); }
  [[nodiscard]] const Json& raw() const { return value_; }
  template <class Each>
  void each(const Each& take) const {
    if (!value_.is_array()) fail("is no array");
    for (std::size_t i = 0; i < value_.size(); ++i) take(Reader(value_[i], fmt::format("{}[{}]", path_, i)));
  }
  [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(path_ + ": " + what); }

 private:
  const Json& value_;
  std::string path_;
};

std::optional<Times> times_from(const Reader& in) {
  if (in.is_null()) return {};
  return Times{.median = in.at("median").number(),
               .mean = in.at("mean").number(),
               .p95 = in.at("p95").number(),
               .p99 = in.at("p99").number(),
               .worst = in.at("worst").number()};
}
std::optional<Spread> spread_from(const Reader& in) {
  if (in.is_null()) return {};
  return Spread{
      .median = in.at("median").number(), .low = in.at("low").number(), .high = in.at("high").number()};
}
ErrorQuantiles errors_from(const Reader& in) {
  return {.median = in.at("median").number_or_none(),
          .p99 = in.at("p99").number_or_none(),
          .worst = in.at("worst").number_or_none()};
}
Work work_from(const Reader& in) {
  return {.mean = in.at("mean").number_or_none(), .worst = in.at("worst").number_or_none()};
}

Row row_from(const Reader& in) {
  Row row;
  row.label = in.at("label").text();
  row.question = in.at("question").text();
  row.method = in.at("method").text();
  row.scalar = in.at("scalar").text();
  row.tier = in.at("tier").text();
  row.tolerance = in.at("tolerance").number();
  row.request = in.at("request").text();
  row.ours = in.at("ours").flag();
  row.asked = in.at("asked").count();
  row.time = times_from(in.at("time"));
  row.ratio = spread_from(in.at("ratio"));
  row.backward = errors_from(in.at("backward"));
  row.forward = errors_from(in.at("forward"));
  row.width = errors_from(in.at("width"));
  row.failures = {.not_converged = in.at("failures").at("not_converged").count(),
                  .no_time = in.at("failures").at("no_time").count(),
                  .refused = in.at("failures").at("refused").count()};
  row.wrong = in.at("wrong").count();
  row.denied = in.at("denied").number_or_none();
  row.late = in.at("late").count();
  row.late_by = in.at("late_by").number_or_none();
  row.proved = in.at("proved").count();
  row.iterations = work_from(in.at("iterations"));
  row.supports = work_from(in.at("supports"));
  row.on_front = in.at("on_front").flag();
  row.worst_case = in.at("worst_case").text();
  row.slowest_case = in.at("slowest_case").text();
  return row;
}

Part part_from(const Reader& in) {
  const std::string text = in.text();
  for (std::size_t k = 0; k < std::size(kParts); ++k) {
    if (text == kParts[k]) return static_cast<Part>(k);
  }
  in.fail(text + " is none of family, growth, request and query");
}

PriceTable table_from(const Reader& in) {
  PriceTable table;
  table.part = part_from(in.at("part"));
  table.series = in.at("series").text();
  table.x = in.at("x").number_or_none();
  table.x_name = in.at("x_name").text();
  table.name = in.at("name").text();
  table.group = in.at("group").text();
  table.kind = in.at("kind").text();
  table.title = in.at("title").text();
  table.sentence = in.at("sentence").text();
  table.cases = in.at("cases").count();
  table.truth = {.exact = in.at("truth").at("exact").count(),
                 .bracket = in.at("truth").at("bracket").count(),
                 .proof = in.at("truth").at("proof").count(),
                 .open = in.at("truth").at("open").count()};
  table.baseline = in.at("baseline").text();
  in.at("rows").each([&](const Reader& row) { table.rows.push_back(row_from(row)); });
  in.at("shown").each([&](const Reader& one) {
    Shown shown{.id = one.at("id").text(), .outcome = one.at("outcome").text()};
    if (const Reader toi = one.at("toi"); !toi.is_null()) {
      std::vector<double> ends;
      toi.each([&](const Reader& end) { ends.push_back(end.number()); });
      if (ends.size() != 2) toi.fail("is no pair of numbers");
      shown.toi = std::pair(ends[0], ends[1]);
    }
    if (const Reader written = one.at("case"); !written.is_null())
      shown.written = corpus::document_text(written.raw());
    table.shown.push_back(std::move(shown));
  });
  return table;
}

Advice advice_from(const Reader& in) {
  Advice one{.user = in.at("user").text(), .wants = in.at("wants").text(), .bodies = in.at("bodies").text()};
  if (!in.at("label").is_null()) {
    one.label = in.at("label").text();
    one.call = in.at("call").text();
  }
  one.baseline = in.at("baseline").text();
  if (const std::optional<Spread> cost = spread_from(in.at("cost"))) one.cost = *cost;
  one.worst = in.at("worst").number_or_none();
  one.denied = in.at("denied").number_or_none();
  one.tables = in.at("tables").count();
  one.asked = in.at("asked").count();
  one.wrong = in.at("wrong").count();
  one.because = in.at("because").text();
  return one;
}

std::string csv_number(double x) { return std::isfinite(x) ? fmt::format("{}", x) : ""; }

// RFC 4180: quotes are added if needed.
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace

const Row* PriceTable::find(const std::string& label) const {
  for (const Row& row : rows) {
    if (row.label == label) return &row;
  }
  return nullptr;
}

const PriceTable* Document::find(const std::string& name) const {
  for (const PriceTable& table : tables) {
    if (table.name == name) return &table;
  }
  return nullptr;
}

std::string write_document(const Document& document) {
  Json tables = Json::array(), advice = Json::array(), sentences = Json::array();
  for (const Advice& one : document.advice) advice.push_back(json_of(one));
  for (const PriceTable& table : document.tables) tables.push_back(json_of(table));
  for (const Sentence& one : document.sentences)
    sentences.push_back({{"topic", one.topic}, {"text", one.text}});
  const Json json = {{"schema", kSchema},
                     {"version", document.version},
                     {"effort", document.effort},
                     {"seed", document.seed},
                     {"rounds", document.rounds},
                     {"finished", document.finished},
                     {"seconds", document.seconds},
                     {"machine",
                      {{"processor", document.machine.processor},
                       {"cores", document.machine.cores},
                       {"compiler", document.machine.compiler},
                       {"build", document.machine.build},
                       {"load", number(document.machine.load)}}},
                     {"tables", std::move(tables)},
                     {"advice", std::move(advice)},
                     {"sentences", std::move(sentences)}};
  return corpus::document_text(json);
}

Document read_document(const std::string& text, const std::string& file) {
  try {
    const Json json = corpus::parse_document(text);
    const Reader in(json, "");
    if (!json.is_object()) throw std::runtime_error("is no object; graze price --json writes one");
    if (const std::string schema = in.at("schema").text(); schema != kSchema)
      throw std::runtime_error(fmt::format("schema: is {}, and not {}", schema, kSchema));
    Document document;
    document.version = in.at("version").text();
    document.effort = in.at("effort").text();
    document.seed = in.at("seed").count();
    document.rounds = static_cast<int>(in.at("rounds").count());
    document.finished = in.at("finished").flag();
    document.seconds = in.at("seconds").number();
    const Reader machine = in.at("machine");
    document.machine = {.processor = machine.at("processor").text(),
                        .compiler = machine.at("compiler").text(),
                        .build = machine.at("build").text(),
                        .cores = machine.at("cores").count(),
                        .load = machine.at("load").number_or_none()};
    in.at("tables").each([&](const Reader& table) { document.tables.push_back(table_from(table)); });
    // Version 0.2.0 wrote none.
    if (in.has("advice"))
      in.at("advice").each([&](const Reader& one) { document.advice.push_back(advice_from(one)); });
    in.at("sentences").each([&](const Reader& one) {
      document.sentences.push_back({.topic = one.at("topic").text(), .text = one.at("text").text()});
    });
    return document;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
}

std::string csv_of(const Document& document) {
  std::string out =
      "part,series,x,table,group,kind,cases,label,question,method,scalar,tier,tolerance,request,ours,asked,"
      "time_median_ns,time_mean_ns,time_p95_ns,time_p99_ns,time_worst_ns,ratio,ratio_low,ratio_high,"
      "backward_median,backward_p99,backward_worst,forward_median,forward_p99,forward_worst,width_median,"
      "width_p99,width_worst,not_converged,no_time,refused,wrong,denied,late,late_by,proved,iterations_mean,"
      "iterations_worst,supports_mean,supports_worst,on_front,worst_case,slowest_case\n";
  for (const PriceTable& table : document.tables) {
    for (const Row& row : table.rows) {
      std::vector<std::string> cells = {kParts[static_cast<std::size_t>(table.part)],
                                        csv_text(table.series),
                                        csv_number(table.x),
                                        csv_text(table.name),
                                        table.group,
                                        table.kind,
                                        fmt::to_string(table.cases),
                                        csv_text(row.label),
                                        row.question,
                                        csv_text(row.method),
                                        row.scalar,
                                        row.tier,
                                        csv_number(row.tolerance),
                                        csv_text(row.request),
                                        row.ours ? "true" : "false",
                                        fmt::to_string(row.asked)};
      const Times none{kNone, kNone, kNone, kNone, kNone};
      const Times& time = row.time ? *row.time : none;
      for (const double x : {time.median, time.mean, time.p95, time.p99, time.worst})
        cells.push_back(csv_number(x));
      const Spread ratio = row.ratio.value_or(Spread{kNone, kNone, kNone});
      for (const double x : {ratio.median, ratio.low, ratio.high}) cells.push_back(csv_number(x));
      for (const ErrorQuantiles* errors : {&row.backward, &row.forward, &row.width}) {
        for (const double x : {errors->median, errors->p99, errors->worst}) cells.push_back(csv_number(x));
      }
      for (const std::size_t n :
           {row.failures.not_converged, row.failures.no_time, row.failures.refused, row.wrong})
        cells.push_back(fmt::to_string(n));
      cells.push_back(csv_number(row.denied));
      cells.push_back(fmt::to_string(row.late));
      cells.push_back(csv_number(row.late_by));
      cells.push_back(fmt::to_string(row.proved));
      for (const Work* work : {&row.iterations, &row.supports}) {
        cells.push_back(csv_number(work->mean));
        cells.push_back(csv_number(work->worst));
      }
      cells.push_back(row.on_front ? "true" : "false");
      cells.push_back(csv_text(row.worst_case));
      cells.push_back(csv_text(row.slowest_case));
      out += fmt::format("{}\n", fmt::join(cells, ","));
    }
  }
  return out;
}

}  // namespace graze::price
