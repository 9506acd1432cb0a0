// graze host: a shared library behind graze_engine.h as an engine. `graze certify --engine libmine.so` starts it.
#include <memory>
#include <string>

#include "engines/adapter/host_library.hpp"
#include "tools/commands/commands.hpp"

namespace graze::tool {

void add_host_command(CLI::App& app, int& exit_code) {
  const auto library = std::make_shared<std::string>();
  const auto options = std::make_shared<adapter::HostOptions>();
  options->program = "graze";
  CLI::App* command =
      app.add_subcommand("host", "Answers questions by a shared library behind graze_engine.h, line by line");
  command->add_option("library", *library, "The library")->type_name("LIB.so")->required();
  command->add_flag("--frames", options->frames,
                    "After the first line, questions and answers as bytes, as graze itself asks them "
                    "(engines/adapter/host_frames.hpp)");
  command->footer(
      "  graze certify --engine ./libmine.so   calls it for each process of the library\n"
      "  graze host ./libmine.so < questions.jsonl > answers.jsonl\n\n"
      "Exit code: 0 when its input has ended, 2 if the library cannot be opened or a line is no question.");
  command->callback(
      [library, options, &exit_code] { exit_code = adapter::host_library(*library, *options); });
}

}  // namespace graze::tool
