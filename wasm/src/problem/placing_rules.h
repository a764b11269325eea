#pragma once
#include <optional>
#include <string>
#include <vector>

#include "alignment/model/grain.h"
#include "problem/problem.h"

namespace seamwise {

/// How a piece's grain line lies on the cloth: as the options say, else as the file does.
GrainRule grainRule(const Problem& problem, int piece);

/// Where the grain line of the face-up piece runs: as the options say, else as the file does, else
/// upwards. [rad]
double grainLine(const Problem& problem, int piece);

/// A sentence that names the printed pieces whose grain line neither file nor options state, if the
/// placing depends on it. @param file   the garment's, for the sentence
std::optional<Note> assumedGrain(const Problem& problem, const std::string& file);

/// Pins and grain of every piece. Under a one-way print, a piece of free grain stays within 60
/// degrees of upright.
std::vector<PieceRule> pieceRules(const Problem& problem);

/// The first imposed symmetry that pinned alignments contradict: a pinned piece whose own axis lies
/// on no mirror line of the print, or a pair of which both are pinned, but not as mirror images.
std::optional<std::size_t> symmetryAgainstPins(const Problem& problem,
                                               const std::vector<BodySymmetry>& imposed);

/// The first imposed symmetry under which a piece cannot lie on its grain on this print.
std::optional<std::size_t> symmetryAgainstGrain(const Problem& problem,
                                                const std::vector<BodySymmetry>& imposed);

}  // namespace seamwise
