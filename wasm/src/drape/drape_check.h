#pragma once
#include <array>
#include <optional>
#include <vector>

#include "drape/distance.h"
#include "drape/fabric.h"
#include "drape/sewn_mesh.h"
#include "pattern/note.h"

namespace seamwise {

/// Quality measures of a draped garment. Seams are closed by construction, because both sides share
/// their vertices.
struct DrapeCheck {
  /// Distribution of a quantity over all triangles.
  struct Spread {
    double median = 0, p99 = 0, most = 0;
  };
  double depth = 0;    ///< m, greatest penetration of a vertex or triangle centre into the body
  Spread tension;      ///< largest principal stretch minus 1, clamped at 0
  double worn = 0;     ///< 99th percentile of the tension further than kBesideGathers from gathers
  Spread compression;  ///< 1 minus the smallest principal stretch, clamped at 0
  int crossings = 0;   ///< pairs of an edge and a triangle that it pierces
};

DrapeCheck checkDrape(const SewnMesh& mesh, const Positions& x, const DistanceField& body);

/// Returns a note for the user about a drape that no real cloth could have.
std::optional<Note> doubtAbout(const DrapeCheck& check);

/// Edge that pierces a triangle without sharing a vertex with it.
struct ClothCrossing {
  std::array<int, 2> edge;  ///< vertices
  int triangle;
};
std::vector<ClothCrossing> crossingsOf(const SewnMesh& mesh, const Positions& x);

}  // namespace seamwise
