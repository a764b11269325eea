#pragma once
#include <cstdint>
#include <vector>

#include "pattern/pattern.h"

namespace seamwise {

/// What a finished shape keeps of the piece that was drafted; the defaults are those of results.
struct ShapeLimits {
  double moved = 1;              ///< cm that an outline vertex may move, as it lies
  double kink = 15 * kPi / 180;  ///< rad by which a smooth outline may bend further at a vertex
  double stretch = 0.15;         ///< change of an outline edge, as a share of its length
  double area = 0.3;             ///< least area of a triangle, as a share of what it was
};

/// What settling aims at: a little inside the limits of results, for what later steps still change.
/// How far outlines may move is limited by itself.
inline constexpr ShapeLimits kSettledLimits{.kink = 12.5 * kPi / 180, .stretch = 0.12};

/// What a pattern may be changed by before anything fits, so that its symmetries are exact; the
/// rest is left to the fit.
inline constexpr ShapeLimits kEvenedLimits{.kink = 12 * kPi / 180, .stretch = 0.12, .area = 0.5};

/// Corners of an outline turn by more, and may bend freely. [rad]
inline constexpr double kSmooth = 30 * kPi / 180;

/// How far two sides of a seam may miss their length ratio, edge by edge and as a whole. [cm]
inline constexpr double kSeamTolerance = 0.01;

/// Greatest changes below it leave nothing to deform. [cm]
inline constexpr double kLeastChange = 1e-3;

enum class BrokenLimit : std::uint8_t { kNone, kMoved, kKink, kStretch, kArea, kCrossing };

/// The first limit that a shape of a piece breaks.
BrokenLimit brokenLimit(const Piece& piece, const std::vector<Vec2>& shape,
                        const ShapeLimits& limits);

/// How far an outline vertex moved at most, as it lies. [cm]
double movedOf(const Piece& piece, const std::vector<Vec2>& shape);

/// How far the sides of a seam miss their length ratio: the worst edge, or all of them together.
/// [cm]
double seamError(const Seam& seam, const Shapes& shapes);

/// Whether all seams keep that.
bool isSewable(const Pattern& pattern, const Shapes& shapes);

/// Every vertex in the middle between itself and what mirrors onto it: the exactly symmetric shapes
/// next to the drafted ones. The same as at rest where no symmetry is imposed.
Shapes evenedShapes(const Pattern& pattern);

}  // namespace seamwise
