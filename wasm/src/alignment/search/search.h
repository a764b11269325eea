#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "alignment/bound/lower_bound.h"
#include "alignment/search/search_share.h"

namespace seamwise {

/// Finds alignments that no local iteration finds: starts grown along random spanning trees of the
/// seam graph, each seam continuous or mirrored, polished by a joint Newton; then random parts of
/// the best are regrown and single pieces moved while that helps. Components of the seam graph are
/// searched one by one, on samples of the seams, in shares that know nothing of each other: they
/// may run elsewhere, and the outcome is the same. The best few answers of all are compared on all
/// edges at the end, and the best one's cost is bounded from below. Anytime: best() is valid after
/// the first step.
class AlignmentSearch {
 public:
  /// @param slack   as in SampledSeams::cost: distances up to it are nearly free
  AlignmentSearch(const MatchProblem& problem, std::uint64_t seed, SearchBudget budget,
                  double slack = 0);

  /// Remembers as well which answer met on the way is best under this slack. [cm] Set before the
  /// first step.
  void watch(double slack) { watch_slack_ = slack; }
  /// That answer, of the leaders.
  Alignments watched() const;

  /// Adds an answer found elsewhere (of the leaders; made admissible), before the first step. The
  /// search never ends with a worse one.
  void offer(const Alignments& at);

  /// A share, and what has come of it.
  struct Share {
    ShareTask task;
    bool begun = false;                           ///< here or elsewhere
    std::optional<std::vector<Answers>> answers;  ///< once it has ended: of its SearchShare
  };
  /// A share that nobody has begun, to be run elsewhere, on problem(); null when there is none.
  /// Whoever has its answers puts them there. Until then the search does without: what has not come
  /// when nothing else is left to do, it runs itself.
  std::shared_ptr<Share> lend();
  const MatchProblem& problem() const { return problem_; }

  /// One start or one regrowth. False when the search has ended.
  bool step();
  double fraction() const { return fraction_; }  ///< of the budget, 0..1, never falls
  /// Element distances evaluated here so far, or work that takes as long.
  double spent() const;

  /// The best alignments of the leaders; polished on all edges once the search has ended.
  const Alignments& best() const { return best_; }
  /// Once the search has ended: alignments of the leaders, the best, then a few others that are
  /// good, cheaper ones first.
  std::vector<Alignments> bestFew() const;
  /// No alignment costs less than this share of best(), once a search without slack has ended: 1
  /// when it is proven the best, 0 when nothing is known.
  double bound() const;

 private:
  void split();
  bool isSettled(std::size_t component, std::size_t share) const;
  Share* nextShare();
  void run(Share& share);
  void show(std::size_t component, const Answers& answers);
  void merge();
  void prove();
  void progress();
  double polish(std::size_t component);
  double polished(const Component& c, Alignments& own, const SampledSeams<double>& seams,
                  int iterations) const;
  double proofAllowed(const Component& c) const;
  void endComponent(double cost, double bound);

  const MatchProblem& problem_;
  SearchBudget budget_;  ///< of all shares
  std::uint64_t seed_;
  std::vector<Component> components_;
  SearchSamples samples_;
  SearchMoves moves_;  ///< for what is offered
  double watch_slack_ = 0;
  Alignments best_;
  std::vector<Answers> known_;  ///< per component: from what was offered, at last from all shares
  std::vector<double> shown_;   ///< per component: cost of best_ on the samples; negative: nothing
  std::vector<Alignments> offered_;
  std::vector<std::shared_ptr<Share>> shares_;
  Share* running_ = nullptr;  ///< here, with
  std::unique_ptr<SearchShare> local_;
  double spent_ = 0;         ///< in shares run here before
  std::size_t current_ = 0;  ///< component that is polished or proven
  bool merged_ = false;
  std::unique_ptr<LowerBound> proof_;  ///< at work on the present component
  double proof_spent_ = 0;
  double cost_ = 0, bound_ = 0;  ///< of the components that are done
  double fraction_ = 0;
};

}  // namespace seamwise
