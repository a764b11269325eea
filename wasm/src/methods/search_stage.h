#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "alignment/search/search_memo.h"
#include "problem/problem.h"

namespace seamwise {

/// Seeks the alignments of the drafted pattern, in up to five searches that pass their answers on.
/// The first one is for the garment with its known symmetry, if not all of it is imposed. The next
/// is for the garment alone, on the straightened print, followed by one under slack near that
/// answer. The last two repeat both with the weights and pins of the options, on the print as
/// given, if that makes a difference. A change of a weight, a pin or the print's turn thus reuses
/// most of the work. Reusing it does not change the answer.
class SearchStage {
 public:
  /// @param pattern   with the weights of the options
  /// @param match     its seams and leaders, with pins
  /// @param slack     mismatch that shapes can take up, cm
  /// @param offered   alignments of all pieces: the last search at rest ends no worse than any of
  ///                  them, nor than the drafted layout
  SearchStage(const Problem& problem, const Pattern& pattern, const MatchProblem& match,
              const std::vector<Mirror>& known, const MatchRules& rules, double slack,
              std::vector<Alignments> offered, SearchMemo& memo);

  /// Works for some milliseconds. Returns false when the stage has ended.
  bool advance();
  /// The current search; null when there is none.
  AlignmentSearch* searching() { return searching_.get(); }
  /// Starts one more search under slack, with other weights, after the stage has ended.
  /// underSlack() then has the answers of that search.
  /// @param factors   per seam: multiple of its weight
  void seekAgain(const std::vector<double>& factors);
  double fraction() const { return fraction_; }  ///< 0..1, never falls
  /// Usual share in the time of a whole solve; less once outcomes are found in the memo.
  double share() const { return share_; }
  /// Returns whether the print meets everywhere with the drafted pieces.
  bool isPerfect() const { return perfect_; }

  /// The best alignments of the leaders so far, with pins; the best at rest once the stage has
  /// ended.
  const Alignments& best() const { return best_; }
  /// The best few alignments of the leaders at rest, best first, once the stage has ended.
  const std::vector<Alignments>& atRest() const { return few_at_rest_; }
  /// The best few alignments of the leaders under slack, best first; the one at rest if no shape
  /// has to change.
  const std::vector<Alignments>& underSlack() const { return under_slack_; }
  /// No alignment at rest costs less than this share of the best: 1 when it is proven.
  double bound() const { return bound_; }

 private:
  struct Search {
    MatchProblem problem;
    SearchBudget budget;
    std::uint64_t seed;
    double share;                    ///< share of the time of a whole solve
    std::vector<std::size_t> after;  ///< searches whose answers are among its starts
    double slack = 0;                ///< cm
    double turn = 0;         ///< turn of the print as given, relative to this problem's. [rad]
    bool requested = false;  ///< its answer at rest is the result's
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
  std::optional<SearchMemo::Inputs> inputs_;  ///< inputs of the current search
  Alignments best_;
  std::vector<Alignments> few_at_rest_, under_slack_;
  /// Answers of each search: its best and its watched one, of all pieces on its own print.
  std::vector<std::vector<Alignments>> found_;
  bool perfect_ = false;
  double bound_ = 0;
  std::size_t at_rest_ = 0;  ///< the last search without slack
  double share_ = 0, before_ = 0, fraction_ = 0;
};

}  // namespace seamwise
