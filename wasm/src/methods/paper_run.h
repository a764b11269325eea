#pragma once
#include <limits>
#include <optional>

#include "alignment/baseline/sweeps.h"
#include "deform/penalty.h"
#include "methods/run.h"
#include "problem/problem.h"
#include "seam/ideal_line.h"

namespace seamwise {

/// `paper`: Wolff et al. 2019 as written, with its slips corrected: one random start, local sweeps,
/// averaged ideal seam lines, E_sym and quadratic penalties. `ws19`: the method it extends, without
/// symmetry and without averaging. Neither bounds movement, so alpha doubles from 1 until the
/// greatest change holds and outlines are simple. If no alpha is enough, the targets move towards
/// rest. Pieces stay as drafted if nothing is gained. Options add starts, including the drafted
/// layout, and the cheapest result counts. They also clip targets to the greatest change, which
/// requires less alpha.
class PaperRun : public Run {
 public:
  /// @param drafted   alignments of all pieces in the drafted layout
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
  void startAttempt();
  bool isKept() const;
  void restIfBetter();

  const Problem& problem_;
  const Pattern& pattern_;
  MatchProblem match_;
  Alignments drafted_;                 ///< drafted layout of the leaders
  int start_ = 0;                      ///< index of the current start of the sweeps
  std::optional<LocalSweeps> sweeps_;  ///< empty once all have ended
  double cost_ = std::numeric_limits<double>::infinity();  ///< cost of the best sweeps, cm2
  PenaltyDeformation deformation_;
  std::vector<Target> targets_;
  Alignments alignment_;
  Shapes shapes_;
  double alpha_ = 1;
  double draw_ = 1;  ///< share of the way from rest to their targets for the seams
  int attempt_ = 0;
  bool probing_ = false;  ///< seeks an alpha that holds, continuing the attempt before
  double progress_ = 0;
  Phase phase_ = Phase::kAlignment;
  std::vector<Note>* notes_;
};

}  // namespace seamwise
