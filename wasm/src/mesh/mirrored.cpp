#include "mesh/mirrored.h"

#include <algorithm>

#include "base/in_quotes.h"
#include "base/sort_by.h"
#include "mesh/region.h"
#include "tuning/mesh.h"

namespace seamwise {
namespace {

using Ring = std::vector<int>;

/// Outline and hole vertices of pieces[0], each averaged with its image mapped back.
std::vector<Vec2> meanBoundary(const Pattern& pattern, const Mirror& mirror) {
  const auto &a = pattern.pieces[mirror.pieces[0]].rest, &b = pattern.pieces[mirror.pieces[1]].rest;
  const RigidMotion back = mirror.map.inverse();
  std::vector<Vec2> mean(mirror.image.size());
  for (std::size_t v = 0; v < mean.size(); ++v) mean[v] = (a[v] + back(b[mirror.image[v]])) / 2;
  return mean;
}

/// One half of a piece that is symmetric in itself, cut along the axis.
struct Half {
  std::vector<Vec2> points;
  std::vector<int> vertex;  ///< piece's vertex per point; new ones on the axis count from the
                            ///< number of boundary vertices
  std::vector<Ring> loops;  ///< indices into points
  std::vector<Vec2> axis;   ///< the new vertices on the axis
};

class HalfBuilder {
 public:
  HalfBuilder(const Piece& piece, const Mirror& mirror, const std::vector<Vec2>& mean,
              double coarsest)
      : piece_(piece),
        image_(mirror.image),
        mean_(mean),
        grading_(mean, loopsOf(piece), coarsest),
        at_(mean.size(), -1) {}

  std::optional<Half> build() {
    const std::vector<int> fixed = fixedOf(piece_.outline);
    if (fixed.size() != 2) return {};
    const Ring rim = path(piece_.outline, fixed[0], fixed[1]);
    start_ = mean_[rim.back()];
    along_ = mean_[rim.front()] - start_;  // the axis, with this half on its left
    half_.loops.emplace_back();
    for (const int v : rim) half_.loops[0].push_back(pointOf(v));

    // Cut-outs on the axis interrupt it; others belong to this half if they are on its side.
    std::vector<Ring> bites;
    std::vector<const Ring*> whole;
    for (const Ring& hole : piece_.holes) {
      const std::vector<int> ends = fixedOf(hole);
      if (ends.empty()) {
        if (sideOf(hole) > 0) whole.push_back(&hole);
        continue;
      }
      if (ends.size() != 2) return {};
      const Ring one = path(hole, ends[0], ends[1]), other = path(hole, ends[1], ends[0]);
      bites.push_back(sideOf(one) > sideOf(other) ? one : other);
    }
    sortBy(bites, [&](const Ring& bite) { return along_.dot(mean_[bite.front()]); });
    int from = rim.back();
    for (const Ring& bite : bites) {
      follow(from, bite.front());
      for (const int v : bite) half_.loops[0].push_back(pointOf(v));
      from = bite.back();
    }
    follow(from, rim.front());
    for (const Ring* hole : whole) {
      half_.loops.emplace_back();
      for (const int v : *hole) half_.loops.back().push_back(pointOf(v));
    }
    return half_;
  }

 private:
  /// Positions in a ring of the vertices that are their own image.
  std::vector<int> fixedOf(const Ring& ring) const {
    std::vector<int> found;
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (image_[ring[i]] == ring[i]) found.push_back(static_cast<int>(i));
    return found;
  }

  static Ring path(const Ring& ring, int from, int to) {
    Ring found;
    const int n = static_cast<int>(ring.size());
    for (int i = from;; i = (i + 1) % n) {
      found.push_back(ring[i]);
      if (i == to) return found;
    }
  }

  double sideOf(const Ring& ring) const {
    double sum = 0;
    for (const int v : ring) sum += cross(along_, mean_[v] - start_);
    return sum;
  }

  int pointOf(int vertex) {
    if (at_[vertex] < 0) {
      at_[vertex] = static_cast<int>(half_.points.size());
      half_.points.push_back(mean_[vertex]);
      half_.vertex.push_back(vertex);
    }
    return at_[vertex];
  }

  /// Adds the stretch of the axis between two boundary vertices.
  void follow(int from, int to) {
    for (const Vec2& p : grading_.spaced(mean_[from], mean_[to])) {
      half_.loops[0].push_back(static_cast<int>(half_.points.size()));
      half_.vertex.push_back(static_cast<int>(mean_.size() + half_.axis.size()));
      half_.points.push_back(p);
      half_.axis.push_back(p);
    }
  }

  const Piece& piece_;
  const std::vector<int>& image_;
  const std::vector<Vec2>& mean_;
  const Grading grading_;
  std::vector<int> at_;  // point in the half, per vertex of the piece
  Vec2 start_ = Vec2::Zero(), along_ = Vec2::Zero();
  Half half_;
};

/// The mesh of pieces[0] in the mean shape. Its construction also extends mirror.image.
struct MeanMesh {
  std::vector<Vec2> points;  // positions of all vertices of pieces[0]
  std::vector<std::array<int, 3>> triangles;
};

std::optional<MeanMesh> meshHalves(const Piece& piece, Mirror& mirror, std::vector<Vec2> mean,
                                   double coarsest, const std::vector<Crease>& creases) {
  const auto half = HalfBuilder(piece, mirror, mean, coarsest).build();
  if (!half) return {};
  const auto mesh = meshRegion(half->points, half->loops, coarsest, creases);
  if (!mesh) return {};
  MeanMesh full{std::move(mean), {}};
  std::vector<int> vertex = half->vertex;  // piece's vertex per vertex of the half mesh
  for (const Vec2& p : half->axis) {
    mirror.image.push_back(static_cast<int>(full.points.size()));
    full.points.push_back(p);
  }
  const int first = static_cast<int>(full.points.size());
  const int count = static_cast<int>(mesh->interior.size());
  for (int i = 0; i < count; ++i) {
    vertex.push_back(first + i);
    mirror.image.push_back(first + count + i);
  }
  for (int i = 0; i < count; ++i) mirror.image.push_back(first + i);
  full.points.insert(full.points.end(), mesh->interior.begin(), mesh->interior.end());
  for (const Vec2& p : mesh->interior) full.points.push_back(mirror.map(p));
  for (const auto& [a, b, c] : mesh->triangles)
    full.triangles.push_back({vertex[a], vertex[b], vertex[c]});
  for (const auto& [a, b, c] : mesh->triangles)
    full.triangles.push_back(
        {mirror.image[vertex[a]], mirror.image[vertex[c]], mirror.image[vertex[b]]});
  return full;
}

std::optional<MeanMesh> meshPair(const Piece& piece, Mirror& mirror, std::vector<Vec2> mean,
                                 double coarsest, const std::vector<Crease>& creases) {
  auto mesh = meshRegion(mean, loopsOf(piece), coarsest, creases);
  if (!mesh) return {};
  MeanMesh full{std::move(mean), std::move(mesh->triangles)};
  for (const Vec2& p : mesh->interior) {
    mirror.image.push_back(static_cast<int>(full.points.size()));
    full.points.push_back(p);
  }
  return full;
}

}  // namespace

Outcome<bool> meshMirrored(Pattern& pattern, Mirror& mirror, double coarsest,
                           const std::vector<Crease>& creases) {
  Piece &a = pattern.pieces[mirror.pieces[0]], &b = pattern.pieces[mirror.pieces[1]];
  std::vector<Vec2> mean = meanBoundary(pattern, mirror);
  const std::size_t boundary = mean.size();
  const auto mesh = mirror.single() ? meshHalves(a, mirror, std::move(mean), coarsest, creases)
                                    : meshPair(a, mirror, std::move(mean), coarsest, creases);
  if (!mesh)
    return Error{Failure::kMesh,
                 "piece " + inQuotes(a.name) +
                     " cannot be meshed as the mirror image it is asked to be: where its two sides "
                     "are averaged the outline crosses itself; leave out that symmetry",
                 mirror.pieces[0]};
  a.triangles = mesh->triangles;
  a.rest.insert(a.rest.end(), mesh->points.begin() + static_cast<std::ptrdiff_t>(boundary),
                mesh->points.end());
  if (!mirror.single()) {
    for (std::size_t v = boundary; v < mesh->points.size(); ++v)
      b.rest.push_back(mirror.map(mesh->points[v]));
    b.triangles.clear();
    for (const auto& [i, j, k] : mesh->triangles)
      b.triangles.push_back({mirror.image[i], mirror.image[k], mirror.image[j]});
  }

  // The mean shape has no inverted triangle, so moving outline vertices there one by one must
  // succeed.
  std::vector<char> moved(boundary, 0);
  bool any_moved = false;
  for (bool again = true; again;) {
    again = false;
    for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
      const double least = MeshTuning::kLeastArea * triangleArea(mesh->points, mesh->triangles[t]);
      if (triangleArea(a.rest, a.triangles[t]) >= least &&
          triangleArea(b.rest, b.triangles[t]) >= least)
        continue;
      for (const int v : mesh->triangles[t]) {
        if (v >= static_cast<int>(boundary) || moved[v]) continue;
        a.rest[v] = mesh->points[v];
        b.rest[mirror.image[v]] = mirror.map(mesh->points[v]);
        moved[v] = 1;
        if (mirror.single()) moved[mirror.image[v]] = 1;
        again = any_moved = true;
      }
    }
  }
  return any_moved;
}

}  // namespace seamwise
