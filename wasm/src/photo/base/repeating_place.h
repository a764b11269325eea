#pragma once
#include <array>
#include <cmath>
#include <vector>

namespace seamwise {

/// Returns the weights of four neighbouring samples at t between the middle two, for cubics through
/// the samples [Catmull and Rom 1974].
inline std::array<float, 4> cubicShares(float t) {
  return {0.5f * t * (-1 + t * (2 - t)), 1 + 0.5f * t * t * (-5 + 3 * t),
          0.5f * t * (1 + t * (4 - 3 * t)), 0.5f * t * t * (t - 1)};
}

/// Returns the index of a sample on a periodic line.
inline int wrappedIndex(int k, int n) {
  const int rest = k % n;
  return rest < 0 ? rest + n : rest;
}

/// Four samples around a place on a periodic line, and their weights.
struct RepeatingReach {
  /// @param place   position in samples; a position within rounding error of a sample is that
  ///                sample
  RepeatingReach(double place, int n) {
    constexpr double kOnSample = 1e-6;
    const double whole = std::floor(place + kOnSample);
    is_between = std::abs(place - whole) > kOnSample;
    share = cubicShares(is_between ? static_cast<float>(place - whole) : 0.0f);
    for (int k = 0; k < 4; ++k) at[k] = wrappedIndex(static_cast<int>(whole) - 1 + k, n);
  }
  std::array<int, 4> at;
  std::array<float, 4> share;
  bool is_between;
};

/// Place in a doubly periodic plane of samples with `columns` per row.
struct RepeatingPlace {
  RepeatingReach x, y;

  float of(const std::vector<float>& plane, int columns) const {
    const auto sample = [&](int j, int i) {
      return plane[static_cast<std::size_t>(y.at[j]) * columns + x.at[i]];
    };
    if (!x.is_between && !y.is_between) return sample(1, 1);
    float sum = 0;
    for (int j = 0; j < 4; ++j) {
      sum += y.share[j] * (x.share[0] * sample(j, 0) + x.share[1] * sample(j, 1) +
                           x.share[2] * sample(j, 2) + x.share[3] * sample(j, 3));
    }
    return sum;
  }
};

}  // namespace seamwise
