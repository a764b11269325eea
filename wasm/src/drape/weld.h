#pragma once
#include <vector>

#include "pattern/pattern.h"

namespace seamwise {

/// The vertices of a garment with those that are sewn together as one.
struct Weld {
  struct Member {
    int piece, vertex;
  };
  std::vector<std::vector<int>> knot;        ///< per piece, per vertex: which of `members` it is in
  std::vector<std::vector<Member>> members;  ///< per sewn vertex, in the order of the pieces
  /// Per sewn vertex its image by the pattern's mirrors; empty unless they cover every piece and
  /// map what is sewn together to what is sewn together.
  std::vector<int> image;
};

/// @param order   of the pieces, in which sewn vertices are numbered
Weld welded(const Pattern& pattern, const std::vector<int>& order);
/// In the order of the pattern.
Weld welded(const Pattern& pattern);

}  // namespace seamwise
