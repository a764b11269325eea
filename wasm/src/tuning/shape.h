#pragma once
#include "geometry/vec2.h"

namespace seamwise {

// Limits of a shape that can be cut and sewn. All methods keep them; they are what results state,
// and chosen, not measured.

/// What a finished shape keeps of the piece that was drafted; the defaults are those of results.
struct ShapeLimits {
  double moved = 1;              ///< cm that an outline vertex may move, as it lies
  double kink = 15 * kPi / 180;  ///< rad by which a smooth outline may bend further at a vertex
  double stretch = 0.15;         ///< change of an outline edge, as a share of its length
  double area = 0.3;             ///< least area of a triangle, as a share of what it was
};

/// Limits that settling aims at: a little inside those of results, for what later steps still
/// change. How far outlines may move is limited by itself.
inline constexpr ShapeLimits kSettledLimits{.kink = 12.5 * kPi / 180, .stretch = 0.12};

/// Limits of what a pattern may be changed by before anything fits, so that its symmetries are
/// exact; the rest is left to fitting.
inline constexpr ShapeLimits kEvenedLimits{.kink = 12 * kPi / 180, .stretch = 0.12, .area = 0.5};

/// Turn of an outline from which on it is a corner, which may bend freely. [rad]
inline constexpr double kSmooth = 30 * kPi / 180;

/// How far two sides of a seam may miss their length ratio, edge by edge and as a whole. [cm]
inline constexpr double kSeamTolerance = 0.01;

/// Greatest change below which there is nothing to deform. [cm]
inline constexpr double kLeastChange = 1e-3;

}  // namespace seamwise
