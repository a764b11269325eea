#pragma once
#include <span>
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// Smooth functions on a picture's plane, one for each channel: uniform cubic B-splines, whose node
/// (i, j) lies at ((i - 1) step, (j - 1) step). Outside of the picture they go on as at its border.
struct SmoothField {
  SmoothField() = default;
  SmoothField(int count, double width, double height, double spacing);

  int channels = 0, columns = 0, rows = 0;
  double step = 1;           ///< between nodes. [px]
  std::vector<float> nodes;  ///< channel c of node (i, j): (j * columns + i) * channels + c

  /// The values of all channels at a place of the plane.
  void at(float x, float y, float* values) const;
};

/// The 4 x 4 nodes that a field's value at a place is made of, and their shares.
struct SplineShares {
  SplineShares(const SmoothField& field, float x, float y);
  int first;  ///< of the nodes, the others follow to the right and below
  float across[4], down[4];
};

/// What a least-squares fit of a field of two channels has summed up: per node the normal
/// equations of its own two values (with the shares of B-splines as weights, [A11, A12, A22]), and
/// the gradient. Sums of rows bound the normal matrix of all nodes, so that steps by it descend.
struct FieldSums {
  explicit FieldSums(const SmoothField& field);
  std::vector<float> a11, a12, a22, g1, g2;
  /// Adds an observation at a place: its normal equations [xx, xy; xy, yy] and gradient [gx, gy].
  void add(const SplineShares& at, float weight, float xx, float xy, float yy, float gx, float gy,
           int columns);
};

/// What a fit of a field costs besides its errors.
struct FieldCost {
  float bending = 0;  ///< times squared second differences of nodes
  float size = 0;     ///< times squared nodes
};

/// One step of a regularised fit: adds to channels c1 and c2 what minimises the sums' squares and
/// that cost. Where nothing was observed, the field goes on as smoothly as it can.
void stepField(const FieldSums& sums, const FieldCost& cost, int c1, int c2, SmoothField* field);

}  // namespace seamwise
