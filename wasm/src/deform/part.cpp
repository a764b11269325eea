#include "deform/part.h"

#include <algorithm>
#include <cmath>

#include "deform/clearance.h"
#include "deform/shape_limits.h"
#include "mesh/lengths.h"
#include "tuning/shaping.h"

namespace seamwise {
namespace {

constexpr double kLeastReach = 1e-5;  ///< cm

/// Part frame in which the axis of the reflection `map` is x = 0.
RigidMotion axisFrame(const RigidMotion& map) {
  const double axis = (map.angle - kPi) / 2;
  RigidMotion frame{kPi / 2 - axis, Vec2::Zero(), false};
  frame.shift = -(frame.linear() * (map.shift / 2));
  return frame;
}

/// Adds edges and bends. A half omits those beyond its axis, which are images.
void addOutline(Part& part, const Piece& piece, const std::vector<double>& kept,
                const std::vector<char>& sewn) {
  const int outer = static_cast<int>(piece.outline.size());
  for (const std::vector<int>& loop : loopsOf(piece)) {
    const int n = static_cast<int>(loop.size());
    for (int k = 0; k < n; ++k) {
      const int u = loop[(k + n - 1) % n], v = loop[k], w = loop[(k + 1) % n];
      const int h = part.local[u], i = part.local[v], j = part.local[w];
      if (i >= 0 && j >= 0) {
        const bool rim = v < outer;
        const double length = rim ? kept[v] : (piece.rest[w] - piece.rest[v]).norm();
        part.edges.push_back({i, j, length, rim && sewn[v]});
      }
      if (i < 0) continue;
      const bool corner = std::abs(turnAt(piece.rest[u], piece.rest[v], piece.rest[w])) >= kSmooth;
      const double before = (piece.rest[v] - piece.rest[u]).norm();
      const double after = (piece.rest[w] - piece.rest[v]).norm();
      if (h >= 0 && j >= 0)
        part.bends.push_back({h, i, j, before, after, corner});
      else if (j >= 0)
        part.bends.push_back({-1, i, j, after, after, corner});
      else if (h >= 0)
        part.bends.push_back({-1, i, h, before, before, corner});
    }
  }
}

/// Adds the triangles with all vertices in the part.
void addTriangles(Part& part, const Piece& piece) {
  for (const auto& t : piece.triangles) {
    const std::array<int, 3> l{part.local[t[0]], part.local[t[1]], part.local[t[2]]};
    if (l[0] >= 0 && l[1] >= 0 && l[2] >= 0) part.triangles.push_back(l);
  }
}

}  // namespace

Parts splitIntoParts(const Pattern& pattern, double max_change) {
  Parts result;
  const std::size_t count = pattern.pieces.size();
  result.pieces.resize(count);
  const auto kept = keptLengths(pattern);
  std::vector<std::vector<char>> sewn = sewnEdges(pattern);
  // An edge whose mirror image is sewn must keep its length, too.
  for (const Mirror& m : pattern.mirrors) {
    const int n = static_cast<int>(sewn[m.pieces[0]].size());
    for (int v = 0; v < n; ++v) {
      const int image = m.image[(v + 1) % n];  // images run in the opposite direction
      char &here = sewn[m.pieces[0]][v], &there = sewn[m.pieces[1]][image];
      here = there = here || there;
    }
  }
  std::vector<const Mirror*> leads(count, nullptr), follows(count, nullptr);
  for (const Mirror& m : pattern.mirrors) {
    leads[m.pieces[0]] = &m;
    if (!m.single()) follows[m.pieces[1]] = &m;
  }

  for (std::size_t p = 0; p < count; ++p) {
    if (follows[p]) continue;
    const Piece& piece = pattern.pieces[p];
    const Mirror* mirror = leads[p];
    const int n = static_cast<int>(piece.rest.size());
    Part part;
    part.piece = static_cast<int>(p);
    part.half = mirror && mirror->single();
    if (part.half) part.frame = axisFrame(mirror->map);
    const PointMap frame(part.frame);
    const PointMap unmirror(mirror ? mirror->map.inverse() : RigidMotion{});
    Follower self;
    self.part = static_cast<int>(result.parts.size());
    self.source.assign(n, -1), self.reflected.assign(n, 0);
    part.local.assign(n, -1);

    // Rest positions, evened out between mirror images so that the problem is exactly symmetric.
    std::vector<Vec2> rest(n);
    for (int v = 0; v < n; ++v) {
      rest[v] = frame(piece.rest[v]);
      if (!mirror) continue;
      const Vec2& image = pattern.pieces[mirror->pieces[1]].rest[mirror->image[v]];
      rest[v] = (rest[v] + frame(unmirror(image))) / 2;
      if (part.half && mirror->image[v] == v) rest[v].x() = 0;
    }
    for (int v = 0; v < n; ++v) {
      if (part.half && mirror->image[v] != v && rest[v].x() < 0) continue;
      part.local[v] = self.source[v] = static_cast<int>(part.vertices.size());
      part.vertices.push_back(v);
      part.rest.push_back(rest[v]);
    }
    const RigidMotion direct = part.frame.inverse();
    self.direct = PointMap(direct);
    self.mirror = mirror ? PointMap(mirror->map.after(direct)) : self.direct;
    if (part.half) {
      for (int v = 0; v < n; ++v) {
        if (self.source[v] >= 0) continue;
        self.source[v] = part.local[mirror->image[v]];
        self.reflected[v] = 1;
      }
    }
    addOutline(part, piece, kept[p], sewn[p]);
    addTriangles(part, piece);
    result.pieces[p] = self;

    // The true rest may be up to the mirror tolerance away from the evened one. Two sides of a gap
    // must not meet.
    const std::vector<double> clear =
        outsideClearance(piece, 2 * max_change / ShapingTuning::kGapShare);
    part.reach.assign(part.vertices.size(), 0);
    std::vector<char> rim(n, 0);
    for (const auto& loop : loopsOf(piece))
      for (int v : loop) rim[v] = 1;
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
      const int v = part.vertices[i];
      if (!rim[v]) continue;
      double off = (frame(piece.rest[v]) - part.rest[i]).norm();
      if (mirror) {
        const Vec2& image = pattern.pieces[mirror->pieces[1]].rest[mirror->image[v]];
        off = std::max(off, (frame(unmirror(image)) - part.rest[i]).norm());
      }
      const double gap =
          v < static_cast<int>(clear.size()) ? ShapingTuning::kGapShare * clear[v] : max_change;
      part.reach[i] = std::max(kLeastReach, std::min(max_change - off, gap));
    }
    if (mirror && !mirror->single()) {
      Follower twin;
      twin.part = self.part;
      twin.source.assign(n, -1), twin.reflected.assign(n, 1);
      for (int v = 0; v < n; ++v) twin.source[mirror->image[v]] = v;
      twin.direct = self.direct;
      twin.mirror = self.mirror;
      result.pieces[mirror->pieces[1]] = twin;
    }
    result.parts.push_back(std::move(part));
  }
  return result;
}

}  // namespace seamwise
