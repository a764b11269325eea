#include "photo/symmetry/stripes.h"

#include "tuning/group_reading.h"

namespace seamwise {

std::array<int, 2> stripeOf(const CellSpectrum& cell) {
  constexpr int kMost = 3;
  const double pattern = 1 - cell.noiseEnergy() / std::max(1e-12, cell.energy());
  for (int h1 = 0; h1 <= kMost; ++h1) {
    for (int h2 = h1 == 0 ? 1 : -kMost; h2 <= kMost; ++h2) {
      const bool isMultiple = (h1 % 2 == 0 && h2 % 2 == 0) || (h1 % 3 == 0 && h2 % 3 == 0) ||
                              (h1 == 0 && h2 != 1) || (h2 == 0 && h1 != 1);
      if (isMultiple) continue;
      if (cell.shareAlong(h1, h2) >= (1 - GroupReadingTuning::kStripeShare) * pattern)
        return {-h2, h1};
    }
  }
  return {0, 0};
}

IntegerMatrix stripeBasis(const std::array<int, 2>& along, const Mat2& gram) {
  const Vec2 w2(along[0], along[1]);
  IntegerMatrix best{};
  double least = 0;
  constexpr int kMost = 4;
  for (int i = -kMost; i <= kMost; ++i) {
    for (int j = -kMost; j <= kMost; ++j) {
      if (i * along[1] - j * along[0] != 1) continue;
      const double slant = std::abs(Vec2(i, j).dot(gram * w2));
      if (best == IntegerMatrix{} || slant < least) {
        best = {i, along[0], j, along[1]};
        least = slant;
      }
    }
  }
  return best;
}

}  // namespace seamwise
