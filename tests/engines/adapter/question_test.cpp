// Questions as structs: every field and every shape, and what is missing is named.
#include <gtest/gtest.h>
#include <graze_adapter.hpp>

#include <cmath>
#include <string>

namespace graze::adapter {
namespace {

std::string asked(const std::string& shape, const std::string& more = R"("t_max": 1)") {
  return R"({"schema": "graze.question/1", "id": "q", "query": "cast", "a": {"shape": )" + shape +
         R"(, "position": [1, 2, 3], "orientation": [0.5, -0.5, 0.5, 0.5], "displacement": [4, 5, 6]},
          "b": {"shape": {"type": "point"}}, )" +
         more + "}";
}
Shape shape_in(const std::string& shape) { return read_question(asked(shape)).a.shape; }

std::string refusal(const std::string& line) {
  try {
    read_question(line);
  } catch (const BadLine& bad) {
    return bad.what();
  }
  return "it was read";
}

TEST(Question, EveryFieldIsRead) {
  const Question q = read_question(
      R"({"schema": "graze.question/1", "id": "one", "query": "rotating_cast", "t_max": 2.5, "target_distance": 0.25,
          "start_policy": "pass_over", "repeat": 7, "later": {"unknown": [1]},
          "a": {"shape": {"type": "sphere", "radius": 0.5}, "position": [1, 2, 3], "orientation": [0.6, 0, 0.8, 0],
                "displacement": [-1, 0, 1], "rotation": [0.1, 0.2, 0.3], "pivot": [7, 8, 9]},
          "b": {"shape": {"type": "point"}, "position": [0, 0, 0], "orientation": [1, 0, 0, 0],
                "displacement": [0, 0, 0], "rotation": [0, 0, 0], "pivot": [0, 0, 0]}})");
  EXPECT_EQ(q.id, "one");
  EXPECT_EQ(q.query, Query::rotating_cast);
  EXPECT_EQ(q.t_max, 2.5);
  EXPECT_EQ(q.target_distance, 0.25);
  EXPECT_TRUE(q.pass_over);
  EXPECT_EQ(q.repeat, 7);
  EXPECT_EQ(q.a.position, (Vector{1, 2, 3}));
  EXPECT_EQ(q.a.orientation.w, 0.6);
  EXPECT_EQ(q.a.orientation.y, 0.8);
  EXPECT_EQ(q.a.displacement, (Vector{-1, 0, 1}));
  EXPECT_EQ(q.a.rotation, (Vector{0.1, 0.2, 0.3}));
  EXPECT_EQ(q.a.pivot, (Vector{7, 8, 9}));
}

TEST(Question, ARayHasNoB) {
  const Question q = read_question(
      R"({"schema": "graze.question/1", "id": "r", "query": "ray", "t_max": "inf", "origin": [1, 2, 3],
          "direction": [0, 0, -1], "a": {"shape": {"type": "box", "half_extents": [1, 2, 3]}}})");
  EXPECT_EQ(q.query, Query::ray);
  EXPECT_TRUE(std::isinf(q.t_max));
  EXPECT_EQ(q.origin, (Vector{1, 2, 3}));
  EXPECT_EQ(q.direction, (Vector{0, 0, -1}));
  EXPECT_EQ(q.a.shape.half_extents, (Vector{1, 2, 3}));
}

TEST(Question, EveryShapeIsRead) {
  EXPECT_EQ(shape_in(R"({"type": "point"})").type, ShapeType::point);
  EXPECT_EQ(shape_in(R"({"type": "segment", "a": [0, 0, 1], "b": [0, 1, 0]})").vertices[1],
            (Vector{0, 1, 0}));
  EXPECT_EQ(
      shape_in(R"({"type": "triangle", "a": [0, 0, 1], "b": [0, 1, 0], "c": [1, 0, 0]})").vertices.size(),
      3U);
  for (const char* type : {"capsule", "cylinder", "cone"}) {
    const Shape shape =
        shape_in(R"({"type": ")" + std::string(type) + R"(", "radius": 0.5, "half_height": 2})");
    EXPECT_EQ(name_of(shape.type, shape_names()), type);
    EXPECT_EQ(shape.radius, 0.5);
    EXPECT_EQ(shape.half_height, 2);
  }
  EXPECT_EQ(shape_in(R"({"type": "ellipsoid", "radii": [1, 2, 3]})").radii, (Vector{1, 2, 3}));
  const Shape hull = shape_in(
      R"({"type": "hull", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], "faces": [[0, 2, 1], [1, 2, 3]]})");
  EXPECT_EQ(hull.vertices.size(), 4U);
  EXPECT_EQ(hull.faces[1], (std::vector<std::size_t>{1, 2, 3}));
  const Shape deep = shape_in(
      R"({"type": "sum", "shapes": [{"type": "rounded", "radius": 0.25, "shape": {"type": "point"}},
          {"type": "hull_of", "shapes": [{"type": "posed", "position": [1, 0, 0], "orientation": [0, 1, 0, 0],
                                          "shape": {"type": "sphere", "radius": 3}}]}]})");
  EXPECT_EQ(deep.parts[0].radius, 0.25);
  EXPECT_EQ(deep.parts[1].parts[0].orientation.x, 1);
  EXPECT_EQ(deep.parts[1].parts[0].parts[0].radius, 3);
}

TEST(Question, WhatIsMissingOrWrongIsNamed) {
  EXPECT_EQ(refusal(R"({"id": "q"})"), "question.schema: missing");
  EXPECT_EQ(refusal(asked(R"({"type": "sphere"})")), "a.shape.radius: missing");
  EXPECT_EQ(refusal(asked(R"({"type": "sphere", "radius": "1"})")), "a.shape.radius: a number is expected");
  EXPECT_EQ(refusal(asked(R"({"type": "box", "half_extents": [1, 2]})")),
            "a.shape.half_extents: an array of 3 numbers is expected");
  EXPECT_EQ(refusal(asked(R"({"type": "hull", "vertices": []})")),
            "a.shape.vertices: an array is expected, not empty");
  EXPECT_EQ(refusal(asked(R"({"type": "hull", "vertices": [[0, 0, 0], [0, null, 0]]})")),
            "a.shape.vertices[1]: a number is expected");
  EXPECT_EQ(refusal(asked(R"({"type": "torus"})")), "a.shape.type: the shape \"torus\" is not known");
  EXPECT_EQ(refusal(asked(R"({"type": "point"})", R"("t_max": true)")), "t_max: a number is expected");
  EXPECT_EQ(refusal(asked(R"({"type": "point"})", R"("t_max": 1, "repeat": 0)")),
            "repeat: a count from 1 to 1e9 is expected");
  EXPECT_EQ(refusal("[1]"), "question: an object is expected");
}

}  // namespace
}  // namespace graze::adapter
