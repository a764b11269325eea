#include "photo/fabric/lattice_canvas.h"

#include <algorithm>
#include <cmath>

#include "photo/base/map_inverse.h"

namespace seamwise {

namespace {
constexpr int kBorderPoints = 16;  // points per side of the image, for its bounds in cells
constexpr double kMostCells = 12;  // cells from the middle: some 500 copies, more only cost time
}  // namespace

SeenCells::SeenCells(const LatticeMap& map, int width, int height) {
  const MapInverse inverse(map);
  const Vec2 middle = inverse(Vec2(width / 2.0, height / 2.0));
  Vec2 low = middle, high = middle;
  for (int k = 0; k <= kBorderPoints; ++k) {
    const double x = width * static_cast<double>(k) / kBorderPoints;
    const double y = height * static_cast<double>(k) / kBorderPoints;
    for (const Vec2& p : {Vec2(x, 0), Vec2(x, height), Vec2(0, y), Vec2(width, y)}) {
      const Vec2 u = inverse(p);
      if (!u.allFinite()) continue;
      low = low.cwiseMin(u);
      high = high.cwiseMax(u);
    }
  }
  low = low.cwiseMax(middle - Vec2::Constant(kMostCells));
  high = high.cwiseMin(middle + Vec2::Constant(kMostCells));
  first_u = static_cast<int>(std::floor(low.x()));
  first_v = static_cast<int>(std::floor(low.y()));
  across = static_cast<int>(std::ceil(high.x())) - first_u;
  up = static_cast<int>(std::ceil(high.y())) - first_v;
}

LatticeCanvas latticeCanvas(const LatticeMap& map, int width, int height, int n) {
  const SeenCells cells(map, width, height);
  LatticeCanvas canvas;
  canvas.n = n;
  canvas.first_u = cells.first_u;
  canvas.first_v = cells.first_v;
  canvas.cells_u = cells.across;
  canvas.cells_v = cells.up;
  const std::size_t size = static_cast<std::size_t>(canvas.columns()) * canvas.rows();
  canvas.x.resize(size);
  canvas.y.resize(size);
  canvas.seen.resize(size);
  for (std::vector<float>& plane : canvas.planes) plane.resize(size);
  std::size_t k = 0;
  for (int b = 0; b < canvas.rows(); ++b) {
    for (int a = 0; a < canvas.columns(); ++a, ++k) {
      const Vec2 p = map(Vec2(canvas.first_u + static_cast<double>(a) / n,
                              canvas.first_v + static_cast<double>(b) / n));
      canvas.x[k] = static_cast<float>(p.x());
      canvas.y[k] = static_cast<float>(p.y());
      canvas.seen[k] = p.x() >= 0 && p.y() >= 0 && p.x() < width && p.y() < height;
    }
  }
  return canvas;
}

void sampleCanvas(const PixelView& pixels, int factor, const SmoothField& shift,
                  LatticeCanvas* canvas) {
  const float scale = 1 / static_cast<float>(factor);
  float d[2];
  for (std::size_t k = 0; k < canvas->size(); ++k) {
    if (!canvas->seen[k]) continue;
    shift.at(canvas->x[k], canvas->y[k], d);
    PixelLanes value = {0, 0, 0, 0};
    // Samples that the shift moves beyond the image's border become unseen.
    canvas->seen[k] =
        bilinear(pixels, (canvas->x[k] + d[0]) * scale, (canvas->y[k] + d[1]) * scale, &value);
    for (int c = 0; c < 3; ++c) canvas->planes[c][k] = value[c] * (1 / 255.0f);
  }
}

}  // namespace seamwise
