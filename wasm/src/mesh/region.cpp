#include "mesh/region.h"

#include "mesh/triangulation.h"
#include "tuning/mesh.h"

namespace seamwise {
std::optional<RegionMesh> meshRegion(const std::vector<Vec2>& boundary,
                                     const std::vector<std::vector<int>>& loops, double coarsest) {
  auto triangulation = Triangulation::make(boundary, loops);
  if (!triangulation) return {};
  // Insert a few distant candidates first. All triangles of a round outline have the same
  // circumcircle, and every one of several successive neighbours would flip all of them.
  const std::vector<Vec2> candidates = Grading(boundary, loops, coarsest).candidates();
  for (std::size_t stride = 512; stride >= 1; stride /= 8)
    for (std::size_t i = 0; i < candidates.size(); i += stride)
      if (stride == 512 || i % (8 * stride) != 0) triangulation->insert(candidates[i]);
  triangulation->smooth(MeshTuning::kSmoothingPasses);
  const std::vector<Vec2> points = triangulation->points();
  RegionMesh mesh{{points.begin() + static_cast<std::ptrdiff_t>(boundary.size()), points.end()},
                  triangulation->triangles()};
  for (const auto& [a, b, c] : mesh.triangles)
    if (!(triangleArea(points[a], points[b], points[c]) > 0)) return {};
  return mesh;
}

}  // namespace seamwise
