#pragma once
#include <optional>
#include <string>
#include <vector>

#include "alignment/model/grain.h"
#include "problem/problem.h"

namespace seamwise {

/// Grain rule of a piece: from its options, else from the file, else from the options for all
/// pieces.
GrainRule grainRule(const Problem& problem, int piece);

/// Direction of the grain line of the face-up piece: from the options, else from the file, else
/// upwards. [rad]
double grainLine(const Problem& problem, int piece);

/// A note that names the printed pieces without a grain line in file and options, if their
/// placement depends on it.
/// @param file   name of the garment file, for the sentence
std::optional<Note> assumedGrain(const Problem& problem, const std::string& file);

/// Pins and grain of every piece. Under a one-way print, a piece of free grain stays within 60
/// degrees of upright.
std::vector<PieceRule> pieceRules(const Problem& problem);

/// The first imposed symmetry that pinned alignments contradict: a pinned piece whose own axis is
/// on no mirror line of the print, or a pair pinned otherwise than as mirror images.
std::optional<std::size_t> symmetryAgainstPins(const Problem& problem,
                                               const std::vector<BodySymmetry>& imposed);

/// The first imposed symmetry that prevents a piece from keeping its grain rule on this print.
std::optional<std::size_t> symmetryAgainstGrain(const Problem& problem,
                                                const std::vector<BodySymmetry>& imposed);

}  // namespace seamwise
