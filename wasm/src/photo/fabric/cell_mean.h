#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "photo/base/cell_picture.h"
#include "photo/base/lattice_map.h"
#include "photo/fabric/copy_fields.h"
#include "photo/fabric/lattice_canvas.h"
#include "photo/fabric/pixels.h"
#include "photo/fabric/robust_mean.h"

namespace seamwise {

/// Sampling grid of a cell.
struct CellGrid {
  int columns = 0, rows = 0;  ///< along w1 and w2
  /// Offset of sample (0, 0), in samples: 0 as in a CellPicture, 1/2 as for the pixels of an image.
  double offset = 0;
  /// Lattice coordinates of the reading: u = basis u' + origin, with u' those of the grid.
  Mat2 basis = Mat2::Identity();
  Vec2 origin = Vec2::Zero();
};

/// Limits of an image's grid: samples along its longer side, and samples per pixel of the source.
struct GridLimits {
  int longest = 2048;
  double denser = 1;
};

/// Returns the grid for an image of the cell at the best resolution in the source or a finer one,
/// with pixels about as wide as high. Lengths that differ by less than 1 % count as equal, so that
/// a group's rotations permute the pixels. Both sizes are multiples of 12 from 48 on.
/// @param gram   Gram matrix of w1, w2 in the basis of the grid, up to a factor
CellGrid nativeGrid(const LatticeMap& map, const Mat2& gram, const Mat2& basis, const Vec2& origin,
                    const GridLimits& limits);

/// Robust mean of all copies of a cell in an image, corrected for light and creases, row by row.
class CellMean {
 public:
  /// @param pixels   image reduced by `factor`
  /// @param flatten  share of the light's unevenness that is removed, 0 to 1
  CellMean(const PixelView& pixels, int factor, const LatticeMap& map, const CopyFields& fields,
           const CellGrid& grid, double flatten);
  /// Continues for about `samples` samples of the image; returns false when done.
  bool advance(int samples);
  double fraction() const { return static_cast<double>(row_) / grid_.rows; }

  /// Grid and gamma-coded planes, valid once done: sample (i, j) at index j * columns + i.
  const CellGrid& grid() const { return grid_; }
  const std::array<std::vector<float>, 3>& planes() const { return planes_; }
  /// Returns planes and variance of a grid with as many rows as columns, valid once done.
  CellPicture picture() const;

 private:
  /// Values that are interpolated along a row of samples.
  struct Knot {
    float x, y;        ///< px of `pixels_`
    PixelLanes gains;  ///< factors of coded values, see `underLight`
    float weight;
    bool seen;
  };
  Knot knotAt(double column, double row, int cell_u, int cell_v) const;
  int addCopy(int cell_u, int cell_v);
  void addPart(const Knot& from, const Knot& to, int first, int end);
  void agree();

  PixelView pixels_;
  double scale_;
  LatticeMap map_;
  const CopyFields& fields_;
  CellGrid grid_;
  float flatten_;
  SeenCells cells_;
  int part_;  ///< samples between knots
  int row_ = 0;
  std::vector<PixelLanes> copies_;  ///< colours of the row, one per sample and cell
  std::vector<int> counts_;         ///< copies per sample of the row
  std::array<std::vector<float>, 3> planes_;
  std::vector<float> noise_;
};

/// Returns the RGBA bytes of a cell with pixels as samples, top row first.
std::vector<std::uint8_t> imageBytes(int columns, int rows,
                                     const std::array<std::vector<float>, 3>& planes);

}  // namespace seamwise
