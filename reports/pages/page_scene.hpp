// A case as a document that a viewer draws: the bodies and their motions, the truth, the claims, the proof.
//
// Everything that a picture needs is computed here, by exact hulls, oracles and the proof checker. A viewer only places
// and draws it. The document is graze.shown/1. page_scene.cpp writes its fields, and docs/reference/page-format.md
// describes them. Places are relative to `origin`, A's position, so that a far offset costs no digits.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engines/method.hpp"

namespace graze::show {

using Json = nlohmann::ordered_json;

struct SceneSettings {
  std::string command = {};  // command that shows the case again, empty for none
  bool has_still = true;  // also the picture of reports/drawing/, which magnifies the contact by long doubles
  std::size_t most_chain = 512;  // slices of a rotating proof that are kept
};

// `claimed`: methods whose answers are shown beside the truth. A method that does not take the case (another question,
// an unsupported shape) is left out.
[[nodiscard]] Json scene_of(const corpus::Case& problem, std::span<const engine::Method* const> claimed,
                            const SceneSettings& settings = {});

// A method's answer to a case, in a line, judged as by graze certify.
struct Claim {
  std::string words;
  std::optional<double> time;  // lower end of the time of contact
  bool is_wrong = false;       // some fault of it is more than its guarantee lets pass
};
// The claims of all methods that take the case.
[[nodiscard]] std::vector<Claim> claims_of(const corpus::Case& problem,
                                           std::span<const engine::Method* const> methods);

// The command that generates the case, if its id names a family, a hardness and a seed. Otherwise empty.
[[nodiscard]] std::string generating_command(const corpus::Case& problem);

// Is the case a question for the method?
[[nodiscard]] bool takes(const engine::Method& method, const corpus::Case& problem);

}  // namespace graze::show
