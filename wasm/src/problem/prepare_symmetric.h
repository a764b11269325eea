#pragma once
#include <optional>
#include <vector>

#include "problem/prepare.h"

namespace seamwise {

/// A problem prepared for solving.
struct PreparedProblem {
  Prepared asked;
  /// The pattern with all known symmetries that the print's group carries, if these are more than
  /// the requested ones. Both patterns have the same vertices, so shapes of one are shapes of the
  /// other.
  std::optional<Pattern> symmetric;
  /// Mirrors at the start of a search: those of `symmetric`, or those that could not be meshed.
  std::vector<Mirror> known;
};

/// Prepares a problem with all known symmetries that the print's group carries, or with the
/// requested ones if those cannot hold. Only the default method uses more symmetries than
/// requested.
class SymmetricPreparation {
 public:
  /// @param problem   must outlive this object
  /// @param memo      may be null
  explicit SymmetricPreparation(const Problem& problem, MeshMemo* memo = nullptr);

  /// Works for some milliseconds. Returns false when finished.
  bool advance();
  double fraction() const { return fraction_; }  ///< 0..1, monotone
  /// Returns the prepared problem; requires that advance() has returned false. Errors: as for
  /// Preparation::take().
  Outcome<PreparedProblem> take();

 private:
  bool judge();

  const Problem& problem_;
  MeshMemo* memo_;
  bool has_more_ = false;  ///< more symmetries than the requested ones are tried
  std::optional<Preparation> preparation_;
  std::optional<PreparedProblem> symmetric_;
  double fraction_ = 0;
};

}  // namespace seamwise
