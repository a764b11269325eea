#include "mesh/coarser.h"

#include <algorithm>

#include "base/disjoint_sets.h"
#include "mesh/mesh.h"
#include "pattern/seam_measure.h"
#include "tuning/mesh.h"

namespace seamwise {
namespace {

/// The outlines' vertices; those tied by seams and mirrors form one class.
class Thinning {
 public:
  Thinning(const Pattern& pattern, double longest) : pattern_(pattern), longest_(longest) {
    for (const Piece& piece : pattern.pieces) {
      first_.push_back(static_cast<int>(piece_.size()));
      piece_.resize(piece_.size() + piece.outline.size(), static_cast<int>(first_.size()) - 1);
    }
    const int count = static_cast<int>(piece_.size());
    classes_ = DisjointSets(count);
    next_.resize(count), before_.resize(count);
    fixed_.assign(count, 0), left_out_.assign(count, 0);
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
      const int n = static_cast<int>(pattern.pieces[p].outline.size());
      for (int v = 0; v < n; ++v) {
        next_[first_[p] + v] = first_[p] + (v + 1) % n;
        before_[first_[p] + v] = first_[p] + (v + n - 1) % n;
      }
      for (int v : pattern.pieces[p].edge_start) fixed_[first_[p] + v] = 1;
    }
    for (const Seam& seam : pattern.seams) tie(seam);
    for (const Mirror& mirror : pattern.mirrors) tie(mirror);
    members_.resize(count);
    for (int v = 0; v < count; ++v) {
      members_[classes_.find(v)].push_back(v);
      if (fixed_[v]) fixed_[classes_.find(v)] = 1;
    }
  }

  /// Removes every other vertex where that is allowed. Returns the number of removed vertices.
  int pass() {
    std::vector<char> touched(piece_.size(), 0);
    int count = 0;
    for (std::size_t v = 0; v < piece_.size(); ++v) {
      const std::vector<int>& all = members_[classes_.find(static_cast<int>(v))];
      if (fixed_[classes_.find(static_cast<int>(v))] || left_out_[v] ||
          !std::all_of(all.begin(), all.end(), [&](int m) { return !touched[m] && mayGo(m); }) ||
          areNeighbours(all))
        continue;
      for (int m : all) {
        left_out_[m] = 1, ++count;
        touched[next_[m]] = touched[before_[m]] = 1;
        next_[before_[m]] = next_[m], before_[next_[m]] = before_[m];
      }
    }
    return count;
  }

  bool isLeftOut(int piece, int vertex) const { return left_out_[first_[piece] + vertex] != 0; }

 private:
  void tie(const Seam& seam) {
    const std::size_t last = seam.a.vertices.size() - 1;
    for (std::size_t k = 0; k <= last; ++k) {
      const int a = first_[seam.a.piece] + seam.a.vertices[k];
      const int b = first_[seam.b.piece] + seam.b.vertices[k];
      classes_.join(a, b);
      if (k == 0 || k == last) fixed_[a] = fixed_[b] = 1;
    }
  }
  void tie(const Mirror& mirror) {
    const int n = static_cast<int>(pattern_.pieces[mirror.pieces[0]].outline.size());
    for (int v = 0; v < n; ++v) {
      const int a = first_[mirror.pieces[0]] + v;
      const int b = first_[mirror.pieces[1]] + mirror.image[v];
      classes_.join(a, b);
      if (a == b) fixed_[a] = 1;
    }
  }
  const Vec2& at(int v) const { return pattern_.pieces[piece_[v]].rest[v - first_[piece_[v]]]; }
  double turn(int h, int i, int j) const { return std::abs(turnAt(at(h), at(i), at(j))); }
  /// Returns whether edges stay short enough and bends blunt enough without a vertex.
  bool mayGo(int v) const {
    const int h = before_[v], j = next_[v];
    if (h == next_[j] || (at(j) - at(h)).norm() > longest_) return false;
    return turn(h, v, j) < MeshTuning::kSharp &&
           (fixed_[h] || turn(before_[h], h, j) < MeshTuning::kSharp) &&
           (fixed_[j] || turn(h, j, next_[j]) < MeshTuning::kSharp);
  }
  /// Returns whether two vertices of a class are neighbours or have one neighbour between them.
  bool areNeighbours(const std::vector<int>& all) const {
    for (int a : all)
      for (int b : all)
        if (next_[a] == b || next_[next_[a]] == b) return true;
    return false;
  }

  const Pattern& pattern_;
  double longest_;
  std::vector<int> first_, piece_;  ///< first vertex per piece, piece per vertex
  DisjointSets classes_{0};         ///< classes of vertices that stay or go together
  std::vector<int> next_, before_;  ///< neighbours on the outline among the remaining vertices
  std::vector<char> fixed_, left_out_;
  std::vector<std::vector<int>> members_;  ///< members of the class of a root
};

/// Copies the remaining vertices of a piece; `kept` has their new indices, -1 for removed ones.
Piece thinned(const Piece& fine, const std::vector<int>& kept, int outline) {
  Piece piece;
  piece.name = fine.name;
  piece.mirrored_from_input = fine.mirrored_from_input;
  for (int v = 0; v < outline; ++v) piece.outline.push_back(v);
  for (const std::vector<int>& hole : fine.holes) {
    piece.holes.emplace_back();
    for (int v : hole) piece.holes.back().push_back(kept[v]);
  }
  for (int v : fine.edge_start) piece.edge_start.push_back(kept[v]);
  for (std::size_t v = 0; v < kept.size(); ++v)
    if (kept[v] >= 0) piece.rest.push_back(fine.rest[v]);
  return piece;
}

std::vector<CoarserPattern::Place> placesOf(const Piece& fine, const std::vector<int>& kept) {
  std::vector<CoarserPattern::Place> places(kept.size());
  for (const std::vector<int>& loop : loopsOf(fine)) {
    const std::size_t n = loop.size();
    const auto start = static_cast<std::size_t>(
        std::find_if(loop.begin(), loop.end(), [&](int v) { return kept[v] >= 0; }) - loop.begin());
    for (std::size_t k = 0; k < n;) {
      std::size_t end = k;
      std::vector<double> along{0};
      auto vertex = [&](std::size_t i) { return loop[(start + i) % n]; };
      do {
        ++end;
        along.push_back(along.back() +
                        (fine.rest[vertex(end)] - fine.rest[vertex(end - 1)]).norm());
      } while (kept[vertex(end)] < 0);
      for (std::size_t i = k; i < end; ++i)
        places[vertex(i)] = {kept[vertex(k)], kept[vertex(end)], along[i - k] / along.back()};
      k = end;
    }
  }
  return places;
}

}  // namespace

std::optional<CoarserPattern> coarsened(const Pattern& fine, double longest) {
  Thinning thinning(fine, longest);
  int all = 0, gone = 0;
  for (const Piece& piece : fine.pieces) all += static_cast<int>(piece.outline.size());
  while (const int more = thinning.pass()) gone += more;
  if (all - gone > MeshTuning::kWorthIt * all) return {};

  CoarserPattern result;
  std::vector<std::vector<int>> kept;  // new index per piece and vertex of outline and cut-outs
  for (std::size_t p = 0; p < fine.pieces.size(); ++p) {
    const Piece& piece = fine.pieces[p];
    std::size_t boundary = 0;
    for (const std::vector<int>& loop : loopsOf(piece)) boundary += loop.size();
    kept.emplace_back(boundary, -1);
    int count = 0, outline = 0;
    for (std::size_t v = 0; v < boundary; ++v) {
      if (v < piece.outline.size() && thinning.isLeftOut(static_cast<int>(p), static_cast<int>(v)))
        continue;
      kept[p][v] = count++;
      if (v < piece.outline.size()) outline = count;
    }
    result.pattern.pieces.push_back(thinned(piece, kept[p], outline));
    result.places.push_back(placesOf(piece, kept[p]));
  }
  for (Seam seam : fine.seams) {
    for (SeamSide* side : {&seam.a, &seam.b}) {
      const std::vector<int> vertices = std::move(side->vertices);
      side->vertices.clear();
      for (int v : vertices)
        if (kept[side->piece][v] >= 0) side->vertices.push_back(kept[side->piece][v]);
    }
    result.pattern.seams.push_back(std::move(seam));
  }
  for (const Mirror& mirror : fine.mirrors) {
    result.pattern.mirrors.push_back({{mirror.pieces[0], mirror.pieces[1]}, mirror.map, {}});
    const std::vector<int>&from = kept[mirror.pieces[0]], &to = kept[mirror.pieces[1]];
    for (std::size_t v = 0; v < from.size(); ++v)
      if (from[v] >= 0) result.pattern.mirrors.back().image.push_back(to[mirror.image[v]]);
  }
  setLengthRatios(result.pattern);
  Outcome<Pattern> mesh = meshed(std::move(result.pattern));
  if (!mesh.ok()) return {};
  result.pattern = std::move(mesh).value();
  return result;
}

}  // namespace seamwise
