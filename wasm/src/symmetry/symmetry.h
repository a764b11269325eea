#pragma once
#include <string>
#include <variant>
#include <vector>

#include "base/outcome.h"
#include "pattern/garment.h"
#include "tuning/symmetry.h"

namespace seamwise {

/// A user's request before its registration. Points are in the coordinates of the *input* panel, cm
/// (so x is negated first if the panel was mirrored on import).
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
};  ///< its axis is detected
struct PairRequest {
  std::string first, second;
};
using SymmetryRequest = std::variant<AxisRequest, EdgesRequest, PieceRequest, PairRequest>;

/// Registers requests on the garment (reflect, then ICP on the outlines [Besl & McKay 1992]).
/// Errors: kSymmetryUnknownPiece; kSymmetryDoesNotMirror with the residual in cm and the limit;
/// kSymmetryConflict for a piece that is named twice.
Outcome<std::vector<BodySymmetry>> registerSymmetries(const Garment& garment,
                                                      const std::vector<SymmetryRequest>& requests);

/// The symmetry that best fits a request.
struct MeasuredSymmetry {
  BodySymmetry symmetry;
  bool mirrors = false;  ///< its residual is small enough for imposing it
};

/// Registers every request separately, even if the garment does not mirror in this way. Errors:
/// kSymmetryUnknownPiece; kSymmetryMalformed for a request without an axis or two edges.
Outcome<std::vector<MeasuredSymmetry>> measureSymmetries(
    const Garment& garment, const std::vector<SymmetryRequest>& requests);

/// Finds the symmetric pieces and pairs: an involution on the pieces that maps all seams, or as
/// many as possible, to seams. If there are several, x -> -x of the 3D placement decides. A piece
/// with a partner is not also made symmetric in itself; a piece without a mirror stays free.
std::vector<BodySymmetry> detectSymmetries(const Garment& garment);

/// The pieces of a symmetry for messages: "'front'", or "'left' and 'right'".
std::string namesOf(const Garment& garment, const BodySymmetry& symmetry);
/// The pieces of a symmetry, one or two: indices in the garment.
std::vector<int> piecesOf(const BodySymmetry& symmetry);

}  // namespace seamwise
