#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "recognition/cloth/cell_mean.h"
#include "recognition/cloth/copy_fields_fit.h"

namespace seamwise {

/// A clean image of a print's cell from all its copies on a picture, step by step.
class PhotoTile {
 public:
  /// @param pixels   outlive it
  /// @param map      of the cell: its w1, w2 and origin
  /// @param gram     of w1, w2, up to a factor
  /// @param flatten  share of the light's unevenness that is taken away
  PhotoTile(const PixelView& pixels, const LatticeMap& map, const Mat2& gram, double flatten);

  /// One step of some milliseconds; false when nothing is left to do.
  bool advance();
  double fraction() const;

  // Once done:

  int columns() const { return mean_->grid().columns; }
  int rows() const { return mean_->grid().rows; }
  /// Red, green, blue, opacity, w1 to the right and w2 up, its top row first.
  std::vector<std::uint8_t> image() const;

 private:
  PixelView pixels_;
  LatticeMap map_;
  Mat2 gram_;
  double flatten_;
  SrgbCurve curve_;
  CopyFieldsFit fit_;
  std::unique_ptr<CellMean> mean_;
};

}  // namespace seamwise
