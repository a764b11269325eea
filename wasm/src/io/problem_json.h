#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/outcome.h"
#include "problem/problem.h"
#include "symmetry/detection.h"
#include "symmetry/symmetry.h"

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

/// makeProblem() in steps.
class ProblemReader {
 public:
  explicit ProblemReader(ProblemTexts texts) : texts_(std::move(texts)) {}

  /// Reads the files, then looks for symmetries: some milliseconds of work. False when there is
  /// none left.
  bool advance();
  double fraction() const { return detection_ ? detection_->fraction() : 0; }  ///< 0..1, monotone
  /// Once it has ended.
  Outcome<Problem> take();

 private:
  /// The files, but for symmetries.
  std::optional<Error> read();

  ProblemTexts texts_;
  std::unique_ptr<Problem> problem_;  ///< stays where it is: the detection looks at its garment
  std::vector<SymmetryRequest> of_garment_;
  std::unique_ptr<SymmetryDetection> detection_;
  std::optional<Error> error_;
};

}  // namespace seamwise
