#pragma once
#include <vector>

#include "alignment/bound/box_tables.h"
#include "alignment/model/sampled_seams.h"
#include "tuning/proof.h"

namespace seamwise {

/// Proves how good an alignment of a component is. Boxes cover what each leader may do, tables say
/// what the seams of two leaders cost at least in each pair of boxes, and elimination over the
/// graph of seams says what all seams do where a box or a pair has a part. What costs more than the
/// answer is dropped, the boxes of one leader are halved, and so on. Anytime: the bound is valid
/// after every step, and nearly always 0 at first. Work is counted in distance evaluations, never
/// in seconds, so that results do not depend on the machine.
class LowerBound {
 public:
  /// @param known   alignments of all leaders; those outside the component stay where they are
  LowerBound(const MatchProblem& problem, const Component& component, const Alignments& known);
  LowerBound(const LowerBound&) = delete;
  LowerBound& operator=(const LowerBound&) = delete;

  /// Some milliseconds of work. False when the answer is proven or no memory is left for more
  /// boxes.
  bool step();

  /// No alignment of the component costs less than this. At most cost(). [cm2]
  double bound() const;
  /// Whether best() costs at most ProofTuning::kProven more than it has to, or next to nothing.
  bool proven() const;
  /// The best answer met, of all leaders: `known`, or a better one to go on from.
  const Alignments& best() const { return best_; }
  double cost() const { return cost_; }  ///< of best(), all edges of the component. [cm2]
  /// Element distances evaluated, or work that takes as long.
  double spent() const { return spent_; }

 private:
  /// A bound that proves the answer. [cm2]
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
  /// What comes next: between two sweeps all boxes and pairs are gone through several times.
  enum class Stage { kSweep, kDrop, kTilt, kHalve };
  Stage stage_ = Stage::kSweep;
  bool ended_ = false;
  Alignments best_;
  std::vector<Alignment> tried_;  ///< the last middles of boxes
  double cost_ = 0, bound_ = 0, spent_ = 0, descents_ = 0;
};

}  // namespace seamwise
