#include "photo/lattice/hidden_places.h"

#include <algorithm>
#include <cmath>

#include "photo/lattice/copies.h"

namespace seamwise {
namespace {

constexpr int kBlocks = 40;                     // blocks along the longer side
constexpr int kSamples = 20, kFewestShown = 8;  // samples along a cell
constexpr double kMostCopied = 100000;          // samples of all copies; more would not tell more
constexpr int kRounds = 3;           // of medians without the blocks that differ from them
constexpr float kLeastCopies = 2.5;  // copies of which one may differ
// Limits of a block's mean squared difference: shares of the pattern's variance and of the
// pattern's energy in the block, where a small shift makes a large difference.
constexpr double kOfVariance = 0.25, kOfEnergy = 0.5;

/// Block of each sample of all copies, or -1 where nothing is visible.
std::vector<int> blocksOf(const Copies& copies, const TiltedLattice& view,
                          const HiddenPlaces& places) {
  const LatticeMap map = view.map();
  std::vector<int> blocks(copies.weights.size(), -1);
  std::size_t at = 0;
  for (const auto& cell : copies.cells) {
    for (int b = 0; b < copies.n; ++b) {
      for (int a = 0; a < copies.n; ++a, ++at) {
        if (copies.weights[at] == 0) continue;
        const Vec2 p = map(Vec2(cell[0] + (a + 0.5) / copies.n, cell[1] + (b + 0.5) / copies.n));
        const int column = std::clamp(static_cast<int>(p.x() / places.side), 0, places.columns - 1);
        const int row = std::clamp(static_cast<int>(p.y() / places.side), 0, places.rows - 1);
        blocks[at] = row * places.columns + column;
      }
    }
  }
  return blocks;
}

/// Medians of the copies that are not hidden, per channel, and the number of these copies.
CopiesMean mediansOf(const Copies& copies, const std::vector<int>& blocks,
                     const std::vector<std::uint8_t>& is_hidden) {
  const std::size_t samples = copies.samples();
  CopiesMean medians;
  medians.values.assign(4 * samples, 0);
  medians.weights.assign(samples, 0);
  std::array<std::vector<float>, 3> values;
  for (std::size_t s = 0; s < samples; ++s) {
    for (auto& channel : values) channel.clear();
    for (std::size_t at = s; at < blocks.size(); at += samples) {
      if (blocks[at] < 0 || is_hidden[blocks[at]] != 0) continue;
      for (int c = 0; c < 3; ++c) values[c].push_back(copies.values[4 * at + c]);
    }
    medians.weights[s] = static_cast<float>(values[0].size());
    if (values[0].empty()) continue;
    for (int c = 0; c < 3; ++c) {
      const std::size_t half = values[c].size() / 2;
      std::nth_element(values[c].begin(), values[c].begin() + half, values[c].end());
      medians.values[4 * s + c] = values[c][half];
    }
  }
  return medians;
}

/// Flags the blocks whose samples differ from the medians.
std::vector<std::uint8_t> differingBlocks(const Copies& copies, const std::vector<int>& blocks,
                                          const CopiesMean& medians, std::size_t block_count) {
  const std::size_t samples = copies.samples();
  const auto squared = [](const ChannelImage::Pixel& e) {
    return e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
  };
  ChannelImage::Pixel sum{};
  float count = 0;
  for (std::size_t s = 0; s < samples; ++s) {
    if (medians.weights[s] < kLeastCopies) continue;
    sum += loaded(&medians.values[4 * s]);
    ++count;
  }
  const ChannelImage::Pixel mean = sum * (1 / std::max(1.0F, count));
  std::vector<double> differences(block_count), energies(block_count), counts(block_count);
  double variance = 0;
  for (std::size_t s = 0; s < samples; ++s) {
    if (medians.weights[s] < kLeastCopies) continue;
    const ChannelImage::Pixel median = loaded(&medians.values[4 * s]);
    const float energy = squared(median - mean);
    variance += energy / count;
    for (std::size_t at = s; at < blocks.size(); at += samples) {
      if (blocks[at] < 0) continue;
      differences[blocks[at]] += squared(loaded(&copies.values[4 * at]) - median);
      energies[blocks[at]] += energy;
      counts[blocks[at]] += 1;
    }
  }
  std::vector<std::uint8_t> flags(block_count);
  for (std::size_t k = 0; k < block_count; ++k)
    flags[k] =
        differences[k] > kOfVariance * variance * counts[k] + kOfEnergy * energies[k] ? 1 : 0;
  return flags;
}

/// Number of flagged blocks among the eight around one and itself.
int flaggedAround(const HiddenPlaces& places, const std::vector<std::uint8_t>& flags, int column,
                  int row) {
  int count = 0;
  for (int y = std::max(0, row - 1); y <= std::min(places.rows - 1, row + 1); ++y)
    for (int x = std::max(0, column - 1); x <= std::min(places.columns - 1, column + 1); ++x)
      count += flags[y * places.columns + x];
  return count;
}

/// Flags also the blocks beside flagged ones.
std::vector<std::uint8_t> widened(const HiddenPlaces& places,
                                  const std::vector<std::uint8_t>& flags) {
  std::vector<std::uint8_t> wide(flags.size());
  for (int row = 0; row < places.rows; ++row)
    for (int column = 0; column < places.columns; ++column)
      wide[row * places.columns + column] = flaggedAround(places, flags, column, row) > 0 ? 1 : 0;
  return wide;
}

/// Middle of the free block that is farthest from hidden ones and from the border.
Vec2 freeMiddleOf(const HiddenPlaces& places) {
  std::vector<std::uint8_t> taken = places.is_hidden;
  Vec2 middle = Vec2::Zero();
  for (bool is_left = true; is_left;) {
    is_left = false;
    std::vector<std::uint8_t> next(taken.size(), 1);
    int count = 0;
    for (int row = 0; row < places.rows; ++row) {
      for (int column = 0; column < places.columns; ++column) {
        const bool is_border =
            row == 0 || column == 0 || row == places.rows - 1 || column == places.columns - 1;
        const std::size_t k = row * places.columns + column;
        if (taken[k] == 0) middle = Vec2(column + 0.5, row + 0.5);
        if (is_border || flaggedAround(places, taken, column, row) > 0) continue;
        next[k] = 0;
        ++count;
      }
    }
    is_left = count > 0;
    taken = next;
  }
  return places.side * middle;
}

}  // namespace

HiddenPlaces hiddenPlaces(const ChannelImage& image, const TiltedLattice& view, double reach) {
  HiddenPlaces places;
  const Vec2 size = 2 * view.middle;
  places.side = static_cast<float>(size.maxCoeff() / kBlocks);
  places.columns = static_cast<int>(std::ceil(size.x() / places.side));
  places.rows = static_cast<int>(std::ceil(size.y() / places.side));
  const std::size_t count = static_cast<std::size_t>(places.columns) * places.rows;
  places.is_hidden.assign(count, 0);
  CellList cells = visibleCells(view, reach);
  const double room = std::sqrt(kMostCopied / static_cast<double>(cells.size() + 1));
  const int n = std::clamp(static_cast<int>(room), kFewestShown, kSamples);
  const Copies copies = sampleCopies(image, view, std::move(cells), n, false);
  const std::vector<int> blocks = blocksOf(copies, view, places);
  for (int round = 0; round < kRounds; ++round) {
    const auto flags =
        differingBlocks(copies, blocks, mediansOf(copies, blocks, places.is_hidden), count);
    places.is_hidden = flags;
    for (std::size_t k = 0; k < count; ++k) {
      // A single block is a spot of dirt or a motif that was printed badly.
      const int column = static_cast<int>(k) % places.columns,
                row = static_cast<int>(k) / places.columns;
      if (flags[k] != 0 && flaggedAround(places, flags, column, row) < 2) places.is_hidden[k] = 0;
    }
    places.is_hidden = widened(places, places.is_hidden);
  }
  std::vector<std::uint8_t> is_compared(count);
  for (const int block : blocks)
    if (block >= 0) is_compared[block] = 1;
  double compared = 0, differing = 0;
  for (std::size_t k = 0; k < count; ++k)
    compared += is_compared[k], differing += is_compared[k] * places.is_hidden[k];
  places.share_of_compared = compared > 0 ? differing / compared : 0;
  places.share =
      static_cast<double>(std::count(places.is_hidden.begin(), places.is_hidden.end(), 1)) /
      static_cast<double>(count);
  places.free_middle = freeMiddleOf(places);
  return places;
}

}  // namespace seamwise
