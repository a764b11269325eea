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

/// The files of a problem as text, with their names for messages.
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
/// Symmetry "auto" imposes the symmetries of the garment file, or the detected ones if the file has
/// none. Those that the print's group cannot carry are dropped with a note. The group must carry
/// all explicit symmetries. Method ws19 imposes none. `options.matches` contains the matched lines
/// of the options, then those of the garment file. Errors: those of the readers; kSymmetryGroup
/// naming the piece and the groups that could carry its symmetry.
Outcome<Problem> makeProblem(const ProblemTexts& texts);

/// makeProblem() in steps.
class ProblemReader {
 public:
  explicit ProblemReader(ProblemTexts texts) : texts_(std::move(texts)) {}

  /// Works for some milliseconds: reads the files, then looks for symmetries. Returns false when
  /// finished.
  bool advance();
  double fraction() const { return detection_ ? detection_->fraction() : 0; }  ///< 0..1, monotone
  /// Returns the problem; requires that advance() has returned false.
  Outcome<Problem> take();

 private:
  /// Reads the files, but not their symmetries.
  std::optional<Error> read();

  ProblemTexts texts_;
  std::unique_ptr<Problem> problem_;  ///< at a fixed address: the detection refers to its garment
  std::vector<SymmetryRequest> of_garment_;
  std::unique_ptr<SymmetryDetection> detection_;
  std::optional<Error> error_;
};

}  // namespace seamwise
