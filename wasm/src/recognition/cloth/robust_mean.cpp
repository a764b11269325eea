#include "recognition/cloth/robust_mean.h"

#include <algorithm>
#include <cmath>

namespace seamwise {

namespace {

/// Distances from the median up to which colours count, over the median distance: 4.7 standard
/// deviations of noise that is normal in three colours.
constexpr float kReach = 4.7f / 1.54f;
/// Added to the median distance: a step and a half of 8 bits.
constexpr float kStep = 1.5f / 255;

float median(std::vector<float>* values, int count) {
  const auto middle = values->begin() + count / 2;
  std::nth_element(values->begin(), middle, values->begin() + count);
  return *middle;
}

float squaredLength(const PixelLanes& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

/// The sum of the squares of the opponent channels of a difference.
float opponentSquares(const PixelLanes& d) {
  const float light = (d[0] + d[1] + d[2]) * (1 / 3.0f);
  const float warm = 0.7f * (d[0] - d[2]), green = 0.7f * (d[1] - 0.5f * (d[0] + d[2]));
  return light * light + warm * warm + green * green;
}

}  // namespace

AgreedColour agreedColour(PixelLanes* colours, int count, std::vector<float>* scratch) {
  AgreedColour agreed;
  if (count == 0) return agreed;
  if (count > 2) {
    if (scratch->size() < static_cast<std::size_t>(count)) scratch->resize(count);
    PixelLanes center = {0, 0, 0, 0};
    for (int c = 0; c < 3; ++c) {
      for (int k = 0; k < count; ++k) (*scratch)[k] = colours[k][c];
      center[c] = median(scratch, count);
    }
    for (int k = 0; k < count; ++k) (*scratch)[k] = squaredLength(colours[k] - center);
    const float reach = kReach * (std::sqrt(median(scratch, count)) + kStep);
    for (int k = 0; k < count; ++k) {
      const float far = squaredLength(colours[k] - center) / (reach * reach);
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
  const float copies = total * total / squares;  // as many equal weights tell as much
  if (copies < 1.5f) return agreed;
  float spread = 0;
  for (int k = 0; k < count; ++k)
    spread += colours[k][3] * opponentSquares(colours[k] - agreed.colour);
  agreed.noise = spread / total / (copies - 1);
  return agreed;
}

}  // namespace seamwise
