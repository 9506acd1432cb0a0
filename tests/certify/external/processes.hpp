// The remaining processes of engines that this process, or its children, have started, recognised by their
// mark.
#pragma once

#include <dirent.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace graze::test {

inline std::size_t entries_of(const char* directory) {
  std::size_t count = 0;
  DIR* const all = opendir(directory);
  if (all == nullptr) return 0;
  while (readdir(all) != nullptr) ++count;
  closedir(all);
  return count;
}

// Said of whatever this process starts, and what that starts: other tests run beside this one.
inline const std::string kOurs = [] {
  const std::string value = std::to_string(getpid());
  setenv("GRAZE_TEST_OF_ENGINES", value.c_str(), 1);
  return "GRAZE_TEST_OF_ENGINES=" + value;
}();

// Processes, zombies aside, that run the bad engine and were started by this test.
inline std::size_t bad_engines() {
  std::size_t count = 0;
  DIR* const all = opendir("/proc");
  if (all == nullptr) return 0;
  while (const dirent* const entry = readdir(all)) {
    const std::string name = entry->d_name;
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream file("/proc/" + name + "/cmdline", std::ios::binary);
    const std::string line((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (!line.starts_with(BAD_ENGINE)) continue;
    std::ifstream around("/proc/" + name + "/environ", std::ios::binary);
    const std::string environment((std::istreambuf_iterator<char>(around)), std::istreambuf_iterator<char>());
    if (environment.find(kOurs + '\0') != std::string::npos) ++count;
  }
  closedir(all);
  return count;
}

// Children of this process that are zombies.
inline std::size_t zombies() {
  std::size_t count = 0;
  std::ifstream children("/proc/thread-self/children");
  for (int pid = 0; children >> pid;) {
    std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
    const std::string line((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (const std::size_t end = line.rfind(')');
        end != std::string::npos && line.substr(end).starts_with(") Z"))
      ++count;
  }
  return count;
}

}  // namespace graze::test
