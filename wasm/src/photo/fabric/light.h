#pragma once
#include <array>
#include <vector>

#include "photo/fabric/lattice_canvas.h"
#include "photo/fabric/smooth_field.h"
#include "photo/fabric/srgb.h"

namespace seamwise {

/// Fits the variation of light over an image of a print, apart from the print: log I = log T + L.
/// I is the linear light of a colour, T that of the print, equal in all copies of the cell, and L a
/// smooth field. Robust least squares fit both in turn. T absorbs everything that repeats with the
/// cell. L therefore needs no whole cells, and it extends to the borders as far as copies are
/// visible.
class LightFit {
 public:
  /// @param canvas   sampled canvas; 8 to 16 samples per cell are enough, because light is smooth
  /// @param width, height   of the whole image. [px]
  /// @param nodes_across   nodes of the field along the longer side
  LightFit(LatticeCanvas canvas, const SrgbCurve& curve, int width, int height, double cell_size,
           double nodes_across);
  /// Runs one round of fitting both; returns false after the last one.
  bool advance();
  /// Red, green, blue: natural logarithm of light over its mean on visible parts.
  const SmoothField& field() const { return field_; }

 private:
  void fit(int channel);
  void center();

  LatticeCanvas canvas_;
  std::array<std::vector<float>, 3> weights_;
  SmoothField field_;
  int round_ = 0;
};

}  // namespace seamwise
