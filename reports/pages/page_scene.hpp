// A case as a document that a viewer draws: the bodies and their motions, what is true, what is claimed, the proof.
//
// Everything a picture needs is computed here, by exact hulls, oracles and the checker of proofs; a viewer places and
// draws. The document is graze.shown/1, whose fields page_scene.cpp writes and docs/howto/show.md describes. Places are about
// `origin`, A's position, so that a far offset costs no digits.
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
  std::string command = {};  // that shows the case again; empty for none
  bool has_still = true;  // also the picture of reports/drawing/, which magnifies the contact by long doubles
  std::size_t most_chain = 512;  // slices of a rotating proof that are kept
};

// `claimed`: methods whose answers are shown beside the truth. A method that is not for the case (another question, a
// shape it does not take) is left out.
[[nodiscard]] Json scene_of(const corpus::Case& problem, std::span<const engine::Method* const> claimed,
                            const SceneSettings& settings = {});

// What a method answers to a case, in a line, as graze certify judges it.
struct Claim {
  std::string words;
  std::optional<double> time;  // of contact, lower end
  bool is_wrong = false;       // some fault of it is more than its guarantee lets pass
};
// Of the methods that take the case.
[[nodiscard]] std::vector<Claim> claims_of(const corpus::Case& problem,
                                           std::span<const engine::Method* const> methods);

// The command that generates the case, where its id is that of a family, a hardness and a seed; else empty.
[[nodiscard]] std::string generating_command(const corpus::Case& problem);

// Is the case a question for the method?
[[nodiscard]] bool takes(const engine::Method& method, const corpus::Case& problem);

}  // namespace graze::show
