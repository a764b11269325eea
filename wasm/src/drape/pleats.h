#pragma once
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "drape/vectors.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// A pleat or tuck of a piece with all of its fold lines, in drafted coordinates. The lines end at
/// vertices of the outline if these are close.
struct Pleat {
  FoldKind kind = FoldKind::kKnife;
  Crease line, to;              ///< as in Fold
  std::vector<Crease> between;  ///< fold lines of the hidden fabric

  /// Returns the lines along which edges of triangles run.
  std::vector<Crease> lines() const;
  /// Returns the lines that are pressed. `to` stays flat in knife pleats and tucks.
  std::vector<Crease> pressed() const;
};

/// Returns the pleats of a piece. The result is empty if they overlap or cross.
std::vector<Pleat> pleatsOf(const Panel& panel, const Piece& piece);
/// Returns the pleats of all pieces, or an empty list if no piece has any.
std::vector<std::vector<Pleat>> pleatsOf(const Garment& garment, const Pattern& pattern);

/// Distance at which vertices are on a fold line. [cm]
inline constexpr double kOnFoldLine = 0.02;

/// Returns the outline position of the vertex closest to a point.
int nearestOutline(const Piece& piece, const Vec2& at);

/// Frame in which a pleat's line runs along y.
struct PleatFrame {
  Vec2 up;
  explicit PleatFrame(const Crease& line) {
    const Vec2 along = line[1] - line[0];
    up = along / planarLength(along);
  }
  Vec2 operator()(const Vec2& p) const {
    return {up.y() * p.x() - up.x() * p.y(), up.x() * p.x() + up.y() * p.y()};
  }
  Vec2 back(const Vec2& q) const {
    return {up.y() * q.x() + up.x() * q.y(), up.y() * q.y() - up.x() * q.x()};
  }
};

/// Fabric between two fold lines of a pleated piece.
struct PleatStrip {
  int index = 0;  ///< from one side of the piece to the other
  int layer = 0;  ///< layers outwards of the fabric beside pleats once all pleats are closed
};
/// @param pleats   of one piece, at least one
PleatStrip stripAt(const std::vector<Pleat>& pleats, const Vec2& p);

/// A pleat in a frame in which its lines run along y, `left` at the smaller x.
struct UprightPleat {
  FoldKind kind;
  bool line_left;  ///< the visible fold of a knife pleat or tuck is `left`
  Crease left, right;

  double leftAt(double y) const { return acrossAt(left, y); }
  double widthAt(double y) const { return acrossAt(right, y) - acrossAt(left, y); }
  /// Returns the distance between the fabric on both sides. [cm]
  /// @param open   share of the width to which the pleat is open
  double gapAt(double y, double open) const;
  static double acrossAt(const Crease& line, double y);
  bool opens() const { return kind != FoldKind::kTuck; }
};

/// Returns a pleat in another frame, or nothing if it runs more across y than along it there.
/// @param map   drafted coordinates -> frame
template <class Map>
std::optional<UprightPleat> uprightPleat(const Pleat& pleat, const Map& map);

/// Sorts pleats from left to right.
void sortAcross(std::vector<UprightPleat>& pleats);

/// Position of a point of a pleated piece after the pleats are closed.
struct PleatedPoint {
  double across = 0;  ///< x, cm
  double layer = 0;   ///< layers outwards of the unpleated fabric; negative behind it
};

/// Closes pleats to a share of their width.
/// @param pleats   by rising x, without overlaps
/// @param open     0: closed, 1: flat; tucks remain closed
PleatedPoint closedAt(const std::vector<UprightPleat>& pleats, const Vec2& p, double open);

template <class Map>
std::optional<UprightPleat> uprightPleat(const Pleat& pleat, const Map& map) {
  Crease line{map(pleat.line[0]), map(pleat.line[1])}, to{map(pleat.to[0]), map(pleat.to[1])};
  for (const Crease& of : {line, to}) {
    const Vec2 along = of[1] - of[0];
    if (!(std::abs(along.y()) > std::abs(along.x()))) return std::nullopt;
  }
  const bool line_left = line[0].x() + line[1].x() < to[0].x() + to[1].x();
  if (!line_left) std::swap(line, to);
  return UprightPleat{pleat.kind, line_left, line, to};
}

}  // namespace seamwise
