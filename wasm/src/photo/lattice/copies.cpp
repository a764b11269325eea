#include "photo/lattice/copies.h"

#include <algorithm>
#include <cmath>

#include "photo/base/map_inverse.h"

namespace seamwise {
namespace {

using Pixel = ChannelImage::Pixel;

void store(float* to, const Pixel& pixel) { std::memcpy(to, &pixel, sizeof pixel); }

float squared(const Pixel& pixel) {
  return pixel[0] * pixel[0] + pixel[1] * pixel[1] + pixel[2] * pixel[2];
}

/// Returns half the image's width and height in units of its radius, half the longer side.
Vec2 halfExtent(const TiltedLattice& view) { return view.middle / view.radius; }

/// Returns whether a place is before the horizon and the fabric is not seen too obliquely there.
bool isBefore(const TiltedLattice& view, const Vec2& q) { return 1 + view.tilt.dot(q) > 0.2; }

bool isInside(const TiltedLattice& view, const Vec2& u) {
  const Vec2 q = view.basis * u + view.origin;
  if (!isBefore(view, q)) return false;
  Vec2 p = q / (1 + view.tilt.dot(q));
  p *= 1 + view.lens * p.squaredNorm();
  const Vec2 half = halfExtent(view);
  return std::abs(p.x()) < half.x() && std::abs(p.y()) < half.y();
}

}  // namespace

CellList visibleCells(const TiltedLattice& view, double reach) {
  const MapInverse latticeAt(view.map());
  const Vec2 middle = latticeAt(view.middle + view.focus);
  Vec2 low = middle, high = middle;
  for (int k = 0; k < 16; ++k) {
    // These points are along the border, because corners alone are not the farthest if the image is
    // tilted.
    const double t = (k % 4) / 2.0 - 1;
    const Vec2 half = halfExtent(view);
    const std::array<Vec2, 4> sides{Vec2(t, -1), Vec2(1, t), Vec2(-t, 1), Vec2(-1, -t)};
    const Vec2 p = sides[k / 4].cwiseProduct(half);
    if (1 - view.tilt.dot(p) < 0.1) continue;
    const Vec2 u = latticeAt(view.middle + view.radius * p);
    low = low.cwiseMin(u), high = high.cwiseMax(u);
  }
  low = low.cwiseMax(middle - Vec2(reach, reach)),
  high = high.cwiseMin(middle + Vec2(reach, reach));
  CellList cells;
  for (int j = static_cast<int>(std::floor(low.y())); j < high.y(); ++j) {
    for (int i = static_cast<int>(std::floor(low.x())); i < high.x(); ++i) {
      bool is_seen = false;
      for (const double v : {0.0, 0.5, 1.0})
        for (const double u : {0.0, 0.5, 1.0})
          is_seen = is_seen || isInside(view, Vec2(i + u, j + v));
      if (is_seen) cells.push_back({i, j});
    }
  }
  return cells;
}

Vec2 repeatsSeen(const TiltedLattice& view) {
  constexpr int kSteps = 10;  // steps per cell
  Vec2 most = Vec2::Zero();
  const CellList cells = visibleCells(view, 12);
  for (int axis = 0; axis < 2; ++axis) {
    for (const auto& cell : cells) {
      Vec2 u(cell[0] + 0.5, cell[1] + 0.5);
      if (!isInside(view, u)) continue;
      const Vec2 step = Vec2(axis == 0 ? 1 : 0, axis == 0 ? 0 : 1) / kSteps;
      int count = 1;
      for (const double side : {-1.0, 1.0})
        for (Vec2 v = u + side * step; isInside(view, v) && count < 12 * kSteps; v += side * step)
          ++count;
      most[axis] = std::max(most[axis], static_cast<double>(count) / kSteps);
    }
  }
  return most;
}

int wholeCells(const TiltedLattice& view) {
  constexpr double kFarthest = 30;  // cells from the middle
  int count = 0;
  for (const auto& cell : visibleCells(view, kFarthest)) {
    bool is_whole = true;
    for (int v = 0; v < 4; ++v)
      for (int u = 0; u < 4; ++u)
        is_whole = is_whole && isInside(view, Vec2(cell[0] + u / 3.0, cell[1] + v / 3.0));
    count += is_whole ? 1 : 0;
  }
  return count;
}

Copies sampleCopies(const ChannelImage& image, const TiltedLattice& view, CellList cells, int n,
                    bool with_slopes) {
  Copies copies;
  copies.n = n;
  copies.cells = std::move(cells);
  const std::size_t count = copies.cells.size() * copies.samples();
  copies.values.assign(4 * count, 0);
  copies.weights.assign(count, 0);
  if (with_slopes) {
    copies.slopes_x.assign(4 * count, 0);
    copies.slopes_y.assign(4 * count, 0);
  }
  const Vec2 step_q = view.basis.col(0) / n;
  const float qx_step = static_cast<float>(step_q.x()), qy_step = static_cast<float>(step_q.y());
  const float tilt_x = static_cast<float>(view.tilt.x()),
              tilt_y = static_cast<float>(view.tilt.y());
  const float lens = static_cast<float>(view.lens), radius = static_cast<float>(view.radius);
  const float mx = static_cast<float>(view.middle.x()), my = static_cast<float>(view.middle.y());
  std::size_t at = 0;
  for (const auto& cell : copies.cells) {
    for (int b = 0; b < n; ++b) {
      const Vec2 q = view.basis * Vec2(cell[0] + 0.5 / n, cell[1] + (b + 0.5) / n) + view.origin;
      float qx = static_cast<float>(q.x()), qy = static_cast<float>(q.y());
      for (int a = 0; a < n; ++a, ++at, qx += qx_step, qy += qy_step) {
        const float z = 1 + tilt_x * qx + tilt_y * qy;
        if (z < 0.2F) continue;
        const float px = qx / z, py = qy / z;
        const float bend = radius * (1 + lens * (px * px + py * py));
        ChannelImage::Patch patch;
        if (!image.look(mx + bend * px, my + bend * py, patch)) continue;
        copies.weights[at] = 1;
        store(&copies.values[4 * at], patch.value);
        if (!with_slopes) continue;
        store(&copies.slopes_x[4 * at], patch.slope_x);
        store(&copies.slopes_y[4 * at], patch.slope_y);
      }
    }
  }
  return copies;
}

CopiesMean meanOf(const Copies& copies) {
  CopiesMean mean;
  const std::size_t samples = copies.samples();
  mean.values.assign(4 * samples, 0);
  mean.weights.assign(samples, 0);
  std::size_t at = 0;
  for (std::size_t c = 0; c < copies.cells.size(); ++c) {
    for (std::size_t s = 0; s < samples; ++s, ++at) {
      const float w = copies.weights[at];
      mean.weights[s] += w;
      store(&mean.values[4 * s], loaded(&mean.values[4 * s]) + w * loaded(&copies.values[4 * at]));
    }
  }
  for (std::size_t s = 0; s < samples; ++s) {
    if (mean.weights[s] > 0)
      store(&mean.values[4 * s], loaded(&mean.values[4 * s]) * (1 / mean.weights[s]));
  }
  return mean;
}

Agreement agreementOf(const Copies& copies) {
  const std::size_t samples = copies.samples();
  Copies all = copies;  // robust weights would hide parts that do not repeat
  for (float& weight : all.weights) weight = weight > 0 ? 1.0F : 0.0F;
  const CopiesMean mean = meanOf(all);
  Pixel sum = Pixel{};
  double count = 0;
  for (std::size_t s = 0; s < samples; ++s) {
    if (mean.weights[s] < 1.5F) continue;
    sum += mean.weights[s] * loaded(&mean.values[4 * s]);
    count += mean.weights[s];
  }
  Agreement result;
  if (count == 0) return result;
  const Pixel middle = sum * static_cast<float>(1 / count);
  double residual = 0, variance = 0;
  std::vector<double> cell_residuals;
  std::size_t at = 0;
  for (std::size_t c = 0; c < copies.cells.size(); ++c) {
    double cell_residual = 0, cell_count = 0;
    for (std::size_t s = 0; s < samples; ++s, ++at) {
      const float n = mean.weights[s];
      if (all.weights[at] == 0 || n < 1.5F) continue;
      const Pixel value = loaded(&copies.values[4 * at]);
      variance += squared(value - middle);
      const float others = n / (n - 1);
      cell_residual += squared((value - loaded(&mean.values[4 * s])) * others);
      ++cell_count;
    }
    residual += cell_residual;
    result.cell_share.push_back(static_cast<float>(cell_count / static_cast<double>(samples)));
    cell_residuals.push_back(cell_count > 0 ? cell_residual / cell_count : 0);
  }
  result.variance = variance / count;
  result.explained = variance > 0 ? 1 - residual / variance : 0;
  for (const double cell : cell_residuals)
    result.of_cells.push_back(
        static_cast<float>(result.variance > 0 ? 1 - cell / result.variance : 0));
  return result;
}

}  // namespace seamwise
