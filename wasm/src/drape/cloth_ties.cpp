#include "drape/cloth_ties.h"

#include <algorithm>
#include <cmath>

#include "drape/mesh_places.h"

namespace seamwise {
namespace {

constexpr double kButtons = 8, kStitches = 1.5;  ///< cm from one to the next

ClothPoint pointOf(const SewnLevel& level, int piece, const MeshPlaces& places, const Vec2& at) {
  const MeshPlace place = places.at(at);
  ClothPoint point{{}, place.weights};
  const auto& corners = level.pattern.pieces[piece].triangles[place.triangle];
  for (int k = 0; k < 3; ++k) point.vertices[k] = level.sewn[piece][corners[k]];
  return point;
}

/// A point of a polyline: in segment `segment`, that share along it.
struct Along {
  std::size_t segment;
  double share;
  Vec2 on(const Polyline& line) const {
    return line[segment] * (1 - share) + line[segment + 1] * share;
  }
};

/// Evenly from end to end, about `spacing` apart.
std::vector<Along> evenly(const Polyline& line, double spacing) {
  std::vector<double> lengths;
  double whole = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    lengths.push_back(planarLength(Vec2(line[k + 1] - line[k])));
    whole += lengths.back();
  }
  const int count = std::max(1, static_cast<int>(std::nearbyint(whole / spacing)));
  std::vector<Along> out;
  std::size_t segment = 0;
  double before = 0;
  for (int k = 0; k <= count && !lengths.empty(); ++k) {
    const double target = whole * k / count;
    while (segment + 1 < lengths.size() && before + lengths[segment] < target)
      before += lengths[segment++];
    const double share = lengths[segment] > 0 ? (target - before) / lengths[segment] : 0;
    out.push_back({segment, std::clamp(share, 0.0, 1.0)});
  }
  return out;
}

}  // namespace

std::vector<ClothTie> tiesOf(const SewnLevel& level, const std::vector<MatchLine>& matches,
                             const std::vector<Overlap>& overlaps, double gap) {
  std::vector<char> sewn(level.pattern.pieces.size(), 0);
  for (const Seam& seam : level.pattern.seams) sewn[seam.a.piece] = sewn[seam.b.piece] = 1;
  std::vector<ClothTie> ties;
  for (const MatchLine& match : matches) {
    const int a = match.piece_a, b = match.piece_b;
    bool turned = false;
    for (const Overlap& o : overlaps) turned = turned || (o.upper == a && o.lower == b);
    const MeshPlaces in_a(level.pattern.pieces[a]), in_b(level.pattern.pieces[b]);
    for (const Along& at : evenly(match.a, sewn[a] && sewn[b] ? kButtons : kStitches)) {
      ClothTie tie{pointOf(level, a, in_a, at.on(match.a)), pointOf(level, b, in_b, at.on(match.b)),
                   gap};
      if (turned) std::swap(tie.a, tie.b);
      ties.push_back(tie);
    }
  }
  return ties;
}

}  // namespace seamwise
