// Forces the loops' edges into the triangulation and finds the triangles inside the loops.

#include "mesh/triangulation.h"

namespace seamwise {

bool Triangulation::fixExisting(int a, int b) {
  const int start = triangle_of_[a];
  int t = start;
  do {
    const int i = indexIn(t, a);
    if (triangles_[t].vertex[next(i)] == b) {
      const int e = previous(i), u = triangles_[t].across[e];
      triangles_[t].fixed[e] = true;
      if (u >= 0) triangles_[u].fixed[indexOfNeighbour(u, t)] = true;
      return true;
    }
    t = triangles_[t].across[next(i)];
  } while (t != start);
  return false;
}

std::vector<std::pair<int, int>> Triangulation::edgesAcross(int a, int b, bool* blocked) const {
  std::vector<std::pair<int, int>> crossed;
  *blocked = true;
  const int start = triangle_of_[a];
  int t = start;
  do {
    const int i = indexIn(t, a);
    const int p = triangles_[t].vertex[next(i)], q = triangles_[t].vertex[previous(i)];
    const int right = side(a, b, p), left = side(a, b, q);
    if (right < 0 && left > 0) {
      // The segment leaves a through p q; follow it to b.
      int r = p, l = q;
      while (true) {
        if (triangles_[t].fixed[3 - indexIn(t, r) - indexIn(t, l)]) return crossed;
        crossed.emplace_back(r, l);
        t = triangles_[t].across[3 - indexIn(t, r) - indexIn(t, l)];
        const int far = triangles_[t].vertex[3 - indexIn(t, r) - indexIn(t, l)];
        if (far == b) break;
        const int s = side(a, b, far);
        if (s == 0) return crossed;
        (s > 0 ? l : r) = far;
      }
      *blocked = false;
      return crossed;
    }
    t = triangles_[t].across[next(i)];
  } while (t != start);
  return crossed;
}

bool Triangulation::fixEdge(int a, int b) {
  if (fixExisting(a, b)) return true;
  // Flip the edges that cross a b [Sloan 1993].
  bool blocked = false;
  std::vector<std::pair<int, int>> open = edgesAcross(a, b, &blocked);
  if (blocked) return false;
  // Some crossing edge can always be flipped; the bound is far above the necessary number of steps.
  const std::size_t most = 1000 + 4 * open.size() * open.size();
  for (std::size_t step = 0; step < open.size(); ++step) {
    if (step > most) return false;
    auto [p, q] = open[step];
    if (p < kFrame) std::swap(p, q);  // the triangles around a corner of the frame do not close
    int t = triangle_of_[p];
    while (triangles_[t].vertex[next(indexIn(t, p))] != q)
      t = triangles_[t].across[next(indexIn(t, p))];
    const int e = previous(indexIn(t, p));
    if (!flippable(t, e)) {
      open.emplace_back(p, q);
      continue;
    }
    const int far = triangles_[t].vertex[e];
    flip(t, e);
    const int near = triangles_[t].vertex[2];
    const bool ends = far == a || far == b || near == a || near == b;
    if (!ends && side(a, b, far) * side(a, b, near) < 0) open.emplace_back(far, near);
  }
  return fixExisting(a, b);
}

void Triangulation::fillInside() {
  std::vector<int> open;
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    if (triangles_[t].inside) open.push_back(static_cast<int>(t));
  while (!open.empty()) {
    const Triangle t = triangles_[open.back()];
    open.pop_back();
    for (int e = 0; e < 3; ++e) {
      if (t.fixed[e] || t.across[e] < 0 || triangles_[t.across[e]].inside) continue;
      triangles_[t.across[e]].inside = true;
      open.push_back(t.across[e]);
    }
  }
}

}  // namespace seamwise
