#include "photo/lattice/channel_image.h"

namespace seamwise {

ChannelImage ChannelImage::of(const Picture& picture) {
  ChannelImage image;
  image.width = picture.width;
  image.height = picture.height;
  image.scale = static_cast<float>(picture.scale);
  image.samples.resize(picture.planes[0].size() * 4);
  for (std::size_t i = 0; i < picture.planes[0].size(); ++i)
    for (int c = 0; c < 3; ++c) image.samples[4 * i + c] = picture.planes[c][i];
  return image;
}

}  // namespace seamwise
