#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/rigid_motion.h"
#include "geometry/vec2.h"

namespace seamwise {

/// One outline edge: a straight line, a Bezier curve of degree 2 or 3, a circular arc, or a path,
/// which is a chain of cubics measured as one curve. [cm]
class Curve {
 public:
  // Not inline: curves are copied in many places, and inlined copies would add code to each.
  Curve();
  Curve(const Curve& other);
  Curve(Curve&& other) noexcept;
  Curve& operator=(const Curve& other);
  Curve& operator=(Curve&& other) noexcept;
  ~Curve();

  static Curve line(const Vec2& a, const Vec2& b);
  static Curve quadratic(const Vec2& a, const Vec2& control, const Vec2& b);
  static Curve cubic(const Vec2& a, const Vec2& c1, const Vec2& c2, const Vec2& b);
  /// Arc from a to b with SVG semantics in y-up coordinates (sweep: counter-clockwise). A radius
  /// smaller than half the chord is enlarged to it, as SVG does; radius 0 gives the straight line.
  static Curve arc(const Vec2& a, const Vec2& b, double radius, bool large, bool sweep);
  /// A chain of cubics, joined end to start, through 3 n + 1 points as points() returns them, n >=
  /// 1.
  static Curve path(const std::vector<Vec2>& points);

  Vec2 start() const { return p_[0]; }
  Vec2 end() const { return p_[3]; }
  /// Point at the curve's own parameter t in [0, 1].
  Vec2 at(double t) const;
  /// Derivative of at(t). [cm]
  Vec2 derivative(double t) const;
  /// Arc length, to 1e-10 relative. [cm]
  double length() const { return length_; }
  /// The curve's own parameter at fraction s in [0, 1] of the arc length.
  double parameterAt(double s) const;
  /// Point at fraction s in [0, 1] of the arc length; a mirrored or reversed curve gives the
  /// mirrored point at s or 1 - s, to 1e-9 cm.
  Vec2 atFraction(double s) const;
  /// Sum of the absolute turns of the tangent between two fractions of the arc length, corners
  /// included. Sampled, but exact for lines and arcs. [rad]
  double turning(double s0, double s1) const;
  /// Points of a polyline within `tolerance` cm of the true curve; first and last are exactly the
  /// ends.
  Polyline flattened(double tolerance) const;
  /// Corners of a path that are too sharp for a bend, as ascending fractions of the arc length.
  /// Only the sharpest of nearby corners counts; a mirrored or reversed path has the same ones.
  std::vector<double> corners() const;
  /// Number of even steps that sample the shape of the curve: `least` for a single curve, more for
  /// a long path.
  int stepsAlong(int least) const;
  Curve transformed(const RigidMotion& motion) const;
  Curve reversed() const;
  bool straight() const { return kind_ == Kind::kLine; }
  bool circular() const { return kind_ == Kind::kArc; }
  /// Number of cubics of a path, else 0.
  std::size_t cubics() const { return cubics_.size(); }
  /// The ends, with a Bezier curve's control points between them: 2 points of a line or an arc,
  /// else 3 or 4. A path returns those of all its cubics, with shared ends once.
  std::vector<Vec2> points() const;
  double radius() const { return radius_; }  ///< arc radius [cm]
  double sweep() const { return sweep_; }    ///< arc angle, positive counter-clockwise [rad]
  bool operator==(const Curve&) const = default;

 private:
  enum class Kind : std::uint8_t { kLine, kQuadratic, kCubic, kArc, kPath };
  /// The arc length is s cm up to parameter t. One Gauss rule between two marks is exact enough.
  struct Mark {
    double t, s;
    bool operator==(const Mark&) const = default;
  };

  static Curve bezier(Kind kind, const Vec2& a, const Vec2& c1, const Vec2& c2, const Vec2& b);
  void setSlope();
  /// Length of a Bezier curve between two parameters.
  double gaussLength(double t0, double t1) const;
  void measure(double t0, double t1, double length, int depth);
  /// The cubic of a path at a parameter, and the cubic's own parameter there.
  std::pair<const Curve*, double> cubicAt(double t) const;
  double turningOfPath(double from, double to) const;
  /// The direction in which a cubic starts or ends, even where its speed is 0.
  Vec2 startDirection() const;
  Vec2 endDirection() const;

  Kind kind_ = Kind::kLine;
  Vec2 p_[4] = {Vec2::Zero(), Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
  ///< p_[0] start, p_[3] end; Bezier: p_[1], p_[2] control points; kArc: p_[1] centre
  /// Bezier: derivative(t) = slope_[0] + slope_[1] t + slope_[2] t^2
  Vec2 slope_[3] = {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
  double radius_ = 0, angle0_ = 0,
         sweep_ = 0;  ///< kArc: p(t) = centre + r (cos, sin)(a0 + t sweep)
  double length_ = 0;
  std::vector<Mark> marks_;    ///< marks of a Bezier curve; ends of the cubics of a path
  std::vector<Curve> cubics_;  ///< kPath
};

}  // namespace seamwise
