#pragma once
#include <cstdint>
#include <vector>

#include "pattern/pattern.h"
#include "tuning/shape.h"

namespace seamwise {

enum class BrokenLimit : std::uint8_t { kNone, kMoved, kKink, kStretch, kArea, kCrossing };

/// Returns whether outline and cut-outs of a piece in this shape cross or touch themselves or each
/// other.
bool crossesItself(const Piece& piece, const std::vector<Vec2>& shape);

/// Returns the first limit that a piece's shape breaks.
BrokenLimit brokenLimit(const Piece& piece, const std::vector<Vec2>& shape,
                        const ShapeLimits& limits);

/// Greatest movement of an outline vertex, without a rigid motion of the piece. [cm]
double pieceMovement(const Piece& piece, const std::vector<Vec2>& shape);

/// Deviation of a seam's sides from their length ratio, the greater of the worst edge's and the
/// whole seam's. [cm]
double seamError(const Seam& seam, const Shapes& shapes);

/// Returns whether seamError() of every seam is at most kSeamTolerance.
bool isSewable(const Pattern& pattern, const Shapes& shapes);

/// The exactly symmetric shapes closest to the drafted ones: every vertex is in the middle between
/// itself and the one mirrored onto it. Equal to the rest shapes if no symmetry is imposed.
Shapes evenedShapes(const Pattern& pattern);
/// Returns whether no vertex is more than kLeastChange from those shapes.
bool hasDraftedLines(const Pattern& pattern, const Shapes& shapes);

}  // namespace seamwise
