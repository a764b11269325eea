#pragma once
#include <memory>

#include "solve/best_run.h"

namespace seamwise {

/// The default method several times, each with another seed and with what the one before found to
/// begin with; the answer that fits best stands. So more of them never end worse, and neither do
/// outlines that may move further than usual: what is found without that comes first.
class EffortRun : public Run {
 public:
  /// @param effort   how many times, 1 or more, at the greatest change that is asked for; the
  /// others as for BestRun
  EffortRun(const Problem& problem, int effort, const Pattern& pattern, std::vector<Mirror> known,
            const MatchRules& rules, SearchMemo* searches, std::shared_ptr<FittingPlans>* plans);

  bool advance() override;
  Phase phase() const override { return round_ == rounds_ ? Phase::kDone : run_->phase(); }
  double fraction() const override {
    return round_ == rounds_ ? 1 : (round_ + run_->fraction()) / rounds_;
  }
  const Alignments& alignment() const override { return best().alignment(); }
  const Alignments& search() const override { return best().search(); }
  double searchBound() const override { return best().searchBound(); }
  AlignmentSearch* searching() override { return run_ ? run_->searching() : nullptr; }
  const Shapes& shapes() const override { return best().shapes(); }
  int iterations() const override { return best().iterations(); }
  int factorisations() const override { return best().factorisations(); }

 private:
  const BestRun& best() const { return best_ ? *best_ : *run_; }
  void begin(std::vector<Alignments> offered);
  double fit(const BestRun& run) const;

  Problem problem_;  ///< with the seed of the run
  double most_;      ///< that an outline may move. [cm]
  int rounds_;
  const Pattern& pattern_;
  std::vector<Mirror> known_;
  const MatchRules& rules_;
  SearchMemo* searches_;
  std::shared_ptr<FittingPlans>* plans_;
  std::unique_ptr<BestRun> run_, best_;  ///< at work; of those before
  int round_ = 0;                        ///< runs that have ended
};

}  // namespace seamwise
