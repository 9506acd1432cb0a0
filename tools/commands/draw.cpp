// graze draw: pictures of cases.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>

#include "engines/method.hpp"
#include "reports/drawing/draw_families.hpp"
#include "reports/text/answer_text.hpp"
#include "reports/text/inputs.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {
namespace {

struct DrawArguments {
  std::vector<std::string> files;
  std::string out = "-", view = "auto", families;
  int width = draw::DrawSettings{}.width;
};

constexpr const char* kViews = "it is x, y, z, auto, or a direction such as 1,0,2.5";

// Three numbers between commas, not all 0.
Vec3<double> parse_direction(const std::string& text) {
  Vec3<double> direction = Vec3<double>::Zero();
  const char* at = text.data();
  const char* const end = at + text.size();
  bool good = true;
  for (int i = 0; i < 3 && good; ++i) {
    const auto [stop, error] = std::from_chars(at, end, direction[i]);
    good = error == std::errc() && std::isfinite(direction[i]) &&
           (i == 2 ? stop == end : stop != end && *stop == ',');
    at = stop + (i < 2 ? 1 : 0);
  }
  if (!good) throw std::runtime_error(fmt::format("--view: {} is no view; {}", text, kViews));
  const double most = direction.cwiseAbs().maxCoeff();
  if (!(most > 0)) throw std::runtime_error(fmt::format("--view: {} has no direction; {}", text, kViews));
  return direction / most;
}

draw::DrawSettings draw_settings(const DrawArguments& settings) {
  draw::DrawSettings out{.view = {}, .width = settings.width};
  if (settings.view == "auto") return out;
  const std::string axes = "xyz";
  const std::size_t axis = settings.view.size() == 1 ? axes.find(settings.view) : std::string::npos;
  out.view = axis == std::string::npos ? parse_direction(settings.view)
                                       : Vec3<double>(Vec3<double>::Unit(static_cast<int>(axis)));
  return out;
}

void write_picture(const std::string& name, const std::string& svg) {
  OutputFile out(name);
  out.write_line(svg.substr(0, svg.size() - 1));  // its last newline is the line's
  out.close();
}

// A file name for an id. All characters except letters, digits, points and _ - become -.
std::string file_name(const std::string& id) {
  std::string name = id;
  for (char& c : name) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       c == '.' || c == '_' || c == '-';
    if (!plain) c = '-';
  }
  return name + ".svg";
}

// The reason why our default method refuses the case. Empty if it answers.
std::string why_refused(const corpus::Case& problem) {
  if (problem.query == corpus::Query::cast) {
    const engine::Answer answer =
        engine::find_method(engine::Kind::rotating, "plan/double")->ask(problem, {});
    return answer.outcome == Outcome::invalid_input ? invalid_text(answer) : "";
  }
  if (const std::string why = engine::unsupported(engine::Kind::query, problem); !why.empty())
    return "it has " + why;
  for (const engine::Method& method : engine::methods(engine::Kind::query)) {
    if (method.query != problem.query) continue;
    const engine::Answer answer = method.answer(problem);
    return answer.outcome == Outcome::invalid_input ? invalid_text(answer) : "";
  }
  return "no method answers its query";
}

int draw_families(const DrawArguments& settings, const draw::DrawSettings& how) {
  require_folder(settings.families);
  for (draw::FamilyPicture picture : draw::family_pictures()) {
    picture.settings.width = how.width;
    write_picture((std::filesystem::path(settings.families) / (picture.family + ".svg")).string(),
                  draw::draw_family(picture));
  }
  return 0;
}

int run_draw_command(const DrawArguments& settings) {
  const draw::DrawSettings how = draw_settings(settings);
  if (!settings.families.empty()) {
    if (!settings.files.empty()) {
      throw std::runtime_error(
          "--families: draws the families' own cases; leave out the files or the option");
    }
    return draw_families(settings, how);
  }
  if (settings.files.empty()) {
    throw std::runtime_error("draw: no case is given; name a case file, or - for standard input");
  }
  will_read(settings.files);
  const CaseFiles inputs = read_case_files(settings.files);
  bool bad = inputs.bad;
  std::vector<std::pair<std::string, const corpus::Case*>> cases;
  for (const CaseFile& file : inputs.files) {
    for (const corpus::Case& problem : file.cases) cases.emplace_back(file.name, &problem);
  }
  const bool many = cases.size() > 1;
  if (many && settings.out == "-") {
    throw std::runtime_error(fmt::format("--out: {} cases need a folder; give --out DIR", cases.size()));
  }
  const bool into_folder = many || std::filesystem::is_directory(settings.out);
  if (into_folder) require_folder(settings.out);
  std::map<std::string, std::string> drawn;  // the pictures, and the ids that they show
  for (const auto& [file, problem] : cases) {
    if (const std::string why = why_refused(*problem); !why.empty()) {
      complain(fmt::format("{}: case {}: cannot be drawn: {}", file, problem->id, why));
      bad = true;
      continue;
    }
    const std::string name =
        into_folder ? (std::filesystem::path(settings.out) / file_name(problem->id)).string() : settings.out;
    if (const auto [first, is_new] = drawn.emplace(name, problem->id); !is_new) {
      complain(fmt::format("{}: case {}: {} shows {} already; draw this one by itself", file, problem->id,
                           name, first->second));
      bad = true;
      continue;
    }
    write_picture(name, draw::draw_svg(*problem, how));
  }
  return bad ? 2 : 0;
}

}  // namespace

void add_draw_command(CLI::App& app, int& exit_code) {
  const auto settings = std::make_shared<DrawArguments>();
  CLI::App* command = app.add_subcommand("draw", "Draws cases as SVG: the bodies, the path, the contact.");
  command
      ->add_option("files", settings->files,
                   "Case files: .json holds one case, .jsonl one a line; - is standard input")
      ->type_name("FILE");
  command
      ->add_option("--out", settings->out,
                   "The picture, or for several cases the folder of pictures, each named by its id "
                   "(default: standard output)")
      ->type_name("OUT");
  command
      ->add_option("--view", settings->view,
                   "Towards the viewer: x, y, z, a direction such as 1,0,2.5, or auto (the default): across "
                   "the motion and along the contact, A below and B above")
      ->type_name("VIEW");
  command->add_option("--width", settings->width, "Width of the picture, in pixels (760)")
      ->check(whole_number(draw::kLeastWidth, draw::kGreatestWidth))
      ->type_name("W");
  command
      ->add_option("--families", settings->families,
                   "Draws the pictures of docs/reference/families.md into this folder")
      ->type_name("DIR");
  command->footer(
      "A is blue, B orange: strong where they meet or pass nearest, paler at t = 0 and on the way. The "
      "arrows are\n"
      "the paths of the points that touch, n is the normal. Details that are too small to see are drawn "
      "again\n"
      "beside it, with the magnification. The answer is our default method's.\n\n"
      "  graze draw pair.json --out pair.svg\n"
      "  graze generate grazing_edge --hardness 9 --count 1 | graze draw - --out graze.svg\n"
      "  graze draw corpus/cases/reported.jsonl --out pictures\n\n"
      "Exit code: 0, or 2 if a case could not be read or drawn; the others are drawn all the same.");
  command->callback([settings, &exit_code] { exit_code = run_draw_command(*settings); });
}

}  // namespace graze::tool
