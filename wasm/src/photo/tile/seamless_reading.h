#pragma once
#include <memory>

#include "photo/base/lattice_reading.h"
#include "photo/symmetry/group_reading.h"
#include "photo/tile/smaller_cell.h"
#include "photo/tile/tile_cell.h"

namespace seamwise {

/// Print of an image that repeats edge to edge.
struct SeamlessReading {
  LatticeReading lattice;        ///< smallest cell inside, with its origin in the lower left corner
  CellPicture cell;              ///< samples of that cell
  Mat2 gram = Mat2::Identity();  ///< Gram matrix of its w1, w2, in units of the sides' Gram matrix
  GroupReading groups;
};

/// Reads a tile whose edges meet, step by step: its smallest cell, then that cell's groups.
class SeamlessReader {
 public:
  /// The pixels of `tile` have to outlive the object.
  SeamlessReader(const SeamlessTile& tile, const Mat2& sides);

  /// Runs one step of some milliseconds; returns false when done.
  bool advance();
  /// Returns whether the smallest cell is known and its groups are being read.
  bool readsGroups() const { return groups_ != nullptr; }

  // Results, valid once done:

  const SeamlessReading& reading() const { return reading_; }
  /// Returns the number of symmetries in the image.
  int symmetries() const { return reading_.lattice.copies * best().group->order; }
  bool isHexagonal() const { return best().group->lattice == LatticeType::kHexagonal; }
  /// Returns whether symmetries fit better on `other`, as they do on a tile to which a missing line
  /// of pixels was added.
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
  double missed_ = 0;  ///< greatest share of energy by which symmetries miss
};

}  // namespace seamwise
