// Questions and answers as bytes, between graze and the process in which it loads a shared library. They hold the
// content of graze_engine.h without the reading and writing of lines. Only `graze host --frames` speaks this format,
// and both ends are of one build.
//
//   question   QuestionHead; body a; body b            a body: BodyHead; its shape
//   shape      ShapeHead; its vertices, three doubles each; its parts, shapes
//   answer     AnswerFrame
//
// Everything is a multiple of eight bytes long, so that vertices can be read in place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "graze_engine.h"

namespace graze::adapter::frames {

inline constexpr std::uint64_t kQuestion = 0x315145'5a415247, kAnswer = 0x315341'5a415247;
// A longer question is invalid.
inline constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 28;

struct QuestionHead {
  std::uint64_t magic = kQuestion;
  std::uint64_t size = 0;  // bytes of the whole question
  std::uint64_t id = 0;
  std::uint32_t query = 0;  // graze_engine_query
  std::int32_t repeat = 0;  // as in graze.question/1, 0 if the time is not requested
  std::uint32_t pass_over = 0, unused = 0;
  double origin[3] = {}, direction[3] = {};
  double t_max = 0, target_distance = 0;
};

struct BodyHead {
  double position[3] = {}, orientation[4] = {}, displacement[3] = {}, rotation[3] = {}, pivot[3] = {};
};

struct ShapeHead {
  std::uint32_t type = 0, unused = 0;  // graze_engine_shape_type
  std::uint64_t vertex_count = 0, part_count = 0;
  double radius = 0, half_height = 0, half_extents[3] = {}, radii[3] = {};
  double position[3] = {}, orientation[4] = {};
};

struct AnswerFrame {
  std::uint64_t magic = kAnswer;
  std::uint64_t id = 0;
  std::uint32_t outcome = 0, unused = 0;  // graze_engine_outcome
  double ns = std::numeric_limits<double>::quiet_NaN();
  graze_engine_answer answer = {};
};
static_assert(sizeof(QuestionHead) % 8 == 0 && sizeof(BodyHead) % 8 == 0 && sizeof(ShapeHead) % 8 == 0);

}  // namespace graze::adapter::frames
