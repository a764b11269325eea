#pragma once
#include <vector>

#include "base/outcome.h"
#include "pattern/breakpoints.h"

namespace seamwise {

/// One sampled loop.
struct SampledLoop {
  Polyline points;               ///< starts at edge 0's start
  std::vector<int> node_vertex;  ///< vertex at each node of the loop's breakpoints
  std::vector<int> edge_start;   ///< vertex at which each edge starts
};

/// Samples all loops between their breakpoints, evenly by arc length. Tied intervals share one
/// count: what the longest needs at `edge_length` cm, and enough that no chord turns by more than
/// 18 degrees (then it is at most 0.4 % shorter than its arc) and that no outline crosses itself.
/// Errors: kMesh when an outline crosses itself however finely it is sampled.
Outcome<std::vector<SampledLoop>> sampleLoops(const Outlines& outlines,
                                              const Breakpoints& breakpoints, double edge_length);

}  // namespace seamwise
