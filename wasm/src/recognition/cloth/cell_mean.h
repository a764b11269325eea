#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "recognition/base/cell_picture.h"
#include "recognition/base/lattice_map.h"
#include "recognition/cloth/copy_fields.h"
#include "recognition/cloth/lattice_canvas.h"
#include "recognition/cloth/pixels.h"
#include "recognition/cloth/robust_mean.h"

namespace seamwise {

/// Which samples of a cell are wanted.
struct CellGrid {
  int columns = 0, rows = 0;  ///< along w1 and w2
  /// Of sample (0, 0), in samples: 0 as a CellPicture has it, 1/2 as the pixels of an image.
  double offset = 0;
  /// Lattice coordinates of the reading: u = basis u' + origin, u' those of the grid.
  Mat2 basis = Mat2::Identity();
  Vec2 origin = Vec2::Zero();
};

/// How fine the grid of an image may be: its longer side, and samples per pixel of the picture.
struct GridLimits {
  int longest = 2048;
  double denser = 1;
};

/// The grid of an image of the cell as fine as the picture shows it best, or finer, its pixels
/// about as wide as high. Lengths that differ by less than 1 % count as equal,
/// so that a group's turns permute the pixels; both are multiples of 12 from 48 on.
/// @param gram   of w1, w2 in the basis of the grid, up to a factor
CellGrid nativeGrid(const LatticeMap& map, const Mat2& gram, const Mat2& basis, const Vec2& origin,
                    const GridLimits& limits);

/// The mean of all copies of a cell on a picture, robust, with light divided out and creases
/// followed, row by row.
class CellMean {
 public:
  /// @param pixels   `factor` times smaller than the whole picture
  /// @param flatten  share of the light's differences that is taken away, 0 to 1
  CellMean(const PixelView& pixels, int factor, const LatticeMap& map, const CopyFields& fields,
           const CellGrid& grid, double flatten);
  /// Goes on for about that many samples of the picture; false when nothing is left to do.
  bool advance(int samples);
  double fraction() const { return static_cast<double>(row_) / grid_.rows; }

  /// Once done: sample (i, j) at index j * columns + i, gamma-coded; and the mean's variance as
  /// CellPicture has it.
  const CellGrid& grid() const { return grid_; }
  const std::array<std::vector<float>, 3>& planes() const { return planes_; }
  /// Once done, of a grid of as many rows as columns.
  CellPicture picture() const;

 private:
  /// What is interpolated along a row of samples.
  struct Knot {
    float x, y;        ///< px of the pixels
    PixelLanes gains;  ///< of coded values, see `lit`
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
  int part_;  ///< samples between which places and light are interpolated
  int row_ = 0;
  std::vector<PixelLanes> copies_;  ///< of the row, `most` for each sample
  std::vector<int> counts_;         ///< per sample of the row
  std::array<std::vector<float>, 3> planes_;
  std::vector<float> noise_;
};

/// An image as files have it, its top row first, of a cell with pixels as samples.
std::vector<std::uint8_t> imageBytes(int columns, int rows,
                                     const std::array<std::vector<float>, 3>& planes);

}  // namespace seamwise
