#include "drape/drape_check.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/decimal.h"
#include "base/sort_by.h"
#include "drape/space_grid.h"

namespace seamwise {
namespace {

/// Number of triangles from gathers, which stretch the band that holds them.
constexpr int kBesideGathers = 3;

/// Returns per vertex whether it is at most that many triangles from gathers.
std::vector<char> besideGathers(const SewnMesh& mesh) {
  std::vector<char> beside(mesh.size, 0);
  for (int ring = 0; ring <= kBesideGathers; ++ring) {
    const std::vector<char> before = beside;
    for (const SewnMesh::Triangle& t : mesh.triangles) {
      bool reached = t.gathered_weft || t.gathered_warp;
      for (const int v : t.vertices) reached = reached || before[v];
      if (reached)
        for (const int v : t.vertices) beside[v] = 1;
    }
  }
  return beside;
}

DrapeCheck::Spread spreadOf(std::vector<double> values) {
  if (values.empty()) return {};
  sortNumbers(values);
  const std::size_t n = values.size();
  return {values[n / 2], values[std::min(n - 1, n * 99 / 100)], values.back()};
}

/// Six times the volume of the tetrahedron a, b, c, d.
double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  return dot(u,
             Vec3(v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]));
}

bool passes(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  if ((volume(p, a, b, c) > 0) == (volume(q, a, b, c) > 0)) return false;
  const bool side = volume(p, q, a, b) > 0;
  return side == (volume(p, q, b, c) > 0) && side == (volume(p, q, c, a) > 0);
}

}  // namespace

std::vector<ClothCrossing> crossingsOf(const SewnMesh& mesh, const Positions& x) {
  std::vector<std::pair<int, int>> edges = mesh.edges();
  for (auto& [a, b] : edges)
    if (a > b) std::swap(a, b);
  sortOnce(edges);
  std::vector<SpaceBox> of_edges, of_triangles;
  double size = 0;
  for (const auto& [a, b] : edges) {
    of_edges.push_back(boxOf(x[a], x[b]));
    size = std::max(size, length(x[b] - x[a]));
  }
  for (const auto& t : mesh.triangles)
    of_triangles.push_back(boxOf(x[t.vertices[0]], x[t.vertices[1]], x[t.vertices[2]]));
  std::vector<ClothCrossing> crossings;
  forOverlaps(of_edges, of_triangles, size, [&](int edge, int triangle) {
    const auto& [p, q] = edges[edge];
    const auto& [a, b, c] = mesh.triangles[triangle].vertices;
    if (p == a || p == b || p == c || q == a || q == b || q == c) return;
    if (passes(x[p], x[q], x[a], x[b], x[c])) crossings.push_back({{p, q}, triangle});
  });
  return crossings;
}

DrapeCheck checkDrape(const SewnMesh& mesh, const Positions& x, const DistanceField& body) {
  DrapeCheck check;
  std::vector<double> tensions, compressions, worn;
  const std::vector<char> beside = besideGathers(mesh);
  for (const Vec3& at : x) check.depth = std::max(check.depth, -body.distance(at, nullptr));
  for (const SewnMesh::Triangle& t : mesh.triangles) {
    Vec3 weft = Vec3::Zero(), warp = Vec3::Zero(), middle = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
      for (int c = 0; c < 3; ++c) {
        const double at = x[t.vertices[k]][c];
        weft[c] += t.weft[k] * at, warp[c] += t.warp[k] * at, middle[c] += at / 3;
      }
    check.depth = std::max(check.depth, -body.distance(middle, nullptr));
    // Principal stretches: roots of the eigenvalues of [weft warp]^T [weft warp].
    const double a = dot(weft, weft), b = dot(weft, warp), c = dot(warp, warp);
    const double mean = (a + c) / 2, spread = std::sqrt((a - c) * (a - c) / 4 + b * b);
    tensions.push_back(std::max(0.0, std::sqrt(mean + spread) - 1));
    if (!beside[t.vertices[0]] && !beside[t.vertices[1]] && !beside[t.vertices[2]])
      worn.push_back(tensions.back());
    compressions.push_back(std::max(0.0, 1 - std::sqrt(std::max(0.0, mean - spread))));
  }
  check.tension = spreadOf(std::move(tensions));
  check.worn = spreadOf(std::move(worn)).p99;
  check.compression = spreadOf(std::move(compressions));
  check.crossings = static_cast<int>(crossingsOf(mesh, x).size());
  return check;
}

std::optional<Note> doubtAbout(const DrapeCheck& check) {
  if (check.crossings > 0)
    return Note{"drapeCrossings",
                "The fabric passes through itself at " + decimal(check.crossings) +
                    (check.crossings == 1 ? " place." : " places."),
                {},
                {},
                {static_cast<double>(check.crossings)}};
  return std::nullopt;
}

}  // namespace seamwise
