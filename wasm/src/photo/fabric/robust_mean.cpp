#include "photo/fabric/robust_mean.h"

#include <algorithm>
#include <cmath>

namespace seamwise {

namespace {

/// Maximum distance from the median at which a colour counts, relative to the mean distance: 4.7
/// standard deviations of noise that is normal in three colours.
constexpr float kOutlierReach = 4.7f / 1.6f;
/// Added to the mean distance: one and a half steps of 8 bits.
constexpr float kCodeStep = 1.5f / 255;
/// Maximum number of colours for the median; more colours are sampled at equal steps.
constexpr int kMedianOf = 15;

PixelLanes greatestColour(const PixelLanes* colours, int count) {
  PixelLanes most = colours[0];
  for (int k = 1; k < count; ++k) most = greatest(most, colours[k]);
  return most;
}

/// Returns the median of each lane.
PixelLanes medianColour(const PixelLanes* colours, int count) {
  PixelLanes sorted[kMedianOf];
  const int n = std::min(count, kMedianOf);
  for (int k = 0; k < n; ++k) sorted[k] = colours[k * count / n];
  // The greatest values move to the end, one after the other, until the middle is known.
  for (int end = n - 1; end >= n / 2; --end) {
    PixelLanes most = sorted[0];
    for (int k = 1; k <= end; ++k) {
      sorted[k - 1] = least(most, sorted[k]);
      most = greatest(most, sorted[k]);
    }
    sorted[end] = most;
  }
  return n % 2 == 1 ? sorted[n / 2] : 0.5f * (sorted[n / 2] + greatestColour(sorted, n / 2));
}

float colourSquares(const PixelLanes& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

/// Returns the sum of the squares of a difference's opponent channels.
float opponentSquares(const PixelLanes& d) {
  const float light = (d[0] + d[1] + d[2]) * (1 / 3.0f);
  const float warm = 0.7f * (d[0] - d[2]), green = 0.7f * (d[1] - 0.5f * (d[0] + d[2]));
  return light * light + warm * warm + green * green;
}

}  // namespace

AgreedColour agreedColour(PixelLanes* colours, int count) {
  AgreedColour agreed;
  if (count == 0) return agreed;
  if (count > 2) {
    const PixelLanes center = medianColour(colours, count);
    float distance = 0;
    for (int k = 0; k < count; ++k) distance += std::sqrt(colourSquares(colours[k] - center));
    const float reach = kOutlierReach * (distance / static_cast<float>(count) + kCodeStep);
    for (int k = 0; k < count; ++k) {
      const float far = colourSquares(colours[k] - center) / (reach * reach);
      colours[k][3] *= far < 1 ? (1 - far) * (1 - far) : 0.0f;
    }
  }
  PixelLanes sum = {0, 0, 0, 0};
  float total = 0, squares = 0;
  for (int k = 0; k < count; ++k) {
    const float weight = colours[k][3];
    sum += weight * colours[k];
    total += weight;
    squares += weight * weight;
  }
  if (!(total > 0)) {
    agreed.colour = colours[0];
    return agreed;
  }
  agreed.colour = sum / total;
  const float copies = total * total / squares;  // effective number of equal weights
  if (copies < 1.5f) return agreed;
  float spread = 0;
  for (int k = 0; k < count; ++k)
    spread += colours[k][3] * opponentSquares(colours[k] - agreed.colour);
  agreed.noise = spread / total / (copies - 1);
  return agreed;
}

}  // namespace seamwise
