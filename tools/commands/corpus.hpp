// graze corpus: the curated cases are edited by this command only, so that they stay valid and their answers
// can be derived again.
#pragma once

#include <CLI/CLI.hpp>

namespace graze::tool {

void add_corpus_command(CLI::App& app, int& exit_code);

}  // namespace graze::tool
