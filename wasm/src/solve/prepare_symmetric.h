#pragma once
#include <optional>
#include <vector>

#include "solve/prepare.h"

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

/// As preparedPattern(), which samples outlines the same way. Only the default method is offered
/// more symmetry than it is asked for.
Outcome<PreparedPatterns> preparedPatterns(Problem& problem, MeshMemo& memo);

}  // namespace seamwise
