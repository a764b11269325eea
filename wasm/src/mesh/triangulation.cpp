#include "mesh/triangulation.h"

#include <algorithm>

#include "geometry/predicates.h"
#include "tuning/mesh.h"

namespace seamwise {
int Triangulation::side(int a, int b, int c) const {
  return orientation(points_[a], points_[b], points_[c]);
}

int Triangulation::indexIn(int triangle, int vertex) const {
  const auto& v = triangles_[triangle].vertex;
  return v[0] == vertex ? 0 : v[1] == vertex ? 1 : 2;
}

int Triangulation::indexOfNeighbour(int triangle, int neighbour) const {
  const auto& n = triangles_[triangle].across;
  return n[0] == neighbour ? 0 : n[1] == neighbour ? 1 : 2;
}

std::optional<Triangulation> Triangulation::make(std::vector<Vec2> points,
                                                 const std::vector<std::vector<int>>& loops) {
  if (points.empty()) return {};
  Vec2 low = points.front(), high = low;
  for (const Vec2& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec2 middle = (low + high) / 2;
  const double reach = 20 * std::max((high - low).norm(), 1e-3);
  Triangulation t;
  t.points_ = {middle + reach * Vec2(-1, -0.6), middle + reach * Vec2(1, -0.6),
               middle + reach * Vec2(0, 1.2)};
  t.points_.insert(t.points_.end(), points.begin(), points.end());
  t.given_ = static_cast<int>(t.points_.size());
  t.triangle_of_.assign(t.points_.size(), 0);
  t.triangles_.push_back({{0, 1, 2}, {-1, -1, -1}, {false, false, false}, false});
  // Insert vertices at halving strides. Consecutive vertices are neighbours, so walks are short,
  // yet no vertex meets a fan of all its predecessors.
  const int count = t.given_ - kFrame;
  int stride = 1;
  while (stride < count) stride *= 2;
  if (!t.addVertex(kFrame)) return {};
  for (; stride >= 1; stride /= 2)
    for (int i = stride; i < count; i += 2 * stride)
      if (!t.addVertex(kFrame + i)) return {};
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (!t.fixEdge(loop[i] + kFrame, loop[(i + 1) % loop.size()] + kFrame)) return {};
  for (int k = 0; k < static_cast<int>(t.triangles_.size()); ++k)
    for (int e = 0; e < 3; ++e) t.stack_.emplace_back(k, e);
  t.restore();
  // The loops' left side is inside.
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int a = loop[i] + kFrame, b = loop[(i + 1) % loop.size()] + kFrame;
      int at = t.triangle_of_[a];
      while (t.triangles_[at].vertex[next(t.indexIn(at, a))] != b)
        at = t.triangles_[at].across[next(t.indexIn(at, a))];
      t.triangles_[at].inside = true;
    }
  }
  t.fillInside();
  return t;
}

Triangulation::Spot Triangulation::locate(const Vec2& p) {
  // Walk towards p. A triangulation that is not quite Delaunay could lead it in circles; a changing
  // first edge breaks them.
  int t = last_;
  for (;;) {
    state_ = state_ * 1664525u + 1013904223u;
    int e = static_cast<int>((state_ >> 16) % 3), on = -1, zeros = 0;
    bool moved = false;
    for (int k = 0; k < 3; ++k, e = next(e)) {
      const auto& v = triangles_[t].vertex;
      const int s = orientation(points_[v[next(e)]], points_[v[previous(e)]], p);
      if (s < 0 && triangles_[t].across[e] >= 0) {
        t = triangles_[t].across[e];
        moved = true;
        break;
      }
      if (s == 0) {
        on = e;
        ++zeros;
      }
    }
    if (moved) continue;
    last_ = t;
    return {t, on, zeros > 1};
  }
}

void Triangulation::link(int triangle, int edge, int neighbour) {
  triangles_[triangle].across[edge] = neighbour;
}

void Triangulation::splitTriangle(int t, int v) {
  const Triangle old = triangles_[t];
  const int t1 = static_cast<int>(triangles_.size()), t2 = t1 + 1;
  const auto& [a, b, c] = old.vertex;
  const auto& n = old.across;
  const auto& f = old.fixed;
  triangles_[t] = {{v, b, c}, {n[0], t1, t2}, {f[0], false, false}, old.inside};
  triangles_.push_back({{v, c, a}, {n[1], t2, t}, {f[1], false, false}, old.inside});
  triangles_.push_back({{v, a, b}, {n[2], t, t1}, {f[2], false, false}, old.inside});
  if (n[1] >= 0) link(n[1], indexOfNeighbour(n[1], t), t1);
  if (n[2] >= 0) link(n[2], indexOfNeighbour(n[2], t), t2);
  triangle_of_[v] = triangle_of_[b] = triangle_of_[c] = t;
  triangle_of_[a] = t1;
  for (const int k : {t, t1, t2}) stack_.emplace_back(k, 0);
}

void Triangulation::splitEdge(int t, int edge, int v) {
  // The edge is b c of triangle a b c and of its neighbour d c b.
  const Triangle old = triangles_[t];
  const int u = old.across[edge];
  const int back = indexOfNeighbour(u, t);
  const Triangle other = triangles_[u];
  const int a = old.vertex[edge], b = old.vertex[next(edge)], c = old.vertex[previous(edge)];
  const int d = other.vertex[back];
  const int t1 = static_cast<int>(triangles_.size()), u1 = t1 + 1;
  const bool fixed = old.fixed[edge];
  const int nca = old.across[next(edge)], nab = old.across[previous(edge)];
  const int nbd = other.across[next(back)], ndc = other.across[previous(back)];
  const bool fca = old.fixed[next(edge)], fab = old.fixed[previous(edge)];
  const bool fbd = other.fixed[next(back)], fdc = other.fixed[previous(back)];
  triangles_[t] = {{v, a, b}, {nab, u1, t1}, {fab, fixed, false}, old.inside};
  triangles_.push_back({{v, c, a}, {nca, t, u}, {fca, false, fixed}, old.inside});
  triangles_[u] = {{v, d, c}, {ndc, t1, u1}, {fdc, fixed, false}, other.inside};
  triangles_.push_back({{v, b, d}, {nbd, u, t}, {fbd, false, fixed}, other.inside});
  if (nca >= 0) link(nca, indexOfNeighbour(nca, t), t1);
  if (nbd >= 0) link(nbd, indexOfNeighbour(nbd, u), u1);
  triangle_of_[v] = triangle_of_[a] = triangle_of_[b] = t;
  triangle_of_[c] = triangle_of_[d] = u;
  for (const int k : {t, t1, u, u1}) stack_.emplace_back(k, 0);
}

bool Triangulation::flippable(int t, int edge) const {
  const Triangle& tri = triangles_[t];
  if (tri.across[edge] < 0 || tri.fixed[edge]) return false;
  const int u = tri.across[edge];
  const int a = tri.vertex[edge], b = tri.vertex[next(edge)], c = tri.vertex[previous(edge)];
  const int d = triangles_[u].vertex[indexOfNeighbour(u, t)];
  return side(a, b, d) > 0 && side(a, d, c) > 0;
}

void Triangulation::flip(int t, int edge) {
  // a b c + d c b  ->  a b d + a d c
  const int u = triangles_[t].across[edge];
  const int back = indexOfNeighbour(u, t);
  const Triangle x = triangles_[t], y = triangles_[u];
  const int a = x.vertex[edge], b = x.vertex[next(edge)], c = x.vertex[previous(edge)];
  const int d = y.vertex[back];
  const int nca = x.across[next(edge)], nab = x.across[previous(edge)];
  const int nbd = y.across[next(back)], ndc = y.across[previous(back)];
  const bool fca = x.fixed[next(edge)], fab = x.fixed[previous(edge)];
  const bool fbd = y.fixed[next(back)], fdc = y.fixed[previous(back)];
  triangles_[t] = {{a, b, d}, {nbd, u, nab}, {fbd, false, fab}, x.inside};
  triangles_[u] = {{a, d, c}, {ndc, nca, t}, {fdc, fca, false}, x.inside};
  if (nbd >= 0) link(nbd, indexOfNeighbour(nbd, u), t);
  if (nca >= 0) link(nca, indexOfNeighbour(nca, t), u);
  triangle_of_[a] = triangle_of_[b] = triangle_of_[d] = t;
  triangle_of_[c] = u;
}

void Triangulation::restore() {
  while (!stack_.empty()) {
    const auto [t, e] = stack_.back();
    stack_.pop_back();
    const Triangle& tri = triangles_[t];
    const int u = tri.across[e];
    if (u < 0 || tri.fixed[e]) continue;
    const int d = triangles_[u].vertex[indexOfNeighbour(u, t)];
    if (!insideCircle(points_[tri.vertex[0]], points_[tri.vertex[1]], points_[tri.vertex[2]],
                      points_[d]) ||
        !flippable(t, e))
      continue;
    flip(t, e);  // t = a b d, u = a d c: the four outer edges may need a flip now
    stack_.emplace_back(t, 0);
    stack_.emplace_back(t, 2);
    stack_.emplace_back(u, 0);
    stack_.emplace_back(u, 1);
  }
}

bool Triangulation::addVertex(int v) {
  const Spot spot = locate(points_[v]);
  if (spot.taken) return false;
  if (spot.edge >= 0)
    splitEdge(spot.triangle, spot.edge, v);
  else
    splitTriangle(spot.triangle, v);
  restore();
  return true;
}

bool Triangulation::insert(const Vec2& p) {
  const Spot spot = locate(p);
  const Triangle& t = triangles_[spot.triangle];
  if (!t.inside || spot.taken || (spot.edge >= 0 && t.fixed[spot.edge])) return false;
  const int v = static_cast<int>(points_.size());
  points_.push_back(p);
  triangle_of_.push_back(-1);
  if (spot.edge >= 0)
    splitEdge(spot.triangle, spot.edge, v);
  else
    splitTriangle(spot.triangle, v);
  restore();
  return true;
}

void Triangulation::addCrease(const std::vector<Vec2>& points) {
  int before = -1;
  for (const Vec2& p : points) {
    int vertex = -1;
    const Spot spot = locate(p);
    if (spot.taken) {
      for (const int v : triangles_[spot.triangle].vertex)
        if (points_[v] == p) vertex = v;
    } else if (insert(p)) {
      vertex = static_cast<int>(points_.size()) - 1;
    }
    if (before >= 0 && vertex >= 0) fixEdge(before, vertex);
    before = vertex;
  }
  given_ = static_cast<int>(points_.size());
  for (int k = 0; k < static_cast<int>(triangles_.size()); ++k)
    for (int e = 0; e < 3; ++e) stack_.emplace_back(k, e);
  restore();
}

double Triangulation::quality(int a, int b, int c) const {
  const Vec2 u = points_[b] - points_[a], v = points_[c] - points_[b], w = points_[a] - points_[c];
  return 2 * std::sqrt(3.0) * cross(u, v) / (u.squaredNorm() + v.squaredNorm() + w.squaredNorm());
}

void Triangulation::smooth(int passes) {
  std::vector<std::pair<int, int>> ring;  // the edges opposite a vertex
  for (int pass = 0; pass < passes; ++pass) {
    for (int v = given_; v < static_cast<int>(points_.size()); ++v) {
      ring.clear();
      const int start = triangle_of_[v];
      int t = start;
      Vec2 sum = Vec2::Zero();
      do {
        const int i = indexIn(t, v);
        ring.emplace_back(triangles_[t].vertex[next(i)], triangles_[t].vertex[previous(i)]);
        sum += points_[ring.back().first];
        t = triangles_[t].across[next(i)];
      } while (t != start);
      const auto worst = [&] {
        double least = 1;
        for (const auto& [p, q] : ring) least = std::min(least, quality(v, p, q));
        return least;
      };
      const Vec2 before = points_[v];
      const double limit = std::min(worst(), MeshTuning::kFairQuality);
      points_[v] = sum / static_cast<double>(ring.size());
      if (!(worst() >= limit)) points_[v] = before;
    }
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t)
      if (triangles_[t].inside)
        for (int e = 0; e < 3; ++e) stack_.emplace_back(t, e);
    restore();
  }
}

std::vector<Vec2> Triangulation::points() const {
  return {points_.begin() + kFrame, points_.end()};
}

std::vector<std::array<int, 3>> Triangulation::triangles() const {
  std::vector<std::array<int, 3>> found;
  for (const Triangle& t : triangles_)
    if (t.inside)
      found.push_back({t.vertex[0] - kFrame, t.vertex[1] - kFrame, t.vertex[2] - kFrame});
  return found;
}

}  // namespace seamwise
