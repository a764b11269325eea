#pragma once
#include <cstdint>
#include <vector>

#include "alignment/model/matching.h"
#include "problem/options.h"

namespace seamwise {

/// The reason why the print does not match at a seam. Values are part of the result file: append
/// only.
enum class SeamReason : std::uint8_t {
  kNone,    ///< it matches
  kGrain,   ///< its sides need an angle to each other that their grain does not allow
  kGather,  ///< its sides differ too much in length
  kGroup,   ///< it needs mirrors, which the print lacks
  kSize,    ///< its sides curve too differently for a repeat of this size
  kOthers,  ///< its pieces follow other seams; alone it would match
  kLocked   ///< one of its edges is locked to the drafted line
};

/// Greatest mean mismatch of a seam that matches visually. [cm]
inline constexpr double kSeenMismatch = 0.3;

struct SeamObstacle {
  SeamReason reason;
  /// Mean mismatch of the drafted lines under the best motion that the reason allows; 0 for
  /// gathers, locks and other seams. [cm]
  double left;
};

/// The first reason that applies to a seam with a mismatch.
/// @param match   match problem of the pieces as drafted
SeamObstacle obstacleOf(const Pattern& pattern, const Seam& seam, const MatchProblem& match,
                        const std::vector<EdgeRef>& locked);

}  // namespace seamwise
