#pragma once
#include <utility>
#include <vector>

#include "drape/mesh_places.h"
#include "drape/pleats.h"
#include "drape/wrap.h"

namespace seamwise {

/// Lays the hidden fabric of closed pleats on the fabric over or under it, layer by layer.
class PleatLayers {
 public:
  explicit PleatLayers(const Pattern& pattern);

  /// Finds the fabric of a piece that its other fabric covers.
  /// @param flat     per vertex: position in the frame of `pleats`, a rigid motion of the piece
  /// @param opened   per vertex: share to which pleats are open there
  void add(int piece, const std::vector<Vec2>& flat, const std::vector<UprightPleat>& pleats,
           const std::vector<double>& opened);
  /// Per piece, per vertex: lay() places it.
  const std::vector<std::vector<char>>& covered() const { return covered_; }
  /// Moves covered vertices to their layers.
  void lay(PiecePositions* positions) const;

 private:
  struct Laid {
    int piece, vertex;
    std::vector<MeshPlace> on;  ///< one place, or two at a join
    double layer;
  };

  const Pattern& pattern_;
  std::vector<std::vector<char>> covered_, sewn_;
  std::vector<Laid> laid_;
};

/// Distance between the layers of a pleat at the start of a drape. [cm]
inline constexpr double kPleatLayer = 0.3;

}  // namespace seamwise
