#pragma once
#include <memory>

#include "methods/fitting_stage.h"
#include "methods/search_stage.h"
#include "problem/problem.h"

namespace seamwise {

/// The default method: alignments are sought with symmetry built in, then shape and alignment
/// improved in turns, never beyond the greatest change, then whatever it takes to keep seams
/// sewable and outlines smooth.
class BestRun : public Run {
 public:
  /// @param known   mirrors of the pattern's known symmetries that the group carries; with none
  ///                imposed the symmetric answer is one of the starts
  /// @param offered   alignments of all pieces: the search never ends with worse ones
  /// @param starts   alignments of all pieces to begin fitting with, besides what the search finds
  /// @param searches   outcomes of the searches of solves before
  /// @param plans   of this mesh; null: made here, for later solves
  BestRun(const Problem& problem, const Pattern& pattern, const std::vector<Mirror>& known,
          const MatchRules& rules, std::vector<Alignments> offered, std::vector<Alignments> starts,
          SearchMemo& searches, std::shared_ptr<FittingPlans>& plans);

  /// How far an outline vertex may move. [cm]
  static double reachOf(const SolveOptions& options);
  /// How much a mismatch may be for shapes to take it up: two sides that may each move by the
  /// greatest change meet across somewhat less than twice it. [cm]
  static double slackOf(const SolveOptions& options);

  bool advance() override;
  Phase phase() const override;
  double fraction() const override;
  const Alignments& alignment() const override { return alignment_; }
  const Alignments& search() const override { return search_result_; }
  std::vector<Alignments> compared() const override;
  double searchBound() const override { return searching_.bound() * of_bound_; }
  double searchCost() const override { return costAtRest(search_result_); }
  /// What the pieces as drafted cost where they are laid, by the seams' weights. [cm2]
  double costAtRest(const Alignments& at) const { return match_.cost(match_.ofLeaders(at)); }
  AlignmentSearch* searching() override { return searching_.searching(); }
  const Shapes& shapes() const override;
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
  double reach_;  ///< how far an outline vertex may move, cm
  MatchProblem match_;
  std::vector<Alignments> offered_starts_;
  SearchStage searching_;
  std::shared_ptr<FittingPlans> plans_;
  std::unique_ptr<FittingStage> fitting_;
  Stage stage_ = Stage::kSearch;
  Alignments alignment_, search_result_;
  double of_bound_ = 1;  ///< less where something else is the result than the search's best
  bool sought_again_ = false;
  int settling_ = 0, settled_ = 0;  ///< iterations; with the last, which finds nothing to do
  double length_error_;             ///< of a sewn edge, cm
  double progress_, searched_ = 0;  ///< now, and once all was searched
};

}  // namespace seamwise
