#pragma once
#include <array>
#include <utility>
#include <vector>

#include "base/outcome.h"
#include "drape/pleats.h"
#include "drape/vectors.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Location of a point in the mesh of a piece: in a triangle, or beside it if the outline of a
/// coarser mesh cuts a curve short.
struct MeshPlace {
  int triangle = -1;
  std::array<double, 3> weights{};  ///< barycentric, sum 1
};

/// Pieces of a garment meshed for a cloth and sewn: vertices joined by a seam are one vertex of the
/// cloth.
struct SewnLevel {
  Pattern pattern;  ///< meshed, as drafted
  /// Per piece, per vertex: location in the given pattern.
  std::vector<std::vector<MeshPlace>> places;
  /// Per piece, per outline vertex: vertex of the given pattern, or -1.
  std::vector<std::vector<int>> from;
  std::vector<std::vector<int>> sewn;  ///< per piece, per vertex: index in the cloth
  int size = 0;                        ///< number of vertices of the cloth
  /// Per vertex of the cloth: its mirror image; empty unless the pattern's mirrors cover the cloth.
  std::vector<int> image;
  std::vector<std::vector<Pleat>> pleats;  ///< per piece; empty if no piece has any
};

/// Two meshes of one garment. A change of its shapes leaves both unchanged.
struct SewnLevels {
  SewnLevel coarse, fine;
  std::vector<std::vector<MeshPlace>> places;  ///< per piece, per vertex of `fine`: in `coarse`
};

/// Approximate edge lengths of triangles. [cm]
inline constexpr double kCoarseCloth = 3.0, kFineCloth = 1.5;

/// Meshes a pattern anew on its outline vertices, or on a subset of them, and sews it.
/// @param pattern   meshed pattern of a solve's result
/// @param edge      edge length of the triangles, cm
/// @param pleats    per piece: pleats, along whose lines edges of triangles run; or empty
/// Errors: kMesh, naming the piece.
Outcome<SewnLevel> sewnLevel(const Pattern& pattern, double edge,
                             const std::vector<std::vector<Pleat>>& pleats = {});
Outcome<SewnLevels> sewnLevels(const Pattern& pattern, double coarse = kCoarseCloth,
                               double fine = kFineCloth,
                               const std::vector<std::vector<Pleat>>& pleats = {});

/// Interpolates positions of the coarse mesh to the fine one, linearly in each triangle. Both sides
/// of a seam are averaged.
Positions prolonged(const SewnLevels& levels, const Positions& coarse);

/// Reference state of the sewn cloth: rest lengths of the pieces as cut. SI.
struct SewnMesh {
  struct Triangle {
    std::array<int, 3> vertices;
    double area;                       ///< m2
    std::array<double, 3> weft, warp;  ///< derivatives of the corners' hat functions, 1/m
    int piece;
    /// Flags of a triangle beside the longer side of a gathered seam that runs across or along the
    /// warp.
    bool gathered_weft, gathered_warp;
    int strip = 0;  ///< equal between the same fold lines of a pleated piece; 0 in other pieces
    int layer = 0;  ///< in a closed pleat: layers outwards of the fabric beside pleats
  };
  /// Two triangles at a common edge. |sum of weights x| is the edge's length times its bend (Bergou
  /// et al., "A Quadratic Bending Model for Inextensible Surfaces", 2006), 0 when flat.
  struct Hinge {
    std::array<int, 4> vertices;
    std::array<double, 4> weights;
    double area;                ///< area of both triangles, m2
    double warp;                ///< share of the bend that bends the warp, 0 to 1
    bool across_plane = false;  ///< triangles are images in x = 0; only y, z of the bend count
    double folded = 0;          ///< m, |sum of weights x| at rest on a pressed fold
  };
  int size = 0;
  std::vector<Triangle> triangles;
  std::vector<Hinge> hinges;
  std::vector<double> area;  ///< per vertex: a third of the area of its triangles, m2

  /// Pairs of vertices joined by an edge, and of all interacting vertices. Both lists contain
  /// duplicates.
  std::vector<std::pair<int, int>> edges() const;
  std::vector<std::pair<int, int>> pairs() const;
};

/// Returns the vertices of a level on the pieces as cut. [cm]
/// @param pattern, shapes   pattern from which the level was made, and its pieces as cut, cm
Shapes shapesOf(const SewnLevel& level, const Pattern& pattern, const Shapes& shapes);

/// Builds the reference state of a level. Triangles without area after sewing or cutting are
/// omitted, and edges of more than two triangles do not resist bending.
/// @param shapes   vertices of the level on the pieces as cut, cm
/// @param warp     per piece: unit vector along the grain line
SewnMesh sewnMesh(const SewnLevel& level, const Shapes& shapes, const std::vector<Vec2>& warp);

}  // namespace seamwise
