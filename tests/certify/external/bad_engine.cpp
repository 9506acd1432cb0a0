// bad_engine FAULT [N]: an engine that casts balls correctly and errs on purpose at its N-th question (the
// first by default). If the fault needs a hit, a miss, or a start in contact, it errs at the first such
// question from there on.
//
// bad_engine none                never errs.
// bad_engine has_margin          does not err, either: its declared margin rounds its balls, half of it each.
// bad_engine misses_all_hits     returns a miss for every hit.
// bad_engine hits_all_starts     returns a hit at time 0 for every start in contact.
// bad_engine declines_half       answers every second question with unsupported.
// bad_engine documents_misses    does so, too, and declares a limit that every body is beyond.
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <graze_adapter.hpp>
#include <iostream>
#include <map>
#include <string>
#include <thread>
#include <vector>

using namespace graze::adapter;

namespace {

constexpr double kMargin = 0.25;
bool has_margin = false;

// Witnesses of a contact in which B is `gap` from A.
void touch(Answer& answer, const Question& q, const Vector& gap, const Vector& center_a) {
  const double rounding = has_margin ? kMargin / 2 : 0;
  answer.normal = normalized(gap);
  answer.point_a = center_a + (q.a.shape.radius + rounding) * *answer.normal;
  answer.point_b = center_a + gap - (q.b.shape.radius + rounding) * *answer.normal;
}

Answer cast(const Question& q) {
  const double reach = q.a.shape.radius + q.b.shape.radius + (has_margin ? kMargin : 0);
  const Vector gap = q.b.position - q.a.position;
  const Vector v = q.b.displacement - q.a.displacement;
  const double c = dot(gap, gap) - reach * reach;
  const double b = dot(gap, v);
  if (c <= 0) {
    Answer answer = Answer::overlapping();
    touch(answer, q, gap, q.a.position);
    return answer;
  }
  const double discriminant = b * b - dot(v, v) * c;
  if (b >= 0 || discriminant < 0) return Answer::miss();
  const double time = c / (-b + std::sqrt(discriminant));
  if (time > q.t_max) return Answer::miss();
  Answer answer = Answer::hit(time);
  touch(answer, q, gap + time * v, q.a.position + time * q.a.displacement);
  return answer;
}

void say(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

[[noreturn]] void sleep_for_ever() {
  for (;;) std::this_thread::sleep_for(std::chrono::seconds(60));
}

// The description that the engine writes at its start.
std::string description(const std::string& fault) {
  if (fault == "declares_nonsense") return R"({"schema": "graze.engine/1", "name": "bad", "scalar": "quad"})";
  if (fault == "declares_no_json") return "Bad Engine 1.0, ready";
  // Another at each start.
  const std::string version = fault == "declares_otherwise" ? std::to_string(getpid()) : "1";
  return R"({"schema": "graze.engine/1", "name": "bad", "version": ")" + version +
         R"(", "scalar": "double", "shapes": ["sphere"], )" +
         (has_margin ? "\"margin\": " + std::to_string(kMargin) + ", " : "") +
         (fault == "documents_misses" ? R"("most_aspect": 0.5, )" : "") +
         R"("queries": {"cast": {"answers": ["time", "normal", "witnesses"], "relative_tolerance": 1e-9, )"
         R"("start_normal": "least_penetration"}}})";
}

// The answer to a question with `text` instead of the value of `field`.
std::string with(std::string line, const std::string& field, const std::string& text) {
  const std::size_t begin = line.find("\"" + field + "\": ") + field.size() + 4;
  std::size_t end = line.find(line[begin] == '[' ? ']' : ',', begin) + (line[begin] == '[' ? 1 : 0);
  if (end == std::string::npos) end = line.size() - 1;
  return line.replace(begin, end - begin, text);
}

// Leaves a child behind that holds nothing of ours open but its output, if asked to.
void fork_child(bool own_session, bool twice, bool holds_output) {
  const pid_t child = fork();
  if (child != 0) {
    if (twice) waitpid(child, nullptr, 0);
    return;
  }
  if (own_session) setsid();
  if (twice && fork() != 0) _exit(0);
  close(0);
  if (!holds_output) close(1);
  close(2);
  sleep_for_ever();
}

// Faults that change an answer, and the answers that they change. nullptr leaves the line to another function.
struct FaultKind {
  enum class Needs { anything, hit, miss, start } needs;
  std::string (*line)(const Question& q, const Answer& right);
};
std::string right_line(const Question& q, const Answer& right) { return write_answer(q.id, right); }

const std::map<std::string, FaultKind>& fault_kinds() {
  using Needs = FaultKind::Needs;
  static const std::map<std::string, FaultKind> all{
      {"segfault",
       {Needs::anything,
        [](const Question&, const Answer&) -> std::string {
          std::fprintf(stderr, "about to fall\n");
          std::raise(SIGSEGV);
          return {};
        }}},
      {"traceback",
       {Needs::anything,
        [](const Question&, const Answer&) -> std::string {
          std::fprintf(stderr, "Traceback:\n  line 1\n  line 2\n");
          std::exit(3);
        }}},
      {"abort", {Needs::anything, [](const Question&, const Answer&) -> std::string { std::abort(); }}},
      {"exit_3", {Needs::anything, [](const Question&, const Answer&) -> std::string { std::exit(3); }}},
      {"declares_otherwise",
       {Needs::anything, [](const Question&, const Answer&) -> std::string { std::exit(3); }}},
      {"exit_0", {Needs::anything, [](const Question&, const Answer&) -> std::string { std::exit(0); }}},
      {"hang", {Needs::anything, [](const Question&, const Answer&) -> std::string { sleep_for_ever(); }}},
      {"spin",
       {Needs::anything,
        [](const Question&, const Answer&) -> std::string {
          for (volatile bool on = true; on;) {
          }
          return {};
        }}},
      {"nan_string",
       {Needs::hit, [](const Question& q,
                       const Answer& right) { return with(right_line(q, right), "time", "\"nan\""); }}},
      {"nan_token",
       {Needs::hit,
        [](const Question& q, const Answer& right) { return with(right_line(q, right), "time", "NaN"); }}},
      {"minus_nan",
       {Needs::hit,
        [](const Question& q, const Answer& right) { return with(right_line(q, right), "time", "-nan"); }}},
      {"infinite",
       {Needs::hit, [](const Question& q,
                       const Answer& right) { return with(right_line(q, right), "time", "\"inf\""); }}},
      {"nan_normal",
       {Needs::hit, [](const Question& q,
                       const Answer& right) { return with(right_line(q, right), "normal", "[0, NaN, 0]"); }}},
      {"before_0",
       {Needs::hit,
        [](const Question& q, const Answer& right) { return with(right_line(q, right), "time", "-0.25"); }}},
      {"after_the_end",
       {Needs::hit,
        [](const Question& q, const Answer& right) { return with(right_line(q, right), "time", "1e30"); }}},
      {"upside_down",
       {Needs::hit,
        [](const Question& q, const Answer& right) {
          return with(right_line(q, right), "time", R"({"lower": 0.5, "upper": 0.25})");
        }}},
      {"long_normal",
       {Needs::hit, [](const Question& q,
                       const Answer& right) { return with(right_line(q, right), "normal", "[0, 0, 2]"); }}},
      {"late",
       {Needs::hit,
        [](const Question& q, const Answer& right) {
          Answer bad = right;
          bad.time = (right.time->lower + q.t_max) / 2;
          return write_answer(q.id, bad);
        }}},
      {"early",
       {Needs::hit,
        [](const Question& q, const Answer& right) {
          Answer bad = right;
          bad.time = right.time->lower / 2;
          return write_answer(q.id, bad);
        }}},
      {"flips_normals",
       {Needs::hit,
        [](const Question& q, const Answer& right) {
          Answer bad = right;
          bad.normal = -*right.normal;
          return write_answer(q.id, bad);
        }}},
      {"shrinks_start_normals",
       {Needs::start,
        [](const Question& q, const Answer& right) {
          Answer bad = right;
          bad.normal = 0.83 * *right.normal;
          return write_answer(q.id, bad);
        }}},
      {"flips_start_normals",
       {Needs::start,
        [](const Question& q, const Answer& right) {
          Answer bad = right;
          bad.normal = -*right.normal;
          return write_answer(q.id, bad);
        }}},
      {"loses_start_witnesses",
       {Needs::start,
        [](const Question& q, const Answer& right) {
          Answer bad = right;
          bad.point_b = q.b.position + 2 * q.b.shape.radius * *right.normal;
          return write_answer(q.id, bad);
        }}},
      {"beyond_its_margin",
       {Needs::hit,
        [](const Question& q, const Answer& right) {
          Answer bad = right;
          bad.point_a = *right.point_a + kMargin * *right.normal;
          return write_answer(q.id, bad);
        }}},
      {"misses_hits",
       {Needs::hit, [](const Question& q, const Answer&) { return write_answer(q.id, Answer::miss()); }}},
      {"claims_hits",
       {Needs::miss,
        [](const Question& q, const Answer&) {
          Answer bad = Answer::hit(q.t_max / 2);
          bad.normal = Vector{1, 0, 0};
          bad.point_a = bad.point_b = q.a.position;
          return write_answer(q.id, bad);
        }}},
      {"leaks",
       {Needs::anything,
        [](const Question&, const Answer&) -> std::string {
          for (;;) std::memset(new char[1 << 20], 1, 1 << 20);
        }}},
      {"wrong_id",
       {Needs::anything,
        [](const Question&, const Answer& right) { return write_answer("q999999", right); }}},
      {"garbage",
       {Needs::anything,
        [](const Question&, const Answer&) -> std::string { return "hit at 0.5, I think"; }}},
      {"binary_garbage",
       {Needs::anything,
        [](const Question&, const Answer&) { return std::string("\0\xff\xfe{\"schema\"\x80", 13); }}},
      {"half_a_line",
       {Needs::anything,
        [](const Question& q, const Answer& right) -> std::string {
          const std::string line = right_line(q, right);
          say(line.substr(0, line.size() / 2));
          std::exit(0);
        }}},
      {"closes_output",
       {Needs::anything,
        [](const Question&, const Answer&) -> std::string {
          std::fclose(stdout);
          close(1);
          sleep_for_ever();
        }}},
      {"forks",
       {Needs::anything,
        [](const Question& q, const Answer& right) {
          fork_child(false, false, false);
          return right_line(q, right);
        }}},
      {"forks_session",
       {Needs::anything,
        [](const Question& q, const Answer& right) {
          fork_child(true, false, false);
          return right_line(q, right);
        }}},
      {"forks_twice",
       {Needs::anything,
        [](const Question& q, const Answer& right) {
          fork_child(true, true, false);
          return right_line(q, right);
        }}},
      {"forks_and_crashes",
       {Needs::anything,
        [](const Question&, const Answer&) -> std::string {
          fork_child(true, true, true);
          std::exit(3);
        }}},
      {"endless_line",
       {Needs::anything,
        [](const Question&, const Answer&) -> std::string {
          const std::string much(1 << 20, 'x');
          for (;;) say(much);
        }}},
      {"floods_errors",
       {Needs::anything,
        [](const Question& q, const Answer& right) {
          const std::string much(1 << 16, 'e');
          for (int i = 0; i < 160; ++i) std::fputs(much.c_str(), stderr);
          return right_line(q, right);
        }}},
      {"two_answers",
       {Needs::anything,
        [](const Question& q, const Answer& right) {
          return right_line(q, right) + "\n" + right_line(q, right);
        }}},
  };
  return all;
}

bool suits(FaultKind::Needs needs, const Answer& right) {
  if (needs == FaultKind::Needs::hit) return right.outcome == Outcome::hit;
  if (needs == FaultKind::Needs::miss) return right.outcome == Outcome::miss;
  if (needs == FaultKind::Needs::start) return right.outcome == Outcome::initially_overlapping;
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string fault = argc > 1 ? argv[1] : "none";
  int left = argc > 2 ? std::atoi(argv[2]) : 1, asked = 0;
  has_margin = fault == "has_margin" || fault == "beyond_its_margin";
  const auto known = fault_kinds().find(fault);
  if (fault == "silent_start") sleep_for_ever();
  if (fault == "ends_at_start") return 0;
  if (fault == "fails_at_start") return 7;
  say(description(fault) + "\n");
  if (fault == "does_not_read") sleep_for_ever();
  std::string line;
  while (std::getline(std::cin, line)) {
    const Question q = read_question(line);
    const Answer right = cast(q);
    // Always, whatever N: what is made small is asked of many processes.
    if ((fault == "misses_all_hits" || fault == "documents_misses") && right.outcome == Outcome::hit) {
      say(write_answer(q.id, Answer::miss()) + "\n");
      continue;
    }
    if (fault == "hits_all_starts" && right.outcome == Outcome::initially_overlapping) {
      Answer bad = right;
      bad.outcome = Outcome::hit;
      bad.time = 0;
      say(write_answer(q.id, bad) + "\n");
      continue;
    }
    if (fault == "declines_half" && asked++ % 2 == 0) {
      say(R"({"schema": "graze.answer/1", "id": ")" + q.id + R"(", "outcome": "unsupported"})" + "\n");
      continue;
    }
    const bool is_time = --left <= 0 && known != fault_kinds().end() && suits(known->second.needs, right);
    say((is_time ? known->second.line(q, right) : right_line(q, right)) + "\n");
  }
  return 0;
}
