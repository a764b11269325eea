#include "drape/pleat_ties.h"

#include <algorithm>
#include <cmath>

#include "drape/mesh_places.h"

namespace seamwise {
namespace {

/// Least weight of a point that is on the piece.
constexpr double kBesidePiece = -0.5;

/// Returns the point of a level at drafted coordinates, or nothing outside the piece.
std::optional<ClothPoint> pointAt(const SewnLevel& level, int piece, const MeshPlaces& places,
                                  const Vec2& at) {
  const MeshPlace place = places.at(at);
  if (*std::min_element(place.weights.begin(), place.weights.end()) < kBesidePiece)
    return std::nullopt;
  ClothPoint point{{}, place.weights};
  for (int k = 0; k < 3; ++k)
    point.vertices[k] = level.sewn[piece][level.pattern.pieces[piece].triangles[place.triangle][k]];
  return point;
}

/// Collects the ties of one pleat.
class PleatHolder {
 public:
  PleatHolder(const SewnLevel& level, int piece, const MeshPlaces& places, const Pleat& pleat,
              double gap, std::vector<ClothTie>* ties)
      : level_(level),
        piece_(piece),
        places_(places),
        frame_(pleat.line),
        upright_(*uprightPleat(pleat, frame_)),
        gap_(gap),
        ties_(ties) {}

  /// Sews the hidden fabric to the fabric over or under it where a seam joins both lines.
  void sewEnd(int end) {
    const Piece& piece = level_.pattern.pieces[piece_];
    const int count = static_cast<int>(piece.outline.size());
    const int from = nearestOutline(piece, frame_.back(upright_.left[end])),
              to = nearestOutline(piece, frame_.back(upright_.right[end]));
    if (from == to || knot(piece.outline[from]) != knot(piece.outline[to])) return;
    for (const int step : {1, count - 1}) {
      const int next = (from + step) % count;
      const double s = across(piece.outline[next]);
      if (next == to ||
          !(s > kOnFoldLine && s < upright_.widthAt(upright_.left[end].y()) - kOnFoldLine))
        continue;
      for (int k = next; k != to; k = (k + step) % count) tieLayer(piece.outline[k]);
      return;
    }
  }

  /// Sews the line of a tuck to the other line.
  void sewAlong() {
    const Piece& piece = level_.pattern.pieces[piece_];
    const Crease &line = upright_.line_left ? upright_.left : upright_.right,
                 &other = upright_.line_left ? upright_.right : upright_.left;
    const double low = std::min(line[0].y(), line[1].y()) - kOnFoldLine,
                 high = std::max(line[0].y(), line[1].y()) + kOnFoldLine;
    for (std::size_t v = 0; v < piece.rest.size(); ++v) {
      const Vec2 q = frame_(piece.rest[v]);
      if (q.y() < low || q.y() > high ||
          std::abs(q.x() - UprightPleat::acrossAt(line, q.y())) > kOnFoldLine)
        continue;
      const double share = (q.y() - line[0].y()) / (line[1].y() - line[0].y());
      const Vec2 onto = other[0] * (1 - share) + other[1] * share;
      tie(frame_.back(onto), static_cast<int>(v), 2 * gap_);  // the tuck is between both lines
    }
  }

 private:
  int knot(int vertex) const { return level_.sewn[piece_][vertex]; }
  double across(int vertex) const {
    const Vec2 q = frame_(level_.pattern.pieces[piece_].rest[vertex]);
    return q.x() - upright_.leftAt(q.y());
  }

  void tieLayer(int vertex) {
    const Vec2 q = frame_(level_.pattern.pieces[piece_].rest[vertex]);
    const PleatedPoint closed = closedAt({upright_}, q, 0);
    const double left = upright_.leftAt(q.y());
    const double beside = closed.across + (closed.across > left ? upright_.widthAt(q.y()) : 0);
    tie(frame_.back({beside, q.y()}), vertex, closed.layer * gap_);
  }

  void tie(const Vec2& onto, int vertex, double gap) {
    const std::optional<ClothPoint> point = pointAt(level_, piece_, places_, onto);
    const int own = knot(vertex);
    if (!point || std::count(point->vertices.begin(), point->vertices.end(), own) > 0) return;
    ties_->push_back({*point, {{own, own, own}, {1, 0, 0}}, gap});
  }

  const SewnLevel& level_;
  int piece_;
  const MeshPlaces& places_;
  PleatFrame frame_;
  UprightPleat upright_;
  double gap_;
  std::vector<ClothTie>* ties_;
};

}  // namespace

std::vector<ClothTie> pleatTies(const SewnLevel& level, double gap) {
  std::vector<ClothTie> ties;
  for (std::size_t p = 0; p < level.pleats.size(); ++p) {
    if (level.pleats[p].empty()) continue;
    const MeshPlaces places(level.pattern.pieces[p]);
    for (const Pleat& pleat : level.pleats[p]) {
      PleatHolder holder(level, static_cast<int>(p), places, pleat, gap, &ties);
      for (const int end : {0, 1}) holder.sewEnd(end);
      if (pleat.kind == FoldKind::kTuck) holder.sewAlong();
    }
  }
  return ties;
}

}  // namespace seamwise
