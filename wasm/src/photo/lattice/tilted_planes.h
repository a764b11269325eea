#pragma once
#include <array>

#include "photo/lattice/autocorrelation.h"
#include "photo/lattice/channel_image.h"

namespace seamwise {

/// Returns the two mixtures of the channels with the greatest variance in an image, as rows.
std::array<std::array<float, 3>, 2> principalAxes(const ChannelImage& image);

/// Part of an image for an autocorrelation, seen like a fabric of some tilt from straight above.
struct TiltedPart {
  Vec2 tilt = Vec2::Zero();    ///< see `TiltedLattice`
  double share = 1;            ///< share of the image's width and height
  Vec2 middle = Vec2::Zero();  ///< of the part. [halves of the longer side]
};

/// Weights of an image's square blocks.
struct BlockWeights {
  int columns = 0, rows = 0;
  float side = 1;             ///< of a block. [pixels of the image]
  std::vector<float> values;  ///< row by row; empty if all are 1
};

/// Returns weights that give no block more contrast than the median block, so that a bright object
/// has no greater say than its area.
BlockWeights evenWeights(const ChannelImage& image);

/// Samples a part with the spacing of the image's pixels at the middle. Weights are the square root
/// of Hann's window over the part, times those of the blocks.
WeightedPlanes tiltedPlanes(const ChannelImage& image,
                            const std::array<std::array<float, 3>, 2>& axes, const TiltedPart& part,
                            const BlockWeights& blocks);

}  // namespace seamwise
