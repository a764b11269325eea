#pragma once
#include <vector>

#include "drape/contacts.h"
#include "pattern/garment.h"

namespace seamwise {

struct HeldLayers {
  std::vector<ClothTie> ties;
  /// Per vertex of the cloth: 1 in the upper layer of a buttoned overlap, -1 in the lower one, else
  /// 0.
  std::vector<signed char> laps;
};

/// Returns the points that hold together overlapping pieces without a common seam.
/// A piece without seams, such as a patch pocket, is stitched along its whole match lines. Two sewn
/// pieces get a button every 8 cm. The button line continues through a band that both are sewn to
/// at its end.
/// @param matches    lines in the pieces as drafted
/// @param overlaps   upper and lower piece of a match; the second piece is the upper one by default
/// @param gap        distance between the layers, m
HeldLayers heldLayers(const SewnLevel& level, const std::vector<MatchLine>& matches,
                      const std::vector<Overlap>& overlaps, double gap);

}  // namespace seamwise
