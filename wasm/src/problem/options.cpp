#include "problem/options.h"

#include <cmath>

namespace seamwise {
namespace {

constexpr double kMaxEdgeLengthCm = 1.05;  // coarser edges hide mismatch
constexpr double kMinEdgeLengthCm = 0.1;
constexpr double kMaxChangeCm = 50;
constexpr double kMaxWeight = 1e6;
constexpr double kMaxEffort = 64;
constexpr int kMaxStarts = 1000;

bool usableWeight(double weight) { return weight >= 0 && weight <= kMaxWeight; }

bool usableRule(const GrainRule& rule) {
  return rule.tolerance >= 0 && rule.tolerance <= kPi / 2 + 1e-12;
}

}  // namespace

// Comparisons are written so that NaN fails them.
std::string SolveOptions::problem() const {
  if (!(max_change_cm >= 0 && max_change_cm <= kMaxChangeCm))
    return "maxChangeCm must be between 0 and 50 cm.";
  if (!(edge_length_cm >= kMinEdgeLengthCm && edge_length_cm <= kMaxEdgeLengthCm))
    return "edgeLengthCm must be between 0.1 and 1.05 cm.";
  if (alpha && !(*alpha > 0 && *alpha <= 1e9)) return "alpha must be positive and at most 1e9.";
  if (!(effort >= 1 && effort <= kMaxEffort)) return "effort must be between 1 and 64.";
  if (!(starts >= 1 && starts <= kMaxStarts)) return "starts must be between 1 and 1000.";
  if (proof && !(*proof >= 0 && *proof <= 1e6)) return "proof must be between 0 and 1e6.";
  if (!usableRule(grain)) return "grain.toleranceDeg must be between 0 and 90 degrees.";
  for (const auto& [piece, own] : piece_grain)
    if (piece < 0 || (own.rule && !usableRule(*own.rule)) ||
        (own.line && !std::isfinite(*own.line)))
      return "grain.pieces must name pieces of the garment, with a tolerance of 0 to 90 degrees.";
  for (const auto& [piece, pin] : pins)
    if (piece < 0 || !std::isfinite(pin.angle) || !pin.translation.allFinite())
      return "pins must name pieces of the garment, with a finite angle and translation.";
  for (const auto& [seam, weight] : weights)
    if (seam < 0 || !usableWeight(weight))
      return "weights must name seams of the garment, with values between 0 and 1e6 (seam " +
             std::to_string(seam) + ").";
  for (const int seam : unmatched)
    if (seam < 0) return "unmatched must name seams of the garment.";
  for (const EdgeRef& edge : locked)
    if (edge.piece < 0 || edge.edge < 0) return "locked must name edges of the garment.";
  for (const int piece : plain)
    if (piece < 0) return "plain must name pieces of the garment.";
  for (const MatchLine& match : matches)
    if (match.piece_a < 0 || match.piece_b < 0 || match.a.size() < 2 ||
        match.a.size() != match.b.size() || !usableWeight(match.weight))
      return "matches must join two lines of equally many points, with a weight between 0 and 1e6.";
  return "";
}

}  // namespace seamwise
