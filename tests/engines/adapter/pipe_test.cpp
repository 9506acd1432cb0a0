// The tiny engine and the libraries, as graze will run them: programs with pipes.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <graze_adapter.hpp>

#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

namespace graze::adapter {
namespace {

// A program between two pipes, its standard error left alone.
class Program {
 public:
  explicit Program(const std::vector<std::string>& command) {
    std::signal(SIGPIPE, SIG_IGN);
    int to[2];
    int from[2];
    if (pipe(to) != 0 || pipe(from) != 0) throw std::runtime_error("no pipe");
    child_ = fork();
    if (child_ == 0) {
      dup2(to[0], 0);
      dup2(from[1], 1);
      for (const int end : {to[0], to[1], from[0], from[1]}) close(end);
      std::vector<char*> words;
      words.reserve(command.size() + 1);
      for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
      words.push_back(nullptr);
      execv(words[0], words.data());
      _exit(127);
    }
    close(to[0]);
    close(from[1]);
    in_ = fdopen(to[1], "w");
    out_ = fdopen(from[0], "r");
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() {
    if (child_ > 0) end();
  }

  // One line, as soon as it is there: an answer that was not flushed would hang here.
  std::string line() {
    std::string out;
    for (int c; (c = std::fgetc(out_)) != EOF && c != '\n';) out += static_cast<char>(c);
    return out;
  }
  std::string ask(const std::string& question) {
    std::fprintf(in_, "%s\n", question.c_str());
    std::fflush(in_);
    return line();
  }
  // Closes its input, and gives its exit code once it has ended.
  int end() {
    std::fclose(in_);
    int status = 0;
    waitpid(child_, &status, 0);
    std::fclose(out_);
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t child_ = -1;
  std::FILE* in_ = nullptr;
  std::FILE* out_ = nullptr;
};

std::string ball(double radius, double x, double dx) {
  return R"({"shape": {"type": "sphere", "radius": )" + std::to_string(radius) + R"(}, "position": [)" +
         std::to_string(x) + R"(, 0, 0], "orientation": [1, 0, 0, 0], "displacement": [)" +
         std::to_string(dx) + ", 0, 0]}";
}
std::string question(const std::string& id, const std::string& query, const std::string& a,
                     const std::string& b, const std::string& more = "") {
  return R"({"schema": "graze.question/1", "id": ")" + id + R"(", "query": ")" + query + R"(", "a": )" + a +
         R"(, "b": )" + b + R"(, "t_max": 1, "target_distance": 0, "start_policy": "report")" + more + "}";
}

TEST(TinyEngine, AnswersThroughPipes) {
  Program engine({TINY_ENGINE});
  EXPECT_EQ(engine.line(),
            R"({"schema": "graze.engine/1", "name": "tiny", "scalar": "double", "shapes": ["sphere"], )"
            R"("queries": {"cast": {"answers": ["time", "normal"]}}, "timed": true})");
  EXPECT_EQ(engine.ask(question("1", "cast", ball(0.5, 0, 0), ball(0.5, 3, -4))),
            R"({"schema": "graze.answer/1", "id": "1", "outcome": "hit", "time": 0.5, "normal": [1, 0, 0]})");
  EXPECT_EQ(engine.ask(question("2", "cast", ball(0.5, 0, 0), ball(0.5, 3, -1))),
            R"({"schema": "graze.answer/1", "id": "2", "outcome": "miss"})");
  EXPECT_EQ(
      engine.ask(question("3", "cast", ball(0.5, 0, 0), R"({"shape": {"type": "point"}})")),
      R"({"schema": "graze.answer/1", "id": "3", "outcome": "unsupported", "message": "a ball is wanted"})");
  const json::Value timed =
      json::read(engine.ask(question("4", "cast", ball(0.5, 0, 0), ball(0.5, 3, -4), R"(, "repeat": 50)")));
  EXPECT_EQ(timed.find("time")->number, 0.5);
  EXPECT_GT(timed.find("ns")->number, 0);
  EXPECT_EQ(engine.end(), 0);
}

TEST(TinyEngine, EndsAtALineThatIsNoQuestion) {
  Program engine({TINY_ENGINE});
  engine.line();
  EXPECT_EQ(engine.ask("{\"schema\": "), "");
  EXPECT_EQ(engine.end(), 2);
}

TEST(TinyLibrary, AnswersThroughTheHost) {
  Program engine({ENGINE_HOST, TINY_LIBRARY});
  EXPECT_EQ(json::read(engine.line()).find("name")->string, "tiny-c");
  EXPECT_EQ(
      engine.ask(question("1", "distance", ball(0.5, 0, 0), ball(0.5, 3, 0))),
      R"({"schema": "graze.answer/1", "id": "1", "outcome": "miss", "distance": {"lower": 1.999999999999998, )"
      R"("upper": 2}, "normal": [1, 0, 0], "point_a": [0.5, 0, 0], "point_b": [2.5, 0, 0]})");
  EXPECT_EQ(engine.ask(question("2", "distance", ball(0.5, 0, 0), ball(0.5, 0.5, 0))),
            R"({"schema": "graze.answer/1", "id": "2", "outcome": "initially_overlapping"})");
  // A field that the description names but the adapter does not fill in is not a number, and the answer shows
  // it.
  EXPECT_EQ(engine.ask(question("3", "penetration", ball(0.5, 0, 0), ball(0.5, 0.5, 0))),
            R"({"schema": "graze.answer/1", "id": "3", "outcome": "initially_overlapping", "depth": "nan"})");
  EXPECT_EQ(engine.ask(R"({"schema": "graze.question/1", "id": "4", "query": "ray", "a": )" + ball(1, 0, 0) +
                       R"(, "origin": [0, 0, 5], "direction": [0, 0, -1], "t_max": 1})"),
            R"({"schema": "graze.answer/1", "id": "4", "outcome": "unsupported", )"
            R"("message": "no such function in the library"})");
  EXPECT_EQ(engine.end(), 0);
}

TEST(TinyLibrary, SeesShapesWithinShapes) {
  Program engine({ENGINE_HOST, TINY_LIBRARY});
  engine.line();
  const std::string sum =
      R"({"shape": {"type": "sum", "shapes": [{"type": "sphere", "radius": 0.5},
          {"type": "hull", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 7]]}]}})";
  std::string line = question("1", "distance", sum, ball(0.5, 3, 0));
  for (std::size_t at; (at = line.find('\n')) != std::string::npos;) line.erase(at, 1);
  EXPECT_EQ(engine.ask(line), R"({"schema": "graze.answer/1", "id": "1", "outcome": "not_converged", )"
                              R"("message": "2 parts, radius 0.5, 4 vertices, last z 7"})");
}

TEST(BareLibrary, IsDescribedByItsFunctions) {
  Program engine({ENGINE_HOST, BARE_LIBRARY});
  const json::Value says = json::read(engine.line());
  EXPECT_EQ(says.find("schema")->string, "graze.engine/1");
  ASSERT_EQ(says.find("queries")->names.size(), 1U);
  EXPECT_EQ(says.find("queries")->find("cast")->find("answers")->values[0].string, "time");
  EXPECT_EQ(says.find("shapes")->values.size(), 10U);
  EXPECT_EQ(engine.ask(question("1", "cast", ball(1, 0, 0), ball(1, 5, -3))),
            R"({"schema": "graze.answer/1", "id": "1", "outcome": "hit", "time": 0.5})");
}

TEST(Host, RefusesWhatIsNoLibrary) {
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{ENGINE_HOST},
                                             {ENGINE_HOST, "nowhere.so"},
                                             {ENGINE_HOST, "libm.so.6"},
                                             {ENGINE_HOST, ENGINE_HOST}}) {
    Program host(command);
    EXPECT_EQ(host.line(), "");
    EXPECT_EQ(host.end(), 2);
  }
}

}  // namespace
}  // namespace graze::adapter
