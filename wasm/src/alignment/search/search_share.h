#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "alignment/search/search_moves.h"
#include "tuning/search.h"

namespace seamwise {

/// Known answers of a component. Costs are those of samples of the seams. [cm2]
struct Answers {
  std::vector<std::pair<double, Alignments>>
      few;                   ///< the best answers of its leaders; all differ, cheapest first
  double watched_cost = -1;  ///< negative: no watched answer
  Alignments watched;        ///< watched answer of its leaders

  double cost() const { return few.empty() ? -1 : few.front().first; }  ///< negative: no answer yet
  /// @param perfect   see SearchMoves, here and below
  bool isPerfect(double perfect) const { return !few.empty() && cost() < perfect; }
  /// Adds an answer, unless it is the same as a cheaper one or not among the best.
  void add(double cost, const Alignments& own, double perfect);
  void watch(double cost, const Alignments& own);
  void add(const Answers& others, double perfect);
};

/// All inputs of a share besides its problem.
struct ShareTask {
  SearchBudget budget;  ///< budget of the share alone
  std::uint64_t seed = 0;
  double slack = 0;    ///< see SampledSeams::cost
  double watched = 0;  ///< slack for the watched answer, the best one found under it; 0: none
  Alignments at;       ///< alignments of the leaders at the start
  std::vector<Answers> known;  ///< per component; perfect ones stay unchanged
};

/// One independent sequence of starts and regrowths in each component. Its outcome depends on its
/// task alone, wherever it runs.
class SearchShare {
 public:
  /// @param components   those of the problem
  /// @param samples   of the problem, by the task's budget
  SearchShare(const MatchProblem& problem, const std::vector<Component>& components,
              const SearchSamples& samples, ShareTask task);

  /// Takes one start or one regrowth. Returns false when the share has ended.
  bool step();
  double fraction() const;  ///< 0..1
  double spent() const;     ///< number of element distances, or equivalent work
  /// Answers per component; valid at any time, complete once the share has ended.
  const std::vector<Answers>& answers() const { return task_.known; }
  std::size_t current() const { return current_; }  ///< current component

 private:
  void next();
  void keep(const Component& c, const Layout& layout, double cost);
  Alignments startFrom(const Component& c, bool anew);
  void lay(const Component& part, bool anew, const std::vector<char>& fresh, Layout& layout);

  const MatchProblem& problem_;
  const std::vector<Component>& components_;
  const SearchSamples& samples_;
  ShareTask task_;
  Random seeds_;                      ///< seeds of the components, one for each
  std::optional<SearchMoves> moves_;  ///< moves in the current component
  std::size_t current_ = 0;
  int starts_ = 0, idle_ = 0;
  int hits_ = 0;         ///< starts from nothing that ended at the best answer
  double allowed_ = 0;   ///< number of distances allowed in this component
  double patience_ = 0;  ///< number of steps allowed without gain
  double spent_ = 0;     ///< work in previous components
  double share_ = 0;     ///< finished share of the current component
};

/// The samples of the seams for a search with this budget.
SearchSamples searchSamples(const MatchProblem& problem, const SearchBudget& budget);

/// Number of distances that a search with this budget may evaluate in a component.
double allowedIn(const Component& component, const SearchBudget& budget);

}  // namespace seamwise
