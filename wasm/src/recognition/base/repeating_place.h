#pragma once
#include <array>
#include <cmath>
#include <vector>

namespace seamwise {

/// The shares of four neighbouring samples at a share t between the middle two: cubics that pass
/// through them [Catmull and Rom 1974].
inline std::array<float, 4> cubicShares(float t) {
  return {0.5f * t * (-1 + t * (2 - t)), 1 + 0.5f * t * t * (-5 + 3 * t),
          0.5f * t * (1 + t * (4 - 3 * t)), 0.5f * t * t * (t - 1)};
}

/// The index of a sample of a line that repeats.
inline int wrappedIndex(int k, int n) {
  const int rest = k % n;
  return rest < 0 ? rest + n : rest;
}

/// Four samples of a line that repeats, around a place in it, and their shares.
struct RepeatingReach {
  /// @param place   in samples; what rounding alone keeps from one is that sample
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

/// A place in a plane of samples that repeats both ways, `columns` to a row.
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
