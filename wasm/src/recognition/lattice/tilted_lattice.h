#pragma once
#include <Eigen/LU>

#include "recognition/base/lattice_map.h"

namespace seamwise {

/// The numbers by which a `LatticeMap` is fitted. With places p = (x - middle) / radius on the
/// picture, before the lens: q = basis u + origin, p = q / (1 + tilt q). So `basis` holds w1, w2 as
/// they are at the picture's middle, and the tilt is that of the cloth: the tangent of the angle
/// times radius / focal length.
struct TiltedLattice {
  Mat2 basis = Mat2::Identity();
  Vec2 origin = Vec2::Zero();
  Vec2 tilt = Vec2::Zero();
  double lens = 0;
  Vec2 middle = Vec2::Zero();  ///< [px]
  double radius = 1;           ///< [px]

  /// Nothing for a map that lays the middle of the picture on the horizon.
  static TiltedLattice of(const LatticeMap& map) {
    Mat3 to_unit;
    to_unit << 1 / map.radius, 0, -map.middle.x() / map.radius,  //
        0, 1 / map.radius, -map.middle.y() / map.radius,         //
        0, 0, 1;
    const Mat3 h = to_unit * map.homography;
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
    Mat3 h, to_pixels;
    h.topLeftCorner<2, 2>() = basis;
    h.topRightCorner<2, 1>() = origin;
    h.bottomLeftCorner<1, 2>() = tilt.transpose() * basis;
    h(2, 2) = 1 + tilt.dot(origin);
    to_pixels << radius, 0, middle.x(), 0, radius, middle.y(), 0, 0, 1;
    LatticeMap map;
    map.homography = to_pixels * h;
    map.lens = lens;
    map.middle = middle;
    map.radius = radius;
    return map;
  }

  /// Where a place of the whole picture [px] lies in lattice coordinates.
  Vec2 latticeAt(const Vec2& x) const {
    const Vec2 seen = (x - middle) / radius;
    Vec2 p = seen;
    for (int k = 0; k < 4; ++k) p = seen / (1 + lens * p.squaredNorm());
    const Vec2 q = p / (1 - tilt.dot(p));
    return basis.inverse() * (q - origin);
  }

  /// The same places for another basis: w' = w m.
  TiltedLattice rebased(const Mat2& m) const {
    TiltedLattice view = *this;
    view.basis = basis * m;
    return view;
  }
};

}  // namespace seamwise
