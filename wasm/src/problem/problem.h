#pragma once
#include <string>
#include <vector>

#include "pattern/garment.h"
#include "pattern/note.h"
#include "problem/options.h"
#include "wallpaper/print.h"

namespace seamwise {

/// Everything a solve needs, checked: numbers are finite, references resolve, the print's group
/// carries the imposed symmetries.
struct Problem {
  Garment garment;
  Print print;
  std::vector<BodySymmetry> imposed;  ///< obeyed by print and shape
  std::vector<BodySymmetry> known;    ///< all that the sampling follows; contains `imposed`
  bool symmetries_optional = false;   ///< found by the program: one that cannot hold may be dropped
  SolveOptions options;
  std::vector<Note> notes;  ///< what was dropped or assumed
};

}  // namespace seamwise
