#include "photo/lattice/tilted_planes.h"

#include <algorithm>
#include <cmath>

namespace seamwise {
namespace {

constexpr int kPowerSteps = 30;         // power iterations; two equal axes may mix, which is fine
constexpr double kWidest = 1.7;         // maximum extent of the tilted part, in its own half sides
constexpr double kLeastNearness = 0.2;  // minimum nearness of fabric, relative to the middle

constexpr int kEvenBlocks = 20;  // blocks along the longer side; chosen

}  // namespace

std::array<std::array<float, 3>, 2> principalAxes(const ChannelImage& image) {
  Mat3 covariance = Mat3::Zero();
  for (std::size_t i = 0; i < image.samples.size(); i += 4) {
    const Vec3 pixel(image.samples[i], image.samples[i + 1], image.samples[i + 2]);
    covariance += pixel * pixel.transpose();
  }
  std::array<std::array<float, 3>, 2> axes{};
  for (auto& axis : axes) {
    Vec3 v(1, 0.8, 0.6);
    for (int k = 0; k < kPowerSteps; ++k) {
      const Vec3 next = covariance * v;
      const double length = next.norm();
      if (!(length > 0)) break;
      v = next / length;
    }
    for (int c = 0; c < 3; ++c) axis[c] = static_cast<float>(v[c]);
    covariance -= v.dot(covariance * v) * v * v.transpose();
  }
  return axes;
}

BlockWeights evenWeights(const ChannelImage& image) {
  BlockWeights blocks;
  blocks.side = static_cast<float>(std::max(image.width, image.height)) / kEvenBlocks;
  blocks.columns = static_cast<int>(static_cast<float>(image.width - 1) / blocks.side) + 1;
  blocks.rows = static_cast<int>(static_cast<float>(image.height - 1) / blocks.side) + 1;
  const std::size_t count = static_cast<std::size_t>(blocks.columns) * blocks.rows;
  std::vector<float> counts(count);
  blocks.values.assign(count, 0);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::size_t k = static_cast<int>(static_cast<float>(y) / blocks.side) * blocks.columns +
                            static_cast<int>(static_cast<float>(x) / blocks.side);
      const float* sample = &image.samples[4 * (static_cast<std::size_t>(y) * image.width + x)];
      for (int c = 0; c < 3; ++c) blocks.values[k] += sample[c] * sample[c];
      counts[k] += 1;
    }
  }
  for (std::size_t k = 0; k < count; ++k) blocks.values[k] /= std::max(1.0F, counts[k]);
  std::vector<float> sorted = blocks.values;
  std::nth_element(sorted.begin(), sorted.begin() + count / 2, sorted.end());
  const float median = sorted[count / 2];
  for (float& value : blocks.values) value = value > median ? std::sqrt(median / value) : 1;
  return blocks;
}

WeightedPlanes tiltedPlanes(const ChannelImage& image,
                            const std::array<std::array<float, 3>, 2>& axes, const TiltedPart& part,
                            const BlockWeights& blocks) {
  const double radius = std::max(image.width, image.height) / 2.0;  // [pixels of the image]
  const Vec2 half = part.share * Vec2(image.width, image.height) / (2 * radius);
  Vec2 low(1e9, 1e9), high(-1e9, -1e9);
  for (int k = 0; k < 4; ++k) {
    const Vec2 p = part.middle +
                   Vec2((k & 1) != 0 ? half.x() : -half.x(), (k & 2) != 0 ? half.y() : -half.y());
    const Vec2 q = p / std::max(kLeastNearness, 1 - part.tilt.dot(p));
    low = low.cwiseMin(q), high = high.cwiseMax(q);
  }
  low = low.cwiseMax(part.middle - kWidest * half);
  high = high.cwiseMin(part.middle + kWidest * half);
  WeightedPlanes planes;
  planes.width = static_cast<int>((high.x() - low.x()) * radius);
  planes.height = static_cast<int>((high.y() - low.y()) * radius);
  const std::size_t count = static_cast<std::size_t>(planes.width) * planes.height;
  planes.first.assign(count, 0);
  planes.second.assign(count, 0);
  planes.weight.assign(count, 0);
  const float pixels = static_cast<float>(radius / image.scale);
  const float mx = static_cast<float>(image.width) / (2 * image.scale);
  const float my = static_cast<float>(image.height) / (2 * image.scale);
  // Sines over the part's sides come from tables, because computing them would take longer than
  // everything else here.
  constexpr int kTable = 512;
  std::array<float, kTable + 1> sines{};
  for (int k = 0; k <= kTable; ++k) sines[k] = static_cast<float>(std::sin(kPi * k / kTable));
  const auto window = [&](float p, double side) {
    const float at = (p / static_cast<float>(side) + 1) * (kTable / 2.0F);
    return at > 0 && at < kTable ? sines[static_cast<int>(at)] : 0.0F;
  };
  const float from_x = static_cast<float>(part.middle.x()),
              from_y = static_cast<float>(part.middle.y());
  const float tx = static_cast<float>(part.tilt.x()), ty = static_cast<float>(part.tilt.y());
  for (int y = 0; y < planes.height; ++y) {
    const float qy = static_cast<float>(low.y() + (y + 0.5) / radius);
    for (int x = 0; x < planes.width; ++x) {
      const float qx = static_cast<float>(low.x() + (x + 0.5) / radius);
      const float z = 1 + tx * qx + ty * qy;
      if (z < static_cast<float>(kLeastNearness)) continue;
      const float px = qx / z, py = qy / z;
      float weight = window(px - from_x, half.x()) * window(py - from_y, half.y());
      ChannelImage::Patch patch;
      if (weight == 0 || !image.look(mx + pixels * px, my + pixels * py, patch)) continue;
      if (!blocks.values.empty()) {
        const float scale = image.scale / blocks.side;
        const int column = static_cast<int>((mx + pixels * px) * scale);
        const int row = static_cast<int>((my + pixels * py) * scale);
        weight *= blocks.values[std::min(row, blocks.rows - 1) * blocks.columns +
                                std::min(column, blocks.columns - 1)];
      }
      const std::size_t i = static_cast<std::size_t>(y) * planes.width + x;
      planes.weight[i] = weight;
      for (int c = 0; c < 3; ++c) {
        planes.first[i] += axes[0][c] * patch.value[c];
        planes.second[i] += axes[1][c] * patch.value[c];
      }
    }
  }
  return planes;
}

}  // namespace seamwise
