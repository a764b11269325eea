#pragma once
#include <deque>
#include <map>
#include <vector>

#include "pattern/breakpoints.h"

namespace seamwise {

/// A place on a loop where there must be a vertex.
struct Node {
  int loop = 0;
  double position = 0;  ///< cm, in [0, length)
  bool pinned = false;  ///< a corner or an axis crossing: it stays where it is
  bool within = false;  ///< a corner within a path
};

/// A seam, or a mirror's tie between two loops (or of one with itself), as a matching of nodes that
/// keeps their order. Both sides are stretches of loops with a coordinate that runs from 0 to
/// `length` in corresponding sense; the ends correspond. Once round a loop, both ends are one node.
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

  /// Adds counterparts until every node has one in every tie; false when that needs more than
  /// `most` nodes.
  bool close(double tolerance, std::size_t most);
  /// Moves free nodes so that tied intervals have like proportions.
  void settle();

  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<int>& order(int loop) const { return order_[loop]; }
  const std::vector<Tie>& ties() const { return ties_; }

 private:
  /// Neighbouring matched pairs around a place: coordinates on the place's side and on the other.
  struct Bracket {
    double at = 0, low = 0, high = 0, other_low = 0, other_high = 0;
  };

  /// Where a tie demands a node between its neighbours: as the counterparts lie, seen in `sense`.
  struct Demand {
    int before, at, after;
    double sense;
    const Loop* loop;  ///< of all three
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
  std::vector<std::vector<int>> order_;                    // per loop: nodes by position
  std::vector<Tie> ties_;                                  // seams, then mirrors
  std::vector<std::vector<std::pair<int, int>>> ties_of_;  // per loop: (tie, side)
  std::deque<int> open_;                                   // nodes that may lack counterparts
};

}  // namespace seamwise
