#pragma once
#include <cstdint>
#include <vector>

#include "marker/board.h"
#include "marker/shape.h"

namespace seamwise {

/// Required distances of pieces. [cm]
struct Spacing {
  double gap = 0;
  double repeat_tolerance = 0;  ///< pieces at distance d may approach by this share of d
  bool is_exact = false;  ///< near-touching differences are decided on full outlines, not on parts
};

/// Depth of the overlap of two shapes on a board by the difference n of their positions (the
/// second's minus the first's), in hundredths of a centimetre, at least 1; 0 if they are apart.
class DifferenceTable {
 public:
  DifferenceTable() = default;
  /// @param offset   position of the second shape's dot 0 relative to the first's. [cm]
  DifferenceTable(const Shape& first, const Shape& second, const Vec2& offset, const Board& board,
                  const Spacing& spacing);
  /// The table with both shapes exchanged.
  DifferenceTable reversed() const;

  bool empty() const { return depths_.empty(); }
  DotRun rows() const { return {row0_, row0_ + rows_ - 1}; }
  DotRun columns() const { return {column0_, column0_ + columns_ - 1}; }
  int depth(Dot n) const {
    const int j = n.j - row0_, i = n.i - column0_;
    return j >= 0 && j < rows_ && i >= 0 && i < columns_ ? depths_[place(j, i)] : 0;
  }
  /// Depths of a row's dots, starting at n, which must be in the table.
  const std::uint16_t* from(Dot n) const {
    return depths_.data() + place(n.j - row0_, n.i - column0_);
  }

 private:
  std::size_t place(int j, int i) const { return static_cast<std::size_t>(j) * columns_ + i; }

  int row0_ = 0, rows_ = 0, column0_ = 0, columns_ = 0;
  std::vector<std::uint16_t> depths_;
};

/// Number of dots in a table of two shapes.
double tableCells(const Shape& first, const Shape& second, const Board& board, double gap);

}  // namespace seamwise
