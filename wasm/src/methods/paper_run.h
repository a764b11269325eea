#pragma once
#include <limits>
#include <optional>

#include "alignment/baseline/sweeps.h"
#include "deform/penalty.h"
#include "methods/run.h"
#include "problem/problem.h"
#include "seam/ideal_line.h"

namespace seamwise {

/// `paper`: Wolff et al. 2019 as written, its slips corrected: one random start, local sweeps,
/// averaged ideal seam lines, E_sym and quadratic penalties. `ws19`: the method it extends, without
/// symmetry and without averaging. Neither bounds movement, so alpha is doubled from 1 until the
/// greatest change holds and outlines are simple; where no alpha does it, the targets are drawn
/// towards rest. Where nothing is gained, pieces stay as drafted. Options give more starts, the
/// drafted layout among them, of which the cheapest end counts, and targets clipped to the greatest
/// change, which need less alpha.
class PaperRun : public Run {
 public:
  /// @param drafted   how a cutter lays the pieces
  PaperRun(const Problem& problem, const Pattern& pattern, const MatchRules& rules,
           const Alignments& drafted, std::vector<Note>* notes);

  bool advance() override;
  Phase phase() const override;
  double fraction() const override;
  const Alignments& alignment() const override { return alignment_; }
  const Alignments& search() const override { return alignment_; }
  const Shapes& shapes() const override { return shapes_; }
  int iterations() const override { return deformation_.iterations(); }
  int factorisations() const override { return deformation_.iterations(); }
  int attempt() const override { return attempt_; }

 private:
  void sweep();
  void startDeformation();
  bool endAttempt();
  bool isKept() const;
  void restIfBetter();

  const Problem& problem_;
  const Pattern& pattern_;
  MatchProblem match_;
  Alignments drafted_;                                     ///< of the leaders
  int start_ = 0;                                          ///< of the sweeps at work
  std::optional<LocalSweeps> sweeps_;                      ///< none once all have ended
  double cost_ = std::numeric_limits<double>::infinity();  ///< of the best end of sweeps, cm2
  PenaltyDeformation deformation_;
  std::vector<Target> targets_;
  Alignments alignment_;
  Shapes shapes_;
  double alpha_ = 1;
  double draw_ = 1;  ///< share of the way from rest to their targets that seams are drawn
  int attempt_ = 0;
  double progress_ = 0;
  Phase phase_ = Phase::kAlignment;
  std::vector<Note>* notes_;
};

}  // namespace seamwise
