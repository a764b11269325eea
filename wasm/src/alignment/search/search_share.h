#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "alignment/search/search_moves.h"
#include "tuning/search.h"

namespace seamwise {

/// What is known of a component. Costs are those of samples of the seams. [cm2]
struct Answers {
  std::vector<std::pair<double, Alignments>>
      few;                   ///< the best, of its leaders; all differ, cheapest first
  double watched_cost = -1;  ///< negative: nothing was watched
  Alignments watched;        ///< of its leaders

  double cost() const { return few.empty() ? -1 : few.front().first; }  ///< negative: nothing yet
  /// @param perfect   as in SearchMoves, here and below
  bool isPerfect(double perfect) const { return !few.empty() && cost() < perfect; }
  /// Adds an answer, unless it is the same as one that costs less or none of the best.
  void add(double cost, const Alignments& own, double perfect);
  void watch(double cost, const Alignments& own);
  void add(const Answers& others, double perfect);
};

/// All that a share depends on besides its problem.
struct ShareTask {
  SearchBudget budget;  ///< of the share alone
  std::uint64_t seed = 0;
  double slack = 0;    ///< as in SampledSeams::cost
  double watched = 0;  ///< slack under which the best answer met is remembered as well; 0: none
  Alignments at;       ///< of the leaders: what to begin with
  std::vector<Answers> known;  ///< per component; what is perfect is left as it is
};

/// One sequence of starts and regrowths in each component, that knows of no other. Its outcome
/// depends on its task alone, wherever it runs.
class SearchShare {
 public:
  /// @param components   those of the problem
  /// @param samples   of the problem, by the task's budget
  SearchShare(const MatchProblem& problem, const std::vector<Component>& components,
              const SearchSamples& samples, ShareTask task);

  /// One start or one regrowth. False when the share has ended.
  bool step();
  double fraction() const;  ///< 0..1
  double spent() const;     ///< element distances, or work that takes as long
  /// Per component; valid at any time, complete once the share has ended.
  const std::vector<Answers>& answers() const { return task_.known; }
  std::size_t current() const { return current_; }  ///< component at work

 private:
  void next();
  void keep(const Component& c, const Layout& layout, double cost);
  Alignments startFrom(const Component& c, bool anew);
  void lay(const Component& part, bool anew, const std::vector<char>& fresh, Layout& layout);

  const MatchProblem& problem_;
  const std::vector<Component>& components_;
  const SearchSamples& samples_;
  ShareTask task_;
  Random seeds_;                      ///< of the components: each has random numbers of its own
  std::optional<SearchMoves> moves_;  ///< in the component at work
  std::size_t current_ = 0;
  int starts_ = 0, idle_ = 0;
  int hits_ = 0;         ///< starts from nothing that ended at the best answer
  double allowed_ = 0;   ///< distances in this component
  double patience_ = 0;  ///< steps without gain
  double spent_ = 0;     ///< in the components before
  double share_ = 0;     ///< of the component at work that is done
};

/// The samples of the seams that a search with this budget looks at.
SearchSamples searchSamples(const MatchProblem& problem, const SearchBudget& budget);

/// Distances that a search with this budget may evaluate in a component.
double allowedIn(const Component& component, const SearchBudget& budget);

}  // namespace seamwise
