#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "problem/prepare.h"

namespace seamwise {

/// The pattern that a problem asks for, and what more symmetry it could have.
struct PreparedPatterns {
  Pattern asked;
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
  explicit SymmetricPreparation(Problem& problem, MeshMemo* memo = nullptr);

  /// Some milliseconds of work. False when there is none left.
  bool advance();
  double fraction() const { return fraction_; }  ///< 0..1, monotone
  /// Once it has ended. Errors: as Preparation::take().
  Outcome<PreparedPatterns> take();
  std::shared_ptr<MeshPlans> plans() const { return preparation_->plans(); }

 private:
  bool judge();

  Problem& problem_;
  MeshMemo* memo_;
  std::optional<Problem> more_;  ///< the problem with more symmetries, while they may hold
  std::optional<Preparation> preparation_;
  std::optional<PreparedPatterns> symmetric_;
  double fraction_ = 0;
};

}  // namespace seamwise
