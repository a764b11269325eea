#pragma once
#include <vector>

#include "symmetry/seam_maps.h"

namespace seamwise {

/// detectSymmetries() in steps. The garment outlives it.
class SymmetryDetection {
 public:
  explicit SymmetryDetection(const Garment& garment) : maps_(garment) {}

  /// A few milliseconds of work. False when there is none left.
  bool advance() { return maps_.advance(); }
  double fraction() const { return maps_.fraction(); }  ///< 0..1
  /// Once it has ended.
  std::vector<BodySymmetry> found() const;

 private:
  SeamMaps maps_;
};

/// Of several maps, the index (into SeamMaps::maps()) of the one that carries most seams to seams,
/// then agrees best with the 3D placement; -1 when there are none.
int likeliestMap(const SeamMaps& maps, const std::vector<int>& candidates);

/// The symmetry that a map describes, its residual measured on the exact curves where possible.
BodySymmetry bodySymmetry(const Garment& garment, int from, int to,
                          const MirrorRegistration& registration);

}  // namespace seamwise
