#pragma once
#include <vector>

namespace seamwise {

/// Costs of pairs of boxes, of two leaders: rows of the pairs that are left.
struct PairTable {
  int row, column;                 ///< the leaders
  std::vector<int> begin;          ///< first entry of each row, and the end
  std::vector<int> to;             ///< the column of an entry
  std::vector<float> cost, least;  ///< of an entry; as Elimination::least
  int entries() const { return static_cast<int>(to.size()); }
};

/// The least sum of costs over all ways to choose a box for each leader, by eliminating one leader
/// after another: what the rest costs at least becomes a cost of its neighbours' boxes. Leaders of
/// three and more neighbours are eliminated as if they could choose for two of them at a time,
/// which makes the sum a bound from below. Then, backwards, the least sum that each entry of a
/// table has a part in.
class Elimination {
 public:
  static constexpr float kNone = 1e30f;  ///< nothing left to choose

  /// @param sizes   about how many boxes the leaders have
  /// @param joined   which tables there are; others follow, for what elimination joins
  Elimination(const std::vector<double>& sizes, const std::vector<std::pair<int, int>>& joined);

  std::vector<PairTable> tables;          ///< rows of the one that is eliminated later
  std::vector<std::vector<float>> alone;  ///< costs of each leader's boxes
  std::vector<std::vector<float>> least;  ///< per box, a lower bound of any total that uses it

  /// Begins anew with the present costs, which it changes.
  void begin();
  /// Goes on until `spent` has grown by `work`. False at the end.
  bool step(double work, double& spent);
  /// The least sum.
  double total() const { return total_; }

 private:
  /// A leader and the neighbours for which it chooses, -1 if it has none; its cost alone is part of
  /// one cluster only.
  struct Cluster {
    int leader, x, y;
    int x_table, y_table, between;  ///< rows of x, of y, and of y by x
    bool alone;
    std::vector<float> message;  ///< to `between` or to x
  };
  int tableOf(int a, int b);
  int rowsOf(const Cluster& c) const;
  double forward(Cluster& c, int row);
  double backward(Cluster& c, int row);

  std::vector<int> rank_;  ///< of the leaders in the order of elimination
  std::vector<Cluster> clusters_;
  std::vector<float> reached_, passed_;  ///< of one row
  std::size_t done_ = 0;                 ///< clusters, forwards and then backwards
  int row_ = 0;
  double total_ = 0;
};

}  // namespace seamwise
