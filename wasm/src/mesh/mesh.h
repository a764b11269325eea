#pragma once
#include <optional>
#include <vector>

#include "base/outcome.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"
#include "tuning/mesh.h"

namespace seamwise {

/// Fills every piece with triangles. The outline stays as sampled; interior vertices form a graded
/// hexagonal pattern (about the outline's spacing at the outline, up to `coarsest` cm inside). A
/// piece with an imposed single mirror is meshed by halves: the second half is the image of the
/// first, so no triangle crosses the axis. The second piece of a pair has the image of the first
/// one's mesh. Extends Mirror::image to every vertex. Errors: kMesh, naming the piece.
Outcome<Pattern> meshed(Pattern pattern, double coarsest = MeshTuning::kCoarsest);

/// Runs meshed() in steps of one piece or pair each.
class Meshing {
 public:
  /// @param panels   of the pieces, for edges along the lines of their pleats; may be null
  explicit Meshing(Pattern pattern, double coarsest = MeshTuning::kCoarsest,
                   const std::vector<Panel>* panels = nullptr);

  /// Fills one piece, or the two of a pair. Returns false once all are filled or one cannot be.
  bool advance();
  double fraction() const;  ///< share of filled pieces, 0..1
  /// Returns the meshed pattern or the error, after advance() has returned false.
  Outcome<Pattern> take();

 private:
  std::optional<Error> fillMirrored(Mirror& mirror);
  std::optional<Error> fill(int piece);
  /// Lines of the pleats of a piece.
  std::vector<Crease> creasesOf(int piece) const;

  Pattern pattern_;
  double coarsest_;
  const std::vector<Panel>* panels_;
  std::vector<char> done_;                ///< per piece
  std::size_t mirrors_ = 0, pieces_ = 0;  ///< numbers of mirrors and pieces already visited
  bool moved_ = false;                    ///< an outline has changed
  std::optional<Error> error_;
};

}  // namespace seamwise
