#pragma once
#include "geometry/vec2.h"

namespace seamwise {

/// Maps lattice coordinates of a flat print to an image: x = lens(H (u, v, 1)), in pixels of the
/// whole upright image, x to the right, y down. The lens has one term: lens(y) = c + (1 + k |y -
/// c|^2 / r^2) (y - c), with the image's middle c and half its longer side r.
struct LatticeMap {
  Mat3 homography = Mat3::Identity();
  double lens = 0;             ///< k
  Vec2 middle = Vec2::Zero();  ///< c. [px]
  double radius = 1;           ///< r. [px]

  Vec2 operator()(const Vec2& u) const {
    const Eigen::Vector3d p = homography * Eigen::Vector3d(u.x(), u.y(), 1);
    const Vec2 flat(p.x() / p.z(), p.y() / p.z());
    const Vec2 off = flat - middle;
    return middle + (1 + lens * off.squaredNorm() / (radius * radius)) * off;
  }

  /// Returns the same map for another basis and origin: u = m u' + origin.
  LatticeMap rebased(const Mat2& m, const Vec2& origin) const {
    LatticeMap map = *this;
    const Mat3& h = homography;
    map.homography.col(0) = m(0, 0) * h.col(0) + m(1, 0) * h.col(1);
    map.homography.col(1) = m(0, 1) * h.col(0) + m(1, 1) * h.col(1);
    map.homography.col(2) += origin.x() * h.col(0) + origin.y() * h.col(1);
    return map;
  }
};

}  // namespace seamwise
