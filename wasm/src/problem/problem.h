#pragma once
#include <string>
#include <vector>

#include "pattern/garment.h"
#include "pattern/note.h"
#include "problem/options.h"
#include "wallpaper/print.h"

namespace seamwise {

/// The symmetries of a garment, as a solve treats them.
struct GarmentSymmetries {
  std::vector<BodySymmetry> imposed;  ///< obeyed by print and shape
  std::vector<BodySymmetry> known;    ///< all that the sampling follows; contains `imposed`
  bool optional = false;  ///< found by the program: an imposed one that cannot hold may be dropped
  bool operator==(const GarmentSymmetries&) const = default;
};

/// Everything a solve needs, checked: numbers are finite, references resolve, the print's group
/// carries the imposed symmetries. Solving changes nothing of it.
struct Problem {
  Garment garment;
  Print print;
  GarmentSymmetries symmetries;
  SolveOptions options;
  std::vector<Note> notes;  ///< what reading dropped or assumed
};

}  // namespace seamwise
