#pragma once
#include <cstdint>
#include <vector>

#include "pattern/pattern.h"
#include "tuning/shape.h"

namespace seamwise {

enum class BrokenLimit : std::uint8_t { kNone, kMoved, kKink, kStretch, kArea, kCrossing };

/// Whether outline and cut-outs of a piece in this shape cross or touch themselves or each other.
bool crossesItself(const Piece& piece, const std::vector<Vec2>& shape);

/// The first limit that a shape of a piece breaks.
BrokenLimit brokenLimit(const Piece& piece, const std::vector<Vec2>& shape,
                        const ShapeLimits& limits);

/// How far an outline vertex moved at most, as it lies. [cm]
double pieceMovement(const Piece& piece, const std::vector<Vec2>& shape);

/// How far the sides of a seam miss their length ratio: the worst edge, or all of them together.
/// [cm]
double seamError(const Seam& seam, const Shapes& shapes);

/// Whether seamError() of every seam is at most kSeamTolerance.
bool isSewable(const Pattern& pattern, const Shapes& shapes);

/// Every vertex in the middle between itself and what mirrors onto it: the exactly symmetric shapes
/// next to the drafted ones. The same as at rest where no symmetry is imposed.
Shapes evenedShapes(const Pattern& pattern);

}  // namespace seamwise
