#pragma once
#include <optional>
#include <vector>

#include "base/outcome.h"
#include "pattern/pattern.h"
#include "tuning/mesh.h"

namespace seamwise {

/// Fills every piece with triangles: the outline is kept as sampled, interior vertices on a graded
/// hexagonal pattern (about the outline's spacing at the outline, up to `coarsest` cm inside).
/// A piece with an imposed single mirror is meshed by halves: one half is triangulated, the other
/// is its image, so no triangle crosses the axis; the second piece of a pair carries the image of
/// the first one's mesh. Extends Mirror::image to every vertex. Errors: kMesh, naming the piece.
Outcome<Pattern> meshed(Pattern pattern, double coarsest = MeshTuning::kCoarsest);

/// meshed() in steps, of one piece or pair each.
class Meshing {
 public:
  explicit Meshing(Pattern pattern, double coarsest = MeshTuning::kCoarsest);

  /// Fills one piece, or the two of a pair. False when all are filled, or one cannot be.
  bool advance();
  double fraction() const;  ///< of the pieces, 0..1
  /// Once it has ended.
  Outcome<Pattern> take();

 private:
  std::optional<Error> fillMirrored(Mirror& mirror);
  std::optional<Error> fill(int piece);

  Pattern pattern_;
  double coarsest_;
  std::vector<char> done_;                ///< per piece
  std::size_t mirrors_ = 0, pieces_ = 0;  ///< that have been looked at
  bool moved_ = false;                    ///< some outline
  std::optional<Error> error_;
};

}  // namespace seamwise
