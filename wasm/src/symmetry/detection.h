#pragma once
#include <vector>

#include "symmetry/seam_maps.h"

namespace seamwise {

/// Runs detectSymmetries() in steps. The garment must outlive this object.
class SymmetryDetection {
 public:
  explicit SymmetryDetection(const Garment& garment) : maps_(garment) {}

  /// Works for a few milliseconds. Returns false when finished.
  bool advance() { return maps_.advance(); }
  double fraction() const { return maps_.fraction(); }  ///< 0..1
  /// Returns the symmetries; requires that advance() has returned false.
  std::vector<BodySymmetry> found() const;

 private:
  SeamMaps maps_;
};

/// Index (into SeamMaps::maps()) of the candidate that carries most seams to seams, then agrees
/// best with the 3D placement; -1 if there are no candidates.
int likeliestMap(const SeamMaps& maps, const std::vector<int>& candidates);

/// Converts a map to a symmetry and measures its residual on the exact curves if possible.
BodySymmetry bodySymmetry(const Garment& garment, int from, int to,
                          const MirrorRegistration& registration);

}  // namespace seamwise
