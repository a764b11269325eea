#pragma once
#include "geometry/vec2.h"

namespace seamwise {

/// Constants of the triangles that all methods deform. They are chosen, not measured, except where
/// a section of docs/experiments.md is named.
struct MeshTuning {
  /// Greatest edge of interior triangles, where the deformation is smooth. [cm]
  static constexpr double kCoarsest = 6.0;
  /// Growth of the spacing, per cm of distance from the outline.
  static constexpr double kGrowth = 0.4;
  /// Height of the first row of triangles over its edge's length, for nearly equilateral triangles.
  static constexpr double kRowHeight = 0.85;
  /// Least distance of other vertices from an outline's vertex, from the middle of its edge and
  /// from a point of the first row, over the local spacing.
  static constexpr double kVertexClear = 0.65, kEdgeClear = 0.6, kRowClear = 0.72;
  /// Passes that move interior vertices to the middle of their neighbours.
  static constexpr int kSmoothingPasses = 4;
  /// Quality of the worst triangle around a vertex above which smoothing may worsen it; an
  /// equilateral triangle has quality 1.
  static constexpr double kFairQuality = 0.6;
  /// Area of a triangle, as a share of its area in the mean of both halves, below which its outline
  /// vertices are taken from that mean.
  static constexpr double kLeastArea = 0.05;

  /// Distance of vertices along a fold line, and the least distance of others from them. [cm]
  static constexpr double kCreaseStep = 1.5, kCreaseClear = 0.9;
  /// Distance at which the end of a fold line becomes a vertex of the outline. [cm]
  static constexpr double kCreaseSnap = 1e-2;

  // --- the coarser mesh ("Coarse to fine")

  /// Greatest bend caused by omitting a vertex. [rad]
  static constexpr double kSharp = 20 * kPi / 180;
  /// Greatest share of remaining vertices at which the coarser mesh pays off.
  static constexpr double kWorthIt = 0.7;
};

}  // namespace seamwise
