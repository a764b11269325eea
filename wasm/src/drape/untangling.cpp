#include "drape/untangling.h"

#include <algorithm>
#include <cmath>

#include "base/sort_by.h"

namespace seamwise {
namespace {

/// Stiffness, N/m3. The force equals that on a layer that is too close by 0.4 of an edge.
constexpr double kPull = 2e5;
constexpr double kFlattest = 0.2;  ///< minimum absolute cosine between edge and normal
constexpr double kSlight = 0.5;    ///< slope at which the pull has 1 / sqrt(2) of its full force

}  // namespace

Untangling::Untangling(const SewnMesh& mesh) : mesh_(&mesh) {
  for (const SewnMesh::Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = t.vertices[(k + 1) % 3], b = t.vertices[(k + 2) % 3];
      wings_.push_back({std::min(a, b), std::max(a, b), t.vertices[k]});
    }
  sortBy(wings_, [&](const Wing& wing) { return double(wing.from) * mesh.size + wing.to; });
}

/// Returns the direction in which to move an edge against a triangle of the given normal, so that
/// the line along which the edge's triangles cross it gets shorter. The length of the result is the
/// shortening per distance moved.
Vec3 Untangling::shortening(int from, int to, const Vec3& normal, const Positions& x) const {
  const Vec3 edge = x[to] - x[from], along = edge / length(edge);
  double steep = dot(along, normal);
  if (std::abs(steep) < kFlattest) steep = steep < 0 ? -kFlattest : kFlattest;
  Vec3 sum = Vec3::Zero();
  auto wing = std::lower_bound(wings_.begin(), wings_.end(), Wing{from, to, 0});
  for (; wing != wings_.end() && wing->from == from && wing->to == to; ++wing) {
    const Vec3 aside = x[wing->opposite] - x[from];
    const Vec3 line = crossProduct(crossProduct(edge, aside), normal);
    const double far = length(line);
    if (!(far > 0)) continue;
    const double side = dot(line, aside) < dot(line, along) * dot(aside, along) ? -1 : 1;
    const Vec3 inwards = (side / far) * line;
    sum += inwards - (2 * dot(along, inwards) / steep) * normal;
  }
  return sum;
}

std::vector<CrossingPull> Untangling::pulls(const Positions& x) const {
  std::vector<CrossingPull> pulls;
  for (const ClothCrossing& crossing : crossingsOf(*mesh_, x)) {
    const auto [from, to] = crossing.edge;
    const auto& corners = mesh_->triangles[crossing.triangle].vertices;
    const Vec3 normal = normalOf(corners, x), edge = x[to] - x[from];
    const double share =
        std::clamp(dot(normal, x[corners[0]] - x[from]) / dot(normal, edge), 0.0, 1.0);
    const Vec3 slope = shortening(from, to, normal, x);
    const double area = (mesh_->area[from] + mesh_->area[to]) / 2;
    const double force =
        kPull * area * length(edge) / std::sqrt(dot(slope, slope) + kSlight * kSlight);
    pulls.push_back({{{from, to, to}, {1 - share, share, 0}},
                     footOf(x[from] + share * edge, corners, x),
                     force * slope,
                     crossing});
  }
  return pulls;
}

}  // namespace seamwise
