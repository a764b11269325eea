#include "drape/cloth_ties.h"

#include <algorithm>
#include <cmath>

#include "drape/mesh_places.h"

namespace seamwise {
namespace {

constexpr double kButtons = 8, kStitches = 1.5;  ///< spacing, cm
/// Buttons of a band at the end of a button line: maximum distance of the line's end from the
/// band's seam, then the start and end of the buttons inside the band. [cm]
constexpr double kAtSeam = 1, kIntoBand = 0.7, kAcrossBand = 2.2;
constexpr double kLap = 6;  ///< cm, maximum distance of overlapping layers from their button line

ClothPoint pointOf(const SewnLevel& level, int piece, const MeshPlaces& places, const Vec2& at) {
  const MeshPlace place = places.at(at);
  ClothPoint point{{}, place.weights};
  const auto& corners = level.pattern.pieces[piece].triangles[place.triangle];
  for (int k = 0; k < 3; ++k) point.vertices[k] = level.sewn[piece][corners[k]];
  return point;
}

/// Point at parameter `share` of segment `segment` of a polyline.
struct Along {
  std::size_t segment;
  double share;
  Vec2 on(const Polyline& line) const {
    return line[segment] * (1 - share) + line[segment + 1] * share;
  }
};

/// Returns points at even distances of about `spacing` from end to end.
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

/// Closest point of a polyline to a given point.
struct Nearest {
  Along at;
  double far;  ///< cm
};

Nearest nearestOn(const Polyline& line, const Vec2& point) {
  Nearest nearest{{0, 0}, 1e18};
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec2 along = line[k + 1] - line[k], to = point - line[k];
    const double squared = along.x() * along.x() + along.y() * along.y();
    const double share =
        squared > 0 ? std::clamp((to.x() * along.x() + to.y() * along.y()) / squared, 0.0, 1.0) : 0;
    const double far = planarLength(Vec2(to - share * along));
    if (far < nearest.far) nearest = {{k, share}, far};
  }
  return nearest;
}

/// Line across a band, starting at the point of its seam that is closest to a given point.
struct BandLine {
  int band = -1;
  Polyline line;
};

std::vector<BandLine> bandLines(const Pattern& pattern, int piece, const Vec2& at) {
  std::vector<BandLine> lines;
  for (const Seam& seam : pattern.seams)
    for (const auto& [own, other] : {std::pair(&seam.a, &seam.b), {&seam.b, &seam.a}}) {
      if (own->piece != piece || other->piece == piece) continue;
      const Piece &of = pattern.pieces[piece], &band = pattern.pieces[other->piece];
      Polyline line;
      for (const int v : own->vertices) line.push_back(of.rest[v]);
      const Nearest nearest = nearestOn(line, at);
      if (nearest.far > kAtSeam) continue;
      const int u = other->vertices[nearest.at.segment],
                v = other->vertices[nearest.at.segment + 1];
      const Vec2 edge = band.rest[v] - band.rest[u];
      // The interior is to the left of the outline.
      const double side = (outlineEdge(band, u, v) == u ? 1 : -1) / planarLength(edge);
      const Vec2 inwards = side * Vec2(-edge.y(), edge.x());
      const Vec2 foot = band.rest[u] + nearest.at.share * edge;
      lines.push_back({other->piece, {foot + kIntoBand * inwards, foot + kAcrossBand * inwards}});
    }
  return lines;
}

/// Returns the button lines of bands that are sewn to both pieces of a match, such as a collar band
/// above the fronts.
std::vector<MatchLine> bandsOf(const Pattern& pattern, const MatchLine& match) {
  std::vector<MatchLine> bands;
  for (const bool first : {true, false})
    for (const BandLine& a :
         bandLines(pattern, match.piece_a, first ? match.a.front() : match.a.back()))
      for (const BandLine& b :
           bandLines(pattern, match.piece_b, first ? match.b.front() : match.b.back())) {
        if (a.band != b.band) continue;
        MatchLine line;
        line.piece_a = line.piece_b = a.band, line.a = a.line, line.b = b.line;
        bands.push_back(line);
      }
  return bands;
}

}  // namespace

HeldLayers heldLayers(const SewnLevel& level, const std::vector<MatchLine>& matches,
                      const std::vector<Overlap>& overlaps, double gap) {
  std::vector<char> sewn(level.pattern.pieces.size(), 0);
  for (const Seam& seam : level.pattern.seams) sewn[seam.a.piece] = sewn[seam.b.piece] = 1;
  HeldLayers held{{}, std::vector<signed char>(level.size, 0)};
  const auto hold = [&](const MatchLine& match, double spacing, bool turned) {
    const int a = match.piece_a, b = match.piece_b;
    const MeshPlaces in_a(level.pattern.pieces[a]), in_b(level.pattern.pieces[b]);
    for (const Along& at : evenly(match.a, spacing)) {
      ClothTie tie{pointOf(level, a, in_a, at.on(match.a)), pointOf(level, b, in_b, at.on(match.b)),
                   gap};
      if (turned) std::swap(tie.a, tie.b);
      held.ties.push_back(tie);
    }
  };
  const auto lap = [&](int piece, const Polyline& line, signed char layer) {
    for (std::size_t v = 0; v < level.sewn[piece].size(); ++v)
      if (nearestOn(line, level.pattern.pieces[piece].rest[v]).far < kLap)
        held.laps[level.sewn[piece][v]] = layer;
  };
  const auto button = [&](const MatchLine& match, bool turned) {
    hold(match, kButtons, turned);
    lap(match.piece_a, match.a, turned ? 1 : -1);
    lap(match.piece_b, match.b, turned ? -1 : 1);
  };
  for (const MatchLine& match : matches) {
    const int a = match.piece_a, b = match.piece_b;
    bool turned = false;
    for (const Overlap& o : overlaps) turned = turned || (o.upper == a && o.lower == b);
    if (!sewn[a] || !sewn[b]) {
      hold(match, kStitches, turned);
      continue;
    }
    button(match, turned);
    for (const MatchLine& band : bandsOf(level.pattern, match)) button(band, turned);
  }
  return held;
}

}  // namespace seamwise
