#include "photo/lattice/channels.h"

#include <algorithm>
#include <cmath>

#include "photo/base/block_sums.h"

namespace seamwise {
namespace {

constexpr int kLightBlock = 8;        // block size for light, which varies slowly. [pixels]
constexpr float kLeastLight = 0.04F;  // minimum light, below which noise resembles a print; chosen

/// Returns the means of blocks of a plane; the last blocks may be smaller.
std::vector<float> blockMeans(const std::vector<float>& plane, int width, int height, int block) {
  const int columns = (width + block - 1) / block, rows = (height + block - 1) / block;
  std::vector<float> means(static_cast<std::size_t>(columns) * rows);
  for (int row = 0; row < rows; ++row) {
    const int y1 = std::min(height, (row + 1) * block);
    for (int column = 0; column < columns; ++column) {
      const int x1 = std::min(width, (column + 1) * block);
      float sum = 0;
      for (int y = row * block; y < y1; ++y)
        for (int x = column * block; x < x1; ++x) sum += plane[y * width + x];
      means[row * columns + column] =
          sum / static_cast<float>((y1 - row * block) * (x1 - column * block));
    }
  }
  return means;
}

/// Position of a row or column of pixels between the middles of blocks.
struct BetweenBlocks {
  int first, second;
  float share;  ///< weight of the second
};

BetweenBlocks betweenBlocks(int pixel, int count) {
  const float at = (static_cast<float>(pixel) + 0.5F) / kLightBlock - 0.5F;
  const int first = std::clamp(static_cast<int>(std::floor(at)), 0, count - 1);
  return {first, std::min(first + 1, count - 1),
          std::clamp(at - static_cast<float>(first), 0.0F, 1.0F)};
}

/// Surrounding light and the channels' own surrounding means, per block.
struct SlowPart {
  int columns, rows;
  std::vector<float> light;
  std::array<std::vector<float>, 3> means;
};

SlowPart slowPart(const Picture& picture, double sigma) {
  SlowPart slow;
  slow.columns = (picture.width + kLightBlock - 1) / kLightBlock;
  slow.rows = (picture.height + kLightBlock - 1) / kLightBlock;
  Picture blocks;
  blocks.width = slow.columns;
  blocks.height = slow.rows;
  for (int c = 0; c < 3; ++c)
    blocks.planes[c] = blockMeans(picture.planes[c], picture.width, picture.height, kLightBlock);
  opponentChannels(blocks);
  slow.light = blurred(blocks.planes[0], slow.columns, slow.rows, sigma / kLightBlock);
  for (float& light : slow.light) light = std::max(light, kLeastLight);
  for (int c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < slow.light.size(); ++i) blocks.planes[c][i] /= slow.light[i];
    slow.means[c] = blurred(blocks.planes[c], slow.columns, slow.rows, sigma / kLightBlock);
  }
  return slow;
}

}  // namespace

void opponentChannels(Picture& picture) {
  auto& [first, second, third] = picture.planes;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const auto channels = opponentOf(first[i], second[i], third[i]);
    first[i] = channels[0], second[i] = channels[1], third[i] = channels[2];
  }
}

int reductionTo(int longest, const PixelView& view) {
  return std::max(1, (std::max(view.width, view.height) + longest - 1) / longest);
}

Picture reducedFrame(const PixelView& view, int factor) {
  Picture picture;
  picture.width = view.width / factor;
  picture.height = view.height / factor;
  picture.scale = 1.0 / factor;
  for (auto& plane : picture.planes)
    plane.assign(static_cast<std::size_t>(picture.width) * picture.height, 0);
  return picture;
}

void reduceRows(const PixelView& view, int factor, int from, int to, Picture& picture) {
  const int width = picture.width;
  const float scale = 1 / (255.0F * static_cast<float>(factor * factor));
  for (int row = from; row < to; ++row) {
    const std::vector<std::uint32_t> sums = blockSums(view, factor, row);
    for (int c = 0; c < 3; ++c) {
      float* plane = picture.planes[c].data() + static_cast<std::size_t>(row) * width;
      for (int x = 0; x < width; ++x) plane[x] = static_cast<float>(sums[4 * x + c]) * scale;
    }
  }
}

std::vector<float> blurred(const std::vector<float>& plane, int width, int height, double sigma) {
  const int reach = std::max(1, static_cast<int>(std::ceil(3 * sigma)));
  std::vector<float> kernel(reach + 1);
  for (int k = 0; k <= reach; ++k)
    kernel[k] = std::exp(static_cast<float>(-k * k / (2 * sigma * sigma)));
  const auto line = [&](const float* in, float* out, int count, int stride) {
    for (int i = 0; i < count; ++i) {
      float sum = 0, weight = 0;
      for (int k = std::max(-reach, -i); k <= std::min(reach, count - 1 - i); ++k) {
        const float w = kernel[std::abs(k)];
        sum += w * in[(i + k) * stride], weight += w;
      }
      out[i * stride] = sum / weight;
    }
  };
  std::vector<float> across(plane.size()), both(plane.size());
  for (int y = 0; y < height; ++y) line(&plane[y * width], &across[y * width], width, 1);
  for (int x = 0; x < width; ++x) line(&across[x], &both[x], height, width);
  return both;
}

void flatten(Picture& picture, double sigma) {
  const SlowPart slow = slowPart(picture, sigma);
  opponentChannels(picture);
  std::vector<BetweenBlocks> columns(picture.width);
  for (int x = 0; x < picture.width; ++x) columns[x] = betweenBlocks(x, slow.columns);
  std::array<std::vector<float>, 4> row_values;
  for (auto& values : row_values) values.resize(slow.columns);
  for (int y = 0; y < picture.height; ++y) {
    const BetweenBlocks rows = betweenBlocks(y, slow.rows);
    for (int c = 0; c < 4; ++c) {
      const float* plane = c == 3 ? slow.light.data() : slow.means[c].data();
      const float* first = plane + rows.first * slow.columns;
      const float* second = plane + rows.second * slow.columns;
      for (int i = 0; i < slow.columns; ++i)
        row_values[c][i] = first[i] + rows.share * (second[i] - first[i]);
    }
    const auto at = [&](int c, const BetweenBlocks& b) {
      const float* values = row_values[c].data();
      return values[b.first] + b.share * (values[b.second] - values[b.first]);
    };
    for (int x = 0; x < picture.width; ++x) {
      const float light = 1 / at(3, columns[x]);
      for (int c = 0; c < 3; ++c) {
        float& value = picture.planes[c][y * picture.width + x];
        value = value * light - at(c, columns[x]);
      }
    }
  }
}

Picture halved(const Picture& picture) {
  Picture half;
  half.width = picture.width / 2;
  half.height = picture.height / 2;
  half.scale = picture.scale / 2;
  std::vector<float> across(static_cast<std::size_t>(half.width) * picture.height);
  const auto line = [](const float* in, float* out, int count, int stride, int pixels) {
    for (int i = 0; i < count; ++i) {
      const int a = std::max(2 * i - 1, 0), d = std::min(2 * i + 2, pixels - 1);
      out[i * stride] =
          (in[a * stride] + in[d * stride] + 3 * (in[2 * i * stride] + in[(2 * i + 1) * stride])) /
          8;
    }
  };
  for (int c = 0; c < 3; ++c) {
    const std::vector<float>& plane = picture.planes[c];
    for (int y = 0; y < picture.height; ++y)
      line(&plane[y * picture.width], &across[y * half.width], half.width, 1, picture.width);
    half.planes[c].resize(static_cast<std::size_t>(half.width) * half.height);
    for (int x = 0; x < half.width; ++x)
      line(&across[x], &half.planes[c][x], half.height, half.width, picture.height);
  }
  return half;
}

}  // namespace seamwise
