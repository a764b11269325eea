#pragma once
#include "recognition/cloth/pixels.h"

namespace seamwise {

/// What several copies of one place of a print agree on.
struct AgreedColour {
  PixelLanes colour = {0, 0, 0, 0};  ///< red, green, blue, as they were given
  /// Variance of that mean, summed over the opponent channels (R + G + B) / 3, 0.7 (R - B) and
  /// 0.7 (G - (R + B) / 2); 0 of a single copy.
  float noise = 0;
};

/// Mean of colours with weights in the fourth lane, those far from their median counting less or
/// nothing [Tukey's biweight], the scale being the mean distance from it: up to a third of them may
/// lie anywhere. Two colours have no outlier. Takes time like their number. Weights are changed.
AgreedColour agreedColour(PixelLanes* colours, int count);

}  // namespace seamwise
