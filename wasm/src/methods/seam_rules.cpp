#include "methods/seam_rules.h"

#include <algorithm>

#include "tuning/shaping.h"

namespace seamwise {
double localMismatch(const WallpaperGroup& group, const Seam& seam, const Shapes& shapes,
                     const std::vector<Alignment>& at) {
  const SeamMidpoints m = seamMidpoints(seam, shapes, at);
  double total = 0, length = 0;
  for (std::size_t i = 0; i < m.x.size(); ++i) {
    total += m.length[i] * group.distance(m.x[i], m.y[i]);
    length += m.length[i];
  }
  return length > 0 ? total / length : 0;
}

std::vector<double> localMismatches(const WallpaperGroup& group, const Pattern& pattern,
                                    const Shapes& shapes, const std::vector<Alignment>& at) {
  std::vector<double> means(pattern.seams.size(), 0);
  for (std::size_t s = 0; s < means.size(); ++s)
    if (counts(pattern.seams[s])) means[s] = localMismatch(group, pattern.seams[s], shapes, at);
  return means;
}

std::vector<double> seamLengths(const Pattern& pattern, const Shapes& shapes) {
  std::vector<double> lengths(pattern.seams.size(), 0);
  const std::vector<Alignment> anywhere(pattern.pieces.size());
  for (std::size_t s = 0; s < lengths.size(); ++s)
    if (counts(pattern.seams[s]))
      for (const double length : seamMidpoints(pattern.seams[s], shapes, anywhere).length)
        lengths[s] += length;
  return lengths;
}

double meanMismatch(const std::vector<double>& mismatches, const std::vector<double>& lengths) {
  double total = 0, length = 0;
  for (std::size_t s = 0; s < lengths.size(); ++s)
    total += lengths[s] * mismatches[s], length += lengths[s];
  return length > 0 ? total / length : 0;
}

double greatestMean(double placed) {
  return std::max(ShapingTuning::kMet, placed + ShapingTuning::kUnseen);
}

double mismatchUnderRules(const std::vector<double>& mismatches, const std::vector<double>& lengths,
                          const std::vector<double>& placed) {
  double total = 0;
  for (std::size_t s = 0; s < lengths.size(); ++s)
    total +=
        lengths[s] * (mismatches[s] + ShapingTuning::kBeyondLimit *
                                          std::max(0.0, mismatches[s] - greatestMean(placed[s])));
  return total;
}

Verdict verdictOn(const SeamMeans& means, double moved) {
  const bool bent = moved > ShapingTuning::kStraight;
  const double most = means.shaped > ShapingTuning::kBroken ? ShapingTuning::kWorthwhileBroken
                                                            : ShapingTuning::kWorthwhile;
  if (bent && means.shaped > most * means.aligned) return Verdict::kInVain;
  if (means.shaped > greatestMean(std::min(means.placed, means.aligned))) return Verdict::kWorse;
  return Verdict::kKept;
}

bool isWithinReach(const std::vector<double>& mismatch, double reach) {
  double left = 0;
  for (const double d : mismatch) left += std::max(0.0, d - 2 * reach);
  return left <= ShapingTuning::kBroken * static_cast<double>(mismatch.size());
}

double seamMovement(const Seam& seam, const Pattern& pattern, const Shapes& shapes) {
  double moved = 0;
  for (const SeamSide* side : {&seam.a, &seam.b})
    for (std::size_t k = 1; k + 1 < side->vertices.size(); ++k) {
      const int v = side->vertices[k];
      moved =
          std::max(moved, (shapes[side->piece][v] - pattern.pieces[side->piece].rest[v]).norm());
    }
  return moved;
}

}  // namespace seamwise
