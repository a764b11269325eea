#pragma once
#include <vector>

#include "alignment/bound/seam_bound.h"

namespace seamwise {

/// What the seams of one or two leaders cost at least, each leader somewhere in a box.
struct Term {
  float known = 0;      ///< a bound. [cm2]
  float middle = 0;     ///< middle + slope . x is a bound at x in [-1, 1]^6
  float slope[6] = {};  ///< for turn and shifts of the first leader, then of the second
};

/// The seams that join two leaders; or those of one leader whose other side is its own or pinned.
class SeamTerms {
 public:
  /// @param swapped   side b of the seam is the first leader's
  void add(const SeamBound& bound, bool swapped) {
    parts_.push_back({&bound, swapped, nullptr, 0});
  }
  /// @param pinned   where the other side lies
  void add(const SeamBound& bound, bool swapped, const Box& pinned) {
    parts_.push_back({&bound, swapped, &pinned, 0});
  }
  bool empty() const { return parts_.empty(); }
  double weight() const;

  /// @param second   of the second leader; the first's again where there is none
  /// @param spent   grows by the distances evaluated
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
