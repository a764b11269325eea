#pragma once
#include <memory>
#include <vector>

#include "deform/fitting.h"
#include "solve/run.h"

namespace seamwise {

/// Shape and alignment improved in turns: a few steps from each of several answers of the search,
/// then on from the best one. Where edges are short this happens on a coarser mesh, and the whole
/// one only takes the last steps. Seam lengths and limits are left to settle.
class FitRun {
 public:
  /// All but the starts outlives the run.
  /// @param match    of the pattern at rest, made by the rules
  /// @param plans    for the pattern
  /// @param starts   of the leaders; at least one
  FitRun(const Pattern& pattern, const MatchProblem& match, const MatchRules& rules,
         const FittingRules& fitting, FittingPlans& plans, std::vector<Alignments> starts);

  /// One step of all parts. False when there is nothing left to do.
  bool advance();
  double fraction() const;  ///< 0..1, never falls
  /// Whether the print meets everywhere as the pieces lie, so that nothing has to move.
  bool isPerfect() const { return perfect_; }

  const Alignments& alignment() const { return alignment_; }  ///< of every piece
  SeamFitting& fitting() { return *fitting_; }                ///< at the end: of the pattern
  int iterations() const { return iterations_; }
  int factorisations() const { return coarse_factorisations_ + fitting_->factorisations(); }

 private:
  /// An alignment to fit from, and how far that has come.
  struct Start {
    Alignments leaders;
    std::vector<Cloth::State> states;
    double fit = 0;
    int steps = 0;
  };
  const Pattern& fitted() const { return fine_ ? coarse_pattern_ : pattern_; }
  void goCoarse();
  void goFine();
  void resume(std::size_t start);
  void place(const Alignments& leaders);
  void realign();
  void compareStarts();

  const Pattern& pattern_;
  const MatchProblem& match_;
  const MatchRules& rules_;
  FittingRules fitting_rules_;
  FittingPlans& plans_;
  std::unique_ptr<SeamFitting> fitting_, fine_;  ///< at work; waiting for its turn, if there is one
  const CoarserPattern* coarser_ = nullptr;
  Pattern coarse_pattern_;  ///< with the seams' present weights
  std::vector<Start> starts_;
  std::size_t current_ = 0;  ///< of the starts
  Alignments leaders_, alignment_;
  bool perfect_ = false, begun_ = false;
  int steps_ = 0, trial_steps_ = 0;  ///< to do, all and from each start
  int fine_steps_ = 0;               ///< done, after coarse ones
  int iterations_ = 0, coarse_factorisations_ = 0;
  double done_ = 0, planned_ = 1;  ///< steps, in coarse ones
  double fine_step_ = 1;           ///< coarse ones that take as long as a fine one
};

}  // namespace seamwise
