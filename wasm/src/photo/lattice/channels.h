#pragma once
#include <array>
#include <vector>

#include "photo/base/picture.h"

namespace seamwise {

/// Returns lightness, red against blue, and green against both: the differences that identify a
/// print, weighted for about equal noise.
inline std::array<float, 3> opponentOf(float red, float green, float blue) {
  return {(red + green + blue) / 3, 0.7F * (red - blue), 0.7F * (green - (red + blue) / 2)};
}

/// Replaces red, green and blue by the opponent channels, in place.
void opponentChannels(Picture& picture);

/// Returns the number of pixels in each row and column of a block, so that the longer side gets at
/// most `longest` blocks.
int reductionTo(int longest, const PixelView& view);

/// Returns a black picture for `view` with blocks of `factor` x `factor` pixels merged;
/// `reduceRows` fills it. Pixels at the right and the bottom that do not fill a block are omitted,
/// and opacity is ignored.
Picture reducedFrame(const PixelView& view, int factor);

/// Computes the mean of each block for rows `from` to `to` (exclusive) of `picture`. It takes some
/// rows at a time, because an image of 12 million pixels takes too long at once.
void reduceRows(const PixelView& view, int factor, int from, int to, Picture& picture);

/// Returns the Gaussian mean of a plane, over the part within its borders.
/// @param sigma   standard deviation. [pixels]
std::vector<float> blurred(const std::vector<float>& plane, int width, int height, double sigma);

/// Removes the light: red, green and blue become opponent channels relative to the surrounding
/// lightness, minus their own surrounding mean. Surroundings are a Gaussian of `sigma` [pixels].
/// The same ink has the same values everywhere if the light varies slowly.
void flatten(Picture& picture, double sigma);

/// Returns an image half as wide and high. The kernel (1 3 3 1) / 8 in both directions keeps finer
/// detail from returning as coarser detail.
Picture halved(const Picture& picture);

}  // namespace seamwise
