#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "alignment/search/search_memo.h"
#include "problem/problem.h"

namespace seamwise {

/// Seeks the alignments of the pattern as drafted, in up to five searches that hand on what they
/// find: of the garment with its known symmetry, where not all of it is imposed; of the garment by
/// itself, on the print lying straight, and of what comes near there once seams may move; then both
/// again with the weights and pins of the options, on the print as it lies, where that makes a
/// difference. So whoever changes a weight, a pin or the print's turn has most of it done already,
/// and comes to the same answer as who has not.
class SearchStage {
 public:
  /// @param pattern   with the weights of the options
  /// @param match     its seams and leaders, with pins
  /// @param slack     cm of mismatch that shapes may take up
  /// @param offered   of all pieces: the last search at rest ends no worse than any of them, nor
  ///                  than the drafted layout
  SearchStage(const Problem& problem, const Pattern& pattern, const MatchProblem& match,
              const std::vector<Mirror>& known, const MatchRules& rules, double slack,
              std::vector<Alignments> offered, SearchMemo& memo);

  /// Some milliseconds of work. False when it has ended.
  bool advance();
  /// The search at work; null when there is none.
  AlignmentSearch* searching() { return searching_.get(); }
  /// Once it has ended: seeks once more what comes near when seams may move, with other weights.
  /// underSlack() is of that search then.
  /// @param factors   per seam: multiple of its weight
  void seekAgain(const std::vector<double>& factors);
  double fraction() const { return fraction_; }  ///< 0..1, never falls
  /// What it takes as a rule, as a share of the time of a whole solve; less once something turns
  /// out to be remembered.
  double share() const { return share_; }
  /// Whether the print meets everywhere as the pieces lie.
  bool isPerfect() const { return perfect_; }

  /// The best alignments of the leaders so far, with pins; once it has ended, the best at rest.
  const Alignments& best() const { return best_; }
  /// The best few alignments of the leaders at rest, once it has ended, the very best first.
  const std::vector<Alignments>& atRest() const { return few_at_rest_; }
  /// The best few alignments of the leaders under slack, the very best first; the one at rest when
  /// nothing has to move.
  const std::vector<Alignments>& underSlack() const { return under_slack_; }
  /// No alignment at rest costs less than this share of the best: 1 when it is proven.
  double bound() const { return bound_; }

 private:
  struct Search {
    MatchProblem problem;
    SearchBudget budget;
    std::uint64_t seed;
    double share;                    ///< of the time of a whole solve, once all are known
    std::vector<std::size_t> after;  ///< searches whose answers it begins with
    double slack = 0;                ///< cm
    double turn = 0;                 ///< of the print as it lies, against this problem's. [rad]
    bool requested = false;          ///< its answer at rest is the result's
  };
  void begin();
  void limit(Search& search) const;
  void end(const SearchMemo::Outcome& outcome);
  Alignments placed(const Search& search, const Alignments& leaders) const;

  const Problem& problem_;
  const MatchProblem& match_;
  double slack_;
  std::vector<Alignments> offered_;
  SearchMemo& memo_;
  std::vector<Search> searches_;
  std::size_t current_ = 0;
  std::unique_ptr<AlignmentSearch> searching_;
  std::optional<SearchMemo::Inputs> inputs_;  ///< of the search at work
  Alignments best_;
  std::vector<Alignments> few_at_rest_, under_slack_;
  /// By each search: its best and what it watched, of the pieces on its own print.
  std::vector<std::vector<Alignments>> found_;
  bool perfect_ = false;
  double bound_ = 0;
  std::size_t at_rest_ = 0;  ///< the last search that was without slack
  double share_ = 0, before_ = 0, fraction_ = 0;
};

}  // namespace seamwise
