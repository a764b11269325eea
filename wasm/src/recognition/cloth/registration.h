#pragma once
#include <array>
#include <vector>

#include "recognition/cloth/lattice_canvas.h"
#include "recognition/cloth/smooth_field.h"
#include "recognition/cloth/srgb.h"

namespace seamwise {

/// Registers the copies of the cell with each other: how far cloth that does not lie flat moves
/// them from where the lattice's map has them. Gauss-Newton on all samples of a canvas, each
/// against the mean of the other copies [Lucas and Kanade 1981], the field being a B-spline whose
/// second differences cost; the mean shift stays zero, since it would only move the origin.
class CopyRegistration {
 public:
  /// @param pixels   `factor` times smaller than the whole picture, a sample being about a pixel
  /// @param coarse   `coarse_factor` times smaller, for the first steps
  /// @param light    see LightFit; divided out
  /// @param width, height   of the whole picture. [px]
  CopyRegistration(LatticeCanvas canvas, const PixelView& pixels, int factor,
                   const PixelView& coarse, int coarse_factor, const SmoothField& light,
                   const SrgbCurve& curve, int width, int height, double cell_size);
  /// Half a step of Gauss-Newton: the canvas is sampled, then the shift is mended by it. False when
  /// that was the last.
  bool advance();

  /// Two channels, along x and y: what the map shows at p lies at p + shift(p). [px]
  const SmoothField& shift() const { return shift_; }
  /// Its root mean square over what is seen. [px]
  double rms() const;
  /// The canvas as the last step has sampled it, light divided out.
  const LatticeCanvas& canvas() const { return canvas_; }
  /// The mean of the copies, and how much all of them weigh, at each place of a cell.
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
  std::array<std::vector<float>, 3> gains_;  ///< per sample what its linear light is multiplied by
  SmoothField shift_;
  std::array<std::vector<float>, 3> mean_;
  std::vector<float> count_;
  int round_ = 0;
  bool is_sampled_ = false;
};

}  // namespace seamwise
