#pragma once
#include <array>
#include <vector>

#include "drape/vectors.h"

namespace seamwise {

/// A frame that a part of the body is described in: coordinates (side, ahead, level).
struct Axis {
  Vec3 origin = Vec3::Zero();
  Vec3 side, ahead, up;  ///< orthonormal, side = up x ahead

  Vec3 local(const Vec3& p) const {
    const Vec3 d = p - origin;
    return {dot(side, d), dot(ahead, d), dot(up, d)};
  }
  Vec3 world(const Vec3& q) const { return origin + (side * q.x() + ahead * q.y() + up * q.z()); }
};

/// A section of a tube: u^2 + v^2 + square u^2 v^2 = 1 with u = side / width and
/// v = (ahead - middle) / depth. An ellipse when square is 0, fuller at its corners below.
struct Section {
  double level = 0;   ///< cm along the axis
  double width = 1;   ///< half of it, cm
  double depth = 1;   ///< half of it, cm
  double middle = 0;  ///< cm
  double square = 0;  ///< -1 < square
  /// Its 96-gon with corners at even angles of (u, v), from v = 1 towards +u. [cm]
  std::vector<Vec2> polygon() const;
  double girth() const;  ///< perimeter of that polygon, cm
  /// The section of the same shape with that girth.
  Section withGirth(double girth_cm) const;
};

/// A plane that closes a tube, with a ridge along `ahead` when it slopes down to both sides.
struct TubeEnd {
  double level = 0;     ///< cm along the axis, at side = 0
  double slope = 0;     ///< how much it falls towards the sides, cm per cm
  double rounding = 1;  ///< cm, radius of the edge, about
};

/// A part of the body: sections along an axis, joined by natural cubic splines and closed by two
/// ends. Its distance is twice continuously differentiable but at the ends' roundings, where it is
/// once.
class Tube {
 public:
  /// @param sections   at least three, by rising level
  Tube(Axis axis, const std::vector<Section>& sections, TubeEnd bottom, TubeEnd top);

  const Axis& axis() const { return axis_; }
  double bottom() const { return bottom_.level; }
  double top() const { return top_.level; }
  Section section(double level) const;

  /// About the distance to the surface, negative inside: (r - 1) / |grad r| with r homogeneous in
  /// the section's plane, so right to first order at the surface, and of the order of the distance
  /// far from it. [cm]
  double distance(const Vec3& p, Vec3* gradient) const;
  /// No more than that distance, from the tube's box. [cm]
  double leastDistance(const Vec3& p) const;

 private:
  enum Shape { kWidth, kDepth, kMiddle, kSquare, kShapes };
  /// A value with its first and second derivatives along the axis.
  struct Cubic {
    double value, slope, bend;
  };
  using Cubics = std::array<Cubic, kShapes>;
  Cubics at(double level) const;
  double wallDistance(const Vec3& local, Vec3* gradient) const;

  Axis axis_;
  std::vector<double> levels_;
  std::array<std::vector<double>, kShapes> values_, bends_;  ///< second derivatives at the levels
  TubeEnd bottom_, top_;
  Vec3 low_, high_;  ///< of its box in its own frame, cm
};

/// The lesser of two distances, rounded where they differ by less than `radius`: polynomial and
/// once continuously differentiable. Symmetric in a and b to the last bit. Writes the weight of `b`
/// in the gradient, 0..1.
double smoothLeast(double a, double b, double radius, double* weight_b);

}  // namespace seamwise
