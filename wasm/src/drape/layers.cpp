#include "drape/layers.h"

#include <algorithm>
#include <cmath>

#include "drape/mesh_places.h"

namespace seamwise {
namespace {

/// Returns per piece whether it has a seam.
std::vector<char> sewnPieces(const Pattern& pattern) {
  std::vector<char> sewn(pattern.pieces.size(), 0);
  for (const Seam& seam : pattern.seams) sewn[seam.a.piece] = sewn[seam.b.piece] = 1;
  return sewn;
}

/// Maps points of a piece to the piece below it: p -> turn p + shift, turn = [c -s; s c].
struct Laying {
  double c = 1, s = 0;
  Vec2 shift = Vec2::Zero();
  Vec2 turned(const Vec2& p) const { return {c * p.x() - s * p.y(), s * p.x() + c * p.y()}; }
  Vec2 operator()(const Vec2& p) const { return turned(p) + shift; }
};

/// Returns the rigid motion that minimises the squared distances between paired points (Kabsch).
Laying fitted(const std::vector<std::pair<Vec2, Vec2>>& points) {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  for (const auto& [a, b] : points) from += a, to += b;
  from /= static_cast<double>(points.size()), to /= static_cast<double>(points.size());
  double along = 0, aside = 0;
  for (const auto& [a, b] : points) {
    const Vec2 u = a - from, v = b - to;
    along += u.x() * v.x() + u.y() * v.y(), aside += u.x() * v.y() - u.y() * v.x();
  }
  Laying laying;
  const double far = std::sqrt(along * along + aside * aside);
  if (far > 0) laying.c = along / far, laying.s = aside / far;
  laying.shift = to - laying.turned(from);
  return laying;
}

std::vector<Vec3> normalsOf(const Piece& piece, const std::vector<Vec3>& x) {
  std::vector<Vec3> normals(x.size(), Vec3::Zero());
  for (const auto& t : piece.triangles) {
    const Vec3 n = crossProduct(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]);
    for (const int v : t) normals[v] += n;
  }
  return normals;
}

}  // namespace

std::vector<Overlap> overlapsOf(const Garment& garment, const Pattern& pattern,
                                const Hanging& hanging) {
  const std::vector<char> sewn = sewnPieces(pattern);
  std::vector<Overlap> overlaps;
  for (const MatchLine& match : garment.matches) {
    const int a = match.piece_a, b = match.piece_b;
    if (sewn[a] != sewn[b]) {
      overlaps.push_back(sewn[a] ? Overlap{b, a} : Overlap{a, b});
    } else if (sewn[a]) {
      const double at_a = hanging.middles[a].x(), at_b = hanging.middles[b].x();
      if (at_a * at_b < 0) overlaps.push_back(at_a < at_b ? Overlap{a, b} : Overlap{b, a});
    }
  }
  sortOverlaps(overlaps);
  const auto same = [](const Overlap& o, const Overlap& p) { return !(o < p) && !(p < o); };
  overlaps.erase(std::unique(overlaps.begin(), overlaps.end(), same), overlaps.end());
  return overlaps;
}

void layOnOthers(const Garment& garment, const Pattern& pattern,
                 const std::vector<Overlap>& overlaps, double gap, PiecePositions* positions) {
  const std::vector<char> sewn = sewnPieces(pattern);
  for (const Overlap& overlap : overlaps) {
    if (sewn[overlap.upper]) continue;
    std::vector<std::pair<Vec2, Vec2>> points;
    for (const MatchLine& match : garment.matches)
      for (std::size_t k = 0; k < match.a.size(); ++k) {
        if (match.piece_a == overlap.upper && match.piece_b == overlap.lower)
          points.emplace_back(match.a[k], match.b[k]);
        if (match.piece_b == overlap.upper && match.piece_a == overlap.lower)
          points.emplace_back(match.b[k], match.a[k]);
      }
    const Laying laying = fitted(points);
    const Piece &piece = pattern.pieces[overlap.upper], &below = pattern.pieces[overlap.lower];
    const std::vector<Vec3>& x = (*positions)[overlap.lower];
    const std::vector<Vec3> normals = normalsOf(below, x);
    const MeshPlaces places(below);
    for (std::size_t v = 0; v < piece.rest.size(); ++v) {
      const MeshPlace place = places.at(laying(piece.rest[v]));
      Vec3 at = Vec3::Zero(), normal = Vec3::Zero();
      for (int k = 0; k < 3; ++k) {
        const int corner = below.triangles[place.triangle][k];
        at += place.weights[k] * x[corner], normal += place.weights[k] * normals[corner];
      }
      const double far = length(normal);
      (*positions)[overlap.upper][v] = far > 0 ? Vec3(at + normal * (gap / far)) : at;
    }
  }
}

}  // namespace seamwise
