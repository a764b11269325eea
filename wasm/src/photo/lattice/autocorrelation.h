#pragma once
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// Two planes of values and the weight of each place, the input of an autocorrelation. Values and
/// weights are 0 outside the known area.
struct WeightedPlanes {
  int width = 0, height = 0;
  std::vector<float> first, second, weight;
};

/// r(s) = sum of f(x) f(x + s) / sum of w(x) w(x + s), f = weight times value, over both planes,
/// r(0) = 1: similarity of an image to itself shifted by s. It covers |s.x| <= reach_x, 0 <= s.y <=
/// reach_y, because r(-s) = r(s).
struct Autocorrelation {
  int reach_x = 0, reach_y = 0;
  std::vector<float> r;        ///< row by row, 2 reach_x + 1 per row
  std::vector<float> overlap;  ///< overlap of the weights, relative to s = 0

  int columns() const { return 2 * reach_x + 1; }
  bool holds(const Vec2& s) const { return std::abs(s.x()) < reach_x && std::abs(s.y()) < reach_y; }
  /// Interpolates bilinearly between samples; s with a negative y is negated.
  double at(const Vec2& s) const { return between(r, s); }
  double overlapAt(const Vec2& s) const { return between(overlap, s); }

 private:
  double between(const std::vector<float>& plane, const Vec2& s) const;
};

/// Computes the autocorrelation by fast Fourier transforms of both planes at once, padded with
/// zeros. r is 0 where the overlap is below `least_overlap`.
Autocorrelation autocorrelation(const WeightedPlanes& planes, int reach_x, int reach_y,
                                double least_overlap);

}  // namespace seamwise
