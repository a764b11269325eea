#pragma once
#include <vector>

#include "pattern/pattern.h"

namespace seamwise {

/// Vertices of a garment, with sewn ones merged into one.
struct Weld {
  struct Member {
    int piece, vertex;
  };
  std::vector<std::vector<int>> knot;        ///< per piece, per vertex: index in `members`
  std::vector<std::vector<Member>> members;  ///< per sewn vertex, in piece order
  /// Per sewn vertex: its image by the pattern's mirrors. It is empty unless the mirrors cover
  /// every piece and map sewn vertices to sewn vertices.
  std::vector<int> image;
};

/// Merges the sewn vertices of a pattern.
/// @param order   piece order in which sewn vertices are numbered
Weld welded(const Pattern& pattern, const std::vector<int>& order);
/// Merges the sewn vertices in the piece order of the pattern.
Weld welded(const Pattern& pattern);

}  // namespace seamwise
