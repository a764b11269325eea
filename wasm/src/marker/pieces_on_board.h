#pragma once
#include <optional>
#include <vector>

#include "marker/board.h"
#include "marker/difference_table.h"
#include "marker/marker_problem.h"
#include "marker/shape.h"

namespace seamwise {

/// The part of the fabric that pieces may cover. [cm]
struct Window {
  double left = 0, right = 0, bottom = 0, top = 0;
};

/// Dots at which a shape is inside a window, row by row.
struct Domain {
  int first = 0;             ///< row of runs[0]
  std::vector<DotRun> runs;  ///< columns per row
  DotRun rows() const { return {first, first + static_cast<int>(runs.size()) - 1}; }
  const DotRun& row(int j) const { return runs[j - first]; }
  bool empty() const;  ///< no row has a dot
  bool has(Dot dot) const {
    return dot.j >= first && dot.j <= rows().hi && dot.i >= row(dot.j).lo && dot.i <= row(dot.j).hi;
  }
};

/// A shape with the position of its dot (0, 0). Pieces and rotations with the same shape and
/// position share tables.
struct PlacedShape {
  int shape = 0;
  Vec2 offset = Vec2::Zero();  ///< cm, from the origin of the print
  int item = -1;               ///< the only item with this shape and position; -1: several
  bool is_pinned = false;      ///< has only this dot and belongs to only one piece
};

/// One of the allowed rotations of a piece on the print: p -> linear p + offset + dot.
struct LayWay {
  int placed = 0;  ///< index of its PlacedShape
  Mat2 linear = Mat2::Identity();
  double angle = 0;
  Vec2 offset = Vec2::Zero();  ///< cm, from the origin of the print, in full precision
  bool is_up = true;           ///< the piece's grain line points up the fabric
  int element = 0;             ///< index in the group's elements()
};

struct LayItem {
  std::vector<LayWay> ways;
  int garment = 0;
  int like = 0;  ///< the first item that has the same ways
  bool is_pinned = false;
};

/// All pieces of a problem on a board, and the tables of their overlaps, which are computed one by
/// one.
class PiecesOnBoard {
 public:
  PiecesOnBoard(const MarkerProblem& problem, bool ignores_print);

  const Board& board() const { return board_; }
  const std::vector<LayItem>& items() const { return items_; }
  const Shape& shapeOf(const LayWay& way) const { return shapes_[placed_[way.placed].shape]; }
  const Shape& shape(int placed) const { return shapes_[placed_[placed].shape]; }
  int placedCount() const { return static_cast<int>(placed_.size()); }
  /// The smallest repeat along the warp; none on a board without one. [cm]
  const std::optional<double>& period() const { return period_; }
  double area() const { return area_; }
  /// True if the board has too many columns for proofs.
  bool isFine() const { return is_fine_; }
  /// True if the board has all dots that the print allows.
  bool isWhole() const { return is_whole_; }

  /// Computes the next table. @returns its number of dots; 0 if all tables are computed
  double makeTable();
  double made() const;  ///< share of computed tables, 0 to 1

  /// Overlaps by the dot of the second placed shape minus that of the first.
  const DifferenceTable& table(int first, int second) const {
    return tables_[static_cast<std::size_t>(first) * placed_.size() + second];
  }
  /// Overlaps of a placed shape with flaws by its dot, one table for each flaw.
  std::vector<DifferenceTable> flawTables(int placed, const Vec2& origin) const;

  /// Position of the placed shape's origin at a dot for a given origin of the print. [cm]
  Vec2 at(int placed, Dot dot, const Vec2& origin) const {
    return origin + placed_[placed].offset + board_.shift(dot);
  }
  double bottomAt(int placed, Dot dot, const Vec2& origin) const {
    return at(placed, dot, origin).y() + shape(placed).low.y();
  }
  double topAt(int placed, Dot dot, const Vec2& origin) const {
    return at(placed, dot, origin).y() + shape(placed).high.y();
  }
  Domain domain(int placed, const Window& window, const Vec2& origin) const;
  /// The map from the piece's coordinates to the fabric, in full precision.
  RigidMotion place(int item, int way, Dot dot, const Vec2& origin) const;

 private:
  int addShape(const Polyline& outline, const Mat2& turn);
  int numberOf(const LayItem* item) const { return static_cast<int>(item - items_.data()); }
  int addPlaced(int shape, const Vec2& offset, int item);
  void addWays(const MarkerPiece& piece, const MarkerProblem& problem, LayItem* item);
  void addPin(const MarkerPiece& piece, const MarkerProblem& problem, LayItem* item);

  Board board_;
  Spacing spacing_;
  bool ignores_print_ = false, is_fine_ = false, is_whole_ = false;
  std::optional<double> period_;
  double area_ = 0;
  std::vector<Shape> shapes_, flaws_;
  std::vector<PlacedShape> placed_;
  std::vector<LayItem> items_;
  std::vector<DifferenceTable> tables_;
  std::size_t next_ = 0;  ///< index of the next table to compute
};

}  // namespace seamwise
