#include "drape/closed_bands.h"

#include <cmath>
#include <utility>
#include <vector>

#include "drape/vectors.h"
#include "drape/weld.h"

namespace seamwise {
namespace {

constexpr double kTallest = 15;   ///< cm, maximum height of a band
constexpr double kAsLong = 0.02;  ///< maximum relative difference between the two end lengths
constexpr double kCorner = 0.7;   ///< cosine of the turn at which an end stops

/// Marks an outline edge without a seam.
constexpr int kOpen = -1;

/// Returns the outline vertices from `from` along open edges to the next corner.
/// @param sewn_to   per outline position: piece sewn to the edge that starts there, or kOpen
/// @param step      1 or -1, along the outline
std::vector<int> endFrom(const Piece& piece, const std::vector<int>& sewn_to, int from, int step) {
  const int count = static_cast<int>(piece.outline.size());
  std::vector<int> end{from};
  while (static_cast<int>(end.size()) < count) {
    const int at = end.back(), next = (at + step + count) % count;
    if (sewn_to[step > 0 ? at : next] != kOpen) break;
    if (end.size() > 1) {
      const Vec2 before = piece.rest[at] - piece.rest[end[end.size() - 2]];
      const Vec2 after = piece.rest[next] - piece.rest[at];
      const double along = before.x() * after.x() + before.y() * after.y();
      if (along < kCorner * planarLength(before) * planarLength(after)) break;
    }
    end.push_back(next);
  }
  return end;
}

double lengthOf(const Piece& piece, const std::vector<int>& end) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < end.size(); ++k)
    sum += planarLength(Vec2(piece.rest[end[k + 1]] - piece.rest[end[k]]));
  return sum;
}

}  // namespace

void closeBands(Pattern* pattern) {
  const Weld weld = welded(*pattern);
  std::vector<std::vector<int>> sewn_to;
  for (const Piece& piece : pattern->pieces) sewn_to.emplace_back(piece.outline.size(), kOpen);
  forSewnEdges(*pattern, [&](int piece, int k, int other) { sewn_to[piece][k] = other; });
  for (int p = 0; p < static_cast<int>(pattern->pieces.size()); ++p) {
    const Piece& piece = pattern->pieces[p];
    const std::vector<int>& sewn = sewn_to[p];
    const int count = static_cast<int>(piece.outline.size());
    for (int from = 0; from < count; ++from) {
      // The edges from here to `to` are sewn.
      if (sewn[from] == kOpen || sewn[(from + count - 1) % count] != kOpen) continue;
      int to = from;
      bool to_others = true;
      for (; sewn[to] != kOpen && (to + 1) % count != from; to = (to + 1) % count)
        to_others = to_others && sewn[to] != p;
      if (!to_others || weld.knot[p][from] != weld.knot[p][to]) continue;
      const std::vector<int> a = endFrom(piece, sewn, from, -1);
      const std::vector<int> b = endFrom(piece, sewn, to, 1);
      const double length = lengthOf(piece, a);
      if (a.size() < 2 || a.size() != b.size() || a.back() == b.back() || length > kTallest ||
          std::abs(lengthOf(piece, b) - length) > kAsLong * length)
        continue;
      Seam seam;
      seam.a = {p, a}, seam.b = {p, b};
      seam.matched = false;
      pattern->seams.push_back(std::move(seam));
    }
  }
}

}  // namespace seamwise
