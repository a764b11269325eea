#pragma once
#include <deque>
#include <map>
#include <vector>

#include "pattern/breakpoints.h"

namespace seamwise {

/// A position on a loop that requires a vertex.
struct Node {
  int loop = 0;
  double position = 0;  ///< cm, in [0, length)
  bool pinned = false;  ///< a corner or an axis crossing, which does not move
  bool within = false;  ///< a corner within a path
};

/// A seam, or a mirror's tie between two loops (or of one with itself), as an order-preserving
/// matching of nodes. Both sides are stretches of loops with a coordinate that runs from 0 to
/// `length` in corresponding sense; the ends correspond. If a side is a whole loop, both its ends
/// are the same node.
struct Tie {
  struct Side {
    int loop = 0;
    double origin = 0, sense = 1, length = 0;
    int first = -1, last = -1;  ///< nodes at the ends
  };
  Side side[2];
  bool mirror = false;
  bool self = false;  ///< both sides are the same loop; counterparts are mutual
  std::map<int, int> counterpart[2];
};

/// The nodes of all loops, in order, and their ties.
class TiedNodes {
 public:
  explicit TiedNodes(const Outlines& outlines);

  /// Adds counterparts until every node has one in every tie. Returns false if that needs more than
  /// `most` nodes.
  bool close(double tolerance, std::size_t most);
  /// Moves free nodes so that tied intervals have equal proportions.
  void settle();

  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<int>& order(int loop) const { return order_[loop]; }
  const std::vector<Tie>& ties() const { return ties_; }

 private:
  /// The matched pairs before and after a node: their coordinates on the node's side and on the
  /// other side.
  struct Bracket {
    double at = 0, low = 0, high = 0, other_low = 0, other_high = 0;
  };

  /// The position between its neighbours that a tie demands of a node: that of its counterpart
  /// between theirs, in direction `sense`.
  struct Demand {
    int before, at, after;
    double sense;
    const Loop* loop;  ///< loop of all three
  };

  const Loop& loopOf(int loop) const { return outlines_->loops[loop].loop; }
  int add(int loop, double position, bool pinned);
  double coordinate(const Tie::Side& side, int node) const;
  bool holds(const Tie::Side& side, int node) const;
  int counterpart(const Tie& tie, int side, int node) const;
  void match(Tie& tie, int side, int node, int other);
  std::size_t indexAt(int loop, double position) const;
  Bracket bracketOf(const Tie& tie, int side, int node) const;
  int nearestTo(const Tie::Side& side, double x, double reach, const Bracket& b) const;
  void place(Tie& tie, int side, int node, double tolerance, const double* wanted);
  void addSeam(const Stitch& stitch);
  void addMirror(const LoopTie& mirror);
  void anchor(Tie& tie, const Correspondence& map, double tolerance);
  Demand demandOf(const Tie& tie, int side, int before, int node, int after) const;

  const Outlines* outlines_;
  std::vector<Node> nodes_;
  std::vector<std::vector<int>> order_;                    // nodes per loop, by position
  std::vector<Tie> ties_;                                  // seams, then mirrors
  std::vector<std::vector<std::pair<int, int>>> ties_of_;  // per loop: (tie, side)
  std::deque<int> open_;                                   // nodes that may lack counterparts
};

}  // namespace seamwise
