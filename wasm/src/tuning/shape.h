#pragma once
#include "geometry/vec2.h"

namespace seamwise {

// Limits of a shape that can be cut and sewn. All methods keep them and results guarantee them.
// They are chosen, not measured.

/// Limits on the changes of a finished shape from the drafted piece; the defaults apply to results.
struct ShapeLimits {
  double moved = 1;              ///< greatest movement of an outline vertex, cm
  double kink = 15 * kPi / 180;  ///< greatest additional bend of a smooth outline at a vertex, rad
  double stretch = 0.15;         ///< change of an outline edge, as a share of its length
  double area = 0.3;             ///< least area of a triangle, as a share of its drafted area
};

/// Limits for settling, stricter than those of results to allow for changes by later steps. A
/// separate limit applies to the movement of outlines.
inline constexpr ShapeLimits kSettledLimits{.kink = 12.5 * kPi / 180, .stretch = 0.12};

/// Limits on changes of a pattern that make its symmetries exact before fitting; fitting may use
/// the rest.
inline constexpr ShapeLimits kEvenedLimits{.kink = 12 * kPi / 180, .stretch = 0.12, .area = 0.5};

/// Least turn of an outline at a corner, which may bend freely. [rad]
inline constexpr double kSmooth = 30 * kPi / 180;

/// Greatest deviation of two sides of a seam from their length ratio, per edge and in total. [cm]
inline constexpr double kSeamTolerance = 0.01;

/// Greatest change below which there is nothing to deform. [cm]
inline constexpr double kLeastChange = 1e-3;

}  // namespace seamwise
