#pragma once
// Range reduction for modules whose angles are a few turns at most, included once in each of them.
#include <cmath>

/// Replaces the C library's function, which takes 1.3 kB. Returns the number of quarter turns in
/// `angle`; the remainder is a sum of two numbers. Exact to the last bit except near multiples of a
/// quarter turn, where the error is below 1e-26.
extern "C" int __rem_pio2(double angle, double* rest) {
  constexpr double kQuarter = 0x1.921FB544p0, kQuarterRest = 0x1.0B4611A626331p-34;
  const double quarters = std::nearbyint(angle * 0x1.45F306DC9C883p-1);
  const double first = angle - quarters * kQuarter, second = quarters * kQuarterRest;
  rest[0] = first - second;
  rest[1] = (first - rest[0]) - second;
  return static_cast<int>(quarters);
}
