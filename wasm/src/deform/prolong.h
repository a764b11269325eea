#pragma once
#include "deform/fitting.h"
#include "mesh/coarser.h"

namespace seamwise {

/// Returns the state of every part of the finer pattern: its outline follows the coarser one, its
/// interior follows smoothly, and its edges have the multipliers of the coarser edges.
std::vector<PartDeformation::State> prolonged(const CoarserPattern& coarser,
                                              const SeamFitting& from, const SeamFitting& to);

}  // namespace seamwise
