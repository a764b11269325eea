#pragma once
#include <array>
#include <vector>

#include "recognition/cloth/lattice_canvas.h"
#include "recognition/cloth/smooth_field.h"
#include "recognition/cloth/srgb.h"

namespace seamwise {

/// How light varies over a picture of a print, apart from the print: log I = log T + L, with I the
/// linear light of a colour, T the print's, the same in all copies of the cell, and L a smooth
/// field. Both are fitted in turn by robust least squares; as T takes whatever repeats with the
/// cell, L needs no whole cells and goes on to the borders as far as the picture shows copies.
class LightFit {
 public:
  /// @param canvas   sampled; a cell of 8 to 16 samples is enough, light being smooth
  /// @param width, height   of the whole picture. [px]
  /// @param nodes_across   of the field, along the longer side
  LightFit(LatticeCanvas canvas, const SrgbCurve& curve, int width, int height, double cell_size,
           double nodes_across);
  /// One round of fitting both; false when that was the last.
  bool advance();
  /// Red, green, blue: the natural logarithm of light over its mean on what is seen.
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
