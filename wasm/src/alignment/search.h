#pragma once
#include <vector>

#include "alignment/matching.h"
#include "geometry/random.h"

namespace seamwise {

/// How long to look. Counted in distance evaluations, never in seconds, so that results do not depend on
/// the machine.
struct SearchBudget {
  int trees = 12;          ///< spanning-tree starts for each free piece's component, at least
  int idle = 20;           ///< stop after so many regrowths without gain, for each free piece
  double evaluations = 5e6;  ///< stop after so many element distances for each free piece
  int samples = 16;        ///< points a seam while searching; the end is polished on all
};

/// Finds alignments that no local iteration finds: starts grown along random spanning trees of the seam
/// graph, each seam continuous or mirrored, polished by a joint Newton; then random parts of the best
/// are regrown and single pieces moved while that helps. Components of the seam graph are searched one
/// by one. Anytime: best() is valid after the first step.
class AlignmentSearch {
 public:
  /// @param slack   as in MatchProblem::seamCost: distances up to it are nearly free
  AlignmentSearch(const MatchProblem& problem, std::uint64_t seed, SearchBudget budget,
                  double slack = 0);

  /// Also remembers which of the answers met on the way is best under this slack.
  void watch(double slack) { watch_slack_ = slack; }
  const Alignments& watched() const { return watched_; }

  /// Adds an answer found elsewhere (of the leaders; made admissible).
  void offer(const Alignments& at);

  /// One start or one regrowth. False when the search has ended.
  bool step();
  double fraction() const;  ///< of the budget, 0..1, monotone

  /// Of the leaders, polished on all samples once the search has ended.
  const Alignments& best() const { return best_; }
  double bestCost() const { return full_.cost(best_, slack_); }

 private:
  struct Component {
    std::vector<int> leaders;
    double cost = -1;  ///< of best_ on the coarse problem; negative: nothing yet
    double watched_cost = -1;
    int starts = 0, idle = 0;
    double spent = 0, allowed = 0;
  };
  void findComponents();
  void grow(const Component& c, Alignments& at, std::vector<char>& placed);
  void place(int leader, Alignments& at, std::vector<char>& placed);
  double refined(Alignments& at, const std::vector<int>& leaders, int iterations);
  double improve(const Component& c, Alignments& at);
  bool moveSingles(const Component& c, Alignments& at);
  std::vector<double> costsOf(const std::vector<Alignment>& choices, int leader,
                              const Alignments& at, const std::vector<char>* placed);
  double componentCost(const Component& c, const Alignments& at, double slack) const;
  void keep(Component& c, const Alignments& at, double cost);
  void polish();

  const MatchProblem& full_;
  MatchProblem coarse_;
  SearchBudget budget_;
  double slack_, watch_slack_ = 0, sample_cost_;
  Random random_;
  std::vector<Component> components_;
  std::size_t current_ = 0;
  double spent_ = 0;
  Alignments best_, watched_;
  bool done_ = false;
};

}  // namespace seamwise
