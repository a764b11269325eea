#pragma once
#include <cmath>

#include "geometry/vec2.h"

namespace seamwise {

/// Sine and cosine of an angle. Our own polynomials compute them, because the C library's differ
/// between platforms in the last bit, and a drape amplifies that to millimetres.
struct Turn {
  double sine, cosine;
};

/// Returns sine and cosine to 2e-16, exact at multiples of 90 degrees, and mirrored for mirrored
/// angles.
inline Turn turnOfDegrees(double degrees) {
  const double quarters = std::nearbyint(degrees / 90);
  const double x = (degrees - 90 * quarters) * (kPi / 180), y = x * x;
  // Taylor series; the first omitted term at 45 degrees is 1e-17 of the whole.
  const double s =
      x *
      (1 + y * (-1.0 / 6 +
                y * (1.0 / 120 +
                     y * (-1.0 / 5040 +
                          y * (1.0 / 362880 + y * (-1.0 / 39916800 +
                                                   y * (1.0 / 6227020800 - y / 1307674368000)))))));
  const double c =
      1 + y * (-1.0 / 2 +
               y * (1.0 / 24 + y * (-1.0 / 720 + y * (1.0 / 40320 + y * (-1.0 / 3628800 +
                                                                         y * (1.0 / 479001600 -
                                                                              y / 87178291200))))));
  switch (static_cast<int>(quarters - 4 * std::floor(quarters / 4))) {
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    case 3:
      return {-c, s};
    default:
      return {s, c};
  }
}

/// Returns an angle in degrees, rounded to 1e-9 degrees: its value in the file before the
/// conversion to radians.
inline double degreesOf(double radians) {
  return std::nearbyint(radians * (180 / kPi) * 1e9) / 1e9;
}

/// Returns the angle from the direction `ahead` towards `aside`, in (-180, 180], to 1e-12 degrees;
/// 0 for the null vector. It uses bisection, which is fast enough for pieces but not for vertices.
inline double degreesBetween(double ahead, double aside) {
  double low = 0, high = 180;
  const double side = std::abs(aside);
  for (int step = 0; step < 48; ++step) {
    const double middle = (low + high) / 2;
    const Turn turn = turnOfDegrees(middle);
    // The value is positive while the direction is beyond `middle`.
    (side * turn.cosine - ahead * turn.sine > 0 ? low : high) = middle;
  }
  const double angle = (low + high) / 2;
  if (side == 0) return ahead < 0 ? 180 : 0;
  return aside < 0 ? -angle : angle;
}

}  // namespace seamwise
