#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "alignment/lower_bound.h"
#include "alignment/search_moves.h"

namespace seamwise {

/// How long to look, for a print of up to four symmetries besides its shifts; for one of more, the
/// search takes longer. Counted in distance evaluations, never in seconds, so that results do not
/// depend on the machine.
struct SearchBudget {
  int trees = 40;  ///< spanning-tree starts for each component, at least
  int idle = 12;   ///< stop after so many steps without gain, for each free piece and four more
  int hits = 8;    ///< or after so many starts that ended at the same, best answer
  double evaluations = 5e6;  ///< stop after so many element distances for each free piece
  double samples = 12;       ///< along the print's shortest repeat, while searching
  /// Work for a proof that nothing better is left, as a share of `evaluations`; unset: a little,
  /// where that may be enough.
  std::optional<double> proof;
  bool operator==(const SearchBudget&) const = default;
};

/// Finds alignments that no local iteration finds: starts grown along random spanning trees of the
/// seam graph, each seam continuous or mirrored, polished by a joint Newton; then random parts of
/// the best are regrown and single pieces moved while that helps. Components of the seam graph are
/// searched one by one, on samples of the seams; the best few answers are compared on all edges at
/// the end, and the best one's cost is bounded from below. Anytime: best() is valid after the first
/// step.
class AlignmentSearch {
 public:
  /// @param slack   as in SampledSeams::cost: distances up to it are nearly free
  AlignmentSearch(const MatchProblem& problem, std::uint64_t seed, SearchBudget budget,
                  double slack = 0);

  /// Also remembers which of the answers met on the way is best under this slack.
  void watch(double slack) { watch_slack_ = slack; }
  const Alignments& watched() const { return watched_; }

  /// Adds an answer found elsewhere (of the leaders; made admissible). The search never ends with a
  /// worse one.
  void offer(const Alignments& at);

  /// One start or one regrowth. False when the search has ended.
  bool step();
  double fraction() const { return fraction_; }  ///< of the budget, 0..1, never falls
  /// Element distances evaluated so far, or work that takes as long.
  double spent() const;

  /// Of the leaders, polished on all edges once the search has ended.
  const Alignments& best() const { return best_; }
  /// Once the search has ended: the best, then a few others that are good, cheaper ones first.
  std::vector<Alignments> bestFew() const;
  /// No alignment costs less than this share of best(), once a search without slack has ended: 1
  /// when it is proven the best, 0 when nothing is known.
  double bound() const;

 private:
  /// A component and what is known of it.
  struct Searched : Component {
    double cost = -1;  ///< of best_ on the samples; negative: nothing yet
    double watched_cost = -1;
    std::vector<std::pair<double, Alignments>> finalists;  ///< by cost; of its leaders
    int starts = 0, idle = 0;
    int hits = 0;  ///< starts from nothing that ended at the best answer
    double spent = 0, allowed = 0;
    double patience = 0;  ///< steps without gain
  };
  void findComponents();
  void keep(Searched& c, const Layout& layout, double cost);
  Alignments before(const Searched& c);
  double polish(Searched& c);
  void progress(double share);
  void endProof(const Searched& c);
  bool endComponent();
  double proofAllowed(const Searched& c) const;
  double polished(const Searched& c, Alignments& own, const SampledSeams<double>& seams,
                  int iterations) const;

  const MatchProblem& problem_;
  SearchBudget budget_;
  SearchMoves moves_;
  double watch_slack_ = 0;
  std::vector<Searched> components_;
  std::size_t current_ = 0;
  Alignments best_, watched_;
  std::vector<Alignments> offered_;
  std::unique_ptr<LowerBound> proof_;  ///< at work on the present component
  double proof_spent_ = 0;
  double cost_ = 0, bound_ = 0;  ///< of the components that are done
  bool done_ = false;
  double fraction_ = 0;
};

}  // namespace seamwise
