#include "photo/tile/tile_cell.h"

#include <algorithm>
#include <cmath>

#include "base/sort_by.h"

namespace seamwise {
namespace {

std::array<float, 3> onWhite(const PixelView& pixels, int column, int row) {
  const std::uint8_t* const from =
      pixels.rgba.data() + 4 * (static_cast<std::size_t>(row) * pixels.width + column);
  const float opaque = from[3] / 255.0f;
  std::array<float, 3> colour{};
  for (int c = 0; c < 3; ++c) colour[c] = opaque * from[c] / 255.0f + 1 - opaque;
  return colour;
}

/// Returns the pixel line at a place along a side, twice, or the two lines averaged by an added
/// line.
std::array<int, 2> linesAt(int place, int pixels, int more) {
  const int all = pixels + more;
  const int wrapped = ((place % all) + all) % all;
  return wrapped < pixels ? std::array{wrapped, wrapped} : std::array{pixels - 1, 0};
}

/// Returns a pixel of a tile that repeats edge to edge, on white. [0, 1]
std::array<float, 3> tileColour(const SeamlessTile& tile, int x, int y) {
  const auto columns = linesAt(x, tile.pixels.width, tile.more_columns);
  const auto rows = linesAt(y, tile.pixels.height, tile.more_rows);
  const auto one = onWhite(tile.pixels, columns[0], rows[0]);
  if (columns[0] == columns[1] && rows[0] == rows[1]) return one;
  const auto other = onWhite(tile.pixels, columns[1], rows[1]);
  return {(one[0] + other[0]) / 2, (one[1] + other[1]) / 2, (one[2] + other[2]) / 2};
}

/// Returns the standard deviation of one colour's noise: the difference of neighbouring pixels from
/// a slope, in the calmer half of places. Motifs with sharp sides and flat areas have none. [0, 1]
double tileNoise(const SeamlessTile& tile) {
  constexpr int kMost = 40000;
  const std::size_t count = static_cast<std::size_t>(tile.width()) * tile.height();
  const std::size_t stride = std::max<std::size_t>(1, count / kMost) | 1;
  std::vector<double> bends;
  for (std::size_t p = 0; p < count; p += stride) {
    const int x = static_cast<int>(p % tile.width()), y = static_cast<int>(p / tile.width());
    const float middle = tileColour(tile, x, y)[1];
    const float left = tileColour(tile, x - 1, y)[1], right = tileColour(tile, x + 1, y)[1];
    bends.push_back(std::abs(left - 2 * middle + right));
  }
  sortNumbers(bends);
  // Second differences of a normal distribution have 6 times its variance.
  return bends[bends.size() / 2] / (0.6745 * std::sqrt(6.0));
}

}  // namespace

TileCell::TileCell(const SeamlessTile& tile, const LatticeMap& map, const CellGrid& grid)
    : tile_(tile),
      grid_(grid),
      origin_(map({0, 0})),
      w1_(map({1, 0}) - origin_),
      w2_(map({0, 1}) - origin_) {
  const double apart = std::max(w1_.norm() / grid.columns, w2_.norm() / grid.rows);
  times_ = std::clamp(static_cast<int>(std::ceil(apart)), 1, 64);
  for (auto& plane : planes_) plane.resize(static_cast<std::size_t>(grid.columns) * grid.rows);
}

bool TileCell::advance(int places) {
  for (; row_ < grid_.rows && places > 0; ++row_) {
    for (int column = 0; column < grid_.columns; ++column) sample(column, row_);
    places -= grid_.columns * times_ * times_;
  }
  return row_ < grid_.rows;
}

void TileCell::sample(int column, int row) {
  std::array<float, 3> sum{};
  for (int s = 0; s < times_ * times_; ++s) {
    const int up = s / times_;
    const double u = (column + (s % times_ + 0.5) / times_ - 0.5 + grid_.offset) / grid_.columns;
    const double v = (row + (up + 0.5) / times_ - 0.5 + grid_.offset) / grid_.rows;
    const Vec2 p = origin_ + u * w1_ + v * w2_ - Vec2(0.5, 0.5);
    const int x = static_cast<int>(std::floor(p.x())), y = static_cast<int>(std::floor(p.y()));
    const auto right = static_cast<float>(p.x() - x), below = static_cast<float>(p.y() - y);
    const auto a = tileColour(tile_, x, y), b = tileColour(tile_, x + 1, y);
    const auto c = tileColour(tile_, x, y + 1), d = tileColour(tile_, x + 1, y + 1);
    for (int k = 0; k < 3; ++k) {
      sum[k] += (1 - below) * ((1 - right) * a[k] + right * b[k]) +
                below * ((1 - right) * c[k] + right * d[k]);
    }
  }
  const std::size_t at = static_cast<std::size_t>(row) * grid_.columns + column;
  for (int k = 0; k < 3; ++k) planes_[k][at] = sum[k] / static_cast<float>(times_ * times_);
}

CellPicture TileCell::picture() const {
  // Squares of the opponent channels' coefficients, and pixels averaged in a sample.
  constexpr double kChannelGain = 1.0 / 3 + 0.49 * 2 + 0.49 * 1.5;
  const auto samples = static_cast<double>(planes_[0].size());
  const double pixels = std::max(1.0, std::abs(cross(w1_, w2_)) / samples);
  const double deviation = tileNoise(tile_);
  const auto noise = static_cast<float>(kChannelGain * deviation * deviation / pixels);
  return {grid_.columns, planes_, std::vector<float>(planes_[0].size(), noise)};
}

}  // namespace seamwise
