#include "photo/lattice/autocorrelation.h"

#include <algorithm>

#include "photo/base/fourier.h"

namespace seamwise {
namespace {

constexpr int kWeightBlock = 8;  // block size for weights, which vary slowly. [pixels]

/// Returns the next even length with no prime factors other than 2, 3 and 5.
int transformLength(int least) {
  for (int n = least + least % 2;; n += 2) {
    int rest = n;
    for (const int factor : {2, 3, 5})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return n;
  }
}

/// Sum of w(x) w(x + s), from sums over blocks.
class WeightOverlap {
 public:
  explicit WeightOverlap(const WeightedPlanes& planes)
      : columns_((planes.width + kWeightBlock - 1) / kWeightBlock),
        rows_((planes.height + kWeightBlock - 1) / kWeightBlock),
        weights_(static_cast<std::size_t>(columns_) * rows_) {
    for (int y = 0; y < planes.height; ++y)
      for (int x = 0; x < planes.width; ++x)
        weights_[(y / kWeightBlock) * columns_ + x / kWeightBlock] +=
            planes.weight[y * planes.width + x];
  }

  /// Returns the sum for a shift by whole blocks.
  double at(int dx, int dy) const {
    float sum = 0;
    const int x0 = std::max(0, -dx), x1 = std::min(columns_, columns_ - dx);
    for (int y = 0; y + dy < rows_; ++y) {
      const float* here = &weights_[y * columns_];
      const float* there = &weights_[(y + dy) * columns_];
      for (int x = x0; x < x1; ++x) sum += here[x] * there[x + dx];
    }
    return sum;
  }

 private:
  int columns_, rows_;
  std::vector<float> weights_;
};

/// Computes the share of overlap at every shift, bilinear between shifts by whole blocks.
void fillOverlap(const WeightedPlanes& planes, Autocorrelation& result) {
  const WeightOverlap weights(planes);
  const int blocks_x = result.reach_x / kWeightBlock + 1,
            blocks_y = result.reach_y / kWeightBlock + 1;
  const int columns = 2 * blocks_x + 1;
  std::vector<double> coarse(static_cast<std::size_t>(columns) * (blocks_y + 1));
  const double all = weights.at(0, 0);
  for (int y = 0; y <= blocks_y; ++y)
    for (int x = -blocks_x; x <= blocks_x; ++x)
      coarse[y * columns + x + blocks_x] = all > 0 ? weights.at(x, y) / all : 0;
  for (int y = 0; y <= result.reach_y; ++y) {
    const int row = y / kWeightBlock;
    const double v = static_cast<double>(y % kWeightBlock) / kWeightBlock;
    for (int x = -result.reach_x; x <= result.reach_x; ++x) {
      const int from_left = x + blocks_x * kWeightBlock;
      const double* corner = &coarse[row * columns + from_left / kWeightBlock];
      const double u = static_cast<double>(from_left % kWeightBlock) / kWeightBlock;
      result.overlap[y * result.columns() + x + result.reach_x] =
          static_cast<float>((1 - v) * ((1 - u) * corner[0] + u * corner[1]) +
                             v * ((1 - u) * corner[columns] + u * corner[columns + 1]));
    }
  }
}

}  // namespace

double Autocorrelation::between(const std::vector<float>& plane, const Vec2& s) const {
  const Vec2 up = s.y() < 0 ? Vec2(-s) : s;
  const int x = std::clamp(static_cast<int>(std::floor(up.x())), -reach_x, reach_x - 1);
  const int y = std::clamp(static_cast<int>(std::floor(up.y())), 0, reach_y - 1);
  const double u = up.x() - x, v = up.y() - y;
  const float* corner = &plane[y * columns() + x + reach_x];
  return (1 - v) * ((1 - u) * corner[0] + u * corner[1]) +
         v * ((1 - u) * corner[columns()] + u * corner[columns() + 1]);
}

Autocorrelation autocorrelation(const WeightedPlanes& planes, int reach_x, int reach_y,
                                double least_overlap) {
  Autocorrelation result;
  result.reach_x = std::min(reach_x, planes.width - 1);
  result.reach_y = std::min(reach_y, planes.height - 1);
  result.r.resize(static_cast<std::size_t>(result.columns()) * (result.reach_y + 1));
  result.overlap.resize(result.r.size());
  fillOverlap(planes, result);

  // Both planes are the real and imaginary parts, so |F(k)|^2 + |F(-k)|^2 is twice the sum of their
  // power spectra. This is even, so its inverse transform equals its forward one except for scale.
  const int width = transformLength(planes.width + result.reach_x);
  const int height = transformLength(planes.height + result.reach_y);
  std::vector<ComplexFloat> spectrum(static_cast<std::size_t>(width) * height);
  const auto at = [&](int x, int y) -> ComplexFloat& {
    return spectrum[static_cast<std::size_t>(y) * width + x];
  };
  for (int y = 0; y < planes.height; ++y) {
    for (int x = 0; x < planes.width; ++x) {
      const int i = y * planes.width + x;
      at(x, y) = {planes.first[i] * planes.weight[i], planes.second[i] * planes.weight[i]};
    }
  }
  const FourierLines columns{width, height, 1, width};
  transformLines(spectrum, {planes.height, width, width, 1});  // the rows below are zero
  transformLines(spectrum, columns);
  for (int y = 0; y <= height / 2; ++y) {
    const int other_y = y == 0 ? 0 : height - y;
    for (int x = 0; x < width; ++x) {
      ComplexFloat& here = at(x, y);
      ComplexFloat& opposite = at(x == 0 ? 0 : width - x, other_y);
      const float power = std::norm(here) + std::norm(opposite);
      here = opposite = power;
      if (y == other_y && 2 * x >= width) break;
    }
  }
  transformLines(spectrum, columns);
  transformLines(spectrum, {result.reach_y + 1, width, width, 1});

  const float all = at(0, 0).real();
  for (int y = 0; y <= result.reach_y; ++y) {
    for (int x = -result.reach_x; x <= result.reach_x; ++x) {
      const int i = y * result.columns() + x + result.reach_x;
      const float overlap = result.overlap[i];
      const bool is_known = all > 0 && overlap >= static_cast<float>(least_overlap);
      result.r[i] = is_known ? at(x < 0 ? x + width : x, y).real() / (all * overlap) : 0;
    }
  }
  return result;
}

}  // namespace seamwise
