#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "recognition/base/lattice_map.h"
#include "recognition/cloth/pixels.h"
#include "recognition/cloth/smooth_field.h"

namespace seamwise {

/// The whole and cut cells of a lattice that a picture shows, around its middle where it shows very
/// many: those from first on.
struct SeenCells {
  SeenCells(const LatticeMap& map, int width, int height);
  int first_u, first_v, across, up;
};

/// What a picture shows of a lattice's whole and cut cells, sampled in lattice coordinates: sample
/// (a, b) lies at (first_u + a / n, first_v + b / n), n samples to a cell's side.
struct LatticeCanvas {
  int n = 0;
  int first_u = 0, first_v = 0;  ///< of the cells
  int cells_u = 0, cells_v = 0;
  std::vector<float> x, y;                   ///< on the whole picture if it lay flat. [px]
  std::vector<std::uint8_t> seen;            ///< whether that is in the picture
  std::array<std::vector<float>, 3> planes;  ///< red, green, blue, gamma-coded, in [0, 1]

  int columns() const { return cells_u * n; }
  int rows() const { return cells_v * n; }
  std::size_t size() const { return x.size(); }
  /// Where in one cell a sample lies, as index b * n + a.
  std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(row % n) * n + column % n;
  }
};

/// The cells of which a picture of that size shows a part, without samples of it.
LatticeCanvas latticeCanvas(const LatticeMap& map, int width, int height, int n);

/// Samples a picture, `factor` times smaller than the whole one, where `shift` (two channels, px of
/// the whole picture) has moved the cloth.
void sampleCanvas(const PixelView& pixels, int factor, const SmoothField& shift,
                  LatticeCanvas* canvas);

}  // namespace seamwise
