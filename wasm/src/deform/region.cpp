#include "deform/region.h"

#include "deform/triangulation.h"

namespace seamwise {
namespace {

constexpr int kSmoothingPasses = 4;

}  // namespace

std::optional<RegionMesh> meshRegion(const std::vector<Vec2>& boundary,
                                     const std::vector<std::vector<int>>& loops, double coarsest) {
  auto triangulation = Triangulation::make(boundary, loops);
  if (!triangulation) return {};
  for (const Vec2& p : Grading(boundary, loops, coarsest).candidates()) triangulation->insert(p);
  triangulation->smooth(kSmoothingPasses);
  const std::vector<Vec2> points = triangulation->points();
  RegionMesh mesh{{points.begin() + static_cast<std::ptrdiff_t>(boundary.size()), points.end()},
                  triangulation->triangles()};
  for (const auto& [a, b, c] : mesh.triangles)
    if (!(cross(points[b] - points[a], points[c] - points[a]) > 0)) return {};
  return mesh;
}

}  // namespace seamwise
