#pragma once
#include <vector>

#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Rough positions of a garment's pieces on a body, from few points of each edge.
struct WornLayout {
  Pattern sketch;                      ///< outlines with a fixed number of points for each edge
  std::vector<std::vector<Vec3>> at;   ///< per piece and vertex; x left, y up, z ahead. [cm]
  std::vector<Vec2> up;                ///< per piece: rise of its x and y directions
  std::vector<Vec3> middle;            ///< per piece: mean of its outline. [cm]
  std::vector<char> arm;               ///< per piece: 1 for sleeves and cuffs
  std::vector<char> neck;              ///< per piece: 1 for collars and hoods
  double middle_depth = 0, depth = 0;  ///< z between front and back, and from there to both. [cm]
};

/// Places the pieces as in the file. If all have the same placement, they are arranged side by side
/// along their seams and wound around the body.
WornLayout wornLayout(const Garment& garment, const std::vector<BodySymmetry>& known);

}  // namespace seamwise
