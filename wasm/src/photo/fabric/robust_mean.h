#pragma once
#include "photo/fabric/pixels.h"

namespace seamwise {

/// Consensus of several copies of one place of a print.
struct AgreedColour {
  PixelLanes colour = {0, 0, 0, 0};  ///< red, green, blue, coded like the input
  /// Variance of that mean, summed over the opponent channels (R + G + B) / 3, 0.7 (R - B) and 0.7
  /// (G - (R + B) / 2); 0 for a single copy.
  float noise = 0;
};

/// Returns the mean of colours with weights in the fourth lane. Colours far from their median count
/// less or nothing [Tukey's biweight], with the mean distance from the median as scale. Up to a
/// third of the colours may be arbitrary. Two colours have no outlier. The time is linear in
/// `count`. The weights are changed.
AgreedColour agreedColour(PixelLanes* colours, int count);

}  // namespace seamwise
