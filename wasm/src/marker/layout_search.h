#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "base/random.h"
#include "marker/layout.h"

namespace seamwise {

/// Searches for short layouts on a fabric. Pieces are first placed one by one, each as low as
/// possible. Then the fabric is shortened, and overlapping pieces move, one at a time, to the
/// position with the least weighted sum of overlaps with all others. Weights of overlapping pairs
/// grow, as in guided local search [Umetani et al. 2009; Gardeyn and Wauters 2025].
class LayoutSearch {
 public:
  LayoutSearch(const PiecesOnBoard& pieces, LayFabric fabric, std::uint64_t seed);

  const LayFabric& fabric() const { return fabric_; }
  /// Places one more piece of a layout, in a sequence of orders and start heights. Returns false if
  /// there are no more orders or a piece does not fit.
  bool construct();
  /// Makes one sweep of moves. Returns false if the domains alone exclude a shorter layout.
  bool improve();
  /// Replaces the best layout by one found elsewhere if that is shorter.
  void offer(const LaidPieces& layout);

  const std::optional<LaidPieces>& best() const { return best_; }
  /// An item that does not fit into a window of any length; -1 if there is none.
  int homeless() const { return homeless_; }
  /// Number of table reads so far.
  double reads() const { return reads_; }

 private:
  /// An obstacle for a piece, and its weight.
  struct Other {
    const DifferenceTable* table;
    Dot dot;
    float weight;
  };
  /// All obstacles for a piece, for lookups of single dots. `boxes` contains the bounds of their
  /// tables on the board in groups of four: first columns, first rows, last columns, last rows.
  struct Neighbours {
    std::vector<Other> others;
    std::vector<int> boxes;
  };
  struct Found {
    LayPlace place;
    float score;
  };

  void shuffle(std::vector<int>* items);
  void setWindow(double bottom, double length);
  bool begin();
  void closeUp(double by);
  void restart();
  void swapTwo();
  void takeUp(const std::vector<LayPlace>& places);
  bool isGivenUp();
  void sweep();
  std::vector<Other> othersOf(int item, int placed, bool weighted) const;
  void scoreRow(const std::vector<Other>& others, int j, const DotRun& run);
  Found leastOverlap(int item);
  Neighbours neighboursOf(int item, int placed) const;
  float scoreAt(const Neighbours& neighbours, Dot dot, float most);
  void descend(const Neighbours& neighbours, const Domain& domain, int step, Found* found);
  Dot dotOf(const Domain& domain);
  Found leastOfSome(int item);
  std::optional<LayPlace> lowest(int item);
  float overlap(int a, int b) const;
  void place(int item, const LayPlace& place);
  void reweigh();
  void shrinkLess();
  double total() const;
  double firstHeight() const;
  bool hasPlace(int item) const;

  const PiecesOnBoard& pieces_;
  LayFabric fabric_;
  Random random_;
  int count_;
  std::vector<std::vector<int>> ways_;               ///< allowed ways per item
  std::vector<std::vector<DifferenceTable>> flaws_;  ///< per placed shape
  std::vector<double> beginnings_;
  std::vector<std::vector<int>> orders_;
  std::size_t next_ = 0;  ///< number of the pair of an order and a start height
  std::size_t laid_ = 0;  ///< number of placed pieces, in that order
  double height_ = 0;     ///< height of the window
  int doublings_ = 0;     ///< number of doublings of the height
  int homeless_ = -1;

  Window window_;
  std::vector<Domain> domains_;  ///< per placed shape
  std::vector<LayPlace> places_;
  std::vector<float> weights_, overlaps_;  ///< per ordered pair
  std::vector<float> flaw_overlaps_;       ///< per item
  std::vector<float> scores_;              ///< scores of a row

  std::optional<LaidPieces> best_;
  double beginning_ = 0;  ///< start height of the best layout
  double shrink_;         ///< reduction of the next target, as a share
  bool is_under_way_ = false;
  int idle_ = 0, returns_ = 0, restarts_ = 0;
  double least_total_ = 0, least_of_target_ = 0;
  std::vector<LayPlace> least_places_, least_places_of_target_;
  double reads_ = 0;
};

}  // namespace seamwise
