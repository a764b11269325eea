#include "problem/options.h"

#include <cmath>

#include "base/decimal.h"
#include "problem/option_limits.h"

namespace seamwise {
namespace {

bool usableRule(const GrainRule& rule) {
  return rule.tolerance >= 0 && rule.tolerance <= kToleranceDeg.most * kPi / 180 + 1e-12;
}

std::string between(const char* option, const Range& range, const char* unit = "") {
  return std::string(option) + " must be between " + significant(range.least, 10) + " and " +
         significant(range.most, 10) + unit + ".";
}

}  // namespace

std::string SolveOptions::problem() const {
  if (!kMaxChangeCm.holds(max_change_cm)) return between("maxChangeCm", kMaxChangeCm, " cm");
  if (!kEdgeLengthCm.holds(edge_length_cm)) return between("edgeLengthCm", kEdgeLengthCm, " cm");
  if (alpha && !kAlpha.holds(*alpha)) return between("alpha", kAlpha);
  if (!kEffort.holds(effort)) return between("effort", kEffort);
  if (!kStarts.holds(starts)) return between("starts", kStarts);
  if (proof && !kProof.holds(*proof)) return between("proof", kProof);
  if (!usableRule(grain)) return between("grain.toleranceDeg", kToleranceDeg, " degrees");
  for (const auto& [piece, own] : piece_grain)
    if (piece < 0 || (own.rule && !usableRule(*own.rule)) ||
        (own.line && !std::isfinite(*own.line)))
      return "grain.pieces must name pieces of the garment, with a tolerance of 0 to 90 degrees.";
  for (const auto& [piece, pin] : pins)
    if (piece < 0 || !std::isfinite(pin.angle) || !pin.translation.allFinite())
      return "pins must name pieces of the garment, with a finite angle and translation.";
  for (const auto& [seam, weight] : weights)
    if (seam < 0 || !kSeamWeight.holds(weight))
      return "weights must name seams of the garment, with values between 0 and 1e6 (seam " +
             decimal(seam) + ").";
  for (const int seam : unmatched)
    if (seam < 0) return "unmatched must name seams of the garment.";
  for (const EdgeRef& edge : locked)
    if (edge.piece < 0 || edge.edge < 0) return "locked must name edges of the garment.";
  for (const int piece : plain)
    if (piece < 0) return "plain must name pieces of the garment.";
  for (const MatchLine& match : matches)
    if (match.piece_a < 0 || match.piece_b < 0 || match.a.size() < 2 ||
        match.a.size() != match.b.size() || !kSeamWeight.holds(match.weight))
      return "matches must join two lines of equally many points, with a weight between 0 and 1e6.";
  return "";
}

}  // namespace seamwise
