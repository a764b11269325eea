#pragma once
#include <Eigen/LU>

#include "photo/base/lattice_map.h"

namespace seamwise {

/// Parameters in which a `LatticeMap` is fitted. Places on the image before the lens are p = (x -
/// middle) / radius, with q = basis u + origin and p = q / (1 + tilt q). `basis` therefore holds
/// w1, w2 at the image's middle. The tilt is that of the fabric: the tangent of the angle times
/// radius / focal length.
struct TiltedLattice {
  Mat2 basis = Mat2::Identity();
  Vec2 origin = Vec2::Zero();
  Vec2 tilt = Vec2::Zero();
  double lens = 0;
  Vec2 middle = Vec2::Zero();  ///< [px]
  double radius = 1;           ///< [px]
  /// Place around which copies are compared, from the middle. It is no parameter of the map. [px]
  Vec2 focus = Vec2::Zero();

  /// Returns the parameters of a map. The horizon must not go through the image's middle.
  static TiltedLattice of(const LatticeMap& map) {
    Mat3 h = map.homography;  // units of the radius, from the middle
    h.row(0) = (h.row(0) - map.middle.x() * h.row(2)) / map.radius;
    h.row(1) = (h.row(1) - map.middle.y() * h.row(2)) / map.radius;
    TiltedLattice view;
    view.middle = map.middle;
    view.radius = map.radius;
    view.lens = map.lens;
    const Mat2 linear = h.topLeftCorner<2, 2>();
    view.tilt = linear.transpose().inverse() * h.bottomLeftCorner<1, 2>().transpose();
    const double scale = h(2, 2) - view.tilt.dot(h.topRightCorner<2, 1>());
    view.basis = linear / scale;
    view.origin = h.topRightCorner<2, 1>() / scale;
    return view;
  }

  LatticeMap map() const {
    Mat3 h;
    h.topLeftCorner<2, 2>() = basis;
    h.topRightCorner<2, 1>() = origin;
    h.bottomLeftCorner<1, 2>() = tilt.transpose() * basis;
    h(2, 2) = 1 + tilt.dot(origin);
    h.row(0) = radius * h.row(0) + middle.x() * h.row(2);
    h.row(1) = radius * h.row(1) + middle.y() * h.row(2);
    LatticeMap map;
    map.homography = h;
    map.lens = lens;
    map.middle = middle;
    map.radius = radius;
    return map;
  }

  /// Returns the same places for another basis: w' = w m.
  TiltedLattice rebased(const Mat2& m) const {
    TiltedLattice view = *this;
    view.basis = basis * m;
    return view;
  }
};

}  // namespace seamwise
