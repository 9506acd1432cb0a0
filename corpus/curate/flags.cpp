#include "corpus/curate/flags.hpp"

#include <algorithm>
#include <set>

#include "corpus/format/case_json.hpp"

namespace graze::corpus {
namespace {

std::string read_sentence(const Fields& fields, std::string_view key) {
  std::string text = read_string(fields.required(key, "a sentence"), fields.path(key));
  if (text.empty()) throw Malformed{fields.path(key), "empty; a sentence"};
  return text;
}

FlagNote read_note(const JsonValue& value, const std::string& path) {
  const Fields fields(value, path, {"breaks", "affects", "cases"});
  FlagNote note{read_sentence(fields, "breaks"), read_sentence(fields, "affects"), {}};
  const std::string where = fields.path("cases");
  for (const JsonValue& id :
       read_array(fields.required("cases", "an array of ids"), where, "an array of ids")) {
    note.cases.push_back(read_string(id, item_path(where, note.cases.size())));
  }
  return note;
}

}  // namespace

FlagNotes read_flag_notes(std::string_view text, const std::string& name) {
  FlagNotes result;
  const ParsedJson parsed = parse_json(text);
  try {
    if (parsed.error) throw *parsed.error;
    if (parsed.value.kind != JsonValue::Kind::object) {
      throw Malformed{"", describe(parsed.value) + "; an object with a note for each flag"};
    }
    for (std::size_t i = 0; i < parsed.value.keys.size(); ++i) {
      const std::string& flag = parsed.value.keys[i];
      result.notes.emplace(flag, read_note(parsed.value.items[i], flag));
    }
  } catch (const Malformed& error) {
    result.error = name + ": " + (error.path.empty() ? "" : error.path + ": ") + error.what;
  }
  return result;
}

FlagNotes read_flag_notes_file(const std::filesystem::path& path) {
  const FileText file = read_whole_file(path.string());
  if (!file.error.empty()) return {{}, path.string() + ": " + file.error};
  return read_flag_notes(file.text, path.string());
}

std::vector<std::string> flag_mismatches(const std::vector<Case>& cases, const FlagNotes& flags) {
  std::vector<std::string> lines;
  std::set<std::string> used;
  std::map<std::string, const Case*> by_id;
  for (const Case& problem : cases) {
    by_id.emplace(problem.id, &problem);
    for (const std::string& flag : problem.flags) {
      used.insert(flag);
      if (!flags.notes.contains(flag)) lines.push_back(problem.id + ": the flag " + flag + " has no note");
    }
  }
  for (const auto& [flag, note] : flags.notes) {
    if (!used.contains(flag)) lines.push_back("the note on " + flag + " is used by no case");
    for (const std::string& id : note.cases) {
      const auto found = by_id.find(id);
      if (found == by_id.end()) {
        lines.push_back("the note on " + flag + " names " + id + ", which does not exist");
      } else if (const auto& own = found->second->flags;
                 std::find(own.begin(), own.end(), flag) == own.end()) {
        lines.push_back("the note on " + flag + " names " + id + ", which lacks the flag");
      }
    }
  }
  return lines;
}

}  // namespace graze::corpus
