#pragma once
#include <array>
#include <vector>

#include "pattern/pattern.h"

namespace seamwise {

/// An independently deformed region for given seam targets: a piece, the first piece of a mirrored
/// pair, or one half of a piece that is symmetric in itself. Mirror images follow exactly.
struct Part {
  struct Edge {
    int i, j;       ///< local vertices
    double length;  ///< kept length, cm
    bool sewn;
  };
  /// Neighbours h, j of an outline vertex i. On the axis of a half, h is -1 and means the mirror
  /// image of j.
  struct Bend {
    int h, i, j;
    double before, after;  ///< rest lengths h-i and i-j, cm
    bool corner = false;   ///< turns by 30 degrees or more at rest; its angle may change
  };

  int piece = -1;
  bool half = false;
  RigidMotion frame;                          ///< piece -> part; the axis of a half is x = 0
  std::vector<int> vertices;                  ///< local -> piece vertex
  std::vector<int> local;                     ///< piece vertex -> local, -1 in the other half
  std::vector<Vec2> rest;                     ///< part frame; evened out between mirror images
  std::vector<std::array<int, 3>> triangles;  ///< local
  std::vector<Edge> edges;                    ///< edges of outline and holes
  std::vector<Bend> bends;
  std::vector<double> reach;  ///< outline vertex's greatest distance from `rest`, cm; interior: 0
  /// Returns whether a vertex is on the axis, along which alone it may move, in y.
  bool onAxis(int vertex) const { return half && rest[vertex].x() == 0; }
};

/// Relation of a piece's vertices to those of its part.
struct Follower {
  int part = -1;
  std::vector<int> source;      ///< piece vertex -> local vertex of the part
  std::vector<char> reflected;  ///< 1 if the vertex is the mirror image of its source
  PointMap direct, mirror;      ///< part frame -> piece, for plain and for reflected vertices
  Vec2 at(int v, const Vec2& local) const { return reflected[v] ? mirror(local) : direct(local); }
};

struct Parts {
  std::vector<Part> parts;
  std::vector<Follower> pieces;  ///< per piece of the pattern
};

/// Divides the pieces of a pattern into parts.
/// @param max_change   greatest movement of an outline vertex of any piece, cm
Parts splitIntoParts(const Pattern& pattern, double max_change);

}  // namespace seamwise
