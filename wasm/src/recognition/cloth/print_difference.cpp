#include "recognition/cloth/print_difference.h"

#include <algorithm>
#include <cmath>

#include "recognition/base/map_inverse.h"
#include "recognition/cloth/copy_fields_fit.h"
#include "recognition/cloth/lattice_canvas.h"
#include "recognition/cloth/robust_mean.h"

namespace seamwise {

namespace {

constexpr int kLongerSide = 1280;  // of what is compared. [px]
constexpr int kFewestSamples = 16, kMostSamples = 160;
constexpr int kPixelsAtOnce = 1 << 22;

int reductionOf(const PixelView& pixels) {
  return (std::max(pixels.width, pixels.height) + kLongerSide - 1) / kLongerSide;
}

}  // namespace

PrintDifference::PrintDifference(const PixelView& pixels, const LatticeMap& map)
    : factor_(reductionOf(pixels)),
      reduced_(pixels, factor_),
      n_(std::clamp(static_cast<int>(cellSize(map) / factor_), kFewestSamples, kMostSamples)) {
  while (reduced_.advance(kPixelsAtOnce)) {
  }
  CopyFieldsFit fit(pixels, map, curve_);
  while (fit.advance()) {
  }
  fields_ = fit.fields();
  average(map, pixels.width, pixels.height);
  compare(map);
}

PixelLanes PrintDifference::flattened(PixelLanes colour, float x, float y) const {
  float light[3];
  fields_.light.at(x, y, light);
  for (int c = 0; c < 3; ++c)
    colour[c] = 255 * curve_.code(curve_.linear(colour[c] / 255) * std::exp(-light[c]));
  return colour;
}

void PrintDifference::average(const LatticeMap& map, int width, int height) {
  LatticeCanvas canvas = latticeCanvas(map, width, height, n_);
  sampleCanvas(reduced_.view(), factor_, fields_.shift, &canvas);
  std::vector<PixelLanes> copies;
  for (int b = 0; b < n_; ++b) {
    for (int a = 0; a < n_; ++a) {
      copies.clear();
      for (int row = b; row < canvas.rows(); row += n_) {
        for (int column = a; column < canvas.columns(); column += n_) {
          const std::size_t k = static_cast<std::size_t>(row) * canvas.columns() + column;
          if (!canvas.seen[k]) continue;
          const auto& [red, green, blue] = canvas.planes;
          const PixelLanes coded = {255 * red[k], 255 * green[k], 255 * blue[k], 0};
          PixelLanes colour = flattened(coded, canvas.x[k], canvas.y[k]) / 255;
          colour[3] = 1;
          copies.push_back(colour);
        }
      }
      mean_.push_back(255 * agreedColour(copies.data(), static_cast<int>(copies.size())).colour);
    }
  }
}

PixelLanes PrintDifference::printAt(const Vec2& u) const {
  const Vec2 p = n_ * (u - u.array().floor().matrix());
  const int a = static_cast<int>(p.x()), b = static_cast<int>(p.y());
  const float s = static_cast<float>(p.x() - a), t = static_cast<float>(p.y() - b);
  const auto mean = [&](int i, int j) { return mean_[(b + j) % n_ * n_ + (a + i) % n_]; };
  return (1 - t) * ((1 - s) * mean(0, 0) + s * mean(1, 0)) +
         t * ((1 - s) * mean(0, 1) + s * mean(1, 1));
}

void PrintDifference::compare(const LatticeMap& map) {
  const PixelView view = reduced_.view();
  const MapInverse inverse(map);
  columns_ = view.width;
  rows_ = view.height;
  difference_.resize(static_cast<std::size_t>(columns_) * rows_);
  std::size_t k = 0;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column, ++k) {
      const Vec2 p = factor_ * Vec2(column + 0.5, row + 0.5);
      const float x = static_cast<float>(p.x()), y = static_cast<float>(p.y());
      float shift[2];
      fields_.shift.at(x, y, shift);
      const PixelLanes print = printAt(inverse(p - Vec2(shift[0], shift[1])));
      const PixelLanes off = flattened(internal::pixelAt(&view.rgba[4 * k]), x, y) - print;
      difference_[k] = std::abs(off[0]) + std::abs(off[1]) + std::abs(off[2]);
    }
  }
}

float PrintDifference::at(const Vec2& p) const {
  const double x = p.x() / factor_ - 0.5, y = p.y() / factor_ - 0.5;
  if (!(x >= 0 && y >= 0 && x < columns_ - 1 && y < rows_ - 1)) return 0;
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  const float s = static_cast<float>(x - i), t = static_cast<float>(y - j);
  const float* above = &difference_[static_cast<std::size_t>(j) * columns_ + i];
  const float* below = above + columns_;
  return (1 - t) * ((1 - s) * above[0] + s * above[1]) + t * ((1 - s) * below[0] + s * below[1]);
}

}  // namespace seamwise
