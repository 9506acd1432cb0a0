// The text form of a proof, graze.proof/1. Each line is one JSON object that holds its case in full, so that
// a file of proofs can be checked by itself. Numbers read back to the same bits. An infinite bound is "inf".
//
//   {"schema": "graze.proof/1", "case": {...}, "method": "mpr", "scalar": "double", "outcome": "hit",
//    "proof": {"toi_lower": 0.25, "axis": [0, -1, 0], "toi_upper": 0.25,
//              "portal": [{"a": {"vertex": 0}, "b": {"vertex": 0, "offset": [0, -1, 0]}}]}}
//
// A symbolic axis is an object, n = sign (F x F'), with factors that are a triple, v, or a difference of
// pairs:
//
//   "axis": {"sign": -1, "cross": [{"from": {"a": {"vertex": 1}, "b": {"vertex": 0}},
//                                   "to": {"a": {"vertex": 3}, "b": {"vertex": 0}}}, "motion"]}
//
// Two fields are optional:
//   - "tier" is standard, certified or exact, the tier of the answer,
//   - "toi", {"lower": 0.25, "upper": 0.25}, is the bracket that the answer states. In tier standard it may be
//     narrower than the bracket that the proof proves.
// oracles/checker/check_record.hpp compares both with the proof.
//
// No axis, a "toi_upper" of "inf" and an empty portal are the absence of a claim (graze/proof.hpp). This
// format does not judge the claims of a proof. A reader's proof may be false.
//
// The proof of a rotating answer (graze/rotating_proof.hpp) has a chain instead of an axis, and weighted
// contact pairs instead of a portal. "frame" is world, a or b. The default is world:
//
//   "proof": {"toi_lower": 0.25, "chain": [{"end": 0.125, "axis": [0, 0, 1]},
//                                          {"end": 0.25, "axis": [0, 1, 0], "frame": "a"}],
//             "toi_upper": 0.375, "contact": [{"a": {"vertex": 3}, "b": {"vertex": 0}, "weight": 1}]}
//
// The field "chain", which may be empty, identifies it. The points of its pairs have no offset. Contact by
// crossing has a "contact_from". Its weights are optional and default to 0:
//
//             "toi_upper": 0.375, "contact_from": 0.3125,
//             "contact": [{"a": {"vertex": 0}, "b": {"vertex": 0}}, {"a": {"vertex": 1}, "b": {"vertex": 0}},
//                         {"a": {"vertex": 2}, "b": {"vertex": 0}}]}
#pragma once

#include <graze/rotating_proof.hpp>

#include "corpus/format/case_io.hpp"

namespace graze::corpus {

// toi_lower <= TOI <= toi_upper
struct StatedBracket {
  double lower = 0, upper = kInfinity<double>;
};

struct ProofRecord {
  Case problem;
  std::string method;  // "mpr"
  std::string scalar;  // "float", "double"
  std::optional<Tier> tier;
  Outcome outcome = Outcome::not_converged;
  std::optional<StatedBracket> toi;
  Proof proof;                            // proof of a linear answer (without a claim for a rotating answer)
  std::optional<RotatingProof> rotating;  // proof of a rotating answer
  int line = 0;                           // line in the file, from 1 (not written)
};

struct JsonValue;
// The object of the field `proof`, of a linear answer. Throws Malformed.
[[nodiscard]] Proof read_proof(const JsonValue& value, const std::string& path);
[[nodiscard]] std::string write_proof(const Proof& proof);

struct ProofReadResult {
  std::vector<ProofRecord> proofs;
  std::vector<ReadError> errors;
  [[nodiscard]] bool ok() const { return errors.empty(); }
};

// One object a line, or one in all. A file of cases instead is one error, however many they are.
[[nodiscard]] ProofReadResult read_proofs_file(const std::filesystem::path& path);
[[nodiscard]] ProofReadResult read_proofs_text(std::string_view text, const std::string& name);

// The value of the field "axis", of a proof that has one.
[[nodiscard]] std::string write_axis(const Proof& proof);

// One line, without the newline at its end.
[[nodiscard]] std::string write_proof(const ProofRecord& record);

}  // namespace graze::corpus
