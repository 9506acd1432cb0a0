#include "reports/drawing/draw_families.hpp"

#include "corpus/families.hpp"

namespace graze::draw {

std::vector<FamilyPicture> family_pictures() {
  std::vector<FamilyPicture> pictures;
  for (const auto list : {corpus::families(), corpus::rotating_families()}) {
    for (const corpus::Family& family : list) {
      pictures.push_back({.family = std::string(family.name),
                          .hardness = family.picture.hardness,
                          .seed = family.picture.seed,
                          .settings = {}});
    }
  }
  return pictures;
}

std::string draw_family(const FamilyPicture& picture) {
  const corpus::Family& family = *corpus::find_family(picture.family);
  return draw_svg(family.generate(picture.hardness, picture.seed), picture.settings);
}

}  // namespace graze::draw
