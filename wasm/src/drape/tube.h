#pragma once
#include <array>
#include <vector>

#include "drape/vectors.h"

namespace seamwise {

/// Frame of a body part with coordinates (side, ahead, level).
struct Axis {
  Vec3 origin = Vec3::Zero();
  Vec3 side, ahead, up;  ///< orthonormal, side = up x ahead

  Vec3 local(const Vec3& p) const {
    const Vec3 d = p - origin;
    return {dot(side, d), dot(ahead, d), dot(up, d)};
  }
  Vec3 world(const Vec3& q) const { return origin + (side * q.x() + ahead * q.y() + up * q.z()); }
};

/// Section of a tube: u^2 + v^2 + square u^2 v^2 = 1 with u = side / width and v = (ahead - middle)
/// / depth. It is an ellipse if square is 0, and fuller at its corners if square is negative.
struct Section {
  double level = 0;   ///< cm along the axis
  double width = 1;   ///< half width, cm
  double depth = 1;   ///< half depth, cm
  double middle = 0;  ///< cm
  double square = 0;  ///< above -1
  /// Returns the 96-gon with corners at even angles of (u, v), from v = 1 towards +u. [cm]
  std::vector<Vec2> polygon() const;
  double girth() const;  ///< perimeter of that polygon, cm
  /// Returns the section of the same shape with the given girth.
  Section withGirth(double girth_cm) const;
};

/// Plane that closes a tube, with a ridge along `ahead` if it slopes down to both sides.
struct TubeEnd {
  double level = 0;     ///< cm along the axis, at side = 0
  double slope = 0;     ///< fall towards the sides, cm per cm
  double rounding = 1;  ///< approximate radius of the edge, cm
};

/// Part of the body: sections along an axis, joined by natural cubic splines and closed by two
/// ends. The distance is twice continuously differentiable, but only once at the roundings of the
/// ends.
class Tube {
 public:
  /// @param sections   at least three, by rising level
  Tube(Axis axis, const std::vector<Section>& sections, TubeEnd bottom, TubeEnd top);

  const Axis& axis() const { return axis_; }
  double bottom() const { return bottom_.level; }
  double top() const { return top_.level; }
  Section section(double level) const;

  /// Returns the approximate distance to the surface, negative inside: (r - 1) / |grad r| with r
  /// homogeneous in the section's plane. It is exact to first order at the surface, and of the
  /// order of the distance far from it. [cm]
  double distance(const Vec3& p, Vec3* gradient) const;
  /// Returns a lower bound of the distance from the tube's bounding box. [cm]
  double leastDistance(const Vec3& p) const;

 private:
  enum Shape { kWidth, kDepth, kMiddle, kSquare, kShapes };
  /// Value with its first and second derivatives along the axis.
  struct Cubic {
    double value, slope, bend;
  };
  using Cubics = std::array<Cubic, kShapes>;
  Cubics at(double level) const;
  double wallDistance(const Vec3& local, Vec3* gradient) const;

  Axis axis_;
  std::vector<double> levels_;
  std::array<std::vector<double>, kShapes> values_, bends_;  ///< values, second derivatives
  TubeEnd bottom_, top_;
  Vec3 low_, high_;  ///< bounding box in the tube's frame, cm
};

/// Returns the smooth minimum of two distances, a polynomial where they differ by less than
/// `radius`. It is once continuously differentiable, and symmetric in a and b to the last bit.
/// @param weight_b   receives the weight of `b` in the gradient, 0..1
double smoothLeast(double a, double b, double radius, double* weight_b);

}  // namespace seamwise
