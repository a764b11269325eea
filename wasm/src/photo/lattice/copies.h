#pragma once
#include <array>
#include <vector>

#include "photo/lattice/channel_image.h"
#include "photo/lattice/tilted_lattice.h"

namespace seamwise {

/// Cells of a lattice, each by the lattice coordinates of its corner.
using CellList = std::vector<std::array<int, 2>>;

/// Returns the cells that are at least partly visible, within `reach` cells of the view's focus.
CellList visibleCells(const TiltedLattice& view, double reach);

/// Returns the maximum number of cells that a straight line along w1 and one along w2 cross in the
/// image.
Vec2 repeatsSeen(const TiltedLattice& view);

/// Returns the number of entirely visible cells, tested at a grid of 4 x 4 places.
int wholeCells(const TiltedLattice& view);

/// All copies of a cell as seen through a map: n x n samples each, at (i + 1/2) / n.
struct Copies {
  int n = 0;
  CellList cells;
  std::vector<float> values;              ///< four per sample: channels and a zero
  std::vector<float> slopes_x, slopes_y;  ///< per pixel; empty unless requested
  std::vector<float> weights;             ///< one per sample; 0 where nothing is visible

  std::size_t samples() const { return static_cast<std::size_t>(n) * n; }
};

Copies sampleCopies(const ChannelImage& image, const TiltedLattice& view, CellList cells, int n,
                    bool with_slopes);

/// Weighted mean of copies.
struct CopiesMean {
  std::vector<float> values;   ///< four per sample
  std::vector<float> weights;  ///< sum of weights, one per sample
};

CopiesMean meanOf(const Copies& copies);

/// Agreement of each copy with the mean of the others; all weights but 0 count as 1.
struct Agreement {
  double explained = 0;           ///< explained share of the variance; negative if nothing repeats
  double variance = 0;            ///< sum over the channels, if two copies are visible
  std::vector<float> of_cells;    ///< the same share per cell, of its own residuals
  std::vector<float> cell_share;  ///< visible share of each cell, where another one is visible too
};

Agreement agreementOf(const Copies& copies);

}  // namespace seamwise
