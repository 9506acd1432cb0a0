// One line of progress on stderr, only if a person is looking (stderr is a terminal).
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace graze::tool {

class Progress {
 public:
  Progress(std::string label, std::size_t total);
  ~Progress();  // wipes the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step();  // from any thread

 private:
  void show();

  std::string label_;
  std::size_t total_, done_ = 0;
  bool visible_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point shown_;
};

}  // namespace graze::tool
