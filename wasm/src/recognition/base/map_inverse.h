#pragma once
#include "recognition/base/lattice_map.h"

namespace seamwise {

/// The lattice coordinates of places on a picture: the inverse of a LatticeMap.
class MapInverse {
 public:
  explicit MapInverse(const LatticeMap& map);
  /// @param p   on the whole picture. [px]
  Vec2 operator()(const Vec2& p) const;

 private:
  Mat3 back_;
  double lens_;
  Vec2 middle_;
  double radius_;
};

/// The derivatives of a map by u and by v at lattice coordinates u, as columns. [px]
Mat2 derivative(const LatticeMap& map, const Vec2& u);

/// The side of the square as large as the cell at the picture's middle. [px]
double cellSize(const LatticeMap& map);

/// The longer of w1 and w2 at the picture's middle. [px]
double longerRepeat(const LatticeMap& map);

}  // namespace seamwise
