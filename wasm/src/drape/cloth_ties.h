#pragma once
#include <vector>

#include "drape/contacts.h"
#include "pattern/garment.h"

namespace seamwise {

struct HeldLayers {
  std::vector<ClothTie> ties;
  /// Per vertex of the cloth 1 where it is of an upper layer that is buttoned, -1 where it is of
  /// the lower one, else 0.
  std::vector<signed char> laps;
};

/// The points at which pieces that lie on each other without being sewn are held together: all
/// along the lines of a piece that nothing else holds, as a patch pocket is stitched on, and by
/// buttons every 8 cm where both pieces are sewn to others, and on through a band that both are
/// sewn to at the end of that line.
/// @param matches    in the pieces as drafted
/// @param overlaps   which piece of each match is above; the second one where it is not said
/// @param gap        between the layers, m
HeldLayers heldLayers(const SewnLevel& level, const std::vector<MatchLine>& matches,
                      const std::vector<Overlap>& overlaps, double gap);

}  // namespace seamwise
