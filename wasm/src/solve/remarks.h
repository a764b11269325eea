#pragma once
#include <optional>
#include <vector>

#include "pattern/note.h"
#include "pattern/pattern.h"

namespace seamwise {

/// One note for each reason why the print cannot meet, however the pieces lie: no seams to
/// match, or seams whose sides differ so much in length that only a stretch of them can match.
std::vector<Note> remarksOn(const Pattern& pattern);

/// Whether no piece was shaped though seams stay off: nobody shall have to guess.
/// @param worst   mean mismatch of the seam that misses by most. [cm]
std::optional<Note> remarkOnRest(const Pattern& pattern, const Shapes& shapes, double worst);

}  // namespace seamwise
