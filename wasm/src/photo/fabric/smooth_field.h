#pragma once
#include <span>
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// Smooth functions on an image plane, one per channel: uniform cubic B-splines with node (i, j) at
/// ((i - 1) step, (j - 1) step). They keep their border values outside the image.
struct SmoothField {
  SmoothField() = default;
  SmoothField(int count, double width, double height, double spacing);

  int channels = 0, columns = 0, rows = 0;
  double step = 1;           ///< distance between nodes. [px]
  std::vector<float> nodes;  ///< channel c of node (i, j): (j * columns + i) * channels + c

  /// Computes the values of all channels at a place of the plane.
  void at(float x, float y, float* values) const;
};

/// The 4 x 4 nodes that contribute to a field's value at a place, and their weights.
struct SplineShares {
  SplineShares(const SmoothField& field, float x, float y);
  int first;  ///< first node; the others follow to the right and below
  float across[4], down[4];
};

/// Sums of a least-squares fit of a field with two channels. Each node has the normal equations of
/// its own two values (weighted by B-spline shares, [A11, A12, A22]) and the gradient. Sums of rows
/// bound the normal matrix of all nodes, so steps by it descend.
struct FieldSums {
  explicit FieldSums(const SmoothField& field);
  std::vector<float> a11, a12, a22, g1, g2;
  /// Adds an observation at a place: its normal equations [xx, xy; xy, yy] and gradient [gx, gy].
  void add(const SplineShares& at, float weight, float xx, float xy, float yy, float gx, float gy,
           int columns);
};

/// Costs of a field besides its errors.
struct FieldCost {
  float bending = 0;  ///< factor of squared second differences of nodes
  float size = 0;     ///< factor of squared nodes
};

/// Runs one step of a regularised fit: adds the change to channels c1 and c2 that minimises the
/// squared errors in `sums` plus `cost`. The field continues as smoothly as possible where nothing
/// was observed.
void stepField(const FieldSums& sums, const FieldCost& cost, int c1, int c2, SmoothField* field);

}  // namespace seamwise
