// A record states an outcome of a case and perhaps a bracket, and supplies a proof. This header checks
// whether the proof is true (check_proof.hpp, check_rotating_proof.hpp), and whether it proves the record's
// statement.
//
// Notation   T = t_max.  A true proof says  p_lower <= TOI <= p_upper,  with 0 and infinity as the defaults,
//            and a lower end beyond T says that there is no contact.
//
//   outcome                what it says          proved by                contradicted by
//   initially_overlapping  TOI = 0               p_upper = 0              p_lower > 0
//   hit                    0 < TOI <= T          p_lower > 0, p_upper     p_upper = 0, no contact, T = 0
//   miss                   TOI > T               no contact               p_upper
//   not_converged, invalid_input: nothing
//   the bracket            lower <= TOI <= upper p_lower >= lower,        p_upper < lower, p_lower > upper
//                                                p_upper <= upper
//
// So a proof that brackets the time less closely than the record proves less than the record says. One that
// brackets it more closely proves more. If the two brackets have no time in common, the proof says that the
// record is false. In tier standard an answer holds for some convex set S within kappa u scale of C, and its
// bracket may be narrower than a bracket that a proof, which is about C, can prove. A bracket of that tier is
// proved if the proof's own axis and portal prove it of one S within the granted length (check_within.hpp).
// The caller takes the length from the guarantee of the record's method. A rotating record is granted
// nothing. A record without a tier is read literally.
//
// Four records lack a full proof without being at fault. They are proved *in part*:
//   - one of a hit's two halves alone,
//   - in tier standard, contact or a miss by the rounding alone,
//   - under the policy pass_over, a start that is not shown to be free, because the format cannot say whether it
//     leaves,
//   - contact at a point made of more than kCurvedParts points of curved shapes, which the format cannot express.
#pragma once

#include <string>

#include "corpus/format/proof_io.hpp"

namespace graze::oracle {

enum class RecordFinding {
  accepted,  // the proof is true, and proves what the record says
  in_part,   // the proof is true, and proves less, as an honest record may
  refused,   // the proof is false, contradicts the record, or proves nothing of its statement
};

struct RecordVerdict {
  RecordFinding finding = RecordFinding::accepted;
  std::string reason;  // refusal of a false proof, or contradicted, unproved, in_part
  std::string detail;  // one line, empty when accepted
};

// `granted`: a length, how far the set that a bracket of tier standard is true of may be from C.
[[nodiscard]] RecordVerdict check_record(const corpus::ProofRecord& record, double granted = 0);

// False where a point of one body is made of more than kCurvedParts points of curved shapes.
[[nodiscard]] bool can_name_contact(const corpus::Case& problem);

// The last part of it: of a record whose proof was accepted.
[[nodiscard]] RecordVerdict compare_claim(const corpus::ProofRecord& record, double granted = 0);

}  // namespace graze::oracle
