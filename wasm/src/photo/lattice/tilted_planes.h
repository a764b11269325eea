#pragma once
#include <array>

#include "photo/lattice/autocorrelation.h"
#include "photo/lattice/channel_image.h"

namespace seamwise {

/// Returns the two mixtures of the channels with the greatest variance in an image, as rows.
std::array<std::array<float, 3>, 2> principalAxes(const ChannelImage& image);

/// Part of an image for an autocorrelation, seen like a fabric of some tilt from straight above.
struct TiltedPart {
  Vec2 tilt = Vec2::Zero();  ///< see `TiltedLattice`
  double share = 1;          ///< share of the image's width and height, around the middle
};

/// Samples a part with the spacing of the image's pixels at the middle. Weights are the square root
/// of Hann's window over the part.
WeightedPlanes tiltedPlanes(const ChannelImage& image,
                            const std::array<std::array<float, 3>, 2>& axes,
                            const TiltedPart& part);

}  // namespace seamwise
