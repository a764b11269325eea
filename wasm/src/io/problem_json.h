#pragma once
#include <cstdint>
#include <string>

#include "geometry/outcome.h"
#include "solve/problem.h"

namespace seamwise {

/// The files of a problem as text, with the names by which messages call them.
struct ProblemTexts {
  std::string garment, garment_name;
  std::string print, print_name;
  std::string symmetry;  ///< "auto", "none", or JSON text
  std::string symmetry_name;
  std::string options;  ///< "" or JSON text
  std::string options_name;
  Method method = Method::kBest;
  std::uint32_t seed = 1;
};

/// Reads and checks everything a solve needs.
///
/// Symmetry "auto" imposes those of the garment file, or else those found, as far as the print's
/// group carries them; what is dropped is noted. Explicit ones must all be carried. Method ws19
/// imposes none. Matched lines of the garment file come after those of the options, in
/// `options.matches`. Errors: those of the readers; kSymmetryGroup naming the piece and the groups
/// that could.
Outcome<Problem> makeProblem(const ProblemTexts& texts);

}  // namespace seamwise
