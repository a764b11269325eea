#include "drape/pleats.h"

#include <algorithm>
#include <cmath>

#include "base/sort_by.h"

namespace seamwise {
namespace {

constexpr double kAtOutline = 0.8;  ///< cm, distance at which a fold line ends at a vertex
constexpr double kJoin = 0.2;    ///< cm, between the edges of the fabric on both sides of a pleat
constexpr double kAtFold = 0.5;  ///< cm, width over which the layer changes at a fold

Crease atOutline(Crease line, const Piece& piece) {
  for (Vec2& end : line) {
    const Vec2& vertex = piece.rest[piece.outline[nearestOutline(piece, end)]];
    if (planarLength(Vec2(vertex - end)) < kAtOutline) end = vertex;
  }
  return line;
}

Crease between(const Crease& a, const Crease& b, double share) {
  return {a[0] * (1 - share) + b[0] * share, a[1] * (1 - share) + b[1] * share};
}

bool isDouble(FoldKind kind) { return kind == FoldKind::kBox || kind == FoldKind::kInverted; }

/// Layers of a pleat: its folds at distances from `left`, and the layer beside each.
struct Stack {
  std::vector<double> folds;
  std::vector<double> layers;  ///< one more than folds: from left to right
};

/// Returns the distance and the layer of a point of the hidden fabric.
/// @param s   distance from the line that folds the fabric back, cm
PleatedPoint stacked(const Stack& stack, double s) {
  PleatedPoint point;
  double from = 0, direction = -1;
  for (std::size_t fold = 0; fold <= stack.folds.size() && s > from; ++fold) {
    const double end = fold < stack.folds.size() ? std::min(s, stack.folds[fold]) : s;
    point.across += direction * (end - from);
    from = end, direction = -direction;
  }
  std::size_t k = 0;
  while (k < stack.folds.size() && s > stack.folds[k]) ++k;
  point.layer = stack.layers[k];
  // Folds are half a layer away from both sides.
  for (const std::size_t fold : {k, k - 1}) {
    if (fold >= stack.folds.size()) continue;
    const double far = std::abs(s - stack.folds[fold]);
    const double other = stack.layers[fold == k ? k + 1 : k - 1];
    if (far < kAtFold) point.layer += (other - point.layer) * (1 - far / kAtFold) / 2;
  }
  return point;
}

}  // namespace

/// Returns the outline position of the vertex closest to a point.
int nearestOutline(const Piece& piece, const Vec2& at) {
  int nearest = 0;
  for (std::size_t k = 0; k < piece.outline.size(); ++k)
    if (planarLength(Vec2(piece.rest[piece.outline[k]] - at)) <
        planarLength(Vec2(piece.rest[piece.outline[nearest]] - at)))
      nearest = static_cast<int>(k);
  return nearest;
}

std::vector<Crease> Pleat::lines() const {
  std::vector<Crease> all{line, to};
  all.insert(all.end(), between.begin(), between.end());
  return all;
}

std::vector<Crease> Pleat::pressed() const {
  std::vector<Crease> all = between;
  all.push_back(line);
  if (isDouble(kind)) all.push_back(to);
  return all;
}

std::vector<Pleat> pleatsOf(const Panel& panel, const Piece& piece) {
  std::vector<Pleat> pleats;
  for (const Fold& fold : panel.folds) {
    if (!fold.takesUp()) continue;
    Pleat pleat{fold.kind, atOutline(fold.line, piece), atOutline(fold.to, piece), {}};
    const std::vector<double> shares =
        isDouble(fold.kind) ? std::vector<double>{0.25, 0.75} : std::vector<double>{0.5};
    for (const double share : shares)
      pleat.between.push_back(atOutline(seamwise::between(fold.line, fold.to, share), piece));
    pleats.push_back(std::move(pleat));
  }
  if (pleats.size() < 2) return pleats;
  const PleatFrame frame(pleats.front().line);
  std::vector<UprightPleat> upright;
  for (const Pleat& pleat : pleats) {
    const std::optional<UprightPleat> one = uprightPleat(pleat, frame);
    if (!one) return {};
    upright.push_back(*one);
  }
  sortAcross(upright);
  for (std::size_t k = 1; k < upright.size(); ++k)
    for (const Crease* line : {&upright[k].left, &upright[k - 1].right})
      for (const Vec2& end : *line)
        if (upright[k].leftAt(end.y()) <
            UprightPleat::acrossAt(upright[k - 1].right, end.y()) - kOnFoldLine)
          return {};
  return pleats;
}

std::vector<std::vector<Pleat>> pleatsOf(const Garment& garment, const Pattern& pattern) {
  std::vector<std::vector<Pleat>> pleats;
  bool any = false;
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
    pleats.push_back(pleatsOf(garment.panels[p], pattern.pieces[p]));
    any = any || !pleats.back().empty();
  }
  return any ? pleats : std::vector<std::vector<Pleat>>{};
}

PleatStrip stripAt(const std::vector<Pleat>& pleats, const Vec2& p) {
  const PleatFrame frame(pleats.front().line);
  const Vec2 at = frame(p);
  const auto isBeyond = [&](const Crease& line) {
    return UprightPleat::acrossAt({frame(line[0]), frame(line[1])}, at.y()) < at.x();
  };
  PleatStrip strip;
  for (const Pleat& pleat : pleats) {
    for (const Crease& line : pleat.lines()) strip.index += isBeyond(line);
    if (isBeyond(pleat.line) == isBeyond(pleat.to)) continue;
    // The fabric next to a visible fold is one layer away, and the rest two.
    const bool first = isBeyond(pleat.line) != isBeyond(pleat.between.front());
    const bool last = isDouble(pleat.kind) && isBeyond(pleat.to) != isBeyond(pleat.between.back());
    strip.layer = (pleat.kind == FoldKind::kBox ? 1 : -1) * (first || last ? 1 : 2);
  }
  return strip;
}

void sortAcross(std::vector<UprightPleat>& pleats) {
  sortBy(pleats, [](const UprightPleat& pleat) { return pleat.left[0].x() + pleat.left[1].x(); });
}

double UprightPleat::acrossAt(const Crease& line, double y) {
  return line[0].x() +
         (y - line[0].y()) / (line[1].y() - line[0].y()) * (line[1].x() - line[0].x());
}

double UprightPleat::gapAt(double y, double open) const {
  const double gap = kind == FoldKind::kTuck ? 0 : open * widthAt(y);
  return isDouble(kind) ? std::max(gap, kJoin) : gap;
}

PleatedPoint closedAt(const std::vector<UprightPleat>& pleats, const Vec2& p, double open) {
  double shift = 0;
  for (const UprightPleat& pleat : pleats) {
    const double width = pleat.widthAt(p.y());
    const double s = p.x() - pleat.leftAt(p.y());
    if (!(width > 0)) continue;
    if (s < -kOnFoldLine) break;
    const double gap = pleat.gapAt(p.y(), open);
    const double left = pleat.leftAt(p.y()) + shift;
    if (s > width + kOnFoldLine) {
      shift += gap - width;
      continue;
    }
    Stack stack;
    const double out = pleat.kind == FoldKind::kBox ? 1 : -1;
    if (isDouble(pleat.kind)) {
      const double depth = (width - gap) / 4;
      stack = {{depth, width - depth}, {out, 2 * out, out}};
      PleatedPoint point = stacked(stack, s);
      // Both lines are half a layer away from the fabric beside them.
      const double from_end = std::min(std::abs(s), std::abs(width - s));
      if (from_end < kAtFold) point.layer *= 1 - (1 - from_end / kAtFold) / 2;
      return {left + point.across, point.layer};
    }
    stack = {{(width - gap) / 2}, {out, 2 * out}};
    const double from_line = pleat.line_left ? s : width - s;
    PleatedPoint point = stacked(stack, from_line);
    if (from_line < kAtFold) point.layer *= 1 - (1 - std::abs(from_line) / kAtFold) / 2;
    return {left + (pleat.line_left ? point.across : gap - point.across), point.layer};
  }
  return {p.x() + shift, 0};
}

}  // namespace seamwise
