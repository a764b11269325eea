#include "drape/upright_joins.h"

#include <algorithm>

#include "drape/turn.h"
#include "drape/vectors.h"

namespace seamwise {
namespace {

// Minimum cosine between the vertical and the line through the ends of an upright seam.
constexpr double kUpright = 0.7;

Vec2 turned(const Vec2& v, int quarters) {
  switch (quarters % 4) {
    case 1:
      return perp(v);
    case 2:
      return -v;
    case 3:
      return -perp(v);
    default:
      return v;
  }
}

}  // namespace

int UprightJoin::quarters() const {
  const double ahead = b.way.dot(a.way), aside = cross(b.way, a.way);
  if (std::abs(ahead) >= std::abs(aside)) return ahead < 0 ? 2 : 0;
  return aside > 0 ? 1 : 3;
}

bool UprightJoin::isFlat() const {
  return !isShoulder() && a.out.dot(turned(b.out, quarters())) < -0.3;
}

bool UprightJoin::isUpright() const {
  const auto upright = [](const Vec2& way) {
    return std::abs(way.y()) > kUpright * planarLength(way);
  };
  return upright(a.way) && upright(b.way);
}

UprightPieces::UprightPieces(const Garment& garment, const Pattern& pattern) : pattern_(pattern) {
  for (const Panel& panel : garment.panels) {
    const Turn turn = turnOfDegrees(degreesOf(panel.grain_angle));
    Vec2 up(turn.cosine, turn.sine);
    // A grain line has no direction; the end that is drawn higher counts as up.
    if (up.y() < -1e-9 || (up.y() < 1e-9 && up.x() < 0)) up = -up;
    ups_.push_back(up);
  }
  join();
}

void UprightPieces::join() {
  joins_.clear();
  for (const Seam& seam : pattern_.seams) {
    UprightJoin join{side(seam.a), side(seam.b), 0};
    join.length = std::min(planarLength(join.a.way), planarLength(join.b.way));
    joins_.push_back(join);
  }
}

UprightSide UprightPieces::side(const SeamSide& side) const {
  const Piece& piece = pattern_.pieces[side.piece];
  UprightSide upright{side.piece, Vec2::Zero(), Vec2::Zero(), Vec2::Zero(), -1e9, 1e9};
  const auto at = [&](int v) { return (*this)(side.piece, piece.rest[v]); };
  for (const int v : side.vertices) {
    const Vec2 p = at(v);
    upright.middle += p;
    upright.top = std::max(upright.top, p.y()), upright.bottom = std::min(upright.bottom, p.y());
  }
  upright.middle /= static_cast<double>(side.vertices.size());
  upright.way = at(side.vertices.back()) - at(side.vertices.front());
  const auto count = static_cast<int>(piece.outline.size());
  for (std::size_t i = 0; i + 1 < side.vertices.size(); ++i) {
    const int k = outlineEdge(piece, side.vertices[i], side.vertices[i + 1]);
    if (k >= count) continue;  // edge of a hole
    const Vec2 step = at(piece.outline[(k + 1) % count]) - at(piece.outline[k]);
    upright.out += Vec2(step.y(), -step.x());
  }
  const double far = planarLength(upright.out);
  if (far > 0) upright.out /= far;
  return upright;
}

void UprightPieces::turn(int piece, int quarters) {
  // A turn as seen by the viewer is the opposite turn in the piece's frame.
  ups_[piece] = turned(ups_[piece], 4 - quarters);
  join();
}

double UprightPieces::width(int piece) const {
  double low = 1e9, high = -1e9;
  for (const int v : pattern_.pieces[piece].outline) {
    const double x = (*this)(piece, pattern_.pieces[piece].rest[v]).x();
    low = std::min(low, x), high = std::max(high, x);
  }
  return high - low;
}

double UprightPieces::area(int piece) const {
  const Piece& one = pattern_.pieces[piece];
  double twice = 0;
  for (std::size_t k = 0; k < one.outline.size(); ++k)
    twice += cross(one.rest[one.outline[k]], one.rest[one.outline[(k + 1) % one.outline.size()]]);
  return twice / 2;
}

}  // namespace seamwise
