#pragma once
#include <vector>

#include "recognition/base/lattice_map.h"
#include "recognition/cloth/copy_fields.h"
#include "recognition/cloth/pixels.h"
#include "recognition/cloth/srgb.h"

namespace seamwise {

/// How much a picture differs from what its copies of the cell agree on, light and creases taken
/// away: what lies on the cloth stands out from its print.
class PrintDifference {
 public:
  PrintDifference(const PixelView& pixels, const LatticeMap& map);
  /// At a place of the whole picture, red, green and blue of 0 to 255 each summed up; 0 outside.
  float at(const Vec2& p) const;
  /// What it was made from is so many times smaller than the picture.
  int factor() const { return factor_; }

 private:
  void average(const LatticeMap& map, int width, int height);
  void compare(const LatticeMap& map);
  PixelLanes flattened(PixelLanes colour, float x, float y) const;
  PixelLanes printAt(const Vec2& u) const;

  SrgbCurve curve_;
  int factor_;
  ReducedPixels reduced_;
  CopyFields fields_;
  int n_;  ///< samples of a cell's side
  std::vector<PixelLanes> mean_;
  int columns_ = 0, rows_ = 0;
  std::vector<float> difference_;
};

}  // namespace seamwise
