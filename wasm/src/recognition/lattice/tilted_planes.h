#pragma once
#include <array>

#include "recognition/lattice/autocorrelation.h"
#include "recognition/lattice/channel_image.h"

namespace seamwise {

/// The two mixtures of the channels in which a picture varies most, as rows.
std::array<std::array<float, 3>, 2> principalAxes(const ChannelImage& image);

/// The part of a picture that is autocorrelated, as a cloth of some tilt would look from straight
/// above.
struct TiltedPart {
  Vec2 tilt = Vec2::Zero();  ///< as `TiltedLattice` has it
  double share = 1;          ///< of the picture's width and height, about the middle
};

/// Samples as far apart as the image's pixels are at the middle; weights are the root of Hann's
/// window over the part.
WeightedPlanes tiltedPlanes(const ChannelImage& image,
                            const std::array<std::array<float, 3>, 2>& axes,
                            const TiltedPart& part);

}  // namespace seamwise
