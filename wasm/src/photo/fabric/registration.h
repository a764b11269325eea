#pragma once
#include <array>
#include <vector>

#include "photo/fabric/lattice_canvas.h"
#include "photo/fabric/smooth_field.h"
#include "photo/fabric/srgb.h"

namespace seamwise {

/// Registers the copies of the cell with each other: finds how far uneven fabric moves them from
/// their positions in the lattice's map.
/// Gauss-Newton uses all samples of a canvas, each against the mean of the other copies [Lucas and
/// Kanade 1981]. The field is a B-spline with a cost on second differences. The mean shift stays
/// zero, because it would only move the origin.
class CopyRegistration {
 public:
  /// @param pixels   image reduced by `factor`, about one pixel per sample
  /// @param coarse   image reduced by `coarse_factor`, for the first steps
  /// @param light    see LightFit; divided out
  /// @param width, height   of the whole image. [px]
  CopyRegistration(LatticeCanvas canvas, const PixelView& pixels, int factor,
                   const PixelView& coarse, int coarse_factor, const SmoothField& light,
                   const SrgbCurve& curve, int width, int height, double cell_size);
  /// Runs half a Gauss-Newton step: it samples the canvas, or corrects the shift by the samples.
  /// Returns false after the last one.
  bool advance();

  /// Two channels, along x and y: content that the map expects at p is at p + shift(p). [px]
  const SmoothField& shift() const { return shift_; }
  /// Root mean square of the shift over visible parts. [px]
  double rms() const;
  /// Canvas as sampled by the last step, light divided out.
  const LatticeCanvas& canvas() const { return canvas_; }
  /// Mean of the copies, and number of copies, at each place of a cell.
  const std::array<std::vector<float>, 3>& mean() const { return mean_; }
  const std::vector<float>& count() const { return count_; }

 private:
  void sample();
  void average();
  void step();
  void center();

  LatticeCanvas canvas_;
  PixelView pixels_, coarse_;
  int factor_, coarse_factor_;
  const SrgbCurve& curve_;
  std::array<std::vector<float>, 3> gains_;  ///< per sample: factor of its linear light
  SmoothField shift_;
  std::array<std::vector<float>, 3> mean_;
  std::vector<float> count_;
  int round_ = 0;
  bool is_sampled_ = false;
};

}  // namespace seamwise
