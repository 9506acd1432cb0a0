// A third-party engine: a command that speaks the protocol, its processes, and its methods, which are added
// to the list of judged methods.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "certify/external/declaration.hpp"
#include "certify/external/process.hpp"
#include "certify/external/terms.hpp"

namespace graze::external {

struct EngineOptions {
  // Words separated by blanks, with "..." and '...' around a word that contains blanks. No shell is used. A
  // command that ends in .so is a shared library, and `library_host` receives it as its last word.
  std::string command;
  std::vector<std::string> library_host = {};
  bool host_takes_frames = false;  // questions and answers of a shared library are bytes, not lines
  ProcessLimits limits = {};
  // Held to these lengths, whatever it declares.
  std::optional<double> tolerance = {}, relative_tolerance = {}, kappa = {};
  bool measure = false;        // no error limit: errors are only measured
  bool beyond_limits = false;  // also asked cases beyond its documented limits
  unsigned spares = 1;         // processes that are started before they are needed
};

// The words of a command. Throws std::runtime_error if a quote has no end, or if there is no word.
[[nodiscard]] std::vector<std::string> words_of(const std::string& command);

class Engine {
 public:
  // Starts the engine and reads its declaration. Throws std::runtime_error with a one-line message.
  explicit Engine(EngineOptions options);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  [[nodiscard]] const Declaration& declaration() const { return declaration_; }
  // A method for each thing that it can be asked. They live as long as the engine.
  [[nodiscard]] std::span<const engine::Method> methods() const { return methods_; }

  // Asks one question, from any thread. `repeat` > 0 also requests the time of a call.
  [[nodiscard]] engine::Answer ask(const Offer& offer, const corpus::Case& problem, int repeat = 0);
  // The same of terms that are not refused.
  [[nodiscard]] engine::Answer ask(const Offer& offer, const Terms& terms, int repeat = 0);

  // Asks every process to end. Returns the number of processes that they left behind, including those that
  // were ended before. Call it once, at the end.
  int finish();
  [[nodiscard]] std::size_t starts() const { return starts_; }  // processes that were started

 private:
  std::unique_ptr<Process> take(Line& first);
  [[nodiscard]] engine::Answer ask(Process& process, const Offer& offer, const Terms& terms, std::uint64_t id,
                                   int repeat) const;
  void give_back(std::unique_ptr<Process> process);
  void add_method(const Offer& offer);

  EngineOptions options_;
  std::vector<std::string> words_;
  bool frames_ = false;
  std::string said_;  // its first line
  Declaration declaration_;
  std::vector<engine::Guarantee> guarantees_;
  std::vector<engine::Method> methods_;

  std::mutex mutex_;
  struct Waiting {
    std::unique_ptr<Process> process;
    bool has_spoken = false;  // its first line is read
  };
  std::vector<Waiting> waiting_;
  std::size_t starts_ = 0;
  std::atomic<std::uint64_t> asked_ = 0;
  std::atomic<int> left_behind_ = 0;
};

}  // namespace graze::external
