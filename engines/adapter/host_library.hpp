// Opens a shared library behind graze_engine.h and speaks the protocol of docs/reference/protocol.md for it on standard input and
// output, so that a library is just another program.
#pragma once

#include <string>

namespace graze::adapter {

struct HostOptions {
  std::string program = "graze_engine_host";  // how its complaints begin
  bool frames = false;  // after the first line, questions and answers as bytes (host_frames.hpp)
};

// Runs until its input ends and returns the exit code, 2 for an invalid question. Ends the process with 2 and one line
// on standard error if the library cannot be opened or its description is invalid.
int host_library(const std::string& file, const HostOptions& options = {});

}  // namespace graze::adapter
