#pragma once
#include <array>
#include <vector>

#include "geometry/boxed_runs.h"
#include "pattern/garment.h"

namespace seamwise {

/// A point of an outline.
struct OutlinePoint {
  Vec2 point = Vec2::Zero();
  double distance = 0;  ///< distance from the query point, cm
  int edge = -1;        ///< panel edge; -1 on the rim of a hole
  double fraction = 0;  ///< fraction of the edge's arc length, in [0, 1]
};

/// A panel's outline and holes, flattened and indexed for registration. [cm]
class Outline {
 public:
  static constexpr int kEven = 64;  ///< number of points of `even()`

  explicit Outline(const Panel& panel);

  /// Corners of the outline and of the holes: the starts of all curves, and corners within them.
  const Polyline& corners() const { return corners_; }
  /// Points on all loops, at most 2 cm apart, corners included.
  const Polyline& samples() const { return samples_; }
  /// kEven points on the outer loop, evenly spaced by arc length.
  const std::array<Vec2, kEven>& even() const { return even_; }
  double length() const { return length_; }  ///< length of the outer loop
  double area() const { return area_; }      ///< area of the outer loop, cm2
  double edgeLength(int edge) const { return edges_[edge].length; }
  Vec2 at(int edge, double fraction) const;
  /// Nearest point of the flattened outline, which deviates from the exact one by at most
  /// kFlatness.
  OutlinePoint nearest(const Vec2& p) const;
  /// Index of the corner nearest to p, the first of equally near ones.
  int nearestCorner(const Vec2& p) const;

  static constexpr double kFlatness = 0.002;

 private:
  struct Segment {
    Vec2 from, step;
    double inverse_square;  ///< 1 / |step|^2
    int edge;
    double start, span;  ///< fractions of the edge
  };
  struct Edge {
    int first, last;  ///< segments [first, last)
    double length;
  };

  void append(const Curve& curve, int edge);
  void sampleEvenly();

  std::vector<Segment> segments_;
  std::vector<Edge> edges_;
  Polyline corners_, samples_;
  BoxedRuns segment_boxes_, corner_boxes_;
  std::array<Vec2, kEven> even_;
  double length_ = 0, area_ = 0;
};

}  // namespace seamwise
