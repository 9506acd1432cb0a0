#include "draw/families.hpp"

#include <algorithm>

#include "corpus/families.hpp"

namespace graze::draw {
namespace {

struct Choice {
  std::string_view family;
  double hardness;
  std::uint64_t seed;
};

// Chosen by eye.
constexpr Choice kChoices[] = {
    {"random", 8, 2},
    {"hulls", 12, 2},
    {"hulls_rotated", 12, 4},
    {"combinators", 3, 3},
    {"many_vertices", 6, 4},
    {"grazing_vertex", 9, 1},
    {"grazing_edge", 6, 2},
    {"grazing_face", 6, 5},
    {"smooth_graze", 4, 1},
    {"perpendicular", 2, 1},
    {"touching", -8, 4},
    {"sliding", 2, 3},
    {"contained", 2, 5},
    {"target_margin", -1, 4},
    {"aligned_boxes", 2, 1},
    {"lattice", 5, 6},
    {"redundant_vertices", 2, 8},
    {"flat_shapes", 2, 4},
    {"slivers", 2, 2},
    {"noisy_copy", 1, 4},
    {"parallel_faces", 1, 6},
    {"parallel_edges", 1, 3},
    {"level_prisms", 3, 1},
    {"size_ratio", 3, 4},
    {"needles", 1, 2},
    {"plates", 2, 1},
    {"curved", 2, 5},
    {"far_from_origin", 6, 6},
    {"far_own_frame", 6, 1},
    {"scaled_scene", 40, 3},
    {"mixed_magnitudes", 1, 1},
    {"speeds", 12, 3},
    {"spinning_graze", 12, 6},
    {"enters_and_leaves", 6, 1},
    {"fast_spin", 5, 2},
    {"off_centre_pivot", 4, 4},
    {"both_turn", 8, 2},
    {"far_own_frame_turning", 22, 1},
    {"long_arms", 4, 1},
    {"swung_balls", 2, 1},
    {"slow_spin", 12, 5},
    {"pure_spin", 12, 4},
    {"random_rotating", 1, 1},
};

}  // namespace

std::vector<FamilyPicture> family_pictures() {
  std::vector<FamilyPicture> pictures;
  for (const auto list : {corpus::families(), corpus::rotating_families()}) {
    for (const corpus::Family& family : list) {
      FamilyPicture picture{.family = std::string(family.name),
                            .hardness = family.levels[family.levels.size() / 2],
                            .seed = 1,
                            .settings = {}};
      const auto* const chosen = std::find_if(std::begin(kChoices), std::end(kChoices),
                                              [&](const Choice& c) { return c.family == family.name; });
      if (chosen != std::end(kChoices)) {
        picture.hardness = chosen->hardness;
        picture.seed = chosen->seed;
      }
      pictures.push_back(std::move(picture));
    }
  }
  return pictures;
}

std::string draw_family(const FamilyPicture& picture) {
  const corpus::Family& family = *corpus::find_family(picture.family);
  return draw_svg(family.generate(picture.hardness, picture.seed), picture.settings);
}

}  // namespace graze::draw
