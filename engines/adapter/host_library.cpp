#include "host_library.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

#include "engines/system/system.hpp"
#include "graze_adapter.hpp"
#include "graze_engine.h"
#include "host_frames.hpp"

namespace graze::adapter {
namespace {

// How complaints begin. One library in a process.
std::string& program() {
  static std::string name;
  return name;
}

[[noreturn]] void refuse(const std::string& what) {
  std::fprintf(stderr, "%s: %s\n", program().c_str(), what.c_str());
  std::exit(2);
}

using Call = graze_engine_outcome (*)(const graze_engine_question*, void*, graze_engine_answer*);

struct Library {
  const char* (*describe)() = nullptr;
  void* (*begin)(const graze_engine_question*) = nullptr;
  void (*end)(void*) = nullptr;
  std::map<Query, Call> calls;
};

template <class Function>
void find(void* handle, const std::string& name, Function& out) {
  out = reinterpret_cast<Function>(system::find_function(handle, "graze_engine_" + name));
}

Library open(const char* file) {
  std::string why;
  void* const handle = system::open_library(file, why);
  if (handle == nullptr) refuse(why);
  Library out;
  find(handle, "describe", out.describe);
  find(handle, "begin", out.begin);
  find(handle, "end", out.end);
  for (const auto& [query, name] : query_names()) {
    Call call = nullptr;
    find(handle, name, call);
    if (call != nullptr) out.calls[query] = call;
  }
  if (out.calls.empty()) refuse(std::string(file) + ": none of the functions of graze_engine.h is in it");
  return out;
}

// ---- Questions, as the header has them: arrays that point into what is kept beside them. ----

struct Kept {
  std::deque<std::vector<double>> numbers;
  std::deque<std::vector<graze_engine_shape>> shapes;
};

void put(double (&out)[3], const Vector& x) { std::copy(x.begin(), x.end(), out); }
void put(double (&out)[4], const Quaternion& q) {
  out[0] = q.w;
  out[1] = q.x;
  out[2] = q.y;
  out[3] = q.z;
}

graze_engine_shape plain(const Shape& shape, Kept& kept) {
  graze_engine_shape out{};
  out.type = static_cast<graze_engine_shape_type>(shape.type);  // one order in both
  out.radius = shape.radius;
  out.half_height = shape.half_height;
  put(out.half_extents, shape.half_extents);
  put(out.radii, shape.radii);
  std::vector<double>& numbers = kept.numbers.emplace_back();
  for (const Vector& x : shape.vertices) numbers.insert(numbers.end(), x.begin(), x.end());
  out.vertices = numbers.data();
  out.vertex_count = shape.vertices.size();
  put(out.position, shape.position);
  put(out.orientation, shape.orientation);
  std::vector<graze_engine_shape> parts;
  for (const Shape& part : shape.parts) parts.push_back(plain(part, kept));
  kept.shapes.push_back(std::move(parts));
  out.parts = kept.shapes.back().data();
  out.part_count = shape.parts.size();
  return out;
}
static_assert(static_cast<int>(ShapeType::hull_of) == GRAZE_ENGINE_HULL_OF);
static_assert(static_cast<int>(ShapeType::box) == GRAZE_ENGINE_BOX);
static_assert(static_cast<int>(Query::penetration) == GRAZE_ENGINE_PENETRATION);

graze_engine_body plain(const Body& body, Kept& kept) {
  graze_engine_body out{};
  out.shape = plain(body.shape, kept);
  put(out.position, body.position);
  put(out.orientation, body.orientation);
  put(out.displacement, body.displacement);
  put(out.rotation, body.rotation);
  put(out.pivot, body.pivot);
  return out;
}

struct Asked {
  Kept kept;
  graze_engine_question question{};
  void* prepared = nullptr;
  void (*end)(void*) = nullptr;

  Asked(const Question& q, const Library& library) {
    question.query = static_cast<graze_engine_query>(q.query);
    question.a = plain(q.a, kept);
    question.b = plain(q.b, kept);
    put(question.origin, q.origin);
    put(question.direction, q.direction);
    question.t_max = q.t_max;
    question.target_distance = q.target_distance;
    question.pass_over = q.pass_over ? 1 : 0;
    if (library.begin != nullptr) prepared = library.begin(&question);
    end = library.end;
  }
  Asked(const Asked&) = delete;
  Asked& operator=(const Asked&) = delete;
  ~Asked() {
    if (end != nullptr) end(prepared);
  }
};

// ---- Answers. ----

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

Bracket bracket(double lower, double upper) {
  return std::isnan(upper) ? Bracket(lower) : Bracket(lower, upper);
}
Vector vector(const double (&x)[3]) { return {x[0], x[1], x[2]}; }

Outcome outcome_of(graze_engine_outcome given) {
  switch (given) {
    case GRAZE_ENGINE_HIT:
      return Outcome::hit;
    case GRAZE_ENGINE_INITIALLY_OVERLAPPING:
      return Outcome::initially_overlapping;
    case GRAZE_ENGINE_MISS:
      return Outcome::miss;
    case GRAZE_ENGINE_NOT_CONVERGED:
      return Outcome::not_converged;
    case GRAZE_ENGINE_UNSUPPORTED:
      break;
  }
  return Outcome::unsupported;
}

Answer call(Call function, const Asked& asked, const std::vector<std::string>& answers) {
  graze_engine_answer given;
  given.time = given.time_upper = given.distance = given.distance_upper = given.depth = given.depth_upper =
      kNothing;
  for (std::size_t i = 0; i < 3; ++i) given.normal[i] = given.point_a[i] = given.point_b[i] = kNothing;
  given.message[0] = '\0';
  Answer out = Answer::of(outcome_of(function(&asked.question, asked.prepared, &given)));
  given.message[sizeof given.message - 1] = '\0';
  out.message = given.message;
  const auto holds = [&answers](const char* name) {
    return std::find(answers.begin(), answers.end(), name) != answers.end();
  };
  const bool contact = out.outcome == Outcome::hit || out.outcome == Outcome::initially_overlapping;
  // A bracket that an undecided call has, or the time of a hit.
  if (out.outcome == Outcome::hit || (out.outcome == Outcome::not_converged && !std::isnan(given.time))) {
    out.time = bracket(given.time, given.time_upper);
  }
  const bool found = contact || out.outcome == Outcome::miss;
  if (found && holds("distance") && (!contact || !std::isnan(given.distance))) {
    out.distance = bracket(given.distance, given.distance_upper);
  }
  if (contact && holds("depth")) out.depth = bracket(given.depth, given.depth_upper);
  // A miss has a direction only for the query distance. For a start in contact, some casts know no direction.
  const bool there = out.outcome == Outcome::hit || (found && !std::isnan(given.normal[0]));
  if (holds("normal") && there) out.normal = vector(given.normal);
  if (holds("witnesses") && (out.outcome == Outcome::hit || (found && !std::isnan(given.point_a[0])))) {
    out.point_a = vector(given.point_a);
    out.point_b = vector(given.point_b);
  }
  return out;
}

// ---- Questions and answers as bytes. ----

bool read_bytes(void* to, std::size_t size) { return std::fread(to, 1, size, stdin) == size; }

// Reads the bytes of a question in order. A question that ends too early is invalid.
class Frame {
 public:
  Frame(const std::vector<double>& words, std::size_t first)
      : at_(reinterpret_cast<const char*>(words.data()) + first),
        end_(reinterpret_cast<const char*>(words.data() + words.size())) {}

  graze_engine_body body() {
    const auto& head = take<frames::BodyHead>();
    graze_engine_body out{};
    std::copy(std::begin(head.position), std::end(head.position), out.position);
    std::copy(std::begin(head.orientation), std::end(head.orientation), out.orientation);
    std::copy(std::begin(head.displacement), std::end(head.displacement), out.displacement);
    std::copy(std::begin(head.rotation), std::end(head.rotation), out.rotation);
    std::copy(std::begin(head.pivot), std::end(head.pivot), out.pivot);
    out.shape = shape();
    return out;
  }

 private:
  template <class Head>
  const Head& take() {
    return *reinterpret_cast<const Head*>(skip(sizeof(Head)));
  }
  const char* skip(std::size_t bytes) {
    if (bytes > static_cast<std::size_t>(end_ - at_)) refuse("a question ends before its end");
    return std::exchange(at_, at_ + bytes);
  }
  graze_engine_shape shape() {
    const auto& head = take<frames::ShapeHead>();
    graze_engine_shape out{};
    out.type = static_cast<graze_engine_shape_type>(head.type);
    out.radius = head.radius;
    out.half_height = head.half_height;
    std::copy(std::begin(head.half_extents), std::end(head.half_extents), out.half_extents);
    std::copy(std::begin(head.radii), std::end(head.radii), out.radii);
    std::copy(std::begin(head.position), std::end(head.position), out.position);
    std::copy(std::begin(head.orientation), std::end(head.orientation), out.orientation);
    if (head.vertex_count > frames::kMostBytes || head.part_count > frames::kMostBytes)
      refuse("a shape is too large");
    out.vertex_count = head.vertex_count;
    out.vertices = reinterpret_cast<const double*>(skip(3 * sizeof(double) * head.vertex_count));
    out.part_count = head.part_count;
    if (head.part_count == 0) return out;
    std::vector<graze_engine_shape> parts;
    for (std::uint64_t i = 0; i < head.part_count; ++i) parts.push_back(shape());
    shapes_.push_back(std::move(parts));
    out.parts = shapes_.back().data();
    return out;
  }

  const char* at_;
  const char* end_;
  std::deque<std::vector<graze_engine_shape>> shapes_;
};

frames::AnswerFrame nothing_known() {
  frames::AnswerFrame out;
  graze_engine_answer& a = out.answer;
  a.time = a.time_upper = a.distance = a.distance_upper = a.depth = a.depth_upper = kNothing;
  for (std::size_t i = 0; i < 3; ++i) a.normal[i] = a.point_a[i] = a.point_b[i] = kNothing;
  a.message[0] = '\0';
  return out;
}

frames::AnswerFrame answer_frame(const Library& library, const frames::QuestionHead& head,
                                 const std::vector<double>& words) {
  Frame frame(words, sizeof head);
  graze_engine_question question{};
  question.query = static_cast<graze_engine_query>(head.query);
  question.a = frame.body();
  question.b = frame.body();
  std::copy(std::begin(head.origin), std::end(head.origin), question.origin);
  std::copy(std::begin(head.direction), std::end(head.direction), question.direction);
  question.t_max = head.t_max;
  question.target_distance = head.target_distance;
  question.pass_over = static_cast<int>(head.pass_over);
  const auto known = library.calls.find(static_cast<Query>(head.query));
  if (known == library.calls.end()) {
    frames::AnswerFrame none = nothing_known();
    std::snprintf(none.answer.message, sizeof none.answer.message, "no such function in the library");
    return none;
  }
  void* const prepared = library.begin != nullptr ? library.begin(&question) : nullptr;
  frames::AnswerFrame out;
  const Answer timed = call_repeatedly(
      [&] {
        out = nothing_known();
        out.outcome = known->second(&question, prepared, &out.answer);
        return Answer();
      },
      head.repeat);
  if (library.end != nullptr) library.end(prepared);
  if (timed.ns) out.ns = *timed.ns;
  out.answer.message[sizeof out.answer.message - 1] = '\0';
  return out;
}

int serve_frames(const Library& library, Output& output) {
  std::vector<double> words;
  frames::QuestionHead head;
  while (read_bytes(&head, sizeof head)) {
    if (head.magic != frames::kQuestion || head.size < sizeof head || head.size > frames::kMostBytes ||
        head.size % sizeof(double) != 0)
      refuse("the bytes are no question");
    words.resize(head.size / sizeof(double));
    std::memcpy(words.data(), &head, sizeof head);
    if (!read_bytes(reinterpret_cast<char*>(words.data()) + sizeof head, head.size - sizeof head)) return 2;
    frames::AnswerFrame out = answer_frame(library, head, words);
    out.id = head.id;
    if (!output.bytes(&out, sizeof out)) return 2;
  }
  return 0;
}

// ---- What the library says of itself. ----

std::string described(const Library& library, const std::string& file) {
  if (library.describe != nullptr) {
    const char* text = library.describe();
    if (text == nullptr) refuse("graze_engine_describe gives nothing");
    return text;
  }
  Engine engine;
  const std::size_t slash = file.find_last_of('/');
  for (const char c : slash == std::string::npos ? file : file.substr(slash + 1)) {
    const bool fine =
        (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' || c == '_';
    engine.name += fine ? c : '-';
  }
  for (const auto& [type, name] : shape_names()) {
    if (type < ShapeType::posed) engine.shapes.push_back(type);
  }
  for (const auto& [query, function] : library.calls) {
    std::vector<std::string>& answers = engine.queries[query].answers;
    if (query == Query::distance) {
      answers = {"distance"};
    } else if (query == Query::penetration) {
      answers = {"depth"};
    } else if (query != Query::overlap) {
      answers = {"time"};
    }
  }
  engine.timed = true;
  return write_engine(engine);
}

// The fields that the answers to each query hold. They come from the description, so a library need not list
// them twice.
std::map<Query, std::vector<std::string>> answers_of(const std::string& description) {
  std::map<Query, std::vector<std::string>> out;
  const json::Value line = json::read(description);
  const json::Value* queries = line.find("queries");
  if (queries == nullptr || queries->kind != json::Value::Kind::object)
    refuse("the description has no queries");
  for (std::size_t i = 0; i < queries->names.size(); ++i) {
    const std::string& name = queries->names[i];
    const std::optional<Query> query = value_of(name, query_names());
    if (!query) refuse("the description has an unknown query: " + name);
    std::vector<std::string>& answers = out[*query];
    if (const json::Value* list = queries->values[i].find("answers")) {
      for (const json::Value& answer : list->values) answers.push_back(answer.string);
    }
  }
  return out;
}

}  // namespace

int host_library(const std::string& file, const HostOptions& options) {
  program() = options.program;
  Output output;  // before the library is opened, which may print
  const Library library = open(file.c_str());
  const std::string description = described(library, file);
  std::map<Query, std::vector<std::string>> answers;
  try {
    answers = answers_of(description);
  } catch (const BadLine& bad) {
    refuse(std::string("the description is no JSON: ") + bad.what());
  }
  if (options.frames) return output(description) ? serve_frames(library, output) : 2;
  const auto function = [&](const Question& q) {
    return [&, asked = std::make_shared<Asked>(q, library), query = q.query]() -> Answer {
      const auto known = library.calls.find(query);
      if (known == library.calls.end()) return Answer::unsupported("no such function in the library");
      return call(known->second, *asked, answers[query]);
    };
  };
  return serve_lines(description, function, std::cin, output);
}

}  // namespace graze::adapter
