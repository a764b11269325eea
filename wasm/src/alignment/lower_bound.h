#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "alignment/boxes.h"
#include "alignment/sampled_seams.h"
#include "alignment/seam_bound.h"
#include "alignment/search_moves.h"

namespace seamwise {

/// Branch and bound on some seams: boxes of alignments, best first, each with a cost that nothing
/// in it falls below: the sum of the flat bounds of its seams, or of their slopes, which cancel
/// where the answer is in balance. What a pair of boxes says of a seam is found once.
class BoxSearch {
 public:
  /// An answer whose cost exceeds the bound by no more than this share of it is proven.
  static constexpr double kProven = 1e-3;

  /// @param edges   of the same problem, every edge a sample
  /// @param known   alignments of all leaders
  BoxSearch(const MatchProblem& problem, const SampledSeams<double>& edges,
            const std::vector<int>& seams, const Alignments& known);

  /// Splits the box that may hold the best answer.
  void step();

  double bound() const;  ///< no alignment costs less. [cm2]
  bool proven() const;
  double cost() const { return cost_; }             ///< of best(), all edges of the seams. [cm2]
  const Alignments& best() const { return best_; }  ///< `known`, unless a better one was met
  double spent() const { return spent_; }           ///< element distances evaluated
  /// How many halvings all boxes together need, about.
  double effort() const;

 private:
  /// A seam, and what pairs of boxes say of it.
  struct Joint {
    int a, b;  ///< indices of boxes_
    SeamBound bound;
    std::vector<SeamBound::Pair> pairs;
    std::unordered_map<std::uint64_t, int> known;  ///< boxes of both sides -> pair
  };
  struct Node {
    double bound;
    std::vector<int> boxes;                                                  ///< of each leader
    std::vector<int> pairs;                                                  ///< of each joint
    bool operator<(const Node& other) const { return bound > other.bound; }  // least on the heap
  };

  int pairOf(Joint& joint, int a, int b);
  double boundOf(const Node& node) const;
  int choice(const Node& node) const;
  double costAt(const Alignments& at) const;
  void descend(const Node& node);

  const MatchProblem& problem_;
  const SampledSeams<double>& edges_;
  std::vector<Boxes> boxes_;
  std::vector<Joint> joints_;
  std::vector<Node> open_;  ///< a heap
  Alignments best_;
  double cost_ = 0, spent_ = 0, descents_ = 0;
};

/// Proves how good an alignment of a component is: by a box search on all its seams, and by one for
/// each two leaders on the seams that join them; no alignment costs less than the sum of the
/// latter. Anytime: the bound is valid after every step, and nearly always 0 at first. Work is
/// counted in distance evaluations, never in seconds, so that results do not depend on the machine.
class LowerBound {
 public:
  /// @param known   alignments of all leaders; those outside the component stay where they are
  LowerBound(const MatchProblem& problem, const Component& component, const Alignments& known);
  LowerBound(const LowerBound&) = delete;
  LowerBound& operator=(const LowerBound&) = delete;

  /// One box of the whole or of a part. False when the answer is proven.
  bool step();

  /// No alignment of the component costs less than this. At most cost(). [cm2]
  double bound() const;
  /// Whether best() costs at most BoxSearch::kProven more than it has to, or next to nothing.
  bool proven() const;
  /// `known`, unless a better answer was met on the way: then whoever searched should go on there.
  const Alignments& best() const { return whole_.best(); }
  double cost() const { return whole_.cost(); }  ///< of best(), all edges of the component. [cm2]
  double spent() const;                          ///< element distances evaluated

 private:
  SampledSeams<double> edges_;
  BoxSearch whole_;
  std::vector<BoxSearch> parts_;
};

}  // namespace seamwise
