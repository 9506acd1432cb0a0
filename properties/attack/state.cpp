#include "properties/attack/state.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "corpus/format/json_value.hpp"

namespace graze::attack {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kSchema = "graze.attack/1";

Json json_of(const Count& count) {
  return {{"agreed", count.agreed},
          {"refused", count.refused},
          {"undecided", count.undecided},
          {"contradicted", count.contradicted}};
}
Count count_of(const Json& json) {
  return {.refused = json.at("refused"),
          .agreed = json.at("agreed"),
          .undecided = json.at("undecided"),
          .contradicted = json.at("contradicted")};
}

std::string row_of(std::string_view name, const Count& count) {
  const std::uint64_t accepted = count.agreed + count.undecided + count.contradicted;
  return fmt::format("| {} | {} | {} | {} | {} | {} |\n", name, accepted, count.agreed, count.contradicted,
                     count.undecided, count.refused);
}

}  // namespace

State read_state(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  try {
    const Json json = corpus::parse_document(
        std::string{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()});
    if (json.at("schema") != kSchema) throw std::runtime_error("");
    State state{
        .seed = json.at("seed"),
        .share = {json.at("share"), json.at("of")},
        .settings = {.flush_subnormals = json.at("flush_subnormals"), .kappa = json.value("kappa", 0.0)},
        .rounds = json.at("rounds"),
        .seconds = json.at("seconds"),
        .tally = {}};
    state.tally.bases = json.at("bases");
    state.tally.refused_bases = json.at("refused_bases");
    state.tally.same = json.at("same_meaning");
    state.tally.all = count_of(json.at("all"));
    for (std::size_t k = 0; k < kEdits; ++k)
      state.tally.by_class[k] = count_of(json.at("classes").at(std::string(kEditNames[k])));
    return state;
  } catch (const std::exception&) {
    throw std::runtime_error(path.string() + ": is no " + kSchema + " state; delete it to begin anew");
  }
}

void write_state(const std::filesystem::path& path, const State& state) {
  Json json = {{"schema", kSchema},
               {"seed", state.seed},
               {"share", state.share.share},
               {"of", state.share.of},
               {"flush_subnormals", state.settings.flush_subnormals},
               {"kappa", state.settings.kappa},
               {"rounds", state.rounds},
               {"seconds", state.seconds},
               {"bases", state.tally.bases},
               {"refused_bases", state.tally.refused_bases},
               {"same_meaning", state.tally.same},
               {"all", json_of(state.tally.all)}};
  for (std::size_t k = 0; k < kEdits; ++k)
    json["classes"][std::string(kEditNames[k])] = json_of(state.tally.by_class[k]);
  std::filesystem::path fresh = path;
  fresh += ".new";
  {
    std::ofstream out(fresh);
    out << corpus::document_text(json, 1) << "\n";
    out.close();
    if (!out) throw std::runtime_error(fresh.string() + ": cannot be written");
  }
  std::error_code failed;
  std::filesystem::rename(fresh, path, failed);
  if (failed) throw std::runtime_error(path.string() + ": cannot be written: " + failed.message());
}

std::string difference(const State& wanted, const State& found) {
  if (wanted.seed != found.seed)
    return fmt::format("the seed is {} here and {} there", wanted.seed, found.seed);
  if (wanted.share.share != found.share.share || wanted.share.of != found.share.of) {
    return fmt::format("the shard is {}/{} here and {}/{} there", wanted.share.share + 1, wanted.share.of,
                       found.share.share + 1, found.share.of);
  }
  if (wanted.settings.flush_subnormals != found.settings.flush_subnormals)
    return "one flushes subnormal numbers, the other does not";
  if (wanted.settings.kappa != found.settings.kappa) return "another kappa";
  return {};
}

std::string table_of(const State& state) {
  const Tally& tally = state.tally;
  std::string out = "| class | accepted | oracles agree | contradicted | undecided | refused |\n";
  out += "|---|---|---|---|---|---|\n";
  for (std::size_t k = 0; k < kEdits; ++k) {
    out += row_of(kEditNames[k], tally.by_class[k]);
  }
  out += row_of("all", tally.all);
  out += fmt::format(
      "\n{} true proofs ({} more were refused), {} rounds, {:.0f} s, {:.0f} accepted and agreed a second; {} "
      "accepted mutants more meant the same. A mutant of several classes counts in each.\n",
      tally.bases, tally.refused_bases, state.rounds, state.seconds,
      state.seconds > 0 ? static_cast<double>(tally.all.agreed) / state.seconds : 0.0, tally.same);
  return out;
}

}  // namespace graze::attack
