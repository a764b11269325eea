#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "base/random.h"
#include "nesting/layout.h"

namespace seamwise {

/// Seeks short layouts on a cloth: pieces are first laid one by one, each as low as it can lie;
/// then the cloth is cut shorter, and pieces that overlap move, one at a time, to where the
/// weighted sum of their overlaps with all others is the least of all their places. Weights of
/// pairs that overlap grow, as in guided local search [Umetani et al. 2009; Gardeyn and Wauters
/// 2025].
class LayoutSearch {
 public:
  LayoutSearch(const PiecesOnBoard& pieces, LayCloth cloth, std::uint64_t seed);

  const LayCloth& cloth() const { return cloth_; }
  /// Lays one more piece of a layout in the next of some orders, from the next of some heights.
  /// False when there are no more orders, or a piece finds no place.
  bool construct();
  /// One sweep of moves; false when no shorter layout can be, by the domains alone.
  bool improve();
  /// A layout found elsewhere, which may be shorter than the best.
  void offer(const LaidPieces& layout);

  const std::optional<LaidPieces>& best() const { return best_; }
  /// An item for which no window has a place, however long; -1 when all have.
  int homeless() const { return homeless_; }
  /// Table reads so far.
  double reads() const { return reads_; }

 private:
  /// What a piece must not lie on, and how much that weighs.
  struct Other {
    const DifferenceTable* table;
    Dot dot;
    float weight;
  };
  /// All that a piece must not lie on, for looking up single dots: where the table of each ends on
  /// the board, four at a time, first columns, first rows, last columns, last rows.
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
  LayCloth cloth_;
  Random random_;
  int count_;
  std::vector<std::vector<int>> ways_;               ///< per item, those allowed
  std::vector<std::vector<DifferenceTable>> flaws_;  ///< per placed shape
  std::vector<double> beginnings_;
  std::vector<std::vector<int>> orders_;
  std::size_t next_ = 0;  ///< pair of an order and a beginning
  std::size_t laid_ = 0;  ///< pieces, in that order
  double height_ = 0;     ///< of the window
  int doublings_ = 0;     ///< of it
  int homeless_ = -1;

  Window window_;
  std::vector<Domain> domains_;  ///< per placed shape
  std::vector<LayPlace> places_;
  std::vector<float> weights_, overlaps_;  ///< of pairs, both ways
  std::vector<float> flaw_overlaps_;       ///< per item
  std::vector<float> scores_;              ///< of a row

  std::optional<LaidPieces> best_;
  double beginning_ = 0;  ///< of the best
  double shrink_;         ///< of the next target, as a share
  bool is_under_way_ = false;
  int idle_ = 0, returns_ = 0, restarts_ = 0;
  double least_total_ = 0, least_of_target_ = 0;
  std::vector<LayPlace> least_places_, least_places_of_target_;
  double reads_ = 0;
};

}  // namespace seamwise
