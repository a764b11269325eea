#pragma once
#include <string>
#include <variant>
#include <vector>

#include "base/outcome.h"
#include "pattern/garment.h"
#include "tuning/symmetry.h"

namespace seamwise {

/// What a user asked for, before it is registered. Points are in the coordinates of the *input*
/// panel, cm (so x is negated first when the panel was mirrored on import).
struct AxisRequest {
  std::string piece;
  Vec2 from, to;
};
struct EdgesRequest {
  std::string piece;
  int first, second;
};  ///< two outline edges that mirror
struct PieceRequest {
  std::string piece;
};  ///< axis to be detected
struct PairRequest {
  std::string first, second;
};
using SymmetryRequest = std::variant<AxisRequest, EdgesRequest, PieceRequest, PairRequest>;

/// Registers requests on the garment (reflect, then ICP on the outlines [Besl & McKay 1992]).
/// Errors: kSymmetryUnknownPiece; kSymmetryDoesNotMirror with the residual in cm and the limit;
/// kSymmetryConflict when a piece is asked for twice.
Outcome<std::vector<BodySymmetry>> registerSymmetries(const Garment& garment,
                                                      const std::vector<SymmetryRequest>& requests);

/// The symmetry that comes nearest to a request.
struct MeasuredSymmetry {
  BodySymmetry symmetry;
  bool mirrors = false;  ///< near enough to be imposed
};

/// Registers every request by itself, whether or not the garment mirrors so. Errors:
/// kSymmetryUnknownPiece; kSymmetryMalformed for what names no axis or no two edges.
Outcome<std::vector<MeasuredSymmetry>> measureSymmetries(
    const Garment& garment, const std::vector<SymmetryRequest>& requests);

/// Finds the symmetric pieces and pairs: an involution on the pieces that maps every seam to a seam
/// (or, failing that, most seams); of several, the one that agrees with x -> -x of the 3D
/// placement. A piece that has a partner is not also made symmetric in itself; what has no mirror
/// stays free.
std::vector<BodySymmetry> detectSymmetries(const Garment& garment);

/// The pieces of a symmetry as messages name them: "'front'", or "'left' and 'right'".
std::string namesOf(const Garment& garment, const BodySymmetry& symmetry);
/// The pieces of a symmetry, one or two: indices in the garment.
std::vector<int> piecesOf(const BodySymmetry& symmetry);

}  // namespace seamwise
