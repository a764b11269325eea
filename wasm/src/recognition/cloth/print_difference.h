#pragma once
#include <cstdint>
#include <vector>

#include "recognition/base/lattice_map.h"
#include "recognition/cloth/copy_fields_fit.h"
#include "recognition/cloth/lattice_canvas.h"
#include "recognition/cloth/pixels.h"
#include "recognition/cloth/srgb.h"

namespace seamwise {

/// How much a picture differs from what its copies of the cell agree on, light and creases taken
/// away: what lies on the cloth stands out from its print. Found step by step, each of some
/// milliseconds.
class PrintDifference {
 public:
  /// `pixels` have to outlive it.
  PrintDifference(const PixelView& pixels, const LatticeMap& map);

  PrintDifference(const PrintDifference&) = delete;  // its parts refer to each other
  PrintDifference& operator=(const PrintDifference&) = delete;

  /// False when nothing is left to do.
  bool advance();
  double fraction() const;

  // Once done:

  /// At a place of the whole picture, red, green and blue of 0 to 255 each summed up; 0 outside.
  float at(const Vec2& p) const { return between(difference_, p); }
  /// How surely something other than the print is seen there, 0 to 1: a half where colours,
  /// averaged over 3 x 3, differ by some times more than they do in the median of the picture.
  float covered(const Vec2& p) const { return between(covered_, p); }
  /// What it was made from is so many times smaller than the picture.
  int factor() const { return factor_; }

 private:
  enum class Stage : std::uint8_t {
    kReduce,
    kFields,
    kCopies,
    kMean,
    kCompare,
    kNoise,
    kCover,
    kDone
  };
  void average();
  void compare();
  PixelLanes averaged(int column, int row) const;
  void measureNoise();
  void cover();
  float between(const std::vector<float>& map, const Vec2& p) const;
  PixelLanes flattened(PixelLanes colour, float x, float y) const;
  PixelLanes printAt(const Vec2& u) const;

  PixelView pixels_;
  LatticeMap map_;
  SrgbCurve curve_;
  int factor_;
  ReducedPixels reduced_;
  CopyFieldsFit fit_;
  int n_;  ///< samples of a cell's side
  Stage stage_ = Stage::kReduce;
  LatticeCanvas canvas_;
  std::vector<PixelLanes> mean_;
  int columns_ = 0, rows_ = 0;
  std::vector<PixelLanes> off_;    ///< colours less those of the print
  std::vector<float> difference_;  ///< of them, summed up without signs
  float noise_ = 0;                ///< median of such sums, once colours are averaged
  std::vector<float> covered_;
};

}  // namespace seamwise
