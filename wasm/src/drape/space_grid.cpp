#include "drape/space_grid.h"

#include <array>
#include <cmath>

#include "base/sort_by.h"

namespace seamwise {
namespace {

/// Returns (cell number, item) for each grid cell that an item's box touches, sorted. Cells more
/// than 2^16 from the origin may share numbers with others, which costs only time. A box without a
/// valid position, such as that of a vertex that is not a number, touches no cell.
std::vector<std::pair<double, std::size_t>> cellsOf(const std::vector<SpaceBox>& boxes,
                                                    double size) {
  constexpr double kCells = 1 << 17, kFar = 1 << 30;
  std::vector<std::pair<double, std::size_t>> cells;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const SpaceBox& box = boxes[i];
    const double farthest = kFar * size;
    if (!(box.low.array() > -farthest).all() || !(box.high.array() < farthest).all()) continue;
    std::array<int, 3> low{}, high{};
    for (int c = 0; c < 3; ++c) {
      low[c] = static_cast<int>(std::floor(box.low[c] / size));
      high[c] = static_cast<int>(std::floor(box.high[c] / size));
    }
    for (int a = low[0]; a <= high[0]; ++a)
      for (int b = low[1]; b <= high[1]; ++b)
        for (int c = low[2]; c <= high[2]; ++c)
          cells.emplace_back((a * kCells + b) * kCells + c, i);
  }
  sortKeyed(cells);
  return cells;
}

}  // namespace

std::vector<std::pair<int, int>> overlappingPairs(const std::vector<SpaceBox>& as,
                                                  const std::vector<SpaceBox>& bs, double size) {
  const auto by_a = cellsOf(as, size), by_b = cellsOf(bs, size);
  std::vector<std::pair<int, int>> pairs;
  std::size_t b = 0;
  for (const auto& [cell, i] : by_a) {
    while (b < by_b.size() && by_b[b].first < cell) ++b;
    for (std::size_t k = b; k < by_b.size() && by_b[k].first == cell; ++k)
      if (const std::size_t j = by_b[k].second; overlap(as[i], bs[j]))
        pairs.emplace_back(static_cast<int>(i), static_cast<int>(j));
  }
  sortOnce(pairs);
  return pairs;
}

}  // namespace seamwise
