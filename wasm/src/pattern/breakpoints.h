#pragma once
#include <string>
#include <vector>

#include "pattern/correspondence.h"
#include "pattern/garment.h"

namespace seamwise {

/// The outline (index 0) or a cut-out (index h + 1: hole h) of a panel.
struct PanelLoop {
  int panel = 0;
  int index = 0;
  Loop loop;
};

/// Two loops tied by a body symmetry; they may be the same one.
struct LoopTie {
  int from = 0, to = 0;  ///< indices into the list of loops
  int symmetry = 0;
  Correspondence map;
};

/// The input of sampling: loops, the stitches between their edges, and their mirror ties.
struct Outlines {
  std::vector<PanelLoop> loops;  ///< the panels' outlines and cut-outs, in order
  std::vector<int> first;        ///< index of each panel's outline in `loops`
  std::vector<Stitch> stitches;
  std::vector<LoopTie> ties;
};

/// All positions where outlines must have a vertex, and the groups of tied intervals between them.
struct Breakpoints {
  std::vector<std::vector<double>> nodes;  ///< per loop, ascending positions; corners included
  std::vector<int> first_interval;         ///< per loop: number of the interval after node 0
  std::vector<int> group;  ///< per interval: the least interval tied to it by seams and mirrors
  /// Per tie: the node of loop `to` that is the image of node 0 of loop `from`; node i goes to
  /// image_of_first - i, cyclically.
  std::vector<int> image_of_first;
  std::string conflict;  ///< reason why the outlines cannot be tied one-to-one; empty if they can
  int conflicting_panel = -1;

  /// Number of a loop's node at the position of a node, e.g. of a corner.
  int nodeAt(int loop, double position) const;
};

/// Carries corners and axis crossings along seams and mirrors until nothing new arises. A
/// breakpoint that arrives within `tolerance` cm of one without a counterpart is identified with
/// it. Otherwise seams and symmetries that disagree slightly would add breakpoints round the
/// garment without end. The difference is then spread over the neighbouring intervals. More than
/// `most` breakpoints are a conflict.
/// @param settled   true: moves breakpoints so that tied intervals have equal proportions, which
///                  affects no conflict
Breakpoints findBreakpoints(const Outlines& outlines, double tolerance, std::size_t most,
                            bool settled = true);

}  // namespace seamwise
