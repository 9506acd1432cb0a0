// The guarantee of each method, by which `graze certify` judges it. docs/reference/guarantees.md explains the fields.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/case.hpp"
#include "engines/method.hpp"

namespace graze::corpus {
struct ProofRecord;  // corpus/format/proof_io.hpp
}

namespace graze::engine {

// The contacts during the motion that a rotating method may miss.
enum class Unseen {
  nothing,        // more than kappa u scale deep
  hidden_motion,  // contacts less deep than the answer's hidden_motion plus kappa u scale
  anything,
};

// A guarantee with a greater cap names the mechanism.
inline constexpr double kPlainStallCap = 0.001;

// The promise of a third-party engine about bodies that touch and go no deeper.
enum class Touching { either, contact, miss };

// The promise of a third-party engine about the normal of a start in contact.
enum class StartNormal {
  any,                // nothing but that it is a unit vector, if there is one
  least_penetration,  // B moved along it by the least distance that parts the bodies parts them
};

// The own_frames of tier certified: it sees no more than this of the lengths that two shapes are given by, for each number
// of theirs (properties/judge/own_frames.hpp has the derivation).
inline constexpr double kOwnFramesOfCertified = 0x1p-84;

struct Guarantee {
  std::string query = "cast";  // or a query other than the cast, or "rotating"
  std::string method, scalar, tier;
  // kappa: errors up to kappa u scale are within the guarantee. u: unit roundoff of the scalar.
  double kappa_polytope = 0;  // points, boxes and hulls, target distance 0
  double kappa_rounded = 0;   // a sphere, or a target distance
  // For tiers certified and exact, kappa is 0 for the verdict and both bounds. Their normals and witnesses are doubles,
  // and this kappa bounds their errors. Absent: the kappas above hold.
  std::optional<double> kappa_contact = {};
  double stall_cap = 0;  // the largest fraction of a family's cases that may end not_converged
  // The largest number of support evaluations (Counters::supports) that any valid input needs with the options' defaults:
  // verdict, normal and witnesses, no tolerance. A proof is asked for, and costs more. Absent: no limit is promised.
  std::optional<int> most_supports = {};
  // The largest fraction of a generated family's cases that may end not_converged for whatever reason, ties within the
  // width included. Absent: those are not capped.
  std::optional<double> open_cap = {};
  std::string mechanism;  // the reason for a kappa above 1,024 or a cap above 1 in 1,000, else empty

  // Rows of "rotating": how deep a contact may be that a miss denies, and one that toi_lower has passed.
  Unseen may_miss = Unseen::nothing, may_be_late = Unseen::nothing;
  // Over scale: how far either end of a hit's bracket may be from contact, if that is not kappa u. For tier certified,
  // whose kappa is 0, undecided cases have a clearance or depth below it.
  std::optional<double> width = {};

  // Third-party engines may promise lengths beside kappa: an absolute tolerance, one over scale, and the length by
  // which their times may be early.
  double tolerance = 0, relative_tolerance = 0, early = 0;
  // And one that grows with the bodies' own frames: for each number that the shapes are given by, over the sum of the
  // lengths among these numbers. How a scalar's last bits limit bodies that lie far out in their own frames.
  double own_frames = 0;
  // Every limit is infinite: errors are measured only.
  bool is_open = false;
  // Nothing was declared about errors, and the limit is the judge's own.
  bool is_assumed = false;
  Touching touching = Touching::either;
  StartNormal start_normal = StartNormal::any;

  [[nodiscard]] double kappa(const corpus::Case& problem) const;
  [[nodiscard]] double contact_kappa(const corpus::Case& problem) const {
    return kappa_contact ? *kappa_contact : kappa(problem);
  }
  [[nodiscard]] std::string name() const {
    return (query == "cast" ? "" : query + " ") + method + "/" + scalar + " " + tier;
  }
};

// Has a case a ball in it, a curved shape or a target distance? kappa_rounded is about those.
[[nodiscard]] bool is_rounded(const corpus::Case& problem);

// The table built into the library (engines/guarantees.json).
[[nodiscard]] std::span<const Guarantee> guarantees();

// Reads a table from JSON text. Throws std::runtime_error with a message that names the guarantee and the field.
[[nodiscard]] std::vector<Guarantee> parse_guarantees(std::string_view text);

// The guarantee with these names in a table, or nullptr if there is no such guarantee.
[[nodiscard]] const Guarantee* find_guarantee(std::span<const Guarantee> table, std::string_view query,
                                              std::string_view method, std::string_view scalar,
                                              std::string_view tier);
// The guarantee of a method in a table, or nullptr if it has none and promises nothing.
[[nodiscard]] const Guarantee* find_guarantee(std::span<const Guarantee> table, const Method& method);

// The kappa of the guarantee that a proof record names by its method, scalar and tier. 0 if none of ours has these
// names.
[[nodiscard]] double kappa_of(const corpus::ProofRecord& record);

}  // namespace graze::engine
