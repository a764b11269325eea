#include "photo/fabric/cell_mean.h"

#include <algorithm>
#include <cmath>

#include "photo/base/map_inverse.h"

namespace seamwise {

namespace {
/// Parts of a row between knots of place and light: fields bend over a third of a row.
constexpr int kRowParts = 32;
constexpr int kShortestPart = 4, kLongestPart = 32;  // samples
constexpr float kLeastCopyWeight = 1e-3f;
constexpr double kEqualLengths = 0.01;
constexpr int kTileMultiple = 12;  // keeps halves, thirds, quarters and sixths of the cell

// sRGB: linear light is ((code + 0.055) / 1.055)^2.4 for codes above the toe, and proportional to
// codes below it.
constexpr float kSrgbGamma = 2.4f, kSrgbOffset = 0.055f, kSrgbToe = 0.04045f;

/// Returns coded colours after their linear light is multiplied by gains^2.4. The result is exact
/// above the toe, where code + 0.055 is multiplied by `gains`, and linear down to black below it.
PixelLanes underLight(const PixelLanes& code, const PixelLanes& gains) {
  const PixelLanes lit = (code + kSrgbOffset) * gains - kSrgbOffset;
  const PixelLanes dark =
      code * (((kSrgbToe + kSrgbOffset) * gains - kSrgbOffset) * (1 / kSrgbToe));
  return least(greatest(code < kSrgbToe ? dark : lit, PixelLanes{0, 0, 0, 0}),
               PixelLanes{1, 1, 1, 1});
}
}  // namespace

CellGrid nativeGrid(const LatticeMap& map, const Mat2& gram, const Mat2& basis, const Vec2& origin,
                    const GridLimits& limits) {
  const double along = std::sqrt(gram(0, 0)), up = std::sqrt(gram(1, 1));
  const double sine =
      std::sqrt(std::max(gram(0, 0) * gram(1, 1) - gram(0, 1) * gram(1, 0), 0.0)) / (along * up);
  // Side of a square with the cell's area in pixels, relative to its length in the gram's unit.
  const double px = cellSize(map.rebased(basis, origin)) / std::sqrt(along * up * sine);
  const double side = px * std::max(along, up);
  const double factor = std::min(limits.denser, limits.longest / side);
  const auto whole = [&](double length) {
    const double n = px * factor * length;
    const int multiple = n >= 4 * kTileMultiple ? kTileMultiple : 1;
    return std::max(1, static_cast<int>(std::lround(n / multiple)) * multiple);
  };
  CellGrid grid;
  grid.offset = 0.5;
  grid.basis = basis;
  grid.origin = origin;
  grid.columns = whole(along);
  grid.rows = std::abs(along - up) < kEqualLengths * along ? grid.columns : whole(up);
  return grid;
}

CellMean::CellMean(const PixelView& pixels, int factor, const LatticeMap& map,
                   const CopyFields& fields, const CellGrid& grid, double flatten)
    : pixels_(pixels),
      scale_(1.0 / factor),
      map_(map.rebased(grid.basis, grid.origin)),
      fields_(fields),
      grid_(grid),
      flatten_(static_cast<float>(flatten)),
      cells_(map_, pixels.width * factor, pixels.height * factor),
      part_(std::clamp(grid.columns / kRowParts, kShortestPart, kLongestPart)),
      copies_(static_cast<std::size_t>(grid.columns) * cells_.across * cells_.up),
      counts_(grid.columns) {
  const std::size_t size = static_cast<std::size_t>(grid.columns) * grid.rows;
  for (std::vector<float>& plane : planes_) plane.resize(size);
  noise_.resize(size);
}

bool CellMean::advance(int samples) {
  for (; row_ < grid_.rows && samples > 0; ++row_) {
    std::fill(counts_.begin(), counts_.end(), 0);
    for (int v = 0; v < cells_.up; ++v)
      for (int u = 0; u < cells_.across; ++u)
        samples -= addCopy(cells_.first_u + u, cells_.first_v + v);
    agree();
  }
  return row_ < grid_.rows;
}

CellMean::Knot CellMean::knotAt(double column, double row, int cell_u, int cell_v) const {
  const Vec2 u((column + grid_.offset) / grid_.columns + cell_u,
               (row + grid_.offset) / grid_.rows + cell_v);
  const Vec2 p = map_(u);
  const float x = static_cast<float>(p.x()), y = static_cast<float>(p.y());
  const Vec2 low = p * scale_;
  const double margin = 2 + 0.1 * pixels_.width;
  Knot knot{0, 0, {1, 1, 1, 1}, 0, false};
  knot.seen = low.x() > -margin && low.y() > -margin && low.x() < pixels_.width + margin &&
              low.y() < pixels_.height + margin;
  if (!knot.seen) return knot;
  float shift[2], light[3];
  fields_.shift.at(x, y, shift);
  fields_.light.at(x, y, light);
  fields_.weight.at(x, y, &knot.weight);
  knot.x = static_cast<float>((p.x() + shift[0]) * scale_);
  knot.y = static_cast<float>((p.y() + shift[1]) * scale_);
  for (int c = 0; c < 3; ++c) knot.gains[c] = std::exp(-flatten_ / kSrgbGamma * light[c]);
  return knot;
}

int CellMean::addCopy(int cell_u, int cell_v) {
  int looked_at = 0;
  Knot from = knotAt(0, row_, cell_u, cell_v);
  for (int first = 0; first < grid_.columns; first += part_) {
    const Knot to = knotAt(first + part_, row_, cell_u, cell_v);
    if (from.seen && to.seen) {
      const int end = std::min(first + part_, grid_.columns);
      addPart(from, to, first, end);
      looked_at += end - first;
    }
    from = to;
    looked_at += 2;
  }
  return looked_at;
}

void CellMean::addPart(const Knot& from, const Knot& to, int first, int end) {
  const std::size_t most = static_cast<std::size_t>(cells_.across) * cells_.up;
  for (int i = first; i < end; ++i) {
    const float t = static_cast<float>(i - first) / static_cast<float>(part_);
    const float weight = from.weight + t * (to.weight - from.weight);
    if (weight < kLeastCopyWeight) continue;
    PixelLanes value = {0, 0, 0, 0};
    if (!bicubic(pixels_, from.x + t * (to.x - from.x), from.y + t * (to.y - from.y), &value))
      continue;
    const PixelLanes gains = from.gains + t * (to.gains - from.gains);
    PixelLanes colour = underLight(value * (1 / 255.0f), gains);
    colour[3] = weight;
    copies_[i * most + counts_[i]++] = colour;
  }
}

void CellMean::agree() {
  const std::size_t most = static_cast<std::size_t>(cells_.across) * cells_.up;
  for (int i = 0; i < grid_.columns; ++i) {
    const AgreedColour agreed = agreedColour(copies_.data() + i * most, counts_[i]);
    const std::size_t k = static_cast<std::size_t>(row_) * grid_.columns + i;
    for (int c = 0; c < 3; ++c) planes_[c][k] = agreed.colour[c];
    noise_[k] = agreed.noise;
  }
}

CellPicture CellMean::picture() const { return {grid_.columns, planes_, noise_}; }

std::vector<std::uint8_t> imageBytes(int columns, int rows,
                                     const std::array<std::vector<float>, 3>& planes) {
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(columns) * rows * 4, 255);
  std::size_t to = 0;
  for (int j = rows - 1; j >= 0; --j) {
    for (int i = 0; i < columns; ++i, to += 4) {
      const std::size_t from = static_cast<std::size_t>(j) * columns + i;
      for (int c = 0; c < 3; ++c)
        rgba[to + c] = static_cast<std::uint8_t>(
            std::nearbyint(std::clamp(planes[c][from], 0.0f, 1.0f) * 255.0f));
    }
  }
  return rgba;
}

}  // namespace seamwise
