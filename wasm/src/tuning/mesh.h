#pragma once
#include "geometry/vec2.h"

namespace seamwise {

/// Constants of the triangles that all methods deform; chosen, not measured, but where a section of
/// docs/experiments.md is named.
struct MeshTuning {
  /// Edges of triangles inside, at most: the interior is smooth. [cm]
  static constexpr double kCoarsest = 6.0;
  /// Growth of the spacing, per cm of distance from the outline.
  static constexpr double kGrowth = 0.4;
  /// Height of the first row of triangles over its edge's length: nearly equilateral.
  static constexpr double kRowHeight = 0.85;
  /// Distance from an outline's vertex, from the middle of its edge and from a point of the first
  /// row within which no other vertex lies, over the local spacing.
  static constexpr double kVertexClear = 0.65, kEdgeClear = 0.6, kRowClear = 0.72;
  /// Passes that move interior vertices to the middle of their neighbours.
  static constexpr int kSmoothingPasses = 4;
  /// Quality of the worst triangle around a vertex, of an equilateral one's 1, above which it may
  /// get worse by smoothing.
  static constexpr double kFairQuality = 0.6;
  /// Area of a triangle, as a share of that in the mean of both halves, below which its outline
  /// vertices are taken from that mean.
  static constexpr double kLeastArea = 0.05;

  // --- the coarser mesh ("Coarse to fine")

  /// Bend that leaving out a vertex may make, at most. [rad]
  static constexpr double kSharp = 20 * kPi / 180;
  /// Share of the vertices that may be left for the coarser mesh to be worth it.
  static constexpr double kWorthIt = 0.7;
};

}  // namespace seamwise
