#pragma once
#include <vector>

#include "geometry/curve.h"
#include "geometry/rigid_motion.h"

namespace seamwise {

/// A closed outline or cut-out, addressed by arc length from the start of its edge 0. Positions are
/// in cm and cyclic: any real number is taken modulo the length. Keeps a pointer to the edges.
class Loop {
 public:
  explicit Loop(const std::vector<Curve>* edges);

  int edges() const { return static_cast<int>(edges_->size()); }
  const Curve& edge(int k) const { return (*edges_)[k]; }
  double length() const { return corner_.back(); }
  /// Start of edge k; corner(edges()) is the length.
  double corner(int k) const { return corner_[k]; }
  /// The position in [0, length()).
  double wrapped(double position) const {
    return position >= 0 && position < length() ? position : turned(position);
  }
  /// The edge that contains a position (the later one at a corner).
  int edgeAt(double position) const;
  /// Positions that require a vertex, ascending: starts of edges and corners within paths.
  const std::vector<double>& corners() const { return corners_; }
  bool isCorner(double position) const;
  Vec2 at(double position) const;
  /// The position in [from, to], from <= to <= from + length(), nearest to p.
  double nearest(const Vec2& p, double from, double to) const;
  /// Centre of the bounding box.
  Vec2 middle() const;

  /// Points along the loop: the ends of straight edges, 16 steps on curves, more on long paths. The
  /// last point repeats the first.
  struct Sample {
    double position;
    Vec2 point;
  };
  const std::vector<Sample>& samples() const { return samples_; }

 private:
  double turned(double position) const;

  const std::vector<Curve>* edges_;
  std::vector<double> corner_;   ///< starts of edges
  std::vector<double> corners_;  ///< starts of edges and corners within paths
  std::vector<Sample> samples_;
};

}  // namespace seamwise
