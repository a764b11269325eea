#pragma once
#include <optional>
#include <vector>

#include "drape/parts.h"

namespace seamwise {

/// Where the vertices of the pieces are in space: per piece, per vertex, cm.
using PiecePositions = std::vector<std::vector<Vec3>>;

struct WrapSettings {
  /// Length at which the fabric bends under its own weight: (bending stiffness / weight)^(1/3). A
  /// wave is six of them long. [cm]
  double fold = 1.9;
  /// Every vertex is at least so far outside the form. [cm]
  double clearance = 0.9;
  /// And so much further per layer of cloth below it. [cm]
  double layer = 0.6;
  /// Rounds in which edges are drawn towards their lengths; at least 2.
  int rounds = 40;
};

/// Wraps a meshed garment around the form, as the start of a drape: what is sewn lies together,
/// pieces lie side by side in rings about the parts of the body, all at least `clearance` outside
/// it. Exactly symmetric when the pattern's mirrors cover it and agree with its placement. The same
/// bytes whatever the order and the names of the pieces.
/// Errors: those of hang().
Outcome<PiecePositions> wrapped(const Garment& garment, const Pattern& pattern, const Form& form,
                                const WrapSettings& settings = {});

/// How wide a closed ring of pieces is at a height.
struct WornGirth {
  double height;  ///< over the floor; of arms, along their axis, cm
  double girth;   ///< cm
};

/// The rings about a part of the body at heights 1 cm apart, as the file hangs them; without hems,
/// and where they are open. Empty when hang() refuses the garment.
std::vector<WornGirth> wornGirths(const Garment& garment, const Pattern& pattern, const Form& form,
                                  BodyPart part);

/// How far the crotch of trousers lies below the top of the garment, its seams sewn, cm; none
/// without legs, or when hang() refuses the garment.
std::optional<double> wornRise(const Garment& garment, const Pattern& pattern, const Form& form);

}  // namespace seamwise
