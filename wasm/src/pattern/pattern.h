#pragma once
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "geometry/rigid_motion.h"

namespace seamwise {

/// A piece in the solver: the sampled outline and, once meshed, its triangles. [cm]
struct Piece {
  std::string name;
  std::vector<Vec2> rest;               ///< outline vertices, then hole vertices, then interior
  std::vector<int> outline;             ///< counter-clockwise; vertices 0 .. n-1 in order
  std::vector<std::vector<int>> holes;  ///< clockwise
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise
  std::vector<int> edge_start;  ///< outline position at which edge k of the panel starts
  bool mirrored_from_input = false;
};

/// The outline position k of the edge between neighbouring outline vertices u and v, in either
/// order: it joins outline[k] and outline[k + 1]. Outline vertices are 0 .. n-1 in order.
inline int outlineEdge(const Piece& piece, int u, int v) {
  return (u + 1) % static_cast<int>(piece.outline.size()) == v ? u : v;
}

/// The outline and the cut-outs.
inline std::vector<std::vector<int>> loopsOf(const Piece& piece) {
  std::vector<std::vector<int>> loops{piece.outline};
  loops.insert(loops.end(), piece.holes.begin(), piece.holes.end());
  return loops;
}

/// Vertices along one edge of a piece, in sewing order of the seam.
struct SeamSide {
  int piece = -1;
  std::vector<int> vertices;
};

/// Vertex i of side a is sewn to vertex i of side b.
struct Seam {
  SeamSide a, b;
  double weight = 1.0;
  bool matched = true;        ///< false: sewn, but its mismatch does not count
  double length_ratio = 1.0;  ///< rho: rest length of a / rest length of b
  bool twin = false;      ///< joins a piece to its own mirror image along corresponding points: any
                          ///< symmetric alignment matches it, so it never counts
  double visibility = 0;  ///< as of its stitch
};

/// True if the sides differ too much in length for the print to match along all of the seam at any
/// alignment: at the limit they run apart by 3 cm over 30 cm, a large part of most repeats.
inline bool isGathered(const Seam& seam) {
  return seam.length_ratio > 1.1 || seam.length_ratio < 1 / 1.1;
}

/// A symmetry imposed on the pattern.
struct Mirror {
  int pieces[2] = {-1, -1};  ///< equal for a piece symmetric in itself
  RigidMotion map;           ///< point of pieces[0] -> point of pieces[1]; map.mirrored is true
  std::vector<int>
      image;  ///< vertex of pieces[0] -> vertex of pieces[1], every vertex (interior too)
  bool single() const { return pieces[0] == pieces[1]; }
};

/// A garment sampled and, once meshed, ready to solve.
struct Pattern {
  std::vector<Piece> pieces;
  std::vector<Seam> seams;  ///< one per stitch, in the order of the file
  std::vector<Mirror> mirrors;
};

/// Calls use(piece, k, other) for each sewn edge. The edge starts at outline position k of `piece`
/// and is sewn to an edge of `other`, which may be the same piece.
template <class Use>
void forSewnEdges(const Pattern& pattern, const Use& use) {
  for (const Seam& seam : pattern.seams)
    for (const auto& [side, other] : {std::pair(&seam.a, &seam.b), {&seam.b, &seam.a}})
      for (std::size_t i = 0; i + 1 < side->vertices.size(); ++i)
        use(side->piece,
            outlineEdge(pattern.pieces[side->piece], side->vertices[i], side->vertices[i + 1]),
            other->piece);
}

/// Per piece and outline position k: true if the edge that starts there is sewn.
inline std::vector<std::vector<char>> sewnEdges(const Pattern& pattern) {
  std::vector<std::vector<char>> sewn;
  for (const Piece& piece : pattern.pieces) sewn.emplace_back(piece.outline.size(), 0);
  forSewnEdges(pattern, [&](int piece, int k, int) { sewn[piece][k] = 1; });
  return sewn;
}

/// Vertex positions per piece and vertex, cm.
using Shapes = std::vector<std::vector<Vec2>>;

inline Shapes restShapes(const Pattern& pattern) {
  Shapes rest;
  for (const Piece& piece : pattern.pieces) rest.push_back(piece.rest);
  return rest;
}

}  // namespace seamwise
