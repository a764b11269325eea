#pragma once
#include <vector>

#include "base/outcome.h"
#include "pattern/breakpoints.h"

namespace seamwise {

struct SampledLoop {
  Polyline points;               ///< start at the start of edge 0
  std::vector<int> node_vertex;  ///< vertex at each node of the loop's breakpoints
  std::vector<int> edge_start;   ///< vertex at which each edge starts
};

/// Samples all loops between their breakpoints, evenly by arc length. Tied intervals share one
/// count. It is the count of the longest at `edge_length` cm, or more, so that no chord turns by
/// more than 18 degrees (then it is at most 0.4 % shorter than its arc) and no outline crosses
/// itself. Errors: kMesh if an outline crosses itself at any sampling.
Outcome<std::vector<SampledLoop>> sampleLoops(const Outlines& outlines,
                                              const Breakpoints& breakpoints, double edge_length);

}  // namespace seamwise
