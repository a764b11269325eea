#pragma once
#include <vector>

#include "alignment/model/component.h"
#include "alignment/model/sampled_seams.h"
#include "base/random.h"
#include "tuning/search.h"

namespace seamwise {

/// An answer under construction.
struct Layout {
  Alignments at;  ///< alignments of the leaders
  std::vector<SearchSamples::Pose> poses;
};

/// The moves of a search from one answer to others. All costs are those of samples of the seams.
/// [cm2]
class SearchMoves {
 public:
  /// @param slack   see SampledSeams::cost
  SearchMoves(const MatchProblem& problem, const SearchSamples& samples, std::uint64_t seed,
              double slack);

  Layout layoutOf(const Alignments& at) const;
  double costOf(const Component& c, const Layout& layout, double slack);
  /// The cost of all seams at a distance of SearchTuning::kPerfectDistance.
  static double perfect(const SearchSamples& samples) {
    return SearchTuning::kPerfectDistance * samples.weight();
  }
  double perfect() const { return perfect(samples_); }
  double slack() const { return slack_; }

  /// A random connected part of a component, up to half of it.
  std::vector<int> randomPart(const Component& c);
  void layAnywhere(int leader, Layout& layout);
  /// Places the remaining leaders along a random spanning tree of the seams.
  void grow(const Component& c, Layout& layout, std::vector<char>& placed);
  /// Polishes an answer whose `fresh` leaders are new: cheaply at first, and further only while it
  /// may become better than `known` (negative: nothing is known). Returns its cost.
  double improve(const Component& c, Layout& layout, std::vector<char> fresh, double known);

  double uniform() { return random_.uniform(); }
  int below(int n) { return random_.below(n); }
  /// Number of element distances evaluated so far.
  double spent() const { return spent_; }

 private:
  void set(Layout& layout, int leader, const Alignment& at) const;
  void place(int leader, Layout& layout, std::vector<char>& placed);
  double costAt(const Alignment& at, int leader, const Layout& layout,
                const std::vector<char>* placed, double bound);
  double refined(Layout& layout, const std::vector<int>& leaders, int iterations);
  bool moveSingles(const Component& c, Layout& layout, std::vector<char>& fresh);

  const MatchProblem& problem_;
  const SearchSamples& samples_;
  double slack_, sample_cost_;
  Random random_;
  double spent_ = 0;
};

}  // namespace seamwise
