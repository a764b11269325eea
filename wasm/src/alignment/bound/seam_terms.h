#pragma once
#include <vector>

#include "alignment/bound/seam_bound.h"

namespace seamwise {

/// Least cost of the seams of one or two leaders, each leader in a box.
struct Term {
  float known = 0;      ///< a bound. [cm2]
  float middle = 0;     ///< middle + slope . x is a bound at x in [-1, 1]^6
  float slope[6] = {};  ///< for turn and shifts of the first leader, then of the second
};

/// The seams that join two leaders, or those of one leader to itself or to a pinned one.
class SeamTerms {
 public:
  /// @param swapped   true if side b of the seam is the first leader's
  void add(const SeamBound& bound, bool swapped) {
    parts_.push_back({&bound, swapped, nullptr, 0});
  }
  /// @param pinned   box of the other side
  void add(const SeamBound& bound, bool swapped, const Box& pinned) {
    parts_.push_back({&bound, swapped, &pinned, 0});
  }
  bool empty() const { return parts_.empty(); }
  double weight() const;

  /// @param second   box of the second leader; the first one again if there is no second
  /// @param spent   grows by the number of distances evaluated
  Term between(const Box& first, double reach_first, const Box& second, double reach_second,
               double& spent) const;

 private:
  struct Part {
    const SeamBound* bound;
    bool swapped;
    const Box* pinned;
    double reach;
  };
  std::vector<Part> parts_;
};

}  // namespace seamwise
