#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "recognition/cloth/cell_mean.h"
#include "recognition/cloth/copy_fields_fit.h"
#include "recognition/cloth/tile_symmetry.h"
#include "recognition/tile/tile_cell.h"

namespace seamwise {

/// How an image of a print's cell is made.
struct PhotoTileSettings {
  /// Of the cell: its w1, w2 and origin.
  LatticeMap map;
  /// Of w1, w2, up to a factor.
  Mat2 gram = Mat2::Identity();
  /// The picture is seamless: one cell of the print, or several.
  bool is_tile = false;
  /// Share of the light's unevenness that is taken away.
  double flatten = 1;
  /// Its symmetries are made exact; nothing for as they are.
  const GroupData* group = nullptr;
};

/// A clean image of a print's cell from all its copies on a picture, step by step.
class PhotoTile {
 public:
  /// `pixels` have to outlive it.
  PhotoTile(const PixelView& pixels, const PhotoTileSettings& settings);

  /// One step of some milliseconds; false when nothing is left to do.
  bool advance();
  double fraction() const;

  // Once done:

  int columns() const { return grid_.columns; }
  int rows() const { return grid_.rows; }
  /// Red, green, blue, opacity, w1 to the right and w2 up, its top row first.
  std::vector<std::uint8_t> image() const;

 private:
  bool symmetrise(std::array<std::vector<float>, 3> planes);

  PixelView pixels_;
  PhotoTileSettings settings_;
  CellGrid grid_;
  SrgbCurve curve_;
  std::unique_ptr<TileCell> cell_;      ///< of a seamless picture, which is one copy
  std::unique_ptr<CopyFieldsFit> fit_;  ///< of others
  std::unique_ptr<CellMean> mean_;
  std::unique_ptr<TileSymmetry> symmetry_;
  std::array<std::vector<float>, 3> planes_;
};

}  // namespace seamwise
