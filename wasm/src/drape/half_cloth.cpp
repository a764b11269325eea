#include "drape/half_cloth.h"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.h"
#include "base/sort_by.h"

namespace seamwise {
namespace {

constexpr double kSameCut = 1e-6;    ///< relative, of triangle areas and derivatives
constexpr double kSamePlace = 1e-6;  ///< m

using Corners = std::array<int, 3>;

Corners sorted(Corners corners) {
  for (const int k : {0, 1, 0})
    if (corners[k] > corners[k + 1]) std::swap(corners[k], corners[k + 1]);
  return corners;
}

/// Returns per triangle its mirror image; empty if a triangle has none or more than one.
std::vector<int> imagesOf(const SewnMesh& mesh, const std::vector<int>& image) {
  std::vector<std::pair<Corners, int>> by_corners;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    by_corners.emplace_back(sorted(mesh.triangles[t].vertices), static_cast<int>(t));
  for (const int k : {2, 1, 0})
    sortBy(by_corners, [&](const auto& corners) { return corners.first[k]; });
  std::vector<int> images;
  for (const SewnMesh::Triangle& t : mesh.triangles) {
    const Corners sought =
        sorted({image[t.vertices[0]], image[t.vertices[1]], image[t.vertices[2]]});
    const auto found =
        std::lower_bound(by_corners.begin(), by_corners.end(), std::pair(sought, -1));
    if (found == by_corners.end() || found->first != sought) return {};
    if (found + 1 != by_corners.end() && (found + 1)->first == sought) return {};
    images.push_back(found->second);
  }
  return images;
}

/// Returns whether two triangles have equal areas and mirrored grains. Threads have no direction.
bool cutAlike(const SewnMesh::Triangle& a, const SewnMesh::Triangle& b,
              const std::vector<int>& image) {
  if (std::abs(a.area - b.area) > kSameCut * a.area) return false;
  const double most = kSameCut / std::sqrt(a.area);  // maximum difference of derivatives
  const auto alike = [&](double along) {
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l)
        if (b.vertices[l] == image[a.vertices[k]] &&
            (std::abs(a.warp[k] - along * b.warp[l]) > most ||
             std::abs(a.weft[k] + along * b.weft[l]) > most))
          return false;
    return true;
  };
  return alike(1) || alike(-1);
}

/// Returns per triangle an index shared by all triangles that are connected without crossing the
/// plane.
std::vector<int> sidesOf(const SewnMesh& mesh, const std::vector<int>& image) {
  struct Edge {
    std::array<int, 2> ends;
    int triangle;
  };
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles[t].vertices[k], b = mesh.triangles[t].vertices[(k + 1) % 3];
      if (image[a] == a && image[b] == b) continue;
      edges.push_back({{std::min(a, b), std::max(a, b)}, static_cast<int>(t)});
    }
  sortBy(edges, [&](const Edge& edge) { return double(edge.ends[0]) * mesh.size + edge.ends[1]; });
  DisjointSets sets(static_cast<int>(mesh.triangles.size()));
  for (std::size_t k = 1; k < edges.size(); ++k)
    if (edges[k].ends == edges[k - 1].ends) sets.join(edges[k - 1].triangle, edges[k].triangle);
  std::vector<int> sides;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sides.push_back(sets.find(static_cast<int>(t)));
  return sides;
}

/// Converts a hinge across the plane. Its other triangle is the mirror image of this one, so the
/// opposite corner counts for both, and half of the energy belongs to this half. The sideways
/// components cancel.
SewnMesh::Hinge acrossPlane(SewnMesh::Hinge hinge, int own) {
  hinge.vertices[2] = hinge.vertices[3] = hinge.vertices[own];
  hinge.weights[2] += hinge.weights[3], hinge.weights[3] = 0;
  hinge.area *= 2;
  hinge.across_plane = true;
  return hinge;
}

}  // namespace

Positions HalfCloth::whole(const Positions& half) const {
  Positions all(in_half.size(), Vec3::Zero());
  for (std::size_t i = 0; i < half.size(); ++i) {
    all[image[i]] = mirrored(half[i]);
    all[vertex[i]] = half[i];
  }
  return all;
}

Positions HalfCloth::half(const Positions& whole) const {
  Positions x;
  for (std::size_t i = 0; i < vertex.size(); ++i) {
    x.push_back(whole[vertex[i]]);
    if (inPlane(static_cast<int>(i))) x.back().x() = 0;
  }
  return x;
}

std::optional<HalfCloth> halved(const SewnMesh& mesh, const std::vector<int>& image,
                                const Positions& x) {
  if (image.empty()) return std::nullopt;
  for (int i = 0; i < mesh.size; ++i)
    if (!(length(Vec3(x[image[i]] - mirrored(x[i]))) < kSamePlace)) return std::nullopt;
  const std::vector<int> images = imagesOf(mesh, image);
  if (images.empty()) return std::nullopt;
  const std::vector<int> sides = sidesOf(mesh, image);
  std::vector<double> to_left(sides.size(), 0.0);  // sum of x over the triangles of a side
  for (std::size_t t = 0; t < sides.size(); ++t) {
    if (sides[t] == sides[images[t]]) return std::nullopt;
    if (!cutAlike(mesh.triangles[t], mesh.triangles[images[t]], image)) return std::nullopt;
    for (const int v : mesh.triangles[t].vertices) to_left[sides[t]] += x[v].x();
  }
  HalfCloth out;
  out.in_half.assign(mesh.size, -1);
  std::vector<char> taken;
  for (std::size_t t = 0; t < sides.size(); ++t) {
    const int own = sides[t], other = sides[images[t]];
    taken.push_back(to_left[own] != to_left[other] ? to_left[own] > to_left[other] : own < other);
    if (taken.back())
      for (const int v : mesh.triangles[t].vertices) out.in_half[v] = 0;
  }
  for (int i = 0; i < mesh.size; ++i) {
    if (out.in_half[i] < 0) continue;
    if (image[i] != i && out.in_half[image[i]] >= 0) return std::nullopt;
    out.in_half[i] = static_cast<int>(out.vertex.size());
    out.vertex.push_back(i), out.image.push_back(image[i]);
  }
  out.mesh.size = static_cast<int>(out.vertex.size());
  out.mesh.area.assign(out.mesh.size, 0);
  const auto renumber = [&](auto& item) {
    for (int& v : item.vertices) v = out.in_half[v];
  };
  for (std::size_t t = 0; t < sides.size(); ++t) {
    if (!taken[t]) continue;
    SewnMesh::Triangle triangle = mesh.triangles[t];
    renumber(triangle);
    for (const int v : triangle.vertices) out.mesh.area[v] += triangle.area / 3;
    out.mesh.triangles.push_back(triangle);
  }
  for (SewnMesh::Hinge hinge : mesh.hinges) {
    const auto& [a, b, c, d] = hinge.vertices;
    const bool has_c = out.in_half[c] >= 0, has_d = out.in_half[d] >= 0;
    if (image[c] == d && image[a] == a && image[b] == b)
      hinge = acrossPlane(hinge, has_c ? 2 : 3);
    else if (out.in_half[a] < 0 || out.in_half[b] < 0 || !has_c || !has_d)
      continue;
    renumber(hinge);
    out.mesh.hinges.push_back(hinge);
  }
  return out;
}

}  // namespace seamwise
