#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "nesting/layout.h"

namespace seamwise {

/// Looks through all layouts of at most a given length, step by step: one piece after the other,
/// that with the fewest dots left first, where pieces that ran out of dots before count more, with
/// the dots that each leaves to the others as bits. Layouts that differ by whole repeats, or by
/// which of two equal pieces lies where, are looked at once.
class CompleteSearch {
 public:
  /// @param length   that no layout sought exceeds. [cm]
  CompleteSearch(const PiecesOnBoard& pieces, const LayCloth& cloth, double length);

  /// Whether its end proves anything: the board has all dots, rows are level, they repeat or the
  /// cut is fixed, and none has more than 64 dots. Otherwise `step` must not be called.
  bool canProve() const { return can_prove_; }
  /// Goes on until about so many rows are looked at; false when it has ended.
  bool step(double reads);
  /// Once it has ended: the layout it has found; nothing when there is none of that length.
  const std::optional<LaidPieces>& found() const { return found_; }
  /// Rows of dots looked at so far.
  double reads() const { return reads_; }

 private:
  struct BitTable {
    DotRun rows;
    int column = 0;  ///< of bit 0
    int words = 0;   ///< of a row
    std::vector<std::uint64_t> bits;
    std::uint64_t window(int row, int start) const;
  };
  struct Value {
    int item = -1, slot = -1;
    Dot dot;
  };
  /// A piece has been chosen, whose dots are tried one by one.
  struct Level {
    std::vector<std::uint64_t> domains;  ///< per slot its rows
    double bottom, top;                  ///< between which all pieces have to lie. [cm]
    std::vector<Value> values;
    std::size_t next = 0;
  };
  /// A way of an item.
  struct Slot {
    int item, way, placed;
    double low, high;  ///< of the piece in row 0. [cm]
  };

  bool setRows(const Window& window);
  Level root(const Window& window) const;
  void place(const Value& value);
  bool leaves(Level* level, const Value& value, int item);
  void removeLike(Level* level, const Value& value) const;
  std::vector<Value> valuesOf(const Level& level, int item) const;
  int dotsOf(const Level& level, int item) const;
  int nextItem(const Level& level) const;
  const BitTable& bitsOf(int first, int second);
  std::size_t rowAt(int slot, int j) const {
    return static_cast<std::size_t>(slot) * rows_.size() + (j - rows_.lo);
  }

  const PiecesOnBoard& pieces_;
  LayCloth cloth_;
  double length_;
  bool can_prove_ = false;
  std::vector<Slot> slots_;
  std::vector<std::vector<int>> slots_of_;  ///< per item
  DotRun rows_;
  std::vector<Domain> domains_;  ///< per slot
  std::vector<int> bases_;       ///< per row the column of bit 0
  std::vector<BitTable> bits_;
  std::vector<Level> levels_;
  std::vector<LayPlace> places_;
  std::vector<double> failures_;  ///< per item, how often it ran out of dots, and 1
  std::vector<int> placed_;       ///< items, in order
  std::optional<LaidPieces> found_;
  double reads_ = 0;
};

}  // namespace seamwise
