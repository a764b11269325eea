#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// A constrained Delaunay triangulation that grows point by point (Lawson flips) inside a large
/// frame triangle. Orientation tests are exact, so it stays valid for any simple outline, however
/// thin or collinear. [cm]
class Triangulation {
 public:
  /// Triangulates the loops (outlines counter-clockwise, cut-outs clockwise, indices into
  /// `points`). Empty when the loops touch or cross themselves or each other.
  static std::optional<Triangulation> make(std::vector<Vec2> points,
                                           const std::vector<std::vector<int>>& loops);

  /// Adds an interior vertex. Returns false, without a change, unless p is strictly inside the
  /// loops and not yet a vertex.
  bool insert(const Vec2& p);
  /// Adds vertices along a line, each joined to the one before by an edge that remains; a point may
  /// be a given vertex. Points that are not inside the loops interrupt the line. The vertices never
  /// move. Requires that nothing is inserted yet.
  void addCrease(const std::vector<Vec2>& points);
  /// Moves free vertices to the middle of their neighbours, `passes` times. A move is undone if the
  /// worst quality around the vertex drops below both its old value and a fair one. Restores the
  /// Delaunay property after each pass.
  void smooth(int passes);

  /// The given vertices, then the inserted ones.
  std::vector<Vec2> points() const;
  /// Triangles inside the loops, counter-clockwise.
  std::vector<std::array<int, 3>> triangles() const;

 private:
  static constexpr int kFrame = 3;  ///< vertices 0..2 are the frame
  static constexpr int next(int i) { return i == 2 ? 0 : i + 1; }
  static constexpr int previous(int i) { return i == 0 ? 2 : i - 1; }
  struct Triangle {
    std::array<int, 3> vertex;  // counter-clockwise
    std::array<int, 3> across;  // triangle opposite vertex i, -1: none
    std::array<bool, 3> fixed;  // the edge opposite vertex i belongs to a loop
    bool inside = false;
  };
  struct Spot {
    int triangle = -1;
    int edge = -1;       // edge of the triangle that contains the point, -1: none
    bool taken = false;  // the point is already a vertex
  };

  int side(int a, int b, int c) const;
  int indexIn(int triangle, int vertex) const;
  int indexOfNeighbour(int triangle, int neighbour) const;
  Spot locate(const Vec2& p);
  bool addVertex(int v);
  void link(int triangle, int edge, int neighbour);
  void splitTriangle(int t, int v);
  void splitEdge(int t, int edge, int v);
  bool flippable(int t, int edge) const;
  void flip(int t, int edge);
  void restore();
  bool fixEdge(int a, int b);
  bool fixExisting(int a, int b);
  std::vector<std::pair<int, int>> edgesAcross(int a, int b, bool* blocked) const;
  void fillInside();
  double quality(int a, int b, int c) const;

  std::vector<Vec2> points_;
  std::vector<Triangle> triangles_;
  std::vector<int> triangle_of_;            // a triangle per vertex
  std::vector<std::pair<int, int>> stack_;  // edges (triangle, edge) that may need a flip
  int last_ = 0;                            // start of the next walk
  std::uint32_t state_ = 1;                 // random state for the walk's first edge
  int given_ = 0;                           // number of vertices that do not move, frame included
};

}  // namespace seamwise
