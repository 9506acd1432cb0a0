#include "certify/external/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "certify/external/engine_methods.hpp"
#include "certify/external/frames.hpp"
#include "certify/external/read_answer.hpp"
#include "corpus/format/json_value.hpp"

namespace graze::external {

using engine::Answer;
using engine::Failure;
using engine::Method;

namespace {

// The time of a call is the median of this number of calls.
constexpr int kTimedCalls = 31;

Answer failure(Failure kind, std::string what) {
  Answer answer;
  answer.failure = kind;
  answer.message = std::move(what);
  return answer;
}

// True for failures that end a process. An answer that can be read but has invalid numbers does not.
bool is_dead(Failure failure) {
  switch (failure) {
    case Failure::none:
    case Failure::garbage:
    case Failure::wrong_id:
    case Failure::non_finite:
    case Failure::out_of_range:
      return false;
    default:
      return true;
  }
}

bool is_library(const std::string& word) { return word.ends_with(".so"); }

// A program is looked for in PATH, as a shell does it: one that stands here needs its folder named.
std::string hint_for(const std::string& program) {
  std::error_code unreadable;
  if (program.find('/') != std::string::npos || !std::filesystem::is_regular_file(program, unreadable))
    return {};
  return fmt::format("; the file of that name here is ./{}", program);
}

}  // namespace

std::vector<std::string> words_of(const std::string& command) {
  std::vector<std::string> words;
  std::string word;
  bool in_word = false;
  char quote = 0;
  for (const char c : command) {
    if (quote != 0 ? c == quote : c == '"' || c == '\'') {
      quote = quote != 0 ? '\0' : c;
      in_word = true;
    } else if (quote == 0 && (c == ' ' || c == '\t')) {
      if (in_word) words.push_back(std::move(word));
      word.clear();
      in_word = false;
    } else {
      word += c;
      in_word = true;
    }
  }
  if (quote != 0) throw std::runtime_error(fmt::format("{}: a quote has no end", command));
  if (in_word) words.push_back(std::move(word));
  if (words.empty()) throw std::runtime_error("an engine is a command: a program and its arguments");
  return words;
}

Engine::Engine(EngineOptions options) : options_(std::move(options)), words_(words_of(options_.command)) {
  const std::string program = words_.front();
  if (is_library(program)) {
    if (options_.library_host.empty())
      throw std::runtime_error(program + ": nothing here loads shared libraries");
    frames_ = options_.host_takes_frames;
    if (frames_) words_.insert(words_.begin(), "--frames");
    words_.insert(words_.begin(), options_.library_host.begin(), options_.library_host.end());
  }
  auto first = std::make_unique<Process>(words_, options_.limits);
  ++starts_;
  const Line line = first->read_line(options_.limits.start);
  if (line.failure != Failure::none) {
    throw std::runtime_error(
        fmt::format("{}: says nothing of itself ({}: {}); its first line is a graze.engine/1{}",
                    options_.command, to_text(line.failure), line.what, hint_for(program)));
  }
  try {
    declaration_ = parse_declaration(line.text);
  } catch (const std::runtime_error& bad) {
    throw std::runtime_error(
        fmt::format("{}: its first line is no graze.engine/1: {}", options_.command, bad.what()));
  }
  said_ = line.text;
  waiting_.push_back({.process = std::move(first), .has_spoken = true});
  guarantees_.reserve(declaration_.offers.size());
  methods_.reserve(declaration_.offers.size());
  for (const Offer& offer : declaration_.offers) add_method(offer);
}

Engine::~Engine() = default;

void Engine::add_method(const Offer& offer) {
  const Held held{options_.tolerance, options_.relative_tolerance, options_.kappa, options_.measure};
  const engine::Guarantee& row = guarantees_.emplace_back(guarantee_of(declaration_, offer, held));
  Method method = method_of(
      declaration_, offer, row, options_.beyond_limits,
      [this](const Offer& asked, const Terms& terms, const corpus::Case&) { return ask(asked, terms); });
  if (declaration_.timed) {
    method.time_ns = [this, &offer](const corpus::Case& problem, const engine::Ask&, int) {
      const Answer answer = ask(offer, problem, kTimedCalls);
      return answer.failure == Failure::none && answer.native && answer.ns ? *answer.ns : std::nan("");
    };
  }
  methods_.push_back(std::move(method));
}

// A process whose first line has been read, or a new one if none is waiting. If the engine declares nothing
// about itself, the error says why.
std::unique_ptr<Process> Engine::take(Line& first) {
  Waiting next;
  {
    const std::lock_guard lock(mutex_);
    if (!waiting_.empty()) {
      next = std::move(waiting_.front());
      waiting_.erase(waiting_.begin());
    }
    while (waiting_.size() < options_.spares) {
      waiting_.push_back({.process = std::make_unique<Process>(words_, options_.limits)});
      ++starts_;
    }
    if (!next.process) {
      next.process = std::make_unique<Process>(words_, options_.limits);
      ++starts_;
    }
  }
  if (!next.has_spoken) first = next.process->read_line(options_.limits.start);
  return std::move(next.process);
}

// One that has spoken is asked before those that were only started.
void Engine::give_back(std::unique_ptr<Process> process) {
  const std::lock_guard lock(mutex_);
  waiting_.insert(waiting_.begin(), {.process = std::move(process), .has_spoken = true});
}

Answer Engine::ask(const Offer& offer, const corpus::Case& problem, int repeat) {
  const Terms terms = in_terms_of(declaration_, offer, problem, true);
  return terms.refused.empty() ? ask(offer, terms, repeat) : declined(terms);
}

Answer Engine::ask(const Offer& offer, const Terms& terms, int repeat) {
  const std::uint64_t id = ++asked_;
  Line first;
  std::unique_ptr<Process> process = take(first);
  if (first.failure != Failure::none) {
    left_behind_ += process->stop();
    return failure(first.failure, "it was started again, and said nothing of itself: " + first.what);
  }
  Answer answer;
  if (!first.text.empty() && first.text != said_) {
    answer = failure(Failure::wrong_id, "started again, it says something else of itself: " +
                                            corpus::json_quote_short(first.text));
  } else {
    answer = ask(*process, offer, terms, id, repeat);
  }
  // An engine that answers another question, or writes no JSON, is out of step with its questions.
  if (is_dead(answer.failure) || answer.failure == Failure::garbage || answer.failure == Failure::wrong_id) {
    left_behind_ += process->stop();
  } else {
    give_back(std::move(process));
  }
  return answer;
}

Answer Engine::ask(Process& process, const Offer& offer, const Terms& terms, std::uint64_t id,
                   int repeat) const {
  if (frames_) {
    const Line bytes = process.exchange(write_question_frame(offer, terms, id, repeat), answer_frame_size());
    return bytes.failure != Failure::none ? failure(bytes.failure, bytes.what)
                                          : read_answer_frame(bytes.text, id, offer, terms);
  }
  const std::string name = fmt::format("q{}", id);
  const Line line = process.ask(write_question(offer, terms, name, repeat));
  return line.failure != Failure::none ? failure(line.failure, line.what)
                                       : read_answer(line.text, name, offer, terms);
}

int Engine::finish() {
  const std::lock_guard lock(mutex_);
  int left = left_behind_;
  for (Waiting& one : waiting_) left += one.process->finish();
  waiting_.clear();
  return left;
}

}  // namespace graze::external
