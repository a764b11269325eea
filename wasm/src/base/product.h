#pragma once

namespace seamwise {

/// The rounding error of a product, x y - product, exact to the last bit; each factor is split into
/// two halves [Dekker 1971]. The C library's fused multiplication would add 1 kB to every module
/// and be slower. Valid for sizes below 1e290, and products above 1e-290 or 0.
inline double lostOf(double x, double y, double product) {
  constexpr double kSplit = 134217729;  // 2^27 + 1
  const double wide_x = kSplit * x, wide_y = kSplit * y;
  const double high_x = wide_x - (wide_x - x), low_x = x - high_x;
  const double high_y = wide_y - (wide_y - y), low_y = y - high_y;
  return low_x * low_y - (((product - high_x * high_y) - low_x * high_y) - high_x * low_y);
}

}  // namespace seamwise
