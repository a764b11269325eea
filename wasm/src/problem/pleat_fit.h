#pragma once
#include <vector>

#include "pattern/garment.h"

namespace seamwise {

/// A panel whose pleats take up more or less fabric than drafted: the strips between their lines
/// are stretched across, and the parts between the strips move rigidly. Folded, the panel is the
/// same. [cm]
struct PleatFit {
  /// The fabric of a pleat, as the interval of positions across the pleats.
  struct Strip {
    double from = 0, to = 0;
    double growth = 0;  ///< new width less `to - from`
  };

  int piece = -1;
  Vec2 across = Vec2::UnitX();  ///< unit vector
  std::vector<Strip> strips;    ///< ascending and disjoint

  /// Maps a point of the drafted panel to the fitted one, and back.
  Vec2 fitted(const Vec2& drafted) const { return drafted + shiftAt(across.dot(drafted)) * across; }
  Vec2 drafted(const Vec2& fitted) const;
  /// Greatest movement of a point of the panel.
  double movement() const;
  /// Index of the strip that contains a curve, -1 if the curve is outside all strips, or -2 if it
  /// is partly inside, or an arc inside.
  int stripOf(const Curve& curve) const;
  /// The fitted curve; exact unless it is partly inside a strip.
  Curve fitted(const Curve& curve) const;

 private:
  double shiftAt(double position) const;
};

}  // namespace seamwise
