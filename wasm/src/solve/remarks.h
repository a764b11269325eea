#pragma once
#include <vector>

#include "pattern/note.h"
#include "pattern/pattern.h"

namespace seamwise {

/// One note for each reason why the print cannot meet, however the pieces lie: no seams to
/// match, or seams whose sides differ so much in length that only a stretch of them can match.
std::vector<Note> remarksOn(const Pattern& pattern);

}  // namespace seamwise
