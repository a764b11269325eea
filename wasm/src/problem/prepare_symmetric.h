#pragma once
#include <optional>
#include <vector>

#include "problem/prepare.h"

namespace seamwise {

/// What a problem is made into before it is solved.
struct PreparedProblem {
  Prepared asked;
  /// With all known symmetries imposed that the print's group carries, where these are more than
  /// are asked for. Its vertices are those of `asked`, so its shapes are shapes of that.
  std::optional<Pattern> symmetric;
  /// Mirrors to begin a search with: of `symmetric`, or those that could not be meshed.
  std::vector<Mirror> known;
};

/// A preparation of the problem with all known symmetries that the print's group carries; where
/// they cannot hold, of the problem as it is. Only the default method is offered more symmetry than
/// it is asked for.
class SymmetricPreparation {
 public:
  /// @param problem   outlives it
  /// @param memo      may be null
  explicit SymmetricPreparation(const Problem& problem, MeshMemo* memo = nullptr);

  /// Some milliseconds of work. False when there is none left.
  bool advance();
  double fraction() const { return fraction_; }  ///< 0..1, monotone
  /// Once it has ended. Errors: as Preparation::take().
  Outcome<PreparedProblem> take();

 private:
  bool judge();

  const Problem& problem_;
  MeshMemo* memo_;
  bool has_more_ = false;  ///< more symmetries than are asked for are tried
  std::optional<Preparation> preparation_;
  std::optional<PreparedProblem> symmetric_;
  double fraction_ = 0;
};

}  // namespace seamwise
