// graze_engine_host LIBRARY: what `graze host` does, without the judge, its packages and their licences.
#include <cstdio>

#include "host_library.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: graze_engine_host LIBRARY\n");
    return 2;
  }
  return graze::adapter::host_library(argv[1]);
}
