#pragma once
#include <map>
#include <vector>

#include "pattern/garment.h"

namespace seamwise {

/// A panel whose pleats take up more or less fabric than drafted: the strips between their lines
/// are stretched across, and the parts between the strips move rigidly. Folded, the panel is the
/// same. [cm]
class PleatFit {
 public:
  /// The fabric of a pleat, as the interval of positions across the pleats.
  struct Strip {
    double from = 0, to = 0;
    double growth = 0;  ///< new width less `to - from`
    bool operator==(const Strip&) const = default;
  };

  /// @param across   unit vector
  /// @param strips   ascending and disjoint
  PleatFit(const Vec2& across, std::vector<Strip> strips);

  /// Maps a point of the drafted panel to the fitted one, and back.
  Vec2 fitted(const Vec2& drafted) const;
  Vec2 drafted(const Vec2& fitted) const;
  /// Greatest movement of a point of the panel.
  double movement() const;
  /// True if a curve is inside one strip or between strips, so that curve() is exact. An arc must
  /// be between strips.
  bool holds(const Curve& curve) const;
  /// Index of the strip that contains a curve which holds() accepts, or -1.
  int stripOf(const Curve& curve) const;
  Curve fitted(const Curve& curve) const;
  const std::vector<Strip>& strips() const { return strips_; }

 private:
  double position(const Vec2& p) const { return across_.dot(p); }
  /// Interval of the positions of a curve.
  std::array<double, 2> extent(const Curve& curve) const;
  double shiftAt(double position) const;

  Vec2 across_;
  std::vector<Strip> strips_, fitted_strips_;
  double start_ = 0;  ///< shift of the points before the first strip
};

/// Fits of the pleated panels, by index of the panel.
using PleatFits = std::map<int, PleatFit>;

}  // namespace seamwise
