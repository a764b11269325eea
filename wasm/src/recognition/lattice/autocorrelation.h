#pragma once
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// Two planes of numbers and how much each place counts, of which the autocorrelation is taken.
/// Values and weights are 0 outside of what is known.
struct WeightedPlanes {
  int width = 0, height = 0;
  std::vector<float> first, second, weight;
};

/// r(s) = sum of f(x) f(x + s) / sum of w(x) w(x + s), f = weight times value, over both planes,
/// r(0) = 1: how much a picture is like itself moved by s. For |s.x| <= reach_x, 0 <= s.y <=
/// reach_y, as r(-s) = r(s).
struct Autocorrelation {
  int reach_x = 0, reach_y = 0;
  std::vector<float> r;        ///< row by row, 2 reach_x + 1 to a row
  std::vector<float> overlap;  ///< share of the weight of s = 0 that meets weight

  int columns() const { return 2 * reach_x + 1; }
  bool holds(const Vec2& s) const { return std::abs(s.x()) < reach_x && std::abs(s.y()) < reach_y; }
  /// Between the samples bilinear; s with a negative y is turned round.
  double at(const Vec2& s) const { return between(r, s); }
  double overlapAt(const Vec2& s) const { return between(overlap, s); }

 private:
  double between(const std::vector<float>& plane, const Vec2& s) const;
};

/// By fast Fourier transforms of both planes at once, padded with zeros. Where less than
/// `least_overlap` meets, r is 0.
Autocorrelation autocorrelation(const WeightedPlanes& planes, int reach_x, int reach_y,
                                double least_overlap);

}  // namespace seamwise
