#include "photo/fabric/pixels.h"

#include <algorithm>

#include "photo/base/block_sums.h"
#include "photo/base/repeating_place.h"

namespace seamwise {

ReducedPixels::ReducedPixels(const PixelView& pixels, int factor)
    : pixels_(pixels),
      factor_(factor),
      width_(pixels.width / factor),
      height_(pixels.height / factor) {
  if (factor == 1)
    row_ = height_;
  else
    rgba_.resize(static_cast<std::size_t>(width_) * height_ * 4);
}

bool ReducedPixels::advance(int pixels) {
  const int rows = std::max(1, pixels / (pixels_.width * factor_));
  const int end = std::min(height_, row_ + rows);
  const int area = factor_ * factor_;
  for (; row_ < end; ++row_) {
    const std::vector<std::uint32_t> sums = blockSums(pixels_, factor_, row_);
    std::uint8_t* to = rgba_.data() + static_cast<std::size_t>(width_) * 4 * row_;
    for (std::size_t k = 0; k < sums.size(); ++k)
      to[k] = static_cast<std::uint8_t>((sums[k] + area / 2) / area);
  }
  return row_ < height_;
}

PixelView ReducedPixels::view() const {
  return factor_ == 1 ? pixels_ : PixelView{width_, height_, rgba_};
}

bool bilinear(const PixelView& pixels, float x, float y, PixelLanes* value) {
  const float width = static_cast<float>(pixels.width), height = static_cast<float>(pixels.height);
  if (!(x >= 0 && y >= 0 && x < width && y < height)) return false;
  const float s = std::clamp(x - 0.5f, 0.0f, width - 1), t = std::clamp(y - 0.5f, 0.0f, height - 1);
  const int i = std::min(static_cast<int>(s), pixels.width - 2);
  const int j = std::min(static_cast<int>(t), pixels.height - 2);
  const float a = s - static_cast<float>(i), b = t - static_cast<float>(j);
  const std::size_t stride = static_cast<std::size_t>(pixels.width) * 4;
  const std::uint8_t* p = pixels.rgba.data() + stride * j + 4 * static_cast<std::size_t>(i);
  const PixelLanes above = (1 - a) * internal::pixelAt(p) + a * internal::pixelAt(p + 4);
  p += stride;
  const PixelLanes below = (1 - a) * internal::pixelAt(p) + a * internal::pixelAt(p + 4);
  *value = (1 - b) * above + b * below;
  return true;
}

bool bicubic(const PixelView& pixels, float x, float y, PixelLanes* value) {
  const float s = x - 0.5f, t = y - 0.5f;
  if (!(s >= 1 && t >= 1 && s < static_cast<float>(pixels.width - 2) &&
        t < static_cast<float>(pixels.height - 2)))
    return bilinear(pixels, x, y, value);
  const int i = static_cast<int>(s), j = static_cast<int>(t);
  const std::array<float, 4> shares = cubicShares(s - static_cast<float>(i));
  const PixelLanes across = loaded(shares.data());
  const std::array<float, 4> down = cubicShares(t - static_cast<float>(j));
  const std::size_t stride = static_cast<std::size_t>(pixels.width) * 4;
  const std::uint8_t* p =
      pixels.rgba.data() + stride * (j - 1) + 4 * static_cast<std::size_t>(i - 1);
  // One lane per pixel of four, one sum per colour.
  using Codes __attribute__((vector_size(16))) = std::uint32_t;
  using Numbers __attribute__((vector_size(16))) = std::int32_t;
  PixelLanes red = {0, 0, 0, 0}, green = red, blue = red;
  for (int k = 0; k < 4; ++k, p += stride) {
    Codes codes;
    std::memcpy(&codes, p, sizeof codes);
    const float share = down[k];
    red += share * __builtin_convertvector((Numbers)(codes & 255), PixelLanes);
    green += share * __builtin_convertvector((Numbers)((codes >> 8) & 255), PixelLanes);
    blue += share * __builtin_convertvector((Numbers)((codes >> 16) & 255), PixelLanes);
  }
  red *= across, green *= across, blue *= across;
  *value = PixelLanes{red[0] + red[1] + red[2] + red[3], green[0] + green[1] + green[2] + green[3],
                      blue[0] + blue[1] + blue[2] + blue[3], 0};
  return true;
}

}  // namespace seamwise
