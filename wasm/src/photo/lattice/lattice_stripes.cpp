#include "photo/lattice/lattice_stripes.h"

#include <Eigen/LU>
#include <cmath>

#include "geometry/principal_axes.h"

namespace seamwise {
namespace {

// Maximum of squared slopes along stripes relative to those across: 0.001 to 0.008 on drawn stripes
// (noise), 0.05 and more on plaids with a faint weft.
constexpr double kMostAlong = 0.02;
constexpr double kLeastPeriod = 0.15;  // share of the longer vector; shorter ones run along

/// Returns the greatest length of which both are multiples, within `tolerance`.
double commonDivisor(double a, double b, double tolerance) {
  while (b > tolerance) {
    const double rest = std::abs(a - std::round(a / b) * b);
    a = b;
    b = rest;
  }
  return a;
}

}  // namespace

std::optional<TiltedLattice> asStripes(const Copies& copies, const TiltedLattice& view) {
  const CopiesMean mean = meanOf(copies);
  const int n = copies.n;
  Mat2 slopes = Mat2::Zero();  // tensor in lattice coordinates
  for (int b = 0; b < n; ++b) {
    for (int a = 0; a < n; ++a) {
      const int here = b * n + a, right = b * n + (a + 1) % n, below = ((b + 1) % n) * n + a;
      if (mean.weights[here] < 1.5F || mean.weights[right] < 1.5F || mean.weights[below] < 1.5F)
        continue;
      for (int c = 0; c < 3; ++c) {
        const double value = mean.values[4 * here + c];
        const Vec2 slope(mean.values[4 * right + c] - value, mean.values[4 * below + c] - value);
        slopes += slope * slope.transpose();
      }
    }
  }
  const Mat2 inverse = view.basis.inverse();
  const Mat2 tensor = inverse.transpose() * slopes * inverse;
  const PrincipalAxes axes(tensor);
  if (!(axes.lesser < kMostAlong * axes.greater)) return std::nullopt;
  const Vec2& across = axes.axis;
  const double first = std::abs(across.dot(view.basis.col(0)));
  const double second = std::abs(across.dot(view.basis.col(1)));
  const double longer = std::max(first, second);
  const double period = commonDivisor(longer, std::min(first, second), kLeastPeriod * longer);
  TiltedLattice stripes = view;
  stripes.basis.col(0) = period * across;
  stripes.basis.col(1) = period * perp(across);
  return stripes;
}

}  // namespace seamwise
