#include "drape/sewn_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/sort_by.h"
#include "drape/mesh_places.h"
#include "drape/weld.h"
#include "mesh/coarser.h"
#include "mesh/mesh.h"

namespace seamwise {
namespace {

/// Width of the strip along a seam in which gathers are smaller than triangles. [cm]
constexpr double kGathers = 3;

/// Pattern with outlines and cut-outs only, and the original vertices per piece.
struct Outlines {
  Pattern pattern;
  std::vector<std::vector<int>> vertices;
};

std::size_t boundaryOf(const Piece& piece) {
  std::size_t count = 0;
  for (const std::vector<int>& loop : loopsOf(piece)) count += loop.size();
  return count;
}

/// Panels with fold lines for the mesh.
std::vector<Panel> creased(const std::vector<std::vector<Pleat>>& pleats) {
  std::vector<Panel> panels(pleats.size());
  for (std::size_t p = 0; p < pleats.size(); ++p)
    for (const Pleat& pleat : pleats[p])
      for (const Crease& line : pleat.lines()) panels[p].folds.push_back({line, line});
  return panels;
}

Outlines outlinesOf(Pattern pattern, double longest,
                    const std::vector<std::vector<Pleat>>& pleats) {
  // The ends of edges remain.
  for (std::size_t p = 0; p < pleats.size(); ++p)
    for (const Pleat& pleat : pleats[p])
      for (const Crease& line : pleat.lines())
        for (const Vec2& end : line)
          pattern.pieces[p].edge_start.push_back(nearestOutline(pattern.pieces[p], end));
  auto coarser = coarsened(pattern, longest);
  Outlines outlines{coarser ? coarser->pattern : pattern, {}};
  for (std::size_t p = 0; p < outlines.pattern.pieces.size(); ++p) {
    Piece& piece = outlines.pattern.pieces[p];
    const std::size_t count = boundaryOf(piece);
    piece.rest.resize(count);
    piece.triangles.clear();
    std::vector<int>& from = outlines.vertices.emplace_back(count, -1);
    if (!coarser) {
      for (std::size_t v = 0; v < count; ++v) from[v] = static_cast<int>(v);
      continue;
    }
    const auto& places = coarser->places[p];
    for (std::size_t v = 0; v < places.size(); ++v)
      if (places[v].share == 0) from[places[v].from] = static_cast<int>(v);
  }
  for (Mirror& mirror : outlines.pattern.mirrors)
    mirror.image.resize(outlines.pattern.pieces[mirror.pieces[0]].rest.size());
  return outlines;
}

/// Returns the location of every vertex of `mesh` in the pieces of `in`.
std::vector<std::vector<MeshPlace>> placesIn(const Pattern& in, const Pattern& mesh) {
  std::vector<std::vector<MeshPlace>> places;
  for (std::size_t p = 0; p < mesh.pieces.size(); ++p) {
    const MeshPlaces found(in.pieces[p]);
    std::vector<MeshPlace>& of_piece = places.emplace_back();
    for (const Vec2& at : mesh.pieces[p].rest) of_piece.push_back(found.at(at));
  }
  return places;
}

/// Sets the exact locations of vertices kept from the pattern, whatever the search found.
void keep(const Piece& piece, const std::vector<int>& vertices, std::vector<MeshPlace>& places) {
  std::vector<std::pair<int, int>> corner(piece.rest.size(), {-1, -1});
  for (std::size_t t = 0; t < piece.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) corner[piece.triangles[t][k]] = {static_cast<int>(t), k};
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const auto [triangle, k] = vertices[v] < 0 ? std::pair(-1, -1) : corner[vertices[v]];
    if (triangle < 0) continue;
    places[v] = {triangle, {}};
    places[v].weights[k] = 1;
  }
}

Vec2 at(const MeshPlace& place, const Piece& piece, const std::vector<Vec2>& points) {
  Vec2 sum = Vec2::Zero();
  for (int k = 0; k < 3; ++k) sum += place.weights[k] * points[piece.triangles[place.triangle][k]];
  return sum;
}

}  // namespace

Outcome<SewnLevel> sewnLevel(const Pattern& pattern, double edge,
                             const std::vector<std::vector<Pleat>>& pleats) {
  Outlines outlines = outlinesOf(pattern, edge, pleats);
  const std::vector<Panel> panels = creased(pleats);
  Meshing meshing(std::move(outlines.pattern), edge, panels.empty() ? nullptr : &panels);
  while (meshing.advance()) {
  }
  Outcome<Pattern> mesh = meshing.take();
  if (!mesh.ok()) return mesh.error();
  SewnLevel level;
  level.pleats = pleats;
  level.pattern = std::move(mesh).value();
  level.places = placesIn(pattern, level.pattern);
  for (std::size_t p = 0; p < level.places.size(); ++p)
    keep(pattern.pieces[p], outlines.vertices[p], level.places[p]);
  level.from = std::move(outlines.vertices);
  for (std::size_t p = 0; p < level.from.size(); ++p)
    level.from[p].resize(level.pattern.pieces[p].outline.size());
  Weld weld = welded(level.pattern);
  level.size = static_cast<int>(weld.members.size());
  level.sewn = std::move(weld.knot), level.image = std::move(weld.image);
  return level;
}

Outcome<SewnLevels> sewnLevels(const Pattern& pattern, double coarse, double fine,
                               const std::vector<std::vector<Pleat>>& pleats) {
  Outcome<SewnLevel> larger = sewnLevel(pattern, coarse, pleats),
                     smaller = sewnLevel(pattern, fine, pleats);
  if (!larger.ok()) return larger.error();
  if (!smaller.ok()) return smaller.error();
  SewnLevels levels{std::move(larger).value(), std::move(smaller).value(), {}};
  levels.places = placesIn(levels.coarse.pattern, levels.fine.pattern);
  return levels;
}

Positions prolonged(const SewnLevels& levels, const Positions& coarse) {
  Positions fine(levels.fine.size, Vec3::Zero());
  std::vector<int> count(fine.size(), 0);
  for (std::size_t p = 0; p < levels.places.size(); ++p) {
    for (std::size_t v = 0; v < levels.places[p].size(); ++v) {
      const MeshPlace& place = levels.places[p][v];
      const auto& corners = levels.coarse.pattern.pieces[p].triangles[place.triangle];
      const int i = levels.fine.sewn[p][v];
      for (int k = 0; k < 3; ++k)
        fine[i] += place.weights[k] * coarse[levels.coarse.sewn[p][corners[k]]];
      ++count[i];
    }
  }
  for (std::size_t i = 0; i < fine.size(); ++i) fine[i] /= count[i];
  return fine;
}

Shapes shapesOf(const SewnLevel& level, const Pattern& pattern, const Shapes& shapes) {
  Shapes result;
  for (std::size_t p = 0; p < level.places.size(); ++p) {
    std::vector<Vec2>& points = result.emplace_back();
    for (const MeshPlace& place : level.places[p])
      points.push_back(at(place, pattern.pieces[p], shapes[p]));
  }
  return result;
}

std::vector<std::pair<int, int>> SewnMesh::edges() const {
  std::vector<std::pair<int, int>> all;
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) all.emplace_back(t.vertices[k], t.vertices[(k + 1) % 3]);
  return all;
}

std::vector<std::pair<int, int>> SewnMesh::pairs() const {
  std::vector<std::pair<int, int>> all = edges();
  for (const Hinge& h : hinges) all.emplace_back(h.vertices[2], h.vertices[3]);
  return all;
}

namespace {

/// Bend of a pressed fold: |u + v| of the unit vectors from the fold into both sides, which are 20
/// degrees apart.
constexpr double kPressed = 1.97;

/// Triangle at one side of an edge.
struct EdgeSide {
  int from, to;  ///< cloth vertices, from < to
  int opposite;
  double area;
  double cot_from, cot_to;  ///< cotangents of the triangle's angles at the ends
  double warp;              ///< squared cosine of the angle between the edge's normal and the warp
  double folded;            ///< m, SewnMesh::Hinge::folded
};

/// Returns the side of the edge opposite corner k.
/// @param p   corners in the grain's frame, m
/// @param pressed   the edge is on a pressed fold
EdgeSide sideOf(const SewnMesh::Triangle& t, const std::array<Vec2, 3>& p, int k, bool pressed) {
  int a = (k + 1) % 3, b = (k + 2) % 3;
  if (t.vertices[a] > t.vertices[b]) std::swap(a, b);
  const Vec2 edge = p[b] - p[a], ka = p[k] - p[a], kb = p[k] - p[b];
  const double cot_a = (edge.x() * ka.x() + edge.y() * ka.y()) / (2 * t.area);
  const double cot_b = -(edge.x() * kb.x() + edge.y() * kb.y()) / (2 * t.area);
  const double squared = edge.x() * edge.x() + edge.y() * edge.y();
  return {t.vertices[a],
          t.vertices[b],
          t.vertices[k],
          t.area,
          cot_a,
          cot_b,
          edge.x() * edge.x() / squared,
          pressed ? kPressed * std::sqrt(squared) : 0};
}

SewnMesh::Hinge hingeOf(const EdgeSide& s, const EdgeSide& t) {
  return {{s.from, s.to, s.opposite, t.opposite},
          {s.cot_to + t.cot_to, s.cot_from + t.cot_from, -(s.cot_from + s.cot_to),
           -(t.cot_from + t.cot_to)},
          s.area + t.area,
          (s.warp + t.warp) / 2,
          false,
          std::max(s.folded, t.folded)};
}

bool isOnLine(const Vec2& p, const Crease& line) {
  const Vec2 along = line[1] - line[0], to = p - line[0];
  const double far = planarLength(along);
  const double aside = (along.x() * to.y() - along.y() * to.x()) / far,
               ahead = (along.x() * to.x() + along.y() * to.y()) / far;
  return std::abs(aside) < kOnFoldLine && ahead > -kOnFoldLine && ahead < far + kOnFoldLine;
}

/// Returns whether an edge of a piece is on a pressed fold.
bool isPressed(const std::vector<Pleat>& pleats, const Vec2& a, const Vec2& b) {
  for (const Pleat& pleat : pleats)
    for (const Crease& line : pleat.pressed())
      if (isOnLine(a, line) && isOnLine(b, line)) return true;
  return false;
}

/// Returns whether a seam's side runs along the warp rather than across it.
bool isAlong(const Vec2& warp, const std::vector<Vec2>& rest, const SeamSide& side) {
  double along = 0, across = 0;
  for (std::size_t i = 0; i + 1 < side.vertices.size(); ++i) {
    const Vec2 edge = rest[side.vertices[i + 1]] - rest[side.vertices[i]];
    along += std::abs(warp.x() * edge.x() + warp.y() * edge.y());
    across += std::abs(warp.y() * edge.x() - warp.x() * edge.y());
  }
  return along > across;
}

constexpr char kWeft = 1, kWarp = 2;

/// Returns per piece and vertex the threads that are gathered there, beside the longer side of a
/// gathered seam.
std::vector<std::vector<char>> gatheredVertices(const Pattern& pattern,
                                                const std::vector<Vec2>& warp) {
  std::vector<std::vector<char>> gathered;
  for (const Piece& piece : pattern.pieces) gathered.emplace_back(piece.rest.size(), 0);
  for (const Seam& seam : pattern.seams) {
    if (!isGathered(seam)) continue;
    const SeamSide& side = seam.length_ratio > 1 ? seam.a : seam.b;
    const std::vector<Vec2>& rest = pattern.pieces[side.piece].rest;
    const char threads = isAlong(warp[side.piece], rest, side) ? kWarp : kWeft;
    for (std::size_t v = 0; v < rest.size(); ++v)
      for (const int u : side.vertices)
        if (planarLength(Vec2(rest[v] - rest[u])) < kGathers) gathered[side.piece][v] |= threads;
  }
  return gathered;
}

}  // namespace

SewnMesh sewnMesh(const SewnLevel& level, const Shapes& shapes, const std::vector<Vec2>& warp) {
  SewnMesh mesh;
  mesh.size = level.size;
  mesh.area.assign(level.size, 0);
  std::vector<EdgeSide> sides;
  const std::vector<std::vector<char>> gathered = gatheredVertices(level.pattern, warp);
  int strips = 0;
  for (std::size_t p = 0; p < shapes.size(); ++p) {
    const std::vector<Vec2>& rest = level.pattern.pieces[p].rest;
    const bool pleated = !level.pleats.empty() && !level.pleats[p].empty();
    const Vec2& along = warp[p];
    const Vec2 across(along.y(), -along.x());
    for (const auto& corners : level.pattern.pieces[p].triangles) {
      SewnMesh::Triangle t{};
      t.piece = static_cast<int>(p);
      const int threads =
          gathered[p][corners[0]] | gathered[p][corners[1]] | gathered[p][corners[2]];
      t.gathered_weft = threads & kWeft, t.gathered_warp = threads & kWarp;
      std::array<Vec2, 3> q;  // (weft, warp), m
      for (int k = 0; k < 3; ++k) {
        const Vec2& at = shapes[p][corners[k]];
        t.vertices[k] = level.sewn[p][corners[k]];
        q[k] = kCentimetre * Vec2(across.x() * at.x() + across.y() * at.y(),
                                  along.x() * at.x() + along.y() * at.y());
      }
      t.area = triangleArea(q[0], q[1], q[2]);
      if (t.vertices[0] == t.vertices[1] || t.vertices[1] == t.vertices[2] ||
          t.vertices[2] == t.vertices[0] || !(t.area > 0))
        continue;
      for (int k = 0; k < 3; ++k) {
        const Vec2 gradient = perp(q[(k + 2) % 3] - q[(k + 1) % 3]) / (2 * t.area);
        t.weft[k] = gradient.x(), t.warp[k] = gradient.y();
        mesh.area[t.vertices[k]] += t.area / 3;
        const bool pressed = pleated && isPressed(level.pleats[p], rest[corners[(k + 1) % 3]],
                                                  rest[corners[(k + 2) % 3]]);
        sides.push_back(sideOf(t, q, k, pressed));
      }
      if (pleated) {
        const PleatStrip strip =
            stripAt(level.pleats[p], (rest[corners[0]] + rest[corners[1]] + rest[corners[2]]) / 3);
        t.strip = strips + 1 + strip.index, t.layer = strip.layer;
      }
      mesh.triangles.push_back(t);
    }
    for (const SewnMesh::Triangle& t : mesh.triangles) strips = std::max(strips, t.strip);
  }
  sortBy(sides, [&](const EdgeSide& side) { return double(side.from) * mesh.size + side.to; });
  for (std::size_t k = 0; k < sides.size();) {
    std::size_t end = k + 1;
    while (end < sides.size() && sides[end].from == sides[k].from && sides[end].to == sides[k].to)
      ++end;
    if (end - k == 2 && sides[k].opposite != sides[k + 1].opposite)
      mesh.hinges.push_back(hingeOf(sides[k], sides[k + 1]));
    k = end;
  }
  return mesh;
}

}  // namespace seamwise
