#pragma once
#include <memory>

#include "deform/fitting.h"
#include "solve/problem.h"
#include "solve/run.h"
#include "solve/search_run.h"

namespace seamwise {

/// The default method: alignments are sought with symmetry built in, then shape and alignment
/// improved in turns, never beyond the greatest change, then whatever it takes to keep seams
/// sewable and outlines smooth.
class BestRun : public Run {
 public:
  /// @param known   mirrors of the pattern's known symmetries that the group carries; with none
  ///                imposed the symmetric answer is one of the starts
  /// @param memo    of searches; may be null
  BestRun(const Problem& problem, const Pattern& pattern, const std::vector<Mirror>& known,
          const MatchRules& rules, SearchMemo* memo);

  bool advance() override;
  Phase phase() const override;
  double fraction() const override;
  const Alignments& alignment() const override { return alignment_; }
  const Alignments& search() const override { return search_result_; }
  double searchBound() const override { return searching_.bound(); }
  const Shapes& shapes() const override;
  int iterations() const override { return iterations_; }
  int factorisations() const override { return fitting_ ? fitting_->factorisations() : 0; }

 private:
  enum class Stage : std::uint8_t { kSearch, kStartFit, kFit, kSettle, kDone };
  void search();
  void startFit();
  void resume(std::size_t start);
  void fitStep();
  void settleStep();
  void restUnsound();
  void restIfBetter();
  void finish();
  void realign();
  bool kept(const Cloth& cloth) const;

  const Problem& problem_;
  const Pattern& pattern_;
  MatchRules rules_;
  double reach_;  ///< how far an outline vertex may move, cm
  MatchProblem match_;
  SearchRun searching_;
  std::unique_ptr<SeamFitting> fitting_;
  Stage stage_ = Stage::kSearch;
  Alignments leaders_;  ///< present alignment of the leaders
  Alignments alignment_, search_result_;
  /// An alignment to fit from, and how far that has come.
  struct Start {
    Alignments leaders;
    std::vector<Cloth::State> states;
    double fit = 0;
    int steps = 0;
  };
  std::vector<Start> starts_;
  std::size_t current_ = 0;  ///< of the starts
  int fit_steps_ = 0;
  int iterations_ = 0, settled_ = 0;
  double progress_, searched_ = 0;  ///< now, and once all was searched
};

}  // namespace seamwise
