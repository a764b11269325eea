#include "alignment/seam_terms.h"

#include <cmath>

namespace seamwise {
namespace {

constexpr double kTermError = 1e-6;  ///< more than single precision loses

}  // namespace

double SeamTerms::weight() const {
  double sum = 0;
  for (const Part& part : parts_) sum += part.bound->seam().weight;
  return sum;
}

/// Seams whose slopes say little count with their flat bounds.
Term SeamTerms::between(const Box& first, double reach_first, const Box& second,
                        double reach_second, double& spent) const {
  double apart = 0, middle = 0, slopes[6] = {};
  for (const Part& part : parts_) {
    const bool own = part.bound->seam().a == part.bound->seam().b;
    const Box& other = part.pinned ? *part.pinned : second;
    const double reach_other = part.pinned ? 0 : reach_second;
    const SeamBound::Pair pair =
        part.swapped ? part.bound->between(other, reach_other, first, reach_first, spent)
                     : part.bound->between(first, reach_first, other, reach_other, spent);
    const int mine = part.swapped ? 3 : 0;
    const double* slope = pair.slope.data();
    double steepness = 0;
    for (int k = 0; k < 3; ++k)
      steepness +=
          own ? std::abs(slope[k] + slope[3 + k]) : std::abs(slope[k]) + std::abs(slope[3 + k]);
    apart += std::max(pair.flat, pair.middle - steepness);
    if (pair.flat >= pair.middle - steepness / 2) {
      middle += pair.flat;
      continue;
    }
    middle += pair.middle;
    for (int k = 0; k < 3; ++k)
      slopes[k] += slope[mine + k], slopes[own ? k : 3 + k] += slope[3 - mine + k];
  }
  Term term;
  double steepness = 0;
  for (int k = 0; k < 6; ++k) {
    term.slope[k] = static_cast<float>(slopes[k]);
    steepness += std::abs(slopes[k]);
  }
  const double below = kTermError * (std::abs(middle) + steepness);
  term.known = static_cast<float>(std::max({0.0, apart, middle - steepness}) - below);
  term.middle = static_cast<float>(middle - below);
  return term;
}

}  // namespace seamwise
