#pragma once
#include "deform/fitting.h"
#include "mesh/coarser.h"

namespace seamwise {

/// The state of every part of the finer pattern whose outline follows that of the coarser one: its
/// interior goes along smoothly, its edges have the multipliers of theirs.
std::vector<PartDeformation::State> prolonged(const CoarserPattern& coarser,
                                              const SeamFitting& from, const SeamFitting& to);

}  // namespace seamwise
