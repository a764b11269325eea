#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "alignment/bound/lower_bound.h"
#include "alignment/search/search_share.h"

namespace seamwise {

/// Finds alignments that no local iteration finds. Starts grow along random spanning trees of the
/// seam graph, each seam continuous or mirrored, and a joint Newton iteration improves them. Random
/// parts of the best answer are then regrown, and single pieces moved, while that helps. Components
/// of the seam graph are searched one by one, on samples of the seams, in independent shares. These
/// may run elsewhere with the same outcome. Finally, the best few answers are compared on all
/// edges, and the cost of the best one is bounded from below. Anytime: best() is valid after the
/// first step.
class AlignmentSearch {
 public:
  /// @param slack   see SampledSeams::cost; distances up to it are nearly free
  AlignmentSearch(const MatchProblem& problem, std::uint64_t seed, SearchBudget budget,
                  double slack = 0);

  /// Also stores the best answer under this slack among those found. [cm] Set before the first
  /// step.
  void watch(double slack) { watch_slack_ = slack; }
  /// The answer for watch(), of the leaders.
  Alignments watched() const;

  /// Adds an answer from elsewhere (of the leaders; made admissible), before the first step. The
  /// search never ends with a worse one.
  void offer(const Alignments& at);

  /// A share and its answers.
  struct Share {
    ShareTask task;
    bool begun = false;                           ///< started here or elsewhere
    std::optional<std::vector<Answers>> answers;  ///< answers of its SearchShare, once it has ended
  };
  /// Returns a share that has not begun, to be run elsewhere on problem(); null when there is none.
  /// The borrower stores its answers there. The search does without until then. It runs lent shares
  /// itself once nothing else is left to do.
  std::shared_ptr<Share> lend();
  const MatchProblem& problem() const { return problem_; }

  /// Takes one start or one regrowth. Returns false when the search has ended.
  bool step();
  double fraction() const { return fraction_; }  ///< share of the budget, 0..1, never falls
  /// Number of element distances evaluated here so far, or equivalent work.
  double spent() const;

  /// The best alignments of the leaders; polished on all edges once the search has ended.
  const Alignments& best() const { return best_; }
  /// The best alignments of the leaders, then a few other good ones, cheaper ones first, once the
  /// search has ended.
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
  SearchBudget budget_;  ///< budget of all shares
  std::uint64_t seed_;
  std::vector<Component> components_;
  SearchSamples samples_;
  SearchMoves moves_;  ///< moves for offered answers
  double watch_slack_ = 0;
  Alignments best_;
  std::vector<Answers> known_;  ///< per component: from offered answers, finally from all shares
  std::vector<double> shown_;   ///< per component: cost of best_ on the samples; negative: none
  std::vector<Alignments> offered_;
  std::vector<std::shared_ptr<Share>> shares_;
  Share* running_ = nullptr;  ///< the share that local_ runs here
  std::unique_ptr<SearchShare> local_;
  double spent_ = 0;         ///< work of earlier shares run here
  std::size_t current_ = 0;  ///< component being polished or proven
  bool merged_ = false;
  std::unique_ptr<LowerBound> proof_;  ///< proof for the current component
  double proof_spent_ = 0;
  double cost_ = 0, bound_ = 0;  ///< sums of the components that are done
  double fraction_ = 0;
};

}  // namespace seamwise
