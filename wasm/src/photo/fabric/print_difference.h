#pragma once
#include <cstdint>
#include <vector>

#include "photo/base/lattice_map.h"
#include "photo/fabric/copy_fields_fit.h"
#include "photo/fabric/lattice_canvas.h"
#include "photo/fabric/pixels.h"
#include "photo/fabric/srgb.h"

namespace seamwise {

/// Difference of an image from the mean of its copies of the cell, corrected for light and creases.
/// An object on the fabric differs from the print. Each step takes some milliseconds.
class PrintDifference {
 public:
  /// `pixels` have to outlive the object.
  PrintDifference(const PixelView& pixels, const LatticeMap& map);

  PrintDifference(const PrintDifference&) = delete;  // members refer to each other
  PrintDifference& operator=(const PrintDifference&) = delete;

  /// Runs one step; returns false when done.
  bool advance();
  double fraction() const;

  // Results, valid once done:

  /// Returns how much the differences of two places of the whole image from the print differ,
  /// summed over red, green and blue of 0 to 255 each; 0 outside.
  float step(const Vec2& p, const Vec2& q) const;
  /// Returns how much brighter a place is than the print, summed in the same way.
  float brighter(const Vec2& p) const {
    const PixelLanes off = between(off_, p, PixelLanes{});
    return off[0] + off[1] + off[2];
  }
  /// Returns the certainty that something other than the print is visible there, 0 to 1. It is a
  /// half where colours, averaged over 3 x 3, differ by several times the median of the image.
  float covered(const Vec2& p) const { return between(covered_, p, 0.0f); }
  /// Reduction factor of the compared image.
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
  template <class Value>
  Value between(const std::vector<Value>& map, const Vec2& p, const Value& outside) const;
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
  std::vector<PixelLanes> off_;  ///< colours minus those of the print
  float noise_ = 0;              ///< median of the sums of absolute values of averaged ones
  std::vector<float> covered_;
};

}  // namespace seamwise
