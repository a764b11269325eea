#pragma once
#include <cstdint>
#include <vector>

#include "alignment/model/matching.h"
#include "problem/options.h"

namespace seamwise {

/// Why the print does not meet at a seam. Values are part of the result file: append only.
enum class SeamReason : std::uint8_t {
  kNone,    ///< it does
  kGrain,   ///< its sides would have to lie at another angle to each other than their grain allows
  kGather,  ///< its sides differ too much in length
  kGroup,   ///< the print has no mirrors, with which it could
  kSize,    ///< its sides curve too differently for a repeat of this size
  kOthers,  ///< by itself it would, but other seams pull its pieces elsewhere
  kLocked   ///< it is to stay as drafted
};

/// A seam whose mean mismatch is at most this meets, to the eye. [cm]
inline constexpr double kSeenMismatch = 0.3;

/// The first reason that holds of a seam that does not meet.
/// @param match   of the pieces as drafted
SeamReason reasonOf(const Pattern& pattern, const Seam& seam, const MatchProblem& match,
                    const std::vector<EdgeRef>& locked);

}  // namespace seamwise
