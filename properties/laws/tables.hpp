// The tables of laws, one a file. A law is a function of such a file and a line of the table at its end.
#pragma once

#include <vector>

#include "properties/laws/law.hpp"

namespace graze::law {

std::vector<Law> linear_metamorphic_laws(), linear_motion_laws(), linear_symmetry_laws(),
    linear_distance_laws(), linear_advancement_laws(), linear_exact_laws(), linear_proof_laws(),
    linear_checker_laws(), linear_oracle_laws();
std::vector<Law> query_any_laws(), query_gap_laws(), query_motion_laws(), query_proof_laws(),
    query_oracle_laws(), query_advancement_laws();
std::vector<Law> rotating_time_laws(), rotating_symmetry_laws(), rotating_plan_laws(), rotating_answer_laws(),
    rotating_standing_laws(), rotating_validity_laws(), rotating_proof_laws(), rotating_oracle_laws(),
    rotating_followed_laws();

struct LawTable {
  Kind kind;
  std::vector<Law> (*laws)();
};
// In the order in which they are listed.
inline constexpr LawTable kLawTables[] = {
    {Kind::linear, &linear_metamorphic_laws},
    {Kind::linear, &linear_motion_laws},
    {Kind::linear, &linear_symmetry_laws},
    {Kind::linear, &linear_distance_laws},
    {Kind::linear, &linear_advancement_laws},
    {Kind::linear, &linear_exact_laws},
    {Kind::linear, &linear_proof_laws},
    {Kind::linear, &linear_checker_laws},
    {Kind::linear, &linear_oracle_laws},
    {Kind::query, &query_any_laws},
    {Kind::query, &query_gap_laws},
    {Kind::query, &query_motion_laws},
    {Kind::query, &query_proof_laws},
    {Kind::query, &query_oracle_laws},
    {Kind::query, &query_advancement_laws},
    {Kind::rotating, &rotating_time_laws},
    {Kind::rotating, &rotating_symmetry_laws},
    {Kind::rotating, &rotating_plan_laws},
    {Kind::rotating, &rotating_answer_laws},
    {Kind::rotating, &rotating_standing_laws},
    {Kind::rotating, &rotating_validity_laws},
    {Kind::rotating, &rotating_proof_laws},
    {Kind::rotating, &rotating_oracle_laws},
    {Kind::rotating, &rotating_followed_laws},
};

}  // namespace graze::law
