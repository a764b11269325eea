#include "recognition/cloth/tile_symmetry.h"

#include <algorithm>
#include <cmath>

namespace seamwise {

namespace {

constexpr double kOnPixel = 1e-6;  // of a pixel

int wrappedPixel(int i, int n) {
  const int rest = i % n;
  return rest < 0 ? rest + n : rest;
}

/// Four pixels and their shares around a place that is given in pixels.
struct CubicReach {
  CubicReach(double place, int n) {
    const double whole = std::floor(place + kOnPixel);
    const float t = static_cast<float>(place - whole);
    const int first = static_cast<int>(whole);
    for (int k = 0; k < 4; ++k) at[k] = wrappedPixel(first - 1 + k, n);
    between = std::abs(place - whole) > kOnPixel;
    share[0] = 0.5f * t * (-1 + t * (2 - t));
    share[1] = 1 + 0.5f * t * t * (-5 + 3 * t);
    share[2] = 0.5f * t * (1 + t * (4 - 3 * t));
    share[3] = 0.5f * t * t * (t - 1);
  }
  int at[4];
  float share[4];
  bool between;
};

}  // namespace

TileSymmetry::TileSymmetry(std::array<std::vector<float>, 3> planes, int columns, int rows,
                           const GroupData& group)
    : planes_(std::move(planes)), columns_(columns), rows_(rows), elements_(cosets(group)) {
  for (std::vector<float>& plane : symmetric_)
    plane.assign(static_cast<std::size_t>(columns) * rows, 0);
}

bool TileSymmetry::advance(int samples) {
  for (; row_ < rows_ && samples > 0; ++row_) {
    for (const LatticeElement& element : elements_) add(element, row_);
    samples -= columns_ * static_cast<int>(elements_.size());
  }
  return row_ < rows_;
}

void TileSymmetry::add(const LatticeElement& element, int row) {
  const float share = 1 / static_cast<float>(elements_.size());
  const double v = (row + 0.5) / rows_;
  for (int i = 0; i < columns_; ++i) {
    const double u = (i + 0.5) / columns_;
    const auto& [m, a] = element;
    const CubicReach x((m[0] * u + m[1] * v + a[0]) * columns_ - 0.5, columns_);
    const CubicReach y((m[2] * u + m[3] * v + a[1]) * rows_ - 0.5, rows_);
    const std::size_t to = static_cast<std::size_t>(row) * columns_ + i;
    for (int c = 0; c < 3; ++c) {
      const std::vector<float>& plane = planes_[c];
      float sum = 0;
      if (!x.between && !y.between) {
        sum = plane[static_cast<std::size_t>(y.at[1]) * columns_ + x.at[1]];
      } else {
        for (int k = 0; k < 4; ++k) {
          const float* line = plane.data() + static_cast<std::size_t>(y.at[k]) * columns_;
          sum += y.share[k] * (x.share[0] * line[x.at[0]] + x.share[1] * line[x.at[1]] +
                               x.share[2] * line[x.at[2]] + x.share[3] * line[x.at[3]]);
        }
      }
      symmetric_[c][to] += share * sum;
    }
  }
}

}  // namespace seamwise
