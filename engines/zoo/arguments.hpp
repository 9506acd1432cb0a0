// The command line of every adapter of the zoo: --call C --setting S, each one of those that the adapter knows.
// Anything else is one line on standard error, and exit code 2.
#ifndef GRAZE_ENGINES_ZOO_ARGUMENTS_HPP
#define GRAZE_ENGINES_ZOO_ARGUMENTS_HPP

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace graze::zoo {

struct Arguments {
  std::string call, setting;
};

[[noreturn]] inline void refuse(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
  std::exit(2);
}

inline std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : ", ") + word;
  return out;
}

// The first of each list is the default.
inline Arguments read_arguments(int argc, char** argv, const std::vector<std::string>& calls,
                                const std::vector<std::string>& settings) {
  Arguments out{calls.front(), settings.front()};
  for (int i = 1; i < argc; i += 2) {
    const std::string option = argv[i];
    const bool call = option == "--call";
    if (!call && option != "--setting") refuse(option + ": unknown; --call and --setting are known");
    if (i + 1 == argc) refuse(option + ": a word is expected after it");
    const std::vector<std::string>& known = call ? calls : settings;
    const std::string word = argv[i + 1];
    if (std::find(known.begin(), known.end(), word) == known.end()) {
      refuse(option + " " + word + ": unknown; known are " + joined(known));
    }
    (call ? out.call : out.setting) = word;
  }
  return out;
}

}  // namespace graze::zoo

#endif
