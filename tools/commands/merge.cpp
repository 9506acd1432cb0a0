// graze merge: the shards of a campaign, joined. docs/howto/campaign.md.
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "certify/campaign/summary.hpp"
#include "reports/text/outputs.hpp"
#include "tools/commands/commands.hpp"

namespace graze::tool {
namespace {

struct MergeArguments {
  std::vector<std::string> parts;
  bool partial = false;
  CampaignOutputs outputs;
};

int run_merge_command(const MergeArguments& arguments) {
  will_read(arguments.parts);
  // A state is first written to a file beside its place.
  const std::string& json = arguments.outputs.json;
  require_own_files(
      {json, json.empty() ? "" : json + ".new", arguments.outputs.save, arguments.outputs.save_undecided});
  std::vector<NamedState> parts;
  for (const std::string& name : arguments.parts) {
    if (std::filesystem::is_directory(name)) throw std::runtime_error(name + ": a directory; a state's file");
    parts.push_back({name, read_state(name)});
  }
  return hand_out(merge_states(parts, arguments.partial), arguments.outputs);
}

}  // namespace

void add_merge_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<MergeArguments>();
  CLI::App* command = app.add_subcommand("merge", "Joins the shards of a campaign into its summary.");
  command
      ->add_option("parts", arguments->parts,
                   "The files that `graze campaign --shard` wrote: its --state or --json files, in any order")
      ->required()
      ->type_name("PART.json");
  command->add_flag("--partial", arguments->partial, "Join what there is, though blocks are missing");
  command->add_option("--save", arguments->outputs.save, "Write the cases of failures to this file")
      ->type_name("OUT.jsonl");
  command
      ->add_option("--save-undecided", arguments->outputs.save_undecided,
                   "Write the cases that the oracle left undecided to this file")
      ->type_name("OUT.jsonl");
  command->add_flag("--levels", arguments->outputs.levels, "Show every level of hardness");
  command
      ->add_option("--json", arguments->outputs.json, "Write the result to this file; - is standard output")
      ->type_name("OUT");
  command->footer(
      "The summary is, to the byte, that of the campaign in one piece. Shards of other settings, blocks that "
      "two\n"
      "files hold, and blocks that none does are refused.\n\n"
      "  graze merge part1.json part2.json part3.json part4.json --json campaign.json\n"
      "  graze merge --partial part*.json --json campaign.json\n"
      "  graze campaign --state campaign.json          then casts what was missing\n\n"
      "Exit code: 0 if no cast failed, 1 if one did, 2 for bad input.");
  command->callback([arguments, &exit_code] { exit_code = run_merge_command(*arguments); });
}

}  // namespace graze::tool
