#pragma once
#include "deform/fitting.h"
#include "mesh/coarser.h"

namespace seamwise {

/// The state that every part of the finer pattern has when its outline follows that of the coarser
/// one, its interior goes along smoothly, and its edges pull as theirs do.
std::vector<PartDeformation::State> prolonged(const CoarserPattern& coarser,
                                              const SeamFitting& from, const SeamFitting& to);

}  // namespace seamwise
