#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "photo/fabric/cell_mean.h"
#include "photo/fabric/copy_fields_fit.h"
#include "photo/fabric/tile_symmetry.h"
#include "photo/tile/tile_cell.h"

namespace seamwise {

/// Settings for an image of a print's cell.
struct PhotoTileSettings {
  /// Map of the cell: its w1, w2 and origin.
  LatticeMap map;
  /// Gram matrix of w1, w2, up to a factor.
  Mat2 gram = Mat2::Identity();
  /// The source is seamless: one cell of the print, or several.
  bool is_tile = false;
  /// Share of the light's unevenness that is removed.
  double flatten = 1;
  /// Group whose symmetries are made exact, or null.
  const GroupData* group = nullptr;
};

/// Makes a clean image of a print's cell from all its copies in a source image, step by step.
class PhotoTile {
 public:
  /// `pixels` have to outlive the object.
  PhotoTile(const PixelView& pixels, const PhotoTileSettings& settings);

  /// Runs one step of some milliseconds; returns false when done.
  bool advance();
  double fraction() const;

  // Results, valid once done:

  int columns() const { return grid_.columns; }
  int rows() const { return grid_.rows; }
  /// Returns red, green, blue, opacity, w1 to the right and w2 up, top row first.
  std::vector<std::uint8_t> image() const;

 private:
  bool symmetrise(std::array<std::vector<float>, 3> planes);

  PixelView pixels_;
  PhotoTileSettings settings_;
  CellGrid grid_;
  SrgbCurve curve_;
  std::unique_ptr<TileCell> cell_;      ///< for a seamless image, which is one copy
  std::unique_ptr<CopyFieldsFit> fit_;  ///< for other images
  std::unique_ptr<CellMean> mean_;
  std::unique_ptr<TileSymmetry> symmetry_;
  std::array<std::vector<float>, 3> planes_;
};

}  // namespace seamwise
