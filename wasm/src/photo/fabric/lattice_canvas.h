#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "photo/base/lattice_map.h"
#include "photo/fabric/pixels.h"
#include "photo/fabric/smooth_field.h"

namespace seamwise {

/// Whole and partial cells of a lattice that are visible in an image, limited to those around its
/// middle if there are very many.
struct SeenCells {
  SeenCells(const LatticeMap& map, int width, int height);
  int first_u, first_v, across, up;
};

/// Samples of a lattice's visible whole and partial cells in lattice coordinates: sample (a, b) is
/// at (first_u + a / n, first_v + b / n), with n samples per side of a cell.
struct LatticeCanvas {
  int n = 0;
  int first_u = 0, first_v = 0;  ///< first cell
  int cells_u = 0, cells_v = 0;
  std::vector<float> x, y;                   ///< positions on the whole image for flat fabric. [px]
  std::vector<std::uint8_t> seen;            ///< 1 if the position is in the image
  std::array<std::vector<float>, 3> planes;  ///< red, green, blue, gamma-coded, in [0, 1]

  int columns() const { return cells_u * n; }
  int rows() const { return cells_v * n; }
  std::size_t size() const { return x.size(); }
  /// Returns the index b * n + a of a sample's place within one cell.
  std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(row % n) * n + column % n;
  }
};

/// Returns a canvas of the cells visible in an image of the given size, without sampled values.
LatticeCanvas latticeCanvas(const LatticeMap& map, int width, int height, int n);

/// Samples an image reduced by `factor`, at positions moved by `shift` (two channels, px of the
/// whole image).
void sampleCanvas(const PixelView& pixels, int factor, const SmoothField& shift,
                  LatticeCanvas* canvas);

}  // namespace seamwise
