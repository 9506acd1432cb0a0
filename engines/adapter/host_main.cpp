// graze_engine_host LIBRARY: the same as `graze host`, without the judge, its packages and their licences.
#include <cstdio>
#include <string_view>

#include "host_library.hpp"

int main(int argc, char** argv) {
  graze::adapter::HostOptions options;
  options.frames = argc == 3 && std::string_view(argv[1]) == "--frames";
  if (argc != (options.frames ? 3 : 2)) {
    std::fprintf(stderr, "usage: graze_engine_host [--frames] LIBRARY\n");
    return 2;
  }
  return graze::adapter::host_library(argv[argc - 1], options);
}
