#include "recognition/lattice/autocorrelation.h"

#include <algorithm>
#include <complex>
#include <unsupported/Eigen/FFT>

namespace seamwise {
namespace {

using Complex = std::complex<float>;

constexpr int kWeightBlock = 8;  // weights vary slowly: every eighth pixel tells. [pixels]

/// The next length with no other prime factors than 2, 3 and 5, even.
int transformLength(int least) {
  for (int n = least + least % 2;; n += 2) {
    int rest = n;
    for (const int factor : {2, 3, 5})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return n;
  }
}

/// Values of a plane as complex numbers, and their transforms, in place.
class Spectrum {
 public:
  Spectrum(int width, int height)
      : width_(width), height_(height), values_(static_cast<std::size_t>(width) * height) {}

  Complex& at(int x, int y) { return values_[static_cast<std::size_t>(y) * width_ + x]; }
  int width() const { return width_; }
  int height() const { return height_; }

  /// @param rows   those from there on hold zeros
  void forward(int rows) {
    alongRows(rows);
    alongColumns();
  }
  void backward(int rows) {
    alongColumns();
    alongRows(rows);
  }

 private:
  // The values are transformed forward both times: of a spectrum that is even, the inverse is the
  // same but for its scale.
  void alongRows(int rows) {
    std::vector<Complex> out(width_);
    for (int y = 0; y < rows; ++y) {
      fft_.fwd(out.data(), &at(0, y), width_);
      std::copy(out.begin(), out.end(), &at(0, y));
    }
  }

  void alongColumns() {
    // Several columns at once, because memory is fetched in lines of several numbers.
    constexpr int kAtOnce = 8;
    std::vector<Complex> in(static_cast<std::size_t>(height_) * kAtOnce), out(height_);
    for (int x = 0; x < width_; x += kAtOnce) {
      const int count = std::min(kAtOnce, width_ - x);
      for (int y = 0; y < height_; ++y)
        for (int k = 0; k < count; ++k) in[k * height_ + y] = at(x + k, y);
      for (int k = 0; k < count; ++k) {
        fft_.fwd(out.data(), &in[k * height_], height_);
        std::copy(out.begin(), out.end(), &in[k * height_]);
      }
      for (int y = 0; y < height_; ++y)
        for (int k = 0; k < count; ++k) at(x + k, y) = in[k * height_ + y];
    }
  }

  int width_, height_;
  std::vector<Complex> values_;
  Eigen::FFT<float> fft_;
};

/// Sum of w(x) w(x + s), from means over blocks.
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

  /// For shifts by whole blocks.
  double at(int dx, int dy) const {
    float sum = 0;
    const int x0 = std::max(0, -dx), x1 = std::min(columns_, columns_ - dx);
    for (int y = 0; y + dy < rows_; ++y) {
      const float* here = &weights_[y * columns_];
      const float* there = &weights_[(y + dy) * columns_ + dx];
      for (int x = x0; x < x1; ++x) sum += here[x] * there[x];
    }
    return sum;
  }

 private:
  int columns_, rows_;
  std::vector<float> weights_;
};

/// The share of overlap at every shift, bilinear between shifts by whole blocks.
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

  // With both planes as real and imaginary part, |F(k)|^2 + |F(-k)|^2 is twice the sum of their
  // power spectra.
  Spectrum spectrum(transformLength(planes.width + result.reach_x),
                    transformLength(planes.height + result.reach_y));
  for (int y = 0; y < planes.height; ++y) {
    for (int x = 0; x < planes.width; ++x) {
      const int i = y * planes.width + x;
      spectrum.at(x, y) = {planes.first[i] * planes.weight[i], planes.second[i] * planes.weight[i]};
    }
  }
  spectrum.forward(planes.height);
  const int width = spectrum.width(), height = spectrum.height();
  for (int y = 0; y <= height / 2; ++y) {
    const int other_y = y == 0 ? 0 : height - y;
    for (int x = 0; x < width; ++x) {
      Complex& here = spectrum.at(x, y);
      Complex& opposite = spectrum.at(x == 0 ? 0 : width - x, other_y);
      const float power = std::norm(here) + std::norm(opposite);
      here = opposite = power;
      if (y == other_y && 2 * x >= width) break;
    }
  }
  spectrum.backward(result.reach_y + 1);

  const float all = spectrum.at(0, 0).real();
  for (int y = 0; y <= result.reach_y; ++y) {
    for (int x = -result.reach_x; x <= result.reach_x; ++x) {
      const int i = y * result.columns() + x + result.reach_x;
      const float overlap = result.overlap[i];
      const bool is_known = all > 0 && overlap >= static_cast<float>(least_overlap);
      result.r[i] = is_known ? spectrum.at(x < 0 ? x + width : x, y).real() / (all * overlap) : 0;
    }
  }
  return result;
}

}  // namespace seamwise
