#pragma once
#include <optional>
#include <vector>

#include "drape/parts.h"

namespace seamwise {

/// Vertex positions in space: per piece, per vertex, cm.
using PiecePositions = std::vector<std::vector<Vec3>>;

struct WrapSettings {
  /// Length at which the fabric bends under its own weight: (bending stiffness / weight)^(1/3). A
  /// wave is six times as long. [cm]
  double fold = 1.9;
  /// Minimum distance of every vertex from the form. [cm]
  double clearance = 0.9;
  /// Additional distance per layer of cloth below. [cm]
  double layer = 0.6;
  /// Rounds that pull edges towards their lengths; at least 2.
  int rounds = 40;
};

/// Wraps a meshed garment around the form, as the start of a drape.
/// Seams are closed, and pieces are side by side in rings around the parts of the body, at least
/// `clearance` outside it. The result is exactly symmetric if the pattern's mirrors cover it and
/// agree with its placement. Its bytes do not depend on the order and names of the pieces.
/// Errors: those of hang().
/// @param fullness   set to the largest girth of a ring relative to the body above, if not null
Outcome<PiecePositions> wrapped(const Garment& garment, const Pattern& pattern, const Form& form,
                                const WrapSettings& settings = {}, double* fullness = nullptr);

/// Girth of a closed ring of pieces at a height.
struct WornGirth {
  double height;  ///< over the floor, cm; for arms along their axis
  double girth;   ///< cm
};

/// Returns the rings around a part of the body at heights 1 cm apart, as hung by the file. It omits
/// hems and heights where rings are open. It is empty if hang() rejects the garment.
std::vector<WornGirth> wornGirths(const Garment& garment, const Pattern& pattern, const Form& form,
                                  BodyPart part);

/// Returns the depth of the trousers' crotch below the top of the garment, with closed seams, cm.
/// It is empty without legs or if hang() rejects the garment.
std::optional<double> wornRise(const Garment& garment, const Pattern& pattern, const Form& form);

}  // namespace seamwise
