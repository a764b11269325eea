#pragma once
#include <array>
#include <vector>

#include "recognition/lattice/channel_image.h"
#include "recognition/lattice/tilted_lattice.h"

namespace seamwise {

/// Cells of a lattice, each by the lattice coordinates of its corner.
using CellList = std::vector<std::array<int, 2>>;

/// The cells of which some part is seen, within `reach` cells of the picture's middle.
CellList visibleCells(const TiltedLattice& view, double reach);

/// How many whole cells a straight line along w1 and one along w2 cross on the picture at most.
Vec2 repeatsSeen(const TiltedLattice& view);

/// How many cells are seen whole, but for what a grid of 4 x 4 places overlooks.
int wholeCells(const TiltedLattice& view);

/// All copies of a cell as they are seen through a map: n x n samples each, at (i + 1/2) / n.
struct Copies {
  int n = 0;
  CellList cells;
  std::vector<float> values;              ///< four to a sample: channels and a zero
  std::vector<float> slopes_x, slopes_y;  ///< per pixel; empty unless asked for
  std::vector<float> weights;             ///< one to a sample; 0 where nothing is seen

  std::size_t samples() const { return static_cast<std::size_t>(n) * n; }
};

Copies sampleCopies(const ChannelImage& image, const TiltedLattice& view, CellList cells, int n,
                    bool with_slopes);

/// The weighted mean of some copies.
struct CopiesMean {
  std::vector<float> values;   ///< four to a sample
  std::vector<float> weights;  ///< their sum, one to a sample
};

CopiesMean meanOf(const Copies& copies);

/// How well each copy is foretold by the mean of the others, weights set aside but for 0.
struct Agreement {
  double explained = 0;           ///< share of the variance; below 0 where nothing repeats
  double variance = 0;            ///< of the channels, summed over them, where two copies are seen
  std::vector<float> of_cells;    ///< the same share of each cell's own residuals
  std::vector<float> cell_share;  ///< how much of each cell is seen, where another is too
};

Agreement agreementOf(const Copies& copies);

}  // namespace seamwise
