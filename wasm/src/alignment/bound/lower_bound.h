#pragma once
#include <vector>

#include "alignment/bound/box_tables.h"
#include "alignment/model/sampled_seams.h"
#include "tuning/proof.h"

namespace seamwise {

/// Proves how good an alignment of a component is. Boxes cover the alignments of each leader.
/// Tables contain the least costs of the seams of two leaders in each pair of boxes. Elimination
/// over the graph of seams bounds the cost of all seams for every box and pair. Boxes and pairs
/// that cost more than the answer are dropped, the boxes of one leader are halved, and so on.
/// Anytime: the bound is valid after every step, and nearly always 0 at first. Work is counted in
/// distance evaluations, never in seconds, so that results do not depend on the machine.
class LowerBound {
 public:
  /// @param known   alignments of all leaders; those outside the component do not change
  LowerBound(const MatchProblem& problem, const Component& component, const Alignments& known);
  LowerBound(const LowerBound&) = delete;
  LowerBound& operator=(const LowerBound&) = delete;

  /// Works for some milliseconds. Returns false when the answer is proven or no more boxes can be
  /// halved within the memory limit.
  bool step();

  /// No alignment of the component costs less than this. At most cost(). [cm2]
  double bound() const;
  /// Returns whether best() costs at most ProofTuning::kProven more than necessary, or almost
  /// nothing.
  bool proven() const;
  /// The best answer found, of all leaders: `known` or a better one to continue from.
  const Alignments& best() const { return best_; }
  double cost() const { return cost_; }  ///< cost of best() over all edges of the component. [cm2]
  /// Number of element distances evaluated, or equivalent work.
  double spent() const { return spent_; }

 private:
  /// The bound that proves the answer. [cm2]
  double enough() const { return cost_ * (1 - ProofTuning::kProven); }
  void next();
  void tighten();
  bool halve();
  void descend();
  double costAt(const Alignments& at) const;

  const MatchProblem& problem_;
  SampledSeams<double> edges_;
  const std::vector<int> seams_;
  BoxTables tables_;
  /// The next stage. Several passes over all boxes and pairs take place between two sweeps.
  enum class Stage { kSweep, kDrop, kTilt, kHalve };
  Stage stage_ = Stage::kSweep;
  bool ended_ = false;
  Alignments best_;
  std::vector<Alignment> tried_;  ///< middles of boxes at the last descent
  double cost_ = 0, bound_ = 0, spent_ = 0, descents_ = 0;
};

}  // namespace seamwise
