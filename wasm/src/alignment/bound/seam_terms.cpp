#include "alignment/bound/seam_terms.h"

#include <cmath>

namespace seamwise {
namespace {

constexpr double kTermError = 1e-6;  ///< exceeds the loss of single precision

}  // namespace

double SeamTerms::weight() const {
  double sum = 0;
  for (const Part& part : parts_) sum += part.bound->seam().weight;
  return sum;
}

/// Seams whose slopes gain little count with their constant bounds.
Term SeamTerms::between(const Box& first, double reach_first, const Box& second,
                        double reach_second, double& spent) const {
  double apart = 0, middle = 0, slopes[6] = {};
  for (const Part& part : parts_) {
    const Box& other = part.pinned ? *part.pinned : second;
    const double reach_other = part.pinned ? 0 : reach_second;
    const SeamBound::Pair pair =
        part.swapped ? part.bound->between(other, reach_other, first, reach_first, spent)
                     : part.bound->between(first, reach_first, other, reach_other, spent);
    apart += pair.least;
    if (pair.least >= pair.middle - pair.steepness() / 2) {
      middle += pair.least;
      continue;
    }
    middle += pair.middle;
    const int mine = part.swapped ? 3 : 0;
    for (int k = 0; k < 3; ++k)
      slopes[k] += pair.slope[mine + k], slopes[3 + k] += pair.slope[3 - mine + k];
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
