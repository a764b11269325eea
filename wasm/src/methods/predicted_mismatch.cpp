#include "methods/predicted_mismatch.h"

#include <algorithm>

#include "alignment/model/matching.h"
#include "methods/seam_rules.h"

namespace seamwise {
namespace {

/// Of what two sides may move, so much is taken up by a seam whose neighbours pull otherwise.
/// Measured on 12 garments in 3 prints: 1.4 led to fits 1 to 2 % below 1.0 and 2.0.
constexpr double kTakenUp = 1.4;

}  // namespace

std::vector<double> predictedMismatches(const WallpaperGroup& group, const Pattern& pattern,
                                        const std::vector<Alignment>& at, double reach) {
  const Shapes rest = restShapes(pattern);
  std::vector<double> means = localMismatches(group, pattern, rest, at);
  for (std::size_t s = 0; s < means.size(); ++s) {
    const Seam& seam = pattern.seams[s];
    if (!counts(seam)) continue;
    // cloth follows one element all along
    const std::vector<double> mismatch =
        joinMismatch(bestJoin(group, seam, rest, at), seam, rest, at);
    double left = 0;
    for (const double d : mismatch)
      left += std::max(0.0, d - kTakenUp * reach) + kLeftByShaping * d;
    left /= static_cast<double>(mismatch.size());
    if (isWithinReach(mismatch, reach) && left < kWorthShaping * means[s]) means[s] = left;
  }
  return means;
}

}  // namespace seamwise
