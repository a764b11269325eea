#pragma once
#include <memory>
#include <string>
#include <vector>

#include "pattern/garment.h"
#include "pattern/note.h"
#include "problem/options.h"
#include "problem/pleat_fit.h"
#include "problem/seam_groups.h"
#include "wallpaper/print.h"

namespace seamwise {

/// The symmetries of a garment in a solve.
struct GarmentSymmetries {
  std::vector<BodySymmetry> imposed;  ///< obeyed by print and shape
  std::vector<BodySymmetry> known;    ///< all that the sampling follows; contains `imposed`
  bool optional = false;  ///< not explicitly requested: one that cannot hold may be dropped
  bool operator==(const GarmentSymmetries&) const = default;
};

/// The checked input of a solve: numbers are finite, references resolve, the print's group carries
/// the imposed symmetries. Solving does not modify it.
struct Problem {
  Garment garment;
  Print print;
  GarmentSymmetries symmetries;
  SolveOptions options;
  std::vector<Note> notes;        ///< items dropped or assumed by reading
  std::vector<SeamGroup> groups;  ///< the stitches as seams of a sewist
  /// Panels whose pleats take up more or less fabric than drafted; null without any.
  std::shared_ptr<const std::vector<PleatFit>> pleat_fits = {};
};

}  // namespace seamwise
