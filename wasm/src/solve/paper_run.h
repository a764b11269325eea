#pragma once
#include "alignment/sweeps.h"
#include "deform/penalty.h"
#include "seam/ideal_line.h"
#include "solve/problem.h"
#include "solve/run.h"

namespace seamwise {

/// `paper`: Wolff et al. 2019 as written, its slips corrected: one random start, local sweeps,
/// averaged ideal seam lines, E_sym and quadratic penalties. `ws19`: the method it extends, without
/// symmetry and without averaging. Neither bounds movement, so alpha is doubled from 1 until the
/// greatest change holds and outlines are simple; where no alpha does it, the targets are drawn
/// towards rest.
class PaperRun : public Run {
 public:
  PaperRun(const Problem& problem, const Pattern& pattern, const MatchRules& rules,
           std::vector<Note>* notes);

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
  void startDeformation();
  bool endAttempt();
  bool isKept() const;

  const Problem& problem_;
  const Pattern& pattern_;
  MatchProblem match_;
  LocalSweeps sweeps_;
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
