#include "deform/shape_limits.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon.h"

namespace seamwise {
double pieceMovement(const Piece& piece, const std::vector<Vec2>& shape) {
  double moved = 0;
  for (const std::vector<int>& loop : loopsOf(piece))
    for (const int v : loop) moved = std::max(moved, (shape[v] - piece.rest[v]).norm());
  return moved;
}

bool crossesItself(const Piece& piece, const std::vector<Vec2>& shape) {
  std::vector<Polyline> loops;
  for (const std::vector<int>& loop : loopsOf(piece)) {
    loops.emplace_back();
    for (const int v : loop) loops.back().push_back(shape[v]);
  }
  return findCrossing(loops).has_value();
}

BrokenLimit brokenLimit(const Piece& piece, const std::vector<Vec2>& shape,
                        const ShapeLimits& limits) {
  if (!(pieceMovement(piece, shape) <= limits.moved)) return BrokenLimit::kMoved;
  for (const std::vector<int>& loop : loopsOf(piece)) {
    const std::size_t n = loop.size();
    for (std::size_t k = 0; k < n; ++k) {
      const int u = loop[(k + n - 1) % n], v = loop[k], w = loop[(k + 1) % n];
      const double rest = (piece.rest[w] - piece.rest[v]).norm();
      if (!(std::abs((shape[w] - shape[v]).norm() - rest) <= limits.stretch * rest))
        return BrokenLimit::kStretch;
      const double turn = turnAt(piece.rest[u], piece.rest[v], piece.rest[w]);
      if (std::abs(turn) < kSmooth &&
          !(std::abs(turnAt(shape[u], shape[v], shape[w]) - turn) <= limits.kink))
        return BrokenLimit::kKink;
    }
  }
  for (const auto& t : piece.triangles)
    if (!(triangleArea(shape, t) >= limits.area * triangleArea(piece.rest, t)))
      return BrokenLimit::kArea;
  return crossesItself(piece, shape) ? BrokenLimit::kCrossing : BrokenLimit::kNone;
}

double seamError(const Seam& seam, const Shapes& shapes) {
  double worst = 0, whole = 0;
  const auto length = [&](const SeamSide& side, std::size_t i) {
    const auto& x = shapes[side.piece];
    return (x[side.vertices[i + 1]] - x[side.vertices[i]]).norm();
  };
  for (std::size_t i = 0; i + 1 < seam.a.vertices.size(); ++i) {
    const double off = length(seam.a, i) - seam.length_ratio * length(seam.b, i);
    worst = std::max(worst, std::abs(off));
    whole += off;
  }
  return std::max(worst, std::abs(whole));
}

bool isSewable(const Pattern& pattern, const Shapes& shapes) {
  return std::all_of(pattern.seams.begin(), pattern.seams.end(),
                     [&](const Seam& seam) { return seamError(seam, shapes) <= kSeamTolerance; });
}

Shapes evenedShapes(const Pattern& pattern) {
  Shapes shapes = restShapes(pattern);
  for (const Mirror& m : pattern.mirrors) {
    auto &a = shapes[m.pieces[0]], &b = shapes[m.pieces[1]];
    const RigidMotion back = m.map.inverse();
    std::vector<Vec2> mean(a.size());
    for (std::size_t v = 0; v < mean.size(); ++v) mean[v] = (a[v] + back(b[m.image[v]])) / 2;
    for (std::size_t v = 0; v < mean.size(); ++v) {
      if (m.single() && m.image[v] < static_cast<int>(v)) continue;  // set with its image
      b[m.image[v]] = m.map(mean[v]);
      a[v] = mean[v];
    }
  }
  return shapes;
}

bool hasDraftedLines(const Pattern& pattern, const Shapes& shapes) {
  const Shapes rest = evenedShapes(pattern);
  for (std::size_t p = 0; p < rest.size(); ++p)
    for (std::size_t v = 0; v < rest[p].size(); ++v)
      if ((shapes[p][v] - rest[p][v]).norm() > kLeastChange) return false;
  return true;
}

}  // namespace seamwise
