#pragma once
#include <array>
#include <vector>

#include "recognition/base/picture.h"

namespace seamwise {

/// Lightness, red against blue, green against both: the differences by which a print is
/// recognised, so weighted that each has about as much noise.
inline std::array<float, 3> opponentOf(float red, float green, float blue) {
  return {(red + green + blue) / 3, 0.7F * (red - blue), 0.7F * (green - (red + blue) / 2)};
}

/// Replaces red, green and blue by the opponent channels, in place.
void opponentChannels(Picture& picture);

/// How many pixels of each row and column become one, so that the longer side has at most
/// `longest` pixels.
int reductionTo(int longest, const PixelView& view);

/// A picture of the size that `view` has once blocks of `factor` x `factor` pixels become one;
/// black until `reduceRows` has been there. What does not fill a block at the right and at the
/// bottom is left out, opacity is not looked at.
Picture reducedFrame(const PixelView& view, int factor);

/// The mean of each block, for rows `from` to `to` (exclusive) of `picture`: some at a time,
/// because a picture of 12 million pixels takes too long at once.
void reduceRows(const PixelView& view, int factor, int from, int to, Picture& picture);

/// Gaussian mean of a plane, of what lies inside where it reaches beyond the borders.
/// @param sigma   standard deviation. [pixels]
std::vector<float> blurred(const std::vector<float>& plane, int width, int height, double sigma);

/// Takes the light away: red, green and blue become opponent channels as shares of the lightness
/// around, minus their own mean around. "Around" is a Gaussian of `sigma` [pixels]. In light that
/// varies slowly the same ink has the same values everywhere.
void flatten(Picture& picture, double sigma);

/// Half as wide and high, the kernel (1 3 3 1) / 8 both ways, so that what is finer does not
/// return as something coarser.
Picture halved(const Picture& picture);

}  // namespace seamwise
