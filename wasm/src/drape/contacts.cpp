#include "drape/contacts.h"

#include <algorithm>
#include <cmath>

#include "base/sort_by.h"
#include "drape/space_grid.h"

namespace seamwise {
namespace {

constexpr double kSeen = 0.008;     ///< m, range in which positions decide a vertex's side
constexpr double kLaid = 0.016;     ///< m, range in which layers decide it
constexpr double kParallel = 0.7;   ///< minimum cosine between the normals of parallel layers
constexpr double kStiffness = 5e5;  ///< N/m3, repulsion between layers
/// The same inside pleats, on which a tight waist presses. [N/m3]
constexpr double kPleatStiffness = 4e6;
/// Depth beyond which layers of a pleat no longer separate, and their minimum cosine. [m, 1]
constexpr double kPleatDepth = 0.004, kPleatParallel = 0.5;
constexpr double kTieStiffness = 400;  ///< N/m, of a tie
constexpr double kBeside = 0.05;       ///< tolerated negative weight of a foot beside the triangle
constexpr double kCell = 0.02;         ///< m, cell size of the search grid
constexpr double kPerItem = 1500, kPerPair = 150;  ///< multiplications in the time of a search

void insertOnce(std::vector<int>& ascending, int item) {
  const auto at = std::lower_bound(ascending.begin(), ascending.end(), item);
  if (at == ascending.end() || *at != item) ascending.insert(at, item);
}

}  // namespace

void sortOverlaps(std::vector<Overlap>& overlaps) {
  for (int Overlap::*const piece : {&Overlap::lower, &Overlap::upper})
    sortBy(overlaps, [&](const Overlap& overlap) { return overlap.*piece; });
}

ClothContacts::ClothContacts(const SewnMesh& mesh, std::vector<Overlap> overlaps,
                             std::vector<ClothTie> ties, std::vector<signed char> laps,
                             const Positions& laid, double gap)
    : mesh_(&mesh),
      overlaps_(std::move(overlaps)),
      pieces_(mesh.size),
      ties_(std::move(ties)),
      laps_(std::move(laps)),
      gap_(gap),
      ring_(mesh.size),
      strips_(mesh.size) {
  sortOverlaps(overlaps_);
  for (const SewnMesh::Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      strips_[t.vertices[k]].add(t);
      insertOnce(pieces_[t.vertices[k]], t.piece);
      insertOnce(ring_[t.vertices[k]], t.vertices[(k + 1) % 3]);
      insertOnce(ring_[t.vertices[k]], t.vertices[(k + 2) % 3]);
    }
  pleated_ = std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                         [](const SewnMesh::Triangle& t) { return t.strip > 0; });
  if (!laid.empty()) lay(laid);
}

/// Calls meet(vertex, triangle, vector from the triangle to the vertex) for each pair within `near`
/// metres.
template <class Meet>
void ClothContacts::forNear(const Positions& x, double near, const Meet& meet) const {
  std::vector<SpaceBox> points, boxes;
  for (const Vec3& p : x)
    points.push_back({p - Vec3(near, near, near), p + Vec3(near, near, near)});
  for (const SewnMesh::Triangle& t : mesh_->triangles)
    boxes.push_back(boxOf(x[t.vertices[0]], x[t.vertices[1]], x[t.vertices[2]]));
  forOverlaps(points, boxes, kCell, [&](int vertex, int triangle) {
    const ClothPoint foot = footOf(x[vertex], mesh_->triangles[triangle].vertices, x);
    for (const double w : foot.weights)
      if (w < -0.5) return;
    const Vec3 off = x[vertex] - foot.at(x);
    if (dot(off, off) <= near * near) meet(vertex, triangle, off);
  });
}

/// Records layers: cloth that is parallel and at least a gap apart. Other cloth nearby, such as at
/// armholes, is not parallel.
void ClothContacts::lay(const Positions& x) {
  std::vector<Vec3> normals(x.size(), Vec3::Zero());
  for (const SewnMesh::Triangle& t : mesh_->triangles)
    for (const int v : t.vertices) normals[v] += normalOf(t.vertices, x);
  forNear(x, kLaid, [&](int vertex, int triangle, const Vec3& off) {
    const auto& corners = mesh_->triangles[triangle].vertices;
    const Vec3 normal = normalOf(corners, x);
    const double apart = dot(normal, off);
    if (neighbours(vertex, corners) || std::abs(apart) < gap_ ||
        dot(normal, normals[vertex]) < kParallel * length(normals[vertex]))
      return;
    laid_.push_back({vertex, triangle, apart < 0 ? -1.0 : 1.0});
  });
}

void ClothContacts::setTouching(bool on) {
  touching_ = on, looks_ = 0;
  pairs_.clear(), touches_.clear(), pulls_.clear(), crossed_.clear();
}

bool ClothContacts::neighbours(int vertex, const std::array<int, 3>& triangle) const {
  const std::vector<int>& ring = ring_[vertex];
  for (const int v : triangle)
    if (v == vertex || std::binary_search(ring.begin(), ring.end(), v)) return true;
  return false;
}

/// Returns 0 outside buttoned overlaps.
double ClothContacts::sideByLaps(int vertex, int triangle) const {
  if (laps_.empty()) return 0;
  for (const int v : mesh_->triangles[triangle].vertices)
    if (laps_[v] != -laps_[vertex]) return 0;
  return laps_[vertex];
}

/// Returns 0 for pieces without a known overlap.
double ClothContacts::sideByOverlaps(int vertex, int triangle) const {
  const int other = mesh_->triangles[triangle].piece;
  for (const int piece : pieces_[vertex]) {
    if (std::binary_search(overlaps_.begin(), overlaps_.end(), Overlap{piece, other})) return 1;
    if (std::binary_search(overlaps_.begin(), overlaps_.end(), Overlap{other, piece})) return -1;
  }
  return 0;
}

/// Returns the side of a recorded pair of the vertex with this triangle or with one that shares a
/// corner, or 0.
double ClothContacts::sideAmong(const std::vector<Pair>& pairs, const SewnMesh& mesh, int vertex,
                                int triangle) {
  const auto& corners = mesh.triangles[triangle].vertices;
  auto pair = std::lower_bound(pairs.begin(), pairs.end(), Pair{vertex, 0, 0});
  double beside = 0;
  for (; pair != pairs.end() && pair->vertex == vertex; ++pair) {
    if (pair->triangle == triangle) return pair->side;
    // Both sides of a fold share corners.
    if (mesh.triangles[pair->triangle].strip != mesh.triangles[triangle].strip) continue;
    const auto& other = mesh.triangles[pair->triangle].vertices;
    for (const int v : corners)
      if (v == other[0] || v == other[1] || v == other[2]) beside = pair->side;
  }
  return beside;
}

void ClothContacts::Strips::add(const SewnMesh::Triangle& t) {
  if (t.strip == 0 || t.strip == low || t.strip == high) return;
  more = more || low != high;
  layers = high == 0 ? 2 * t.layer : layers / 2 + t.layer;
  if (std::abs(layers) == 1) layers = 0;  // the visible edge of the fabric beside the pleat
  low = high == 0 ? t.strip : std::min(low, t.strip);
  high = std::max(high, t.strip);
}

/// Updates the normals of vertices if the cloth has pleats.
void ClothContacts::findNormals(const Positions& x) {
  if (!pleated_) return;
  looked_ = &x;
  normals_.assign(x.size(), Vec3::Zero());
  for (const SewnMesh::Triangle& t : mesh_->triangles) {
    const Vec3 normal = normalOf(t.vertices, x);
    for (const int v : t.vertices) normals_[v] += t.area * normal;
  }
}

/// Returns the side of a triangle on which a vertex belongs by the layers of pleats, or 0. Fabric
/// of odd layers is turned over, so the other fabric gives the direction outwards.
double ClothContacts::sideInPleats(int vertex, int triangle) const {
  const SewnMesh::Triangle& t = mesh_->triangles[triangle];
  const Strips& own = strips_[vertex];
  if (own.more || own.low == t.strip || own.high == t.strip || own.layers == 2 * t.layer) return 0;
  const double above = own.layers > 2 * t.layer ? 1 : -1;
  if (t.layer % 2 == 0) return above;
  if (own.layers % 4 != 0) return 0;
  const double along = dot(normalOf(t.vertices, *looked_), normals_[vertex]);
  if (std::abs(along) < kParallel * length(normals_[vertex])) return 0;
  return along < 0 ? -above : above;
}

/// Returns whether layers of a pleat still lie on each other: they are parallel, and the vertex is
/// on its side or nearly so. Otherwise the fabric has moved away and come back elsewhere.
bool ClothContacts::holdsInPleat(const Pair& pair, const Vec3& normal, const Vec3& off) const {
  const Vec3& own = normals_[pair.vertex];
  return pair.side * dot(normal, off) > -kPleatDepth &&
         std::abs(dot(normal, own)) > kPleatParallel * length(own);
}

/// Layers slide on each other by about one edge length, so the search includes neighbours of the
/// vertex.
double ClothContacts::sideAsLaid(int vertex, int triangle) const {
  double side = sideAmong(laid_, *mesh_, vertex, triangle);
  for (std::size_t k = 0; side == 0 && k < ring_[vertex].size(); ++k)
    side = sideAmong(laid_, *mesh_, ring_[vertex][k], triangle);
  return side;
}

/// Returns 0 for cloth that is not layered and for neighbours, which meet in sharp folds such as
/// under the arms.
double ClothContacts::sideByLayers(int vertex, int triangle) const {
  if (strips_[vertex].high > 0 && mesh_->triangles[triangle].strip > 0)
    return sideInPleats(vertex, triangle);
  if (neighbours(vertex, mesh_->triangles[triangle].vertices)) return 0;
  double side = sideByOverlaps(vertex, triangle);
  if (side == 0) side = sideByLaps(vertex, triangle);
  return side == 0 ? sideAsLaid(vertex, triangle) : side;
}

/// Returns the side of an earlier pair, or else the current side of the vertex.
double ClothContacts::sideBySight(int vertex, int triangle, const Positions& x) const {
  const auto& corners = mesh_->triangles[triangle].vertices;
  const double earlier = sideAmong(pairs_, *mesh_, vertex, triangle);
  if (earlier != 0) return earlier;
  return dot(normalOf(corners, x), x[vertex] - x[corners[0]]) < 0 ? -1 : 1;
}

void ClothContacts::search(const Positions& x) {
  std::vector<Pair> found;
  search_cost_ += kPerItem * static_cast<double>(x.size() + mesh_->triangles.size());
  forNear(x, hasLayers() ? kLaid : kSeen, [&](int vertex, int triangle, const Vec3& off) {
    search_cost_ += kPerPair;
    const auto& corners = mesh_->triangles[triangle].vertices;
    if (std::find(corners.begin(), corners.end(), vertex) != corners.end()) return;
    Pair pair{vertex, triangle, sideByLayers(vertex, triangle)};
    pair.seen = pair.side == 0;
    pair.in_pleat = !pair.seen && strips_[vertex].high > 0 && mesh_->triangles[triangle].strip > 0;
    if (pair.seen && (dot(off, off) > kSeen * kSeen || isCrossed(pair))) return;
    if (pair.seen) pair.side = sideBySight(vertex, triangle, x);
    found.push_back(pair);
  });
  pairs_ = std::move(found);
}

bool ClothContacts::isOf(int piece, int vertex) const {
  return std::binary_search(pieces_[vertex].begin(), pieces_[vertex].end(), piece);
}

/// Updates the forces that separate crossings, and the crossed vertices. Layered pieces are
/// excluded, because their sides are known. Overlapping ends of a collar band are separated
/// nevertheless.
void ClothContacts::findCrossed(const Positions& x) {
  pulls_ = untangling_->pulls(x);
  const auto in_layers = [&](const CrossingPull& pull) {
    const auto& [edge, triangle] = pull.crossing;
    const int piece = mesh_->triangles[triangle].piece;
    if (mesh_->triangles[triangle].strip == 0 && isOf(piece, edge[0]) && isOf(piece, edge[1]))
      return false;
    return sideByLayers(edge[0], triangle) != 0 || sideByLayers(edge[1], triangle) != 0;
  };
  pulls_.erase(std::remove_if(pulls_.begin(), pulls_.end(), in_layers), pulls_.end());
  search_cost_ += kPerItem * static_cast<double>(x.size() + mesh_->triangles.size());
  crossed_.assign(pulls_.empty() ? 0 : x.size(), 0);
  for (const CrossingPull& pull : pulls_)
    for (const ClothPoint* point : {&pull.on_edge, &pull.on_triangle})
      for (const int v : point->vertices) {
        crossed_[v] = 1;
        for (const int beside : ring_[v]) crossed_[beside] = 1;
      }
}

/// Returns whether the side of a pair is undefined because of a crossing.
bool ClothContacts::isCrossed(const Pair& pair) const {
  if (!pair.seen || crossed_.empty()) return false;
  for (const int v : mesh_->triangles[pair.triangle].vertices)
    if (crossed_[v]) return true;
  return crossed_[pair.vertex];
}

void ClothContacts::look(const Positions& x) {
  search_cost_ = 0;
  findNormals(x);
  if (touching_ && untangling_) findCrossed(x);
  if (touching_ && looks_++ % (pleated_ ? 1 : kSearchEach) == 0) search(x);
  touches_.clear();
  for (const Pair& pair : pairs_) {
    const auto& corners = mesh_->triangles[pair.triangle].vertices;
    if (isCrossed(pair)) continue;
    const ClothPoint foot = footOf(x[pair.vertex], corners, x);
    if (*std::min_element(foot.weights.begin(), foot.weights.end()) < -kBeside) continue;
    const Vec3 normal = normalOf(corners, x);
    if (pair.in_pleat && !holdsInPleat(pair, normal, x[pair.vertex] - foot.at(x))) continue;
    const double area =
        std::min(mesh_->area[pair.vertex], mesh_->triangles[pair.triangle].area / 2);
    touches_.push_back({pair.vertex, foot, pair.side * normal,
                        (pair.in_pleat ? kPleatStiffness : kStiffness) * area});
  }
  tied_.clear();
  for (const ClothTie& tie : ties_)
    tied_.push_back({tie.gap * normalOf(tie.a.vertices, x), kTieStiffness});
}

double ClothContacts::excess(const Touch& touch, const Positions& x) const {
  return gap_ - dot(touch.normal, x[touch.vertex] - touch.point.at(x));
}

double ClothContacts::energy(const Positions& x, Positions* gradient) const {
  double energy = 0;
  for (const Touch& touch : touches_) {
    const double depth = excess(touch, x);
    if (!(depth > 0)) continue;
    energy += touch.stiffness * depth * depth / 2;
    if (!gradient) continue;
    const Vec3 force = touch.stiffness * depth * touch.normal;
    for (int c = 0; c < 3; ++c) (*gradient)[touch.vertex][c] -= force[c];
    touch.point.addTo(*gradient, force);
  }
  for (const CrossingPull& pull : pulls_) {
    energy -= dot(pull.force, pull.on_edge.at(x) - pull.on_triangle.at(x));
    if (!gradient) continue;
    pull.on_edge.addTo(*gradient, -pull.force);
    pull.on_triangle.addTo(*gradient, pull.force);
  }
  for (std::size_t k = 0; k < tied_.size(); ++k) {
    const Vec3 apart = ties_[k].b.at(x) - ties_[k].a.at(x) - tied_[k].offset;
    energy += tied_[k].stiffness * dot(apart, apart) / 2;
    if (!gradient) continue;
    ties_[k].b.addTo(*gradient, tied_[k].stiffness * apart);
    ties_[k].a.addTo(*gradient, -tied_[k].stiffness * apart);
  }
  return energy;
}

void ClothContacts::addProduct(const Positions& x, const Positions& p, Positions& y) const {
  for (const Touch& touch : touches_) {
    if (!(excess(touch, x) > 0)) continue;
    const Vec3 force =
        touch.stiffness * dot(touch.normal, p[touch.vertex] - touch.point.at(p)) * touch.normal;
    for (int c = 0; c < 3; ++c) y[touch.vertex][c] += force[c];
    touch.point.addTo(y, -force);
  }
  for (std::size_t k = 0; k < tied_.size(); ++k) {
    const Vec3 force = tied_[k].stiffness * (ties_[k].b.at(p) - ties_[k].a.at(p));
    ties_[k].b.addTo(y, force);
    ties_[k].a.addTo(y, -force);
  }
}

}  // namespace seamwise
