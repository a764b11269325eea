#include "mesh/region.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon.h"
#include "mesh/triangulation.h"
#include "tuning/mesh.h"

namespace seamwise {
namespace {

/// The nearest boundary vertex, or p itself if none is close.
Vec2 snapped(const Vec2& p, const std::vector<Vec2>& boundary) {
  const auto nearest = std::min_element(
      boundary.begin(), boundary.end(),
      [&](const Vec2& a, const Vec2& b) { return (a - p).norm() < (b - p).norm(); });
  return (*nearest - p).norm() < MeshTuning::kCreaseSnap ? *nearest : p;
}

/// Even points along a crease, from end to end.
Polyline pointsOf(const Crease& crease, const std::vector<Vec2>& boundary) {
  const Vec2 a = snapped(crease[0], boundary), b = snapped(crease[1], boundary);
  const int steps =
      std::max(1, static_cast<int>(std::ceil((b - a).norm() / MeshTuning::kCreaseStep)));
  Polyline points;
  for (int k = 0; k < steps; ++k) points.push_back(a + k * (b - a) / steps);
  points.push_back(b);
  return points;
}

}  // namespace

std::optional<RegionMesh> meshRegion(const std::vector<Vec2>& boundary,
                                     const std::vector<std::vector<int>>& loops, double coarsest,
                                     const std::vector<Crease>& creases) {
  auto triangulation = Triangulation::make(boundary, loops);
  if (!triangulation) return {};
  std::vector<Polyline> lines;
  for (const Crease& crease : creases) {
    lines.push_back(pointsOf(crease, boundary));
    triangulation->addCrease(lines.back());
  }
  const auto isClear = [&](const Vec2& p) {
    return std::all_of(lines.begin(), lines.end(), [&](const Polyline& line) {
      return nearestOnPolyline(line, p).distance > MeshTuning::kCreaseClear;
    });
  };
  // Insert a few distant candidates first. All triangles of a round outline have the same
  // circumcircle, and every one of several successive neighbours would flip all of them.
  std::vector<Vec2> candidates = Grading(boundary, loops, coarsest).candidates();
  if (!lines.empty())
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [&](const Vec2& p) { return !isClear(p); }),
                     candidates.end());
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
