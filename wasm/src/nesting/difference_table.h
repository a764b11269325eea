#pragma once
#include <cstdint>
#include <vector>

#include "nesting/board.h"
#include "nesting/shape.h"

namespace seamwise {

/// How far apart pieces lie. [cm]
struct Spacing {
  double gap = 0;
  double repeat_tolerance = 0;  ///< pieces d apart may come nearer by this share of d
  bool is_exact = false;  ///< near-touching differences are decided on full outlines, not on parts
};

/// For two shapes on a board: how deep they overlap by the difference n of their places (the
/// second's less the first's), in hundredths of a centimetre, 1 at least; 0 where they are apart.
class DifferenceTable {
 public:
  DifferenceTable() = default;
  /// @param offset   of the second shape's place 0 from the first's. [cm]
  DifferenceTable(const Shape& first, const Shape& second, const Vec2& offset, const Board& board,
                  const Spacing& spacing);
  /// The same of the second shape and the first.
  DifferenceTable reversed() const;

  bool empty() const { return depths_.empty(); }
  DotRun rows() const { return {row0_, row0_ + rows_ - 1}; }
  DotRun columns() const { return {column0_, column0_ + columns_ - 1}; }
  int depth(Dot n) const {
    const int j = n.j - row0_, i = n.i - column0_;
    return j >= 0 && j < rows_ && i >= 0 && i < columns_ ? depths_[place(j, i)] : 0;
  }
  /// Depths of a row's dots, from (i, j) on, which must be in the table.
  const std::uint16_t* from(Dot n) const {
    return depths_.data() + place(n.j - row0_, n.i - column0_);
  }

 private:
  std::size_t place(int j, int i) const { return static_cast<std::size_t>(j) * columns_ + i; }

  int row0_ = 0, rows_ = 0, column0_ = 0, columns_ = 0;
  std::vector<std::uint16_t> depths_;
};

/// How many dots a table of two shapes would have.
double tableCells(const Shape& first, const Shape& second, const Board& board, double gap);

}  // namespace seamwise
