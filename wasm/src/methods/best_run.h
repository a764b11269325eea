#pragma once
#include <memory>

#include "methods/fitting_stage.h"
#include "methods/run_memo.h"
#include "methods/search_stage.h"
#include "problem/problem.h"

namespace seamwise {

/// The default method. It seeks alignments with symmetry built in, then improves shape and
/// alignment in turns within the greatest change. Finally it settles the shapes until seams are
/// sewable and outlines smooth.
class BestRun : public Run {
 public:
  /// @param known   mirrors of the pattern's known symmetries that the group carries; the symmetric
  ///                answer is one of the starts unless all of them are imposed
  /// @param offered   alignments of all pieces; the search never ends with worse ones
  /// @param starts   alignments of all pieces, as additional starts of fitting
  /// @param searches   outcomes of the searches of previous solves
  /// @param plans   plans for this mesh; null or for other settings: made here, for later solves
  BestRun(const Problem& problem, const Pattern& pattern, const std::vector<Mirror>& known,
          const MatchRules& rules, std::vector<Alignments> offered, std::vector<Alignments> starts,
          SearchMemo& searches, std::shared_ptr<FittingPlans>& plans);

  /// Greatest movement of an outline vertex. [cm]
  static double reachOf(const SolveOptions& options);
  /// Greatest mismatch that shapes can take up. Two sides that may each move by the greatest change
  /// meet across somewhat less than twice it. [cm]
  static double slackOf(const SolveOptions& options);

  bool advance() override;
  Phase phase() const override;
  double fraction() const override;
  const Alignments& alignment() const override { return alignment_; }
  const Alignments& search() const override { return search_result_; }
  std::vector<Alignments> compared() const override;
  double searchBound() const override { return searching_.bound() * of_bound_; }
  double searchCost() const override { return costAtRest(search_result_); }
  /// Cost of the drafted pieces at these alignments, by the seams' weights. [cm2]
  double costAtRest(const Alignments& at) const { return match_.cost(match_.ofLeaders(at)); }
  AlignmentSearch* searching() override { return searching_.searching(); }
  const Shapes& shapes() const override;
  /// The outcome, once the run has ended.
  RunOutcome outcome() const;
  int iterations() const override { return settling_ + (fitting_ ? fitting_->iterations() : 0); }
  int factorisations() const override { return fitting_ ? fitting_->factorisations() : 0; }

 private:
  enum class Stage : std::uint8_t { kSearch, kStartFitting, kFitting, kSeekAgain, kSettle, kDone };
  void searchStep();
  std::vector<FittingStart> bestPredicted(std::size_t count) const;
  void startFitting();
  void fittingStep();
  void seekAgain();
  void settleStep();
  void restUnsound();
  void restIfBetter();
  void restAt(const Alignments& at);
  void finish();
  bool keepsLimits(const PartDeformation& deformation, double length) const;

  const Problem& problem_;
  const Pattern& pattern_;
  MatchRules rules_;
  double reach_;  ///< greatest movement of an outline vertex, cm
  MatchProblem match_;
  std::vector<Alignments> offered_starts_;
  SearchStage searching_;
  std::shared_ptr<FittingPlans> plans_;
  std::unique_ptr<FittingStage> fitting_;
  Stage stage_ = Stage::kSearch;
  Alignments alignment_, search_result_;
  double of_bound_ = 1;  ///< less than 1 if the result is not the search's best
  bool sought_again_ = false;
  int settling_ = 0, settled_ = 0;  ///< steps of settling, without and with the last, idle one
  double length_error_;             ///< greatest length error of a sewn edge, cm
  double progress_, searched_ = 0;  ///< current progress, and progress after all searches
};

}  // namespace seamwise
