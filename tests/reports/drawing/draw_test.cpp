// Pictures of cases: what they show is where it is, they are XML whatever the case, and the page of families
// has one of each.
#include "reports/drawing/draw.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "corpus/families.hpp"
#include "corpus/format/case_io.hpp"
#include "reports/drawing/draw_families.hpp"
#include "reports/drawing/drawn_scene.hpp"

namespace graze::draw {
namespace {

const std::filesystem::path kRoot = GRAZE_SOURCE_DIR;

corpus::Case case_of(const std::string& text) {
  const corpus::ReadResult read =
      corpus::read_text(R"({"schema": "graze.case/1", )" + text + "}", "case", false);
  EXPECT_TRUE(read.ok()) << (read.errors.empty() ? "" : read.errors[0].text());
  return read.cases.empty() ? corpus::Case{} : read.cases[0];
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// Well-formed, and every number of it is one.
void expect_picture(const std::string& svg, const std::string& id) {
  std::istringstream stream(svg);
  boost::property_tree::ptree tree;
  ASSERT_NO_THROW(boost::property_tree::read_xml(stream, tree)) << id;
  EXPECT_EQ(tree.get<std::string>("svg.title"), id);
  for (const auto& [name, element] : tree.get_child("svg")) {
    for (const char* attribute : {"points", "d", "x", "y", "cx", "cy", "width", "height"}) {
      const std::string value = element.get<std::string>(std::string("<xmlattr>.") + attribute, "");
      EXPECT_EQ(value.find("nan"), std::string::npos) << id;
      EXPECT_EQ(value.find("inf"), std::string::npos) << id;
    }
  }
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

constexpr const char* kFalls = R"("id": "test/falls",
 "a": {"shape": {"type": "box", "half_extents": [4, 4, 1]}},
 "b": {"shape": {"type": "sphere", "radius": 1}, "position": [-2, 0, 6], "displacement": [4, 0, -8]})";

TEST(Outline, OfABoxIsItsCornersAndOfABallIsWithinTheTolerance) {
  const View view;
  const Window window{.middle = Flat::Zero(), .half_width = 8, .half_height = 8};
  const std::vector<Flat> square = outline(Box<double>{{3, 2, 1}}, {}, view, window, Real(1e-3));
  ASSERT_EQ(square.size(), 4U);
  for (const Flat& p : square) EXPECT_EQ(p.cwiseAbs(), Flat(3, 2));

  const std::vector<Flat> circle = outline(Sphere<double>{2}, {}, view, window, Real(1e-3));
  EXPECT_GT(circle.size(), 32U);
  for (std::size_t i = 0; i < circle.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(circle[i].norm()), 2, 1e-15);
    const Flat middle = (circle[i] + circle[(i + 1) % circle.size()]) / 2;
    EXPECT_GT(middle.norm(), 2 - Real(1e-3));
  }
}

TEST(Outline, AtAGreatMagnificationIsFineWhereItIsSeenOnly) {
  // The top of a ball of radius 4, a millionth wide: the arc rises by (1e-6)^2 / 8 there.
  const Window window{.middle = {0, 4}, .half_width = Real(1e-6), .half_height = Real(1e-6)};
  const std::vector<Flat> arc = outline(Sphere<double>{4}, {}, {}, window, Real(1e-14));
  const auto inside = std::count_if(arc.begin(), arc.end(), [&](const Flat& p) {
    return std::abs(p[0]) < window.half_width && std::abs(p[1] - 4) < window.half_height;
  });
  EXPECT_GE(inside, 2);
  EXPECT_LT(arc.size(), 200U);
}

TEST(Edges, OfABoxAreNineOnTheViewersSide) {
  const Vec towards = Vec(1, 2, 3).normalized(), right = towards.unitOrthogonal();
  const View oblique{.right = right, .up = towards.cross(right), .towards = towards};
  EXPECT_EQ(visible_edges(Box<double>{{3, 2, 1}}, {}, oblique).size(), 9U);
  EXPECT_EQ(visible_edges(Box<double>{{3, 2, 1}}, {}, {}).size(), 4U);
  EXPECT_TRUE(visible_edges(Sphere<double>{1}, {}, oblique).empty());
}

TEST(Scene, OfAHitIsWhereAndWhenTheBodiesMeetAndIsSeenFromTheSide) {
  const corpus::Case falls = case_of(kFalls);
  const Scene scene = make_scene(falls);
  EXPECT_TRUE(scene.has_contact);
  EXPECT_DOUBLE_EQ(static_cast<double>(scene.moment), 0.5);
  EXPECT_LT((scene.focus - Vec(0, 0, 1)).norm(), Real(1e-14));
  const View view = make_view(scene, std::nullopt);
  EXPECT_LT((view.up - Vec(0, 0, 1)).norm(), Real(1e-14));
  EXPECT_LT((view.right - Vec(1, 0, 0)).norm(), Real(1e-14));
  const View from_above = make_view(scene, Vec3<double>(0, 0, 5));
  EXPECT_LT((from_above.towards - Vec(0, 0, 1)).norm(), Real(1e-14));
}

TEST(Scene, OfAMissIsTheNearestApproachAndItsClearance) {
  // Passes the corner (1, 1) of the square along the diagonal, sqrt(2) - 0.01 of the way out.
  const corpus::Case passes = case_of(R"("id": "test/passes", "t_max": "inf",
 "a": {"shape": {"type": "box", "half_extents": [1, 1, 1]}},
 "b": {"shape": {"type": "point"}, "position": [6, -3.98, 0], "displacement": [-3, 3, 0]})");
  const Scene scene = make_scene(passes);
  EXPECT_FALSE(scene.has_contact);
  EXPECT_NEAR(static_cast<double>(scene.moment), 4.99 / 3, 1e-9);
  ASSERT_TRUE(scene.margin);
  EXPECT_NEAR(static_cast<double>(*scene.margin), 0.01 * std::sqrt(2.0), 1e-14);
}

TEST(Picture, MagnifiesAClearanceOfAMillionthUntilItIsSeen) {
  const std::string svg = draw_svg(corpus::find_family("grazing_edge")->generate(6, 2));
  EXPECT_NE(svg.find("miss; clearance: 10⁻⁶"), std::string::npos) << svg;
  EXPECT_NE(svg.find(">× 10⁷<"), std::string::npos) << svg;
}

TEST(Picture, OfASceneMovedFarAwayIsTheSame) {
  corpus::Case near = case_of(kFalls), far = near;
  const Vec3<double> offset(0x1p27, -0x1p26, 0x1p25);
  far.a.position += offset;
  far.b.position += offset;
  std::string moved = draw_svg(far);
  const std::string note = "; 1.5·10⁸ from the origin";
  ASSERT_NE(moved.find(note), std::string::npos) << moved;
  moved.erase(moved.find(note), note.size());
  EXPECT_EQ(moved, draw_svg(near));
}

TEST(Picture, IsWellFormedForEveryFamilyAtItsExtremes) {
  for (const auto list : {corpus::families(), corpus::rotating_families()}) {
    for (const corpus::Family& family : list) {
      for (const double level :
           {family.levels.front(), family.levels[family.levels.size() / 2], family.levels.back()}) {
        const corpus::Case problem = family.generate(level, 3);
        expect_picture(draw_svg(problem), problem.id);
      }
    }
  }
}

TEST(Picture, IsWellFormedForEveryCuratedCase) {
  const corpus::ReadResult read = corpus::read_directory(kRoot / "corpus/cases");
  ASSERT_FALSE(read.cases.empty());
  for (const corpus::Case& problem : read.cases) expect_picture(draw_svg(problem), problem.id);
}

TEST(Picture, OfACaseThatIsRefusedSaysSoAndDrawsNothing) {
  corpus::Case refused = case_of(kFalls);
  refused.id = "a < b & \"c\"";
  refused.a.orientation = {0, 0, 0, 0};
  const std::string svg = draw_svg(refused);
  expect_picture(svg, refused.id);
  EXPECT_NE(svg.find("invalid_input"), std::string::npos);
  EXPECT_EQ(count(svg, "<polygon"), 0U);
}

// The page: a section `### name` and a picture for each family, and for nothing else.
TEST(PageOfFamilies, HasASectionAndAPictureOfEachAndOfNothingElse) {
  std::set<std::string> names, sections, shown, pictures;
  for (const FamilyPicture& picture : family_pictures()) names.insert(picture.family);
  std::istringstream page(text_of(kRoot / "docs/reference/families.md"));
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("### ")) sections.insert(line.substr(4));
    if (line.starts_with("![")) shown.insert(line);
  }
  std::set<std::string> expected_shown;
  for (const std::string& name : names)
    expected_shown.insert("![" + name + "](../pictures/families/" + name + ".svg)");
  for (const auto& entry : std::filesystem::directory_iterator(kRoot / "docs/pictures/families")) {
    pictures.insert(entry.path().stem().string());
  }
  EXPECT_EQ(sections, names);
  EXPECT_EQ(shown, expected_shown);
  EXPECT_EQ(pictures, names) << "redraw them: graze draw --families docs/pictures/families";
}

// The outcome line up to its first number, and that number. The last digits of a time may differ by compiler.
std::pair<std::string, double> outcome_of(const std::string& svg) {
  const std::size_t title = svg.find("<text "), line = svg.find("<text ", title + 1);
  const std::size_t begin = svg.find('>', line) + 1, end = svg.find('<', begin);
  const std::string words = svg.substr(begin, end - begin);
  const std::size_t digit = words.find_first_of("0123456789");
  if (digit == std::string::npos) return {words, 0};
  return {words.substr(0, digit), std::stod(words.substr(digit))};
}

TEST(PageOfFamilies, ShowsTheCasesThatAreChosenAsTheyAreNowInSmallFiles) {
  for (const FamilyPicture& picture : family_pictures()) {
    const std::string svg = text_of(kRoot / "docs/pictures/families" / (picture.family + ".svg"));
    const std::string id = corpus::find_family(picture.family)->generate(picture.hardness, picture.seed).id;
    expect_picture(svg, id);
    EXPECT_LT(svg.size(), 30000U) << picture.family;
    const auto [words, number] = outcome_of(svg);
    const auto [words_now, number_now] = outcome_of(draw_family(picture));
    EXPECT_EQ(words, words_now) << id << ": redraw it: graze draw --families docs/pictures/families";
    EXPECT_NEAR(number, number_now, 1e-6 * std::abs(number)) << id << ": redraw it";
  }
}

}  // namespace
}  // namespace graze::draw
