// What is left of engines that this process, or those that it runs, have started: told by their mark.
#pragma once

#include <dirent.h>

#include <cstddef>
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

// Processes, zombies aside, whose command line names the bad engine.
inline std::size_t bad_engines() {
  std::size_t count = 0;
  DIR* const all = opendir("/proc");
  if (all == nullptr) return 0;
  while (const dirent* const entry = readdir(all)) {
    const std::string name = entry->d_name;
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream file("/proc/" + name + "/cmdline", std::ios::binary);
    const std::string line((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (line.starts_with(BAD_ENGINE)) ++count;
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
