#pragma once
#include <vector>

namespace seamwise {

/// Costs of the remaining pairs of boxes of two leaders, by rows.
struct PairTable {
  int row, column;                 ///< the leaders
  std::vector<int> begin;          ///< first entry of each row, and the end
  std::vector<int> to;             ///< column of each entry
  std::vector<float> cost, least;  ///< per entry; `least` as in Elimination
  int entries() const { return static_cast<int>(to.size()); }
};

/// The least sum of costs over all choices of one box per leader, by eliminating one leader after
/// another. The least cost of an eliminated leader becomes a cost of its neighbours' boxes. A
/// leader with three or more neighbours is eliminated as if it could choose for two of them at a
/// time, which makes the sum a lower bound. A backward pass then finds the least sum that contains
/// each entry of a table.
class Elimination {
 public:
  static constexpr float kNone = 1e30f;  ///< no choice remains

  /// @param sizes   approximate numbers of the leaders' boxes
  /// @param joined   pairs of leaders with a table; elimination adds tables for others
  Elimination(const std::vector<double>& sizes, const std::vector<std::pair<int, int>>& joined);

  std::vector<PairTable> tables;          ///< rows are those of the leader that is eliminated later
  std::vector<std::vector<float>> alone;  ///< costs of each leader's boxes
  std::vector<std::vector<float>> least;  ///< per box, a lower bound of any total that uses it

  /// Restarts with the current costs, which it changes.
  void begin();
  /// Continues until `spent` has grown by `work`. Returns false at the end.
  bool step(double work, double& spent);
  /// The least sum.
  double total() const { return total_; }

 private:
  /// A leader and the neighbours for which it chooses, -1 if it has none. Its own cost is part of
  /// one cluster only.
  struct Cluster {
    int leader, x, y;
    int x_table, y_table, between;  ///< indices of tables: rows of x, of y, and of y by x
    bool alone;
    std::vector<float> message;  ///< costs passed to `between` or to x
  };
  int tableOf(int a, int b);
  int rowsOf(const Cluster& c) const;
  double forward(Cluster& c, int row);
  double backward(Cluster& c, int row);

  std::vector<int> rank_;  ///< per leader: its rank in the order of elimination
  std::vector<Cluster> clusters_;
  std::vector<float> reached_, passed_;  ///< sums of the current row
  std::size_t done_ = 0;                 ///< number of clusters done, forwards and then backwards
  int row_ = 0;
  double total_ = 0;
};

}  // namespace seamwise
