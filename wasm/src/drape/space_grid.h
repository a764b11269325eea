#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "drape/vectors.h"

namespace seamwise {

/// Axis-aligned bounding box of points.
struct SpaceBox {
  Vec3 low, high;
};

template <class... Rest>
SpaceBox boxOf(const Vec3& first, const Rest&... rest) {
  SpaceBox box{first, first};
  for (const Vec3* p : {&first, &rest...})
    for (int c = 0; c < 3; ++c)
      box.low[c] = std::min(box.low[c], (*p)[c]), box.high[c] = std::max(box.high[c], (*p)[c]);
  return box;
}

inline bool overlap(const SpaceBox& a, const SpaceBox& b) {
  for (int c = 0; c < 3; ++c)
    if (a.low[c] > b.high[c] || b.low[c] > a.high[c]) return false;
  return true;
}

/// Returns the index pairs of overlapping boxes from two lists, without duplicates, sorted by the
/// first index, then the second.
/// @param size   cell size of the search grid, about the size of the boxes
std::vector<std::pair<int, int>> overlappingPairs(const std::vector<SpaceBox>& as,
                                                  const std::vector<SpaceBox>& bs, double size);

/// Calls meet(a, b) for each overlapping pair.
template <class Meet>
void forOverlaps(const std::vector<SpaceBox>& as, const std::vector<SpaceBox>& bs, double size,
                 const Meet& meet) {
  for (const auto& [a, b] : overlappingPairs(as, bs, size)) meet(a, b);
}

}  // namespace seamwise
