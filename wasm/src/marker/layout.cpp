#include "marker/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seamwise {

void measure(const PiecesOnBoard& pieces, const LayFabric& fabric, LaidPieces* layout) {
  layout->bottom = std::numeric_limits<double>::infinity();
  layout->top = -layout->bottom;
  for (std::size_t k = 0; k < layout->places.size(); ++k) {
    const LayPlace& place = layout->places[k];
    const int placed = pieces.items()[k].ways[place.way].placed;
    layout->bottom = std::min(layout->bottom, pieces.bottomAt(placed, place.dot, fabric.origin));
    layout->top = std::max(layout->top, pieces.topAt(placed, place.dot, fabric.origin));
  }
  if (fabric.is_fixed) layout->bottom = 0;
}

std::vector<std::vector<int>> allowedWays(const PiecesOnBoard& pieces, const LayFabric& fabric) {
  std::vector<std::vector<int>> allowed;
  for (const LayItem& item : pieces.items()) {
    std::vector<int> ways;
    for (std::size_t k = 0; k < item.ways.size(); ++k) {
      const bool is_turned = !item.ways[k].is_up;
      if (fabric.turned_down.empty() || (fabric.turned_down[item.garment] != 0) == is_turned)
        ways.push_back(static_cast<int>(k));
    }
    allowed.push_back(std::move(ways));
  }
  return allowed;
}

std::vector<double> beginnings(const PiecesOnBoard& pieces, const LayFabric& fabric,
                               std::size_t most) {
  if (fabric.is_fixed) return {0};
  if (pieces.isFine()) return {fabric.origin.y()};
  // Rows repeat after the period. On boards without one, all rows differ.
  const Board& board = pieces.board();
  constexpr int kRows = 8;
  const double range = pieces.period().value_or(kRows * board.up.y());
  std::vector<double> found;
  for (int placed = 0; placed < pieces.placedCount(); ++placed) {
    for (int i = 0; i < 24; ++i) {
      for (int j = 0; j < 24; ++j) {
        const double bottom = pieces.bottomAt(placed, {i, j}, fabric.origin);
        const double within = bottom - range * std::floor(bottom / range + 1e-9);
        const auto at = std::lower_bound(found.begin(), found.end(), within - 1e-6);
        if (at == found.end() || *at > within + 1e-6) {
          const auto place = static_cast<std::size_t>(at - found.begin());
          found.push_back(within);
          for (std::size_t k = found.size() - 1; k > place; --k) std::swap(found[k], found[k - 1]);
        }
        if (pieces.period() && board.along.y() == 0 && j * board.up.y() > range) break;
      }
      if (board.along.y() == 0) break;
    }
  }
  if (found.size() <= most) return found;
  std::vector<double> chosen;
  for (std::size_t k = 0; k < most; ++k) chosen.push_back(found[k * found.size() / most]);
  return chosen;
}

}  // namespace seamwise
