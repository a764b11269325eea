#include "pattern/seam_measure.h"

#include <utility>

namespace seamwise {
namespace {

struct VertexRef {
  int piece = -1;
  int vertex = -1;
  bool operator==(const VertexRef&) const = default;
};

/// The mirror image of every vertex, in both directions; piece -1 for a vertex without image.
std::vector<std::vector<VertexRef>> mirrorImages(const Pattern& pattern) {
  std::vector<std::vector<VertexRef>> images;
  for (const Piece& p : pattern.pieces) images.emplace_back(p.rest.size());
  for (const Mirror& m : pattern.mirrors)
    for (std::size_t v = 0; v < m.image.size(); ++v) {
      images[m.pieces[0]][v] = {m.pieces[1], m.image[v]};
      images[m.pieces[1]][m.image[v]] = {m.pieces[0], static_cast<int>(v)};
    }
  return images;
}

}  // namespace

void setLengthRatios(Pattern& pattern) {
  const auto images = mirrorImages(pattern);
  const auto edgeLength = [&](int piece, int u, int v) {
    const auto& rest = pattern.pieces[piece].rest;
    const double own = (rest[v] - rest[u]).norm();
    const VertexRef a = images[piece][u], b = images[piece][v];
    if (a.piece < 0 || b.piece < 0 || a.piece != b.piece) return own;
    const auto& other = pattern.pieces[a.piece].rest;
    return (own + (other[b.vertex] - other[a.vertex]).norm()) / 2;
  };
  const auto sideLength = [&](const SeamSide& side) {
    double sum = 0;
    for (std::size_t i = 1; i < side.vertices.size(); ++i)
      sum += edgeLength(side.piece, side.vertices[i - 1], side.vertices[i]);
    return sum;
  };
  for (Seam& s : pattern.seams) {
    s.length_ratio = sideLength(s.a) / sideLength(s.b);
    s.twin = s.a.vertices.size() == s.b.vertices.size();
    for (std::size_t i = 0; s.twin && i < s.a.vertices.size(); ++i)
      s.twin = images[s.a.piece][s.a.vertices[i]] == VertexRef{s.b.piece, s.b.vertices[i]};
  }
}

}  // namespace seamwise
