#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "drape/vectors.h"

namespace seamwise {

/// Low and high corner of what holds some points.
struct Box {
  Vec3 low, high;
};

template <class... Rest>
Box boxOf(const Vec3& first, const Rest&... rest) {
  Box box{first, first};
  for (const Vec3* p : {&first, &rest...})
    for (int c = 0; c < 3; ++c)
      box.low[c] = std::min(box.low[c], (*p)[c]), box.high[c] = std::max(box.high[c], (*p)[c]);
  return box;
}

inline bool overlap(const Box& a, const Box& b) {
  for (int c = 0; c < 3; ++c)
    if (a.low[c] > b.high[c] || b.low[c] > a.high[c]) return false;
  return true;
}

/// A cell of a grid in space that the box of an item reaches into.
struct GridEntry {
  std::array<int, 3> cell;
  int item;
  bool operator<(const GridEntry& other) const {
    return cell != other.cell ? cell < other.cell : item < other.item;
  }
};

/// By cell, then item.
inline std::vector<GridEntry> gridEntries(const std::vector<Box>& boxes, double size) {
  std::vector<GridEntry> entries;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    std::array<int, 3> low{}, high{};
    for (int c = 0; c < 3; ++c) {
      low[c] = static_cast<int>(std::floor(boxes[i].low[c] / size));
      high[c] = static_cast<int>(std::floor(boxes[i].high[c] / size));
    }
    for (int a = low[0]; a <= high[0]; ++a)
      for (int b = low[1]; b <= high[1]; ++b)
        for (int c = low[2]; c <= high[2]; ++c) entries.push_back({{a, b, c}, static_cast<int>(i)});
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// Calls meet(a, b) for items of two lists whose boxes overlap, once for each pair, by a, then b.
template <class Meet>
void forOverlaps(const std::vector<Box>& as, const std::vector<Box>& bs, double size,
                 const Meet& meet) {
  const std::vector<GridEntry> by_a = gridEntries(as, size), by_b = gridEntries(bs, size);
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t a = 0, b = 0; a < by_a.size(); ++a) {
    while (b < by_b.size() && by_b[b].cell < by_a[a].cell) ++b;
    for (std::size_t k = b; k < by_b.size() && by_b[k].cell == by_a[a].cell; ++k)
      if (overlap(as[by_a[a].item], bs[by_b[k].item]))
        pairs.emplace_back(by_a[a].item, by_b[k].item);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const auto& [a, b] : pairs) meet(a, b);
}

}  // namespace seamwise
