// The reader's refusals, each with its one line: the file, the field, the error, and the valid values.
#include <gtest/gtest.h>

#include <fstream>

#include "corpus/curate/flags.hpp"
#include "corpus/format/case_io.hpp"

namespace graze::corpus {
namespace {

const char* const kSound =
    R"({"schema": "graze.case/1", "id": "t/1", "a": {"shape": {"type": "point"}}, "b": {"shape": {"type": "point"}}})";

// A case whose first body is `body`.
std::string with_body(const std::string& body) {
  return R"({"schema": "graze.case/1", "id": "t/1", "a": )" + body +
         R"(, "b": {"shape": {"type": "point"}}})";
}
std::string with_shape(const std::string& shape) { return with_body(R"({"shape": )" + shape + "}"); }
// A point in so many roundings.
std::string nested(int depth) {
  std::string text = R"({"type": "point"})";
  for (int i = 0; i < depth; ++i) text = R"({"type": "rounded", "radius": 0, "shape": )" + text + "}";
  return text;
}
// A sound case with more fields.
std::string with_fields(const std::string& fields) {
  const std::string sound = kSound;
  return sound.substr(0, sound.size() - 1) + ", " + fields + "}";
}

struct Malformation {
  const char* name;
  std::string text;
  const char* field;    // the path that must be named
  const char* message;  // a part of what must be said
};

void PrintTo(const Malformation& m, std::ostream* out) { *out << m.name; }

const Malformation kMalformations[] = {
    {"not_json", "hello", "", "not JSON"},
    {"cut_off", R"({"schema": "graze.case/1", "id")", "", "not JSON: parse error at line 1"},
    {"two_objects", std::string(kSound) + kSound, "", "not JSON"},
    // The parser takes a NUL for the end, and would leave the rest unread.
    {"nul_after_the_case", kSound + std::string("\0", 1), "",
     "not JSON: a NUL byte at column 110; JSON is text"},
    {"bytes_after_a_nul", kSound + std::string("\0{\"id\": 2}", 11), "",
     "not JSON: a NUL byte at column 110"},
    {"nul_on_another_line", kSound + std::string("\n \0", 3), "", "not JSON: a NUL byte at line 2, column 2"},
    {"nul_within", std::string("{\0}", 3), "", "not JSON: a NUL byte at column 2"},
    {"nan_literal", with_shape(R"({"type": "sphere", "radius": NaN})"), "", "not JSON"},
    {"an_array", std::string("[") + kSound + "]", "", "an array of 1; an object with the fields schema"},
    {"deep_arrays", std::string(100000, '['), "[0][0]", "nested deeper than 64 levels"},
    {"deep_objects",
     [] {
       std::string text;
       for (int i = 0; i < 100000; ++i) text += "{\"a\":";
       return text;
     }(),
     "a.a.a", "nested deeper than 64 levels"},
    {"many_fields",
     [] {
       std::string text = "{";
       for (int i = 0; i < 100000; ++i) text += "\"f" + std::to_string(i) + "\":0,";
       return text + "\"z\":0}";
     }(),
     "f63", "more than 64 fields"},
    {"duplicate_key", with_fields(R"("t_max": 1, "t_max": 2)"), "t_max", "appears twice"},
    {"duplicate_key_inside", with_shape(R"({"type": "sphere", "radius": 1, "radius": 1})"), "a.shape.radius",
     "appears twice"},
    {"duplicate_key_after_an_object", with_fields(R"("expect": {"by": "x"}, "id": "other")"), "id",
     "appears twice"},
    {"no_schema", R"({"id": "t/1"})", "schema", "missing; \"graze.case/1\""},
    {"later_schema", R"({"schema": "graze.case/3", "id": "t/1"})", "schema",
     "this version reads \"graze.case/1\" and \"graze.case/2\""},
    {"scene", R"({"schema": "graze.scene/1", "id": "s", "ask": "pair"})", "",
     "holds a scene (graze.scene/1); graze scene answers it"},
    {"measure_of_the_second_schema", with_fields(R"("expect": {"by": "x", "clearance": 1})"),
     "expect.clearance", "a field of \"graze.case/2\""},
    {"no_id", R"({"schema": "graze.case/1"})", "id", "missing; every case has an id"},
    {"empty_id", R"({"schema": "graze.case/1", "id": ""})", "id", "an id is made of letters"},
    {"id_with_space", R"({"schema": "graze.case/1", "id": "a b"})", "id", "an id is made of letters"},
    {"no_body", R"({"schema": "graze.case/1", "id": "t/1", "a": {"shape": {"type": "point"}}})", "b",
     "missing; a case has two bodies"},
    {"body_a_number", with_body("3"), "a", "the number 3; an object with the fields shape"},
    {"unknown_field", with_fields(R"("tmax": 2)"), "", "unknown field \"tmax\"; known fields: schema, id"},
    {"unknown_field_of_a_body", with_body(R"({"shape": {"type": "point"}, "velocity": [0, 0, 0]})"), "a",
     "unknown field \"velocity\"; known fields: shape, position"},
    {"unknown_field_of_a_shape", with_shape(R"({"type": "point", "radius": 0})"), "a.shape",
     "unknown field \"radius\"; known fields: type"},
    {"no_shape", with_body("{}"), "a.shape", "missing"},
    {"no_type", with_shape("{}"), "a.shape.type",
     "missing; one of point, segment, triangle, sphere, capsule, box"},
    {"type_a_number", with_shape(R"({"type": 1})"), "a.shape.type", "the number 1; a string"},
    {"unknown_type", with_shape(R"({"type": "blob"})"), "a.shape.type",
     "unknown shape type \"blob\"; one of point"},
    {"segment_missing_end", with_shape(R"({"type": "segment", "a": [0, 0, 0]})"), "a.shape.b",
     "missing; each corner is an array of three numbers"},
    {"triangle_corner_short",
     with_shape(R"({"type": "triangle", "a": [0, 0, 0], "b": [1, 0, 0], "c": [0, 1]})"), "a.shape.c",
     "an array of 2; each corner is an array of three numbers"},
    {"capsule_height_missing", with_shape(R"({"type": "capsule", "radius": 1})"), "a.shape.half_height",
     "missing; a length, zero or more"},
    {"cylinder_radius_negative", with_shape(R"({"type": "cylinder", "radius": -2, "half_height": 1})"),
     "a.shape.radius", "-2 is negative; zero or more"},
    {"cone_height_negative", with_shape(R"({"type": "cone", "radius": 2, "half_height": -1})"),
     "a.shape.half_height", "-1 is negative; zero or more"},
    {"cone_unknown_field", with_shape(R"({"type": "cone", "radius": 2, "height": 1})"), "a.shape",
     "unknown field \"height\"; known fields: type, radius or half_height"},
    {"ellipsoid_radii_negative", with_shape(R"({"type": "ellipsoid", "radii": [1, -1, 1]})"),
     "a.shape.radii[1]", "-1 is negative; radii is an array of three numbers, zero or more"},
    {"rounded_without_shape", with_shape(R"({"type": "rounded", "radius": 1})"), "a.shape.shape",
     "missing; rounded has the shape that it rounds"},
    {"rounded_radius_negative",
     with_shape(R"({"type": "rounded", "shape": {"type": "point"}, "radius": -1})"), "a.shape.radius",
     "-1 is negative"},
    {"posed_zero_quaternion",
     with_shape(R"({"type": "posed", "shape": {"type": "point"}, "orientation": [0, 0, 0, 0]})"),
     "a.shape.orientation", "a zero quaternion"},
    {"sum_of_nothing", with_shape(R"({"type": "sum", "shapes": []})"), "a.shape.shapes",
     "an empty array; shapes is an array of one or more shapes"},
    {"sum_without_shapes", with_shape(R"({"type": "sum"})"), "a.shape.shapes",
     "missing; shapes is an array of one or more shapes"},
    {"hull_of_a_null", with_shape(R"({"type": "hull_of", "shapes": [{"type": "point"}, null]})"),
     "a.shape.shapes[1]", "null; a shape is an object with a type"},
    {"deep_inside",
     with_shape(
         R"({"type": "sum", "shapes": [{"type": "rounded", "radius": 0, "shape": {"type": "sphere", "radius": "x"}}]})"),
     "a.shape.shapes[0].shape.radius", "the string \"x\""},
    {"nested_too_deep", with_shape(nested(17)), "a.shape.shape.shape", "nested deeper than 16 combinators"},
    {"radius_missing", with_shape(R"({"type": "sphere"})"), "a.shape.radius",
     "missing; a sphere has a radius"},
    {"radius_negative", with_shape(R"({"type": "sphere", "radius": -1})"), "a.shape.radius",
     "-1 is negative; zero or more"},
    {"radius_overflow", with_shape(R"({"type": "sphere", "radius": 1e999})"), "a.shape.radius",
     "beyond the largest double"},
    {"radius_hexfloat_overflow", with_shape(R"({"type": "sphere", "radius": "0x1p1024"})"), "a.shape.radius",
     "beyond the largest double"},
    {"radius_nan", with_shape(R"({"type": "sphere", "radius": "nan"})"), "a.shape.radius",
     "the string \"nan\"; a finite decimal"},
    {"radius_inf", with_shape(R"({"type": "sphere", "radius": "inf"})"), "a.shape.radius",
     "the string \"inf\"; a finite decimal"},
    {"radius_decimal_string", with_shape(R"({"type": "sphere", "radius": "1.5"})"), "a.shape.radius",
     "hexfloat"},
    {"radius_bad_hexfloat", with_shape(R"({"type": "sphere", "radius": "0x1.8p+1x"})"), "a.shape.radius",
     "hexfloat"},
    {"radius_null", with_shape(R"({"type": "sphere", "radius": null})"), "a.shape.radius",
     "null; a finite decimal"},
    {"extents_short", with_shape(R"({"type": "box", "half_extents": [1, 2]})"), "a.shape.half_extents",
     "an array of 2; half_extents is an array of three numbers"},
    {"extents_negative", with_shape(R"({"type": "box", "half_extents": [1, 2, -3]})"),
     "a.shape.half_extents[2]", "-3 is negative"},
    {"hull_empty", with_shape(R"({"type": "hull", "vertices": []})"), "a.shape.vertices", "an empty hull"},
    {"hull_missing_vertices", with_shape(R"({"type": "hull"})"), "a.shape.vertices", "missing"},
    {"vertex_missing", with_shape(R"({"type": "hull", "vertices": [[0,0,0], [1,0,0], [0,1,0], null]})"),
     "a.shape.vertices[3]", "missing; each vertex is an array of three numbers"},
    {"vertex_short", with_shape(R"({"type": "hull", "vertices": [[0, 0, 0], [1, 0]]})"),
     "a.shape.vertices[1]", "an array of 2; each vertex is an array of three numbers"},
    {"vertex_text", with_shape(R"({"type": "hull", "vertices": [[0, 0, "x"]]})"), "a.shape.vertices[0][2]",
     "the string \"x\""},
    {"faces_a_number", with_shape(R"({"type": "hull", "vertices": [[0, 0, 0]], "faces": 1})"),
     "a.shape.faces", "faces is an array of arrays"},
    {"face_short", with_shape(R"({"type": "hull", "vertices": [[0, 0, 0]], "faces": [[0, 0]]})"),
     "a.shape.faces[0]", "three or more"},
    {"face_beyond", with_shape(R"({"type": "hull", "vertices": [[0, 0, 0]], "faces": [[0, 0, 1]]})"),
     "a.shape.faces[0][2]", "no vertex 1; the hull has 1"},
    {"face_fraction", with_shape(R"({"type": "hull", "vertices": [[0, 0, 0]], "faces": [[0, 0, 0.5]]})"),
     "a.shape.faces[0][2]", "an index is an integer from 0"},
    {"position_object", with_body(R"({"shape": {"type": "point"}, "position": {"x": 0}})"), "a.position",
     "an object; a position is an array of three numbers"},
    {"orientation_zero", with_body(R"({"shape": {"type": "point"}, "orientation": [0, 0, 0, 0]})"),
     "a.orientation", "a zero quaternion"},
    {"orientation_three", with_body(R"({"shape": {"type": "point"}, "orientation": [1, 0, 0]})"),
     "a.orientation", "four numbers w, x, y, z"},
    {"t_max_negative", with_fields(R"("t_max": -1)"), "t_max", "-1 is negative"},
    {"t_max_text", with_fields(R"("t_max": "forever")"), "t_max", "the string \"forever\""},
    {"target_negative", with_fields(R"("target_distance": -0.5)"), "target_distance", "-0.5 is negative"},
    {"target_infinite", with_fields(R"("target_distance": "inf")"), "target_distance", "a finite decimal"},
    {"policy_unknown", with_fields(R"("start_policy": "ignore")"), "start_policy",
     "one of report or pass_over"},
    {"query_unknown", with_fields(R"("query": "sweep")"), "query", "one of cast, line, overlap"},
    {"direction_without_query", with_fields(R"("direction": [1, 0, 0])"), "direction", "penetration_along"},
    {"direction_missing", with_fields(R"("query": "penetration_along")"), "direction", "missing"},
    {"direction_zero", with_fields(R"("query": "penetration_along", "direction": [0, 0, 0])"), "direction",
     "zero"},
    {"flags_text", with_fields(R"("flags": "Ray")"), "flags", "flags is an array of strings"},
    {"flag_twice", with_fields(R"("flags": ["Ray", "Ray"])"), "flags[1]", "appears twice"},
    {"hardness_text", with_fields(R"("hardness": "high")"), "hardness", "the string \"high\""},
    {"expect_without_by", with_fields(R"("expect": {"outcome": "hit"})"), "expect.by", "missing; the oracle"},
    {"expect_by_core", with_fields(R"("expect": {"by": "core"})"), "expect.by", "never core"},
    {"expect_outcome", with_fields(R"("expect": {"by": "x", "outcome": "maybe"})"), "expect.outcome",
     "one of initially_overlapping, hit"},
    {"expect_toi_crossed", with_fields(R"("expect": {"by": "x", "toi": {"lower": 2, "upper": 1}})"),
     "expect.toi", "lower is above upper"},
    {"expect_toi_exact",
     with_fields(R"("expect": {"by": "x", "toi": {"lower": 0, "upper": 1, "exact": "1/0"}})"),
     "expect.toi.exact", "a fraction such as"},
    {"long_text", with_shape("{\"type\": \"" + std::string(10000, 'x') + "\"}"), "a.shape.type", "xxx..."},
};

class Malformed : public testing::TestWithParam<Malformation> {};

TEST_P(Malformed, IsRefusedInOneLineThatNamesTheField) {
  const Malformation& malformation = GetParam();
  const ReadResult result = read_text(malformation.text, "cases/x.json", false);
  ASSERT_EQ(result.errors.size(), 1u);
  EXPECT_TRUE(result.cases.empty());
  const std::string line = result.errors[0].text();
  EXPECT_EQ(result.errors[0].field.substr(0, std::string(malformation.field).size()), malformation.field)
      << line;
  EXPECT_NE(line.find(malformation.message), std::string::npos) << line;
  EXPECT_EQ(line.substr(0, 14), "cases/x.json: ") << line;
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  EXPECT_LT(line.size(), 500u) << line;
}

INSTANTIATE_TEST_SUITE_P(Table, Malformed, testing::ValuesIn(kMalformations),
                         [](const auto& table) { return std::string(table.param.name); });

TEST(CaseReader, SixteenCombinatorsDeepIsRead) {
  EXPECT_TRUE(read_text(with_shape(nested(16)), "x", false).ok());
  std::string sums = R"({"type": "hull", "vertices": [[0, 0, 0]]})";
  for (int i = 0; i < 16; ++i) sums = R"({"type": "sum", "shapes": [)" + sums + "]}";
  const ReadResult result = read_text(with_shape(sums), "x", false);
  EXPECT_TRUE(result.ok()) << result.errors[0].text();
}

TEST(CaseReader, ReadsEveryShape) {
  const ReadResult result = read_text(with_shape(R"({"type": "sum", "shapes": [
          {"type": "segment", "a": [1, 2, 3], "b": [4, 5, 6]},
          {"type": "triangle", "a": [1, 0, 0], "b": [0, 1, 0], "c": [0, 0, 1]},
          {"type": "capsule", "radius": 1, "half_height": 2},
          {"type": "cylinder", "radius": 3, "half_height": 4},
          {"type": "cone", "radius": 5, "half_height": 6},
          {"type": "ellipsoid", "radii": [1, 2, 0]},
          {"type": "rounded", "shape": {"type": "box", "half_extents": [1, 1, 1]}, "radius": 0.5},
          {"type": "hull_of", "shapes": [{"type": "point"},
              {"type": "posed", "shape": {"type": "sphere", "radius": 1}, "position": [0, 0, 7],
               "orientation": [1, 1, 0, 0]}]}]})"),
                                      "x", false);
  ASSERT_TRUE(result.ok()) << result.errors[0].text();
  const auto& parts = std::get<Sum<double>>(result.cases[0].a.shape).shapes;
  ASSERT_EQ(parts.size(), 8u);
  EXPECT_EQ(std::get<Segment<double>>(parts[0]->shape).b, Vec3<double>(4, 5, 6));
  EXPECT_EQ(std::get<Triangle<double>>(parts[1]->shape).c, Vec3<double>(0, 0, 1));
  EXPECT_EQ(std::get<Capsule<double>>(parts[2]->shape).half_height, 2);
  EXPECT_EQ(std::get<Cylinder<double>>(parts[3]->shape).radius, 3);
  EXPECT_EQ(std::get<Cone<double>>(parts[4]->shape).half_height, 6);
  EXPECT_EQ(std::get<Ellipsoid<double>>(parts[5]->shape).radii, Vec3<double>(1, 2, 0));
  EXPECT_EQ(std::get<Rounded<double>>(parts[6]->shape).radius, 0.5);
  const auto& pair = std::get<HullOf<double>>(parts[7]->shape).shapes;
  const auto& posed = std::get<Posed<double>>(pair.at(1)->shape);
  EXPECT_EQ(posed.position, Vec3<double>(0, 0, 7));
  EXPECT_EQ(posed.orientation.x, 1);
  EXPECT_EQ(std::get<Sphere<double>>(posed.shape->shape).radius, 1);
}

TEST(CaseReader, TheWholeMessageReadsAsItShould) {
  const std::string text = with_shape(R"({"type": "hull", "vertices": [[0,0,0], [1,0,0], [0,1,0], null]})");
  EXPECT_EQ(read_text(text, "cases/x.json", false).errors.at(0).text(),
            "cases/x.json: a.shape.vertices[3]: missing; each vertex is an array of three numbers");
}

TEST(CaseReader, KeepsTheGoodLinesOfAFileWithABadOne) {
  const std::string second = R"({"schema": "graze.case/1", "id": "t/2", "a": 1, "b": 2})";
  std::string third = kSound;
  third.replace(third.find("t/1"), 3, "t/3");
  const ReadResult result =
      read_text(std::string(kSound) + "\n\r\n" + second + "\r\n" + third, "x.jsonl", true);
  ASSERT_EQ(result.cases.size(), 2u);
  EXPECT_EQ(result.cases[0].id, "t/1");
  EXPECT_EQ(result.cases[1].id, "t/3");
  ASSERT_EQ(result.errors.size(), 1u);
  EXPECT_EQ(result.errors[0].line, 3);
  EXPECT_EQ(result.errors[0].text().substr(0, 13), "x.jsonl:3: a:");
}

TEST(CaseReader, AnIdReadTwiceIsAnError) {
  const ReadResult result = read_text(std::string(kSound) + "\n" + kSound, "x.jsonl", true);
  EXPECT_EQ(result.cases.size(), 1u);
  ASSERT_EQ(result.errors.size(), 1u);
  EXPECT_NE(result.errors[0].what.find("already read"), std::string::npos);
}

TEST(CaseReader, AnEmptyReadFails) {
  EXPECT_FALSE(read_text("", "x.json", false).ok());
  EXPECT_FALSE(read_text(" \n\t\n", "x.json", false).ok());
  EXPECT_FALSE(read_text("\n\r\n", "x.jsonl", true).ok());
  const auto directory = std::filesystem::path(testing::TempDir()) / "graze_no_cases";
  std::filesystem::create_directories(directory);
  EXPECT_FALSE(read_directory(directory).ok());
}

TEST(CaseReader, AFileThatCannotBeReadIsAnError) {
  const auto missing = std::filesystem::path(testing::TempDir()) / "graze_not_there.json";
  EXPECT_NE(
      read_file(missing).errors.at(0).text().find("cannot be opened: No such file or directory; a readable"),
      std::string::npos);
  EXPECT_NE(read_file(testing::TempDir()).errors.at(0).text().find("a directory"), std::string::npos);
  EXPECT_FALSE(read_directory(missing).ok());
}

TEST(CaseReader, TheExtensionSaysWhetherAFileHoldsLines) {
  const auto path = std::filesystem::path(testing::TempDir()) / "graze_two.jsonl";
  std::string other = kSound;
  other.replace(other.find("t/1"), 3, "t/2");
  std::ofstream(path) << kSound << "\n" << other << "\n";
  const ReadResult result = read_file(path);
  EXPECT_TRUE(result.ok());
  EXPECT_EQ(result.cases.size(), 2u);
}

TEST(CaseReader, NumbersAreTheNearestDoubles) {
  const ReadResult result = read_text(
      with_body(
          R"({"shape": {"type": "sphere", "radius": "0x1.8p+1"}, "position": [0.1, "-0x1p-1074", 9007199254740993],
                  "displacement": [123456789012345678901234567890, 1e-400, "0x.8p0"]})"),
      "x", false);
  ASSERT_TRUE(result.ok()) << result.errors[0].text();
  const Body<double>& a = result.cases[0].a;
  EXPECT_EQ(std::get<Sphere<double>>(a.shape).radius, 3);
  EXPECT_EQ(a.position, Vec3<double>(0.1, -0x1p-1074, 9007199254740992.0));
  EXPECT_EQ(a.displacement, Vec3<double>(123456789012345678901234567890.0, 0, 0.5));
}

TEST(FlagNotes, AreRefusedWithTheFieldNamed) {
  EXPECT_NE(read_flag_notes("[]", "flags.json").error, "");
  EXPECT_NE(read_flag_notes("{", "flags.json").error, "");
  EXPECT_EQ(read_flag_notes(R"({"Ray": {"breaks": "x", "affects": "y"}})", "flags.json").error,
            "flags.json: Ray.cases: missing; an array of ids");
}

}  // namespace
}  // namespace graze::corpus
