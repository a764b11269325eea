#pragma once
#include "photo/base/lattice_map.h"

namespace seamwise {

/// Inverse of a LatticeMap: converts points of an image to lattice coordinates.
class MapInverse {
 public:
  explicit MapInverse(const LatticeMap& map);
  /// @param p   point of the whole image. [px]
  Vec2 operator()(const Vec2& p) const;

 private:
  Mat3 back_;
  double lens_;
  Vec2 middle_;
  double radius_;
};

/// Returns the derivatives of a map by u and by v at lattice coordinates u, as columns. [px]
Mat2 derivative(const LatticeMap& map, const Vec2& u);

/// Returns the side of a square with the area of the cell at the image's middle. [px]
double cellSize(const LatticeMap& map);

/// Returns the longer of w1 and w2 at the image's middle. [px]
double longerRepeat(const LatticeMap& map);

}  // namespace seamwise
