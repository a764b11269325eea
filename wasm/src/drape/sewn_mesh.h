#pragma once
#include <array>
#include <utility>
#include <vector>

#include "base/outcome.h"
#include "drape/vectors.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Where a point lies in the mesh of a piece: in a triangle, or beside it where the outline of a
/// coarser mesh cuts a curve short.
struct MeshPlace {
  int triangle = -1;
  std::array<double, 3> weights{};  ///< of its corners, sum 1
};

/// A garment's pieces meshed for a cloth and sewn: vertices that a seam joins are one.
struct SewnLevel {
  Pattern pattern;                             ///< meshed; as drafted
  std::vector<std::vector<MeshPlace>> places;  ///< per piece, per vertex: in the given pattern
  std::vector<std::vector<int>> from;          ///< per piece, per outline vertex: the given one
  std::vector<std::vector<int>> sewn;          ///< per piece, per vertex: its number in the cloth
  int size = 0;                                ///< of the cloth, vertices
  /// Per vertex of the cloth its image by the pattern's mirrors; empty unless they cover the cloth.
  std::vector<int> image;
};

/// Two meshes of one garment. A shape that changes leaves both as they are.
struct SewnLevels {
  SewnLevel coarse, fine;
  std::vector<std::vector<MeshPlace>> places;  ///< per piece, per vertex of `fine`: in `coarse`
};

/// Lengths of triangles' edges, about. [cm]
inline constexpr double kCoarseCloth = 3.0, kFineCloth = 1.5;

/// Meshes a pattern anew, on the outline vertices that it has, and sews it.
/// @param pattern   meshed, as a solve's result has it
/// Errors: kMesh, naming the piece.
Outcome<SewnLevel> sewnLevel(const Pattern& pattern, double edge);
Outcome<SewnLevels> sewnLevels(const Pattern& pattern, double coarse = kCoarseCloth,
                               double fine = kFineCloth);

/// What a cloth on a coarse mesh becomes on the fine one: linear in each triangle, and the mean
/// where sides of a seam differ.
Positions prolonged(const SewnLevels& levels, const Positions& coarse);

/// What the sewn cloth resists changes of: rest lengths of the pieces as cut. SI.
struct SewnMesh {
  struct Triangle {
    std::array<int, 3> vertices;
    double area;                       ///< m2
    std::array<double, 3> weft, warp;  ///< derivatives of the corners' hat functions, 1/m
    int piece;
    /// Beside the longer side of a gathered seam that runs across, along the warp.
    bool gathered_weft, gathered_warp;
  };
  /// Two triangles at an edge: |sum of weights x| is the edge's length times its bend (Bergou et
  /// al., "A Quadratic Bending Model for Inextensible Surfaces", 2006), 0 when flat.
  struct Hinge {
    std::array<int, 4> vertices;
    std::array<double, 4> weights;
    double area;                ///< of both triangles, m2
    double warp;                ///< how far bending it bends the warp, 0 to 1
    bool across_plane = false;  ///< its triangles are images in x = 0: bends in the plane only
  };
  int size = 0;
  std::vector<Triangle> triangles;
  std::vector<Hinge> hinges;
  std::vector<double> area;  ///< per vertex, a third of its triangles', m2

  /// Pairs of vertices that an edge joins, and all that act on each other; duplicates.
  std::vector<std::pair<int, int>> edges() const;
  std::vector<std::pair<int, int>> pairs() const;
};

/// Where the vertices of a level are on the pieces as cut. [cm]
/// @param pattern, shapes   that the level was made for, and its pieces as cut
Shapes shapesOf(const SewnLevel& level, const Pattern& pattern, const Shapes& shapes);

/// @param shapes   of the level's vertices, cm
/// @param warp     per piece the direction of its grain line, a unit vector
/// Triangles that sewing or cutting leaves no area are left out, and edges of more than two
/// triangles do not resist bending.
SewnMesh sewnMesh(const SewnLevel& level, const Shapes& shapes, const std::vector<Vec2>& warp);

}  // namespace seamwise
