#include "mesh/region.h"

#include "mesh/triangulation.h"
#include "tuning/mesh.h"

namespace seamwise {
namespace {

/// The boundary vertex close to p, or p itself.
Vec2 snapped(const Vec2& p, const std::vector<Vec2>& boundary) {
  for (const Vec2& vertex : boundary)
    if ((vertex - p).norm() < MeshTuning::kCreaseSnap) return vertex;
  return p;
}

}  // namespace

std::optional<RegionMesh> meshRegion(const std::vector<Vec2>& boundary,
                                     const std::vector<std::vector<int>>& loops, double coarsest,
                                     const std::vector<Crease>& creases) {
  auto triangulation = Triangulation::make(boundary, loops);
  if (!triangulation) return {};
  std::vector<Vec2> creased;
  for (const Crease& crease : creases) {
    const Vec2 a = snapped(crease[0], boundary), b = snapped(crease[1], boundary);
    const int steps = 1 + static_cast<int>((b - a).norm() / MeshTuning::kCreaseStep);
    std::vector<Vec2> points;
    points.reserve(steps + 1);
    for (int k = 0; k < steps; ++k) points.push_back(a + k * (b - a) / steps);
    points.push_back(b);
    triangulation->addCrease(points);
    creased.insert(creased.end(), points.begin(), points.end());
  }
  const auto insert = [&](const Vec2& p) {
    for (const Vec2& q : creased)
      if ((p - q).norm() < MeshTuning::kCreaseClear) return;
    triangulation->insert(p);
  };
  // Insert a few distant candidates first. All triangles of a round outline have the same
  // circumcircle, and every one of several successive neighbours would flip all of them.
  const std::vector<Vec2> candidates = Grading(boundary, loops, coarsest).candidates();
  for (std::size_t stride = 512; stride >= 1; stride /= 8)
    for (std::size_t i = 0; i < candidates.size(); i += stride)
      if (stride == 512 || i % (8 * stride) != 0) insert(candidates[i]);
  triangulation->smooth(MeshTuning::kSmoothingPasses);
  const std::vector<Vec2> points = triangulation->points();
  RegionMesh mesh{{points.begin() + static_cast<std::ptrdiff_t>(boundary.size()), points.end()},
                  triangulation->triangles()};
  for (const auto& [a, b, c] : mesh.triangles)
    if (!(triangleArea(points[a], points[b], points[c]) > 0)) return {};
  return mesh;
}

}  // namespace seamwise
