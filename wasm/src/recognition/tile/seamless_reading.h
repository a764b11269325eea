#pragma once
#include <memory>

#include "recognition/base/lattice_reading.h"
#include "recognition/symmetry/group_reading.h"
#include "recognition/tile/smaller_cell.h"
#include "recognition/tile/tile_cell.h"

namespace seamwise {

/// The print of a picture that repeats edge to edge.
struct SeamlessReading {
  LatticeReading lattice;  ///< of the smallest cell inside, its origin in the lower left corner
  CellPicture cell;        ///< of that cell
  Mat2 gram = Mat2::Identity();  ///< of its w1, w2, in units of the sides' Gram matrix
  GroupReading groups;
};

/// Reads a tile whose edges meet, step by step: its smallest cell, then that cell's groups.
class SeamlessReader {
 public:
  /// `tile`'s pixels have to outlive it.
  /// @param sides   Gram matrix of the tile's sides to the right and up
  SeamlessReader(const SeamlessTile& tile, const Mat2& sides);

  /// One step of some milliseconds; false when nothing is left to do.
  bool advance();
  /// The smallest cell is known, and its groups are read.
  bool readsGroups() const { return groups_ != nullptr; }

  // Once done:

  const SeamlessReading& reading() const { return reading_; }
  /// How many symmetries lie in the picture.
  int symmetries() const { return reading_.lattice.copies * best().group->order; }
  bool isHexagonal() const { return best().group->lattice == LatticeType::kHexagonal; }
  /// Symmetries fit better on another tile, as one has that was cut by a line.
  bool isMendedBy(const SeamlessReader& other) const;

 private:
  void beginCell(const Mat2& finer);
  void keepCell();
  void finish();
  const GroupVerdict& best() const { return reading_.groups.groups[reading_.groups.best]; }

  SeamlessTile tile_;
  Mat2 sides_;
  std::unique_ptr<TileCell> sampled_;
  std::unique_ptr<SmallerCellSearch> smaller_;
  std::unique_ptr<GroupReader> groups_;
  SeamlessReading reading_;
  double missed_ = 0;  ///< greatest share of energy by which its symmetries miss
};

}  // namespace seamwise
