#include "drape/ring_piece.h"

#include <algorithm>
#include <cmath>

namespace seamwise {

Vec2 RingPiece::extent(double level) const {
  const double l = std::clamp(level, bottom + 1e-6, top - 1e-6);
  Vec2 out(1e9, -1e9);
  const std::size_t n = outline->outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = flat[outline->outline[i]], &b = flat[outline->outline[(i + 1) % n]];
    if ((a.y() < l) == (b.y() < l)) continue;
    const double across = a.x() + (l - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    out = {std::min(out.x(), across), std::max(out.y(), across)};
  }
  return out;
}

Vec2 RingPiece::folded(const Vec2& p, double middle) const {
  const double out = std::abs(p.x() - middle), up = p.y() - bottom;
  return tied == 0 || out + up <= tied ? Vec2(out, p.y()) : Vec2(tied - up, bottom + tied - out);
}

void findFlanks(const Pattern& pattern, std::vector<RingPiece>* pieces) {
  std::vector<int> at(pattern.pieces.size(), -1);
  for (std::size_t i = 0; i < pieces->size(); ++i) at[(*pieces)[i].piece] = static_cast<int>(i);
  const auto mark = [&](RingPiece& piece, const Vec2& a, const Vec2& b) {
    const Vec2 middle = (a + b) / 2, extent = piece.extent(middle.y());
    const bool left = middle.x() - extent.x() < extent.y() - middle.x();
    // A dart is inside the piece.
    if (std::min(middle.x() - extent.x(), extent.y() - middle.x()) > 0.6) return;
    RingPiece::Flank& flank = left ? piece.left : piece.right;
    flank.low = std::min({flank.low, a.y(), b.y()});
    flank.high = std::max({flank.high, a.y(), b.y()});
  };
  const auto steep = [](const Vec2& a, const Vec2& b) {
    return std::abs(a.y() - b.y()) > std::abs(a.x() - b.x());
  };
  for (const Seam& seam : pattern.seams) {
    if (at[seam.a.piece] < 0 || at[seam.b.piece] < 0) continue;
    RingPiece &a = (*pieces)[at[seam.a.piece]], &b = (*pieces)[at[seam.b.piece]];
    for (std::size_t i = 0; i + 1 < seam.a.vertices.size(); ++i) {
      const Vec2 &a0 = a.flat[seam.a.vertices[i]], &a1 = a.flat[seam.a.vertices[i + 1]];
      const Vec2 &b0 = b.flat[seam.b.vertices[i]], &b1 = b.flat[seam.b.vertices[i + 1]];
      if (!steep(a0, a1) || !steep(b0, b1)) continue;
      mark(a, a0, a1);
      mark(b, b0, b1);
    }
  }
}

void findHems(const Pattern& pattern, std::vector<RingPiece>* pieces) {
  const std::vector<std::vector<char>> sewn = sewnEdges(pattern);
  for (RingPiece& piece : *pieces) {
    const std::vector<int>& outline = piece.outline->outline;
    const auto lower = [&](int u, int v) { return piece.flat[u].y() < piece.flat[v].y(); };
    const auto at = std::min_element(outline.begin(), outline.end(), lower) - outline.begin();
    const std::vector<char>& edges = sewn[piece.piece];
    piece.hem = !edges[at] || !edges[at == 0 ? edges.size() - 1 : at - 1];
  }
}

}  // namespace seamwise
