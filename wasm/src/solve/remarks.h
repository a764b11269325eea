#pragma once
#include <optional>
#include <vector>

#include "pattern/note.h"
#include "pattern/pattern.h"

namespace seamwise {

/// One note for each reason why the print cannot match at any alignment: no seams to match, or
/// seams whose sides differ so much in length that only a part of them can match.
std::vector<Note> remarksOn(const Pattern& pattern);

/// A note if no piece was shaped although seams still mismatch.
/// @param worst   greatest mean mismatch of a seam. [cm]
std::optional<Note> remarkOnRest(const Pattern& pattern, const Shapes& shapes, double worst);

}  // namespace seamwise
