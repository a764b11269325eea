#pragma once
#include <memory>
#include <optional>

#include "methods/best_run.h"

namespace seamwise {

/// Runs the default method several times and takes the answer with the least total mismatch, so
/// more runs never end worse. Each run starts from earlier results: outlines with more than the
/// usual greatest change from those with the usual one, the requested pattern from the symmetric
/// one, then the same with other seeds.
class EffortRun : public Run {
 public:
  /// A mesh and its fitting plans.
  struct Mesh {
    const Pattern& pattern;
    std::shared_ptr<FittingPlans>& plans;
  };

  /// @param symmetric   the same vertices with more symmetries imposed, which may give a better
  ///                    result
  EffortRun(const Problem& problem, Mesh requested, std::optional<Mesh> symmetric,
            std::vector<Mirror> known, const MatchRules& rules, SearchMemo& searches,
            RunMemo& runs);

  bool advance() override;
  Phase phase() const override { return isDone() ? Phase::kDone : run_->phase(); }
  double fraction() const override { return isDone() ? 1 : fraction_; }
  const Alignments& alignment() const override {
    return isDone() ? best().alignment : run_->alignment();
  }
  const Alignments& search() const override { return isDone() ? best().search : run_->search(); }
  std::vector<Alignments> compared() const override { return best().compared; }
  double searchBound() const override;
  double searchCost() const override { return costAtRest(best().search); }
  AlignmentSearch* searching() override { return run_ ? run_->searching() : nullptr; }
  const Shapes& shapes() const override { return isDone() ? best().shapes : run_->shapes(); }
  int iterations() const override { return best().iterations; }
  int factorisations() const override { return best().factorisations; }

 private:
  struct Round {
    bool symmetric;
    double change;  ///< greatest movement of an outline. [cm]
    std::uint32_t seed;
  };
  bool isDone() const { return ended_ == rounds_.size(); }
  const RunOutcome& best() const { return symmetric_stands_ ? *best_symmetric_ : *best_requested_; }
  std::optional<RunOutcome>& bestOf(const Round& round) {
    return round.symmetric ? best_symmetric_ : best_requested_;
  }
  void begin();
  void end(RunOutcome outcome);
  double mismatchOf(const RunOutcome& run) const;
  double costAtRest(const Alignments& at) const;
  bool keptLines(const RunOutcome& run) const;
  void tryLessChange();

  Problem problem_;  ///< the seed and the greatest change are those of the round
  Mesh requested_;
  std::optional<Mesh> symmetric_;
  std::vector<Mirror> known_;
  const MatchRules& rules_;
  SearchMemo& searches_;
  RunMemo& runs_;
  double requested_change_;  ///< cm
  std::vector<Round> rounds_;
  std::size_t ended_ = 0;  ///< number of rounds that have ended
  double fraction_ = 0;
  std::unique_ptr<BestRun> run_;                               ///< current run
  std::optional<RunMemo::Inputs> inputs_;                      ///< its inputs
  std::optional<RunOutcome> best_symmetric_, best_requested_;  ///< best of the ended rounds
  bool symmetric_stands_ = false;
};

}  // namespace seamwise
