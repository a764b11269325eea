#include "methods/predicted_mismatch.h"

#include <algorithm>

#include "alignment/model/matching.h"
#include "methods/seam_rules.h"
#include "tuning/search.h"
#include "tuning/shaping.h"

namespace seamwise {
std::vector<double> predictedMismatches(const WallpaperGroup& group, const Pattern& pattern,
                                        const std::vector<Alignment>& at, double reach) {
  const Shapes rest = restShapes(pattern);
  std::vector<double> means = localMismatches(group, pattern, rest, at);
  for (std::size_t s = 0; s < means.size(); ++s) {
    const Seam& seam = pattern.seams[s];
    if (!counts(seam)) continue;
    // Shaping uses one element along the whole seam.
    const std::vector<double> mismatch =
        joinMismatch(bestJoin(group, seam, rest, at), seam, rest, at);
    double left = 0;
    for (const double d : mismatch)
      left += std::max(0.0, d - ShapingTuning::kTakenUp * reach) + SearchTuning::kLeftByShaping * d;
    left /= static_cast<double>(mismatch.size());
    if (isWithinReach(mismatch, reach) && left < SearchTuning::kWorthShaping * means[s])
      means[s] = left;
  }
  return means;
}

}  // namespace seamwise
