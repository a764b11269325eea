#pragma once
#include <array>
#include <optional>
#include <vector>

#include "mesh/grading.h"
#include "pattern/fold.h"

namespace seamwise {

/// Triangles of a plane region. Vertices are the given boundary points, then `interior`.
struct RegionMesh {
  std::vector<Vec2> interior;
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise
};

/// Meshes the region inside loops (outline counter-clockwise, cut-outs clockwise; indices into
/// `boundary`, every point in one loop). The boundary stays unchanged. Edges of triangles run along
/// the creases, as far as these are inside. Returns nothing if the loops are not simple, or so thin
/// that rounding leaves a triangle without area.
std::optional<RegionMesh> meshRegion(const std::vector<Vec2>& boundary,
                                     const std::vector<std::vector<int>>& loops, double coarsest,
                                     const std::vector<Crease>& creases);

}  // namespace seamwise
