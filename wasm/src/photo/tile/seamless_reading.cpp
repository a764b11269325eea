#include "photo/tile/seamless_reading.h"

#include <algorithm>

#include "photo/symmetry/group_embedding.h"
#include "tuning/tile_reading.h"

namespace seamwise {
namespace {

/// Returns the Gram matrix of a lattice on a tile, from that of the tile's sides.
Mat2 gramOn(const SeamlessTile& tile, const Mat2& sides, const LatticeMap& map) {
  const Mat2 shares = Vec2(1.0 / tile.width(), -1.0 / tile.height()).asDiagonal() *
                      map.homography.topLeftCorner<2, 2>();
  return shares.transpose() * sides * shares;
}

/// Returns the samples along a side: even, so that half cells are samples, and no more than its
/// pixels.
int samplesFor(const LatticeMap& map) {
  const Mat2 w = map.homography.topLeftCorner<2, 2>();
  const double pixels = std::max(w.col(0).norm(), w.col(1).norm());
  return std::clamp(2 * static_cast<int>(std::lround(pixels / 2)), TileReadingTuning::kLeastSamples,
                    TileReadingTuning::kMostSamples);
}

}  // namespace

SeamlessReader::SeamlessReader(const SeamlessTile& tile, const Mat2& sides)
    : tile_(tile), sides_(sides) {
  LatticeMap& map = reading_.lattice.map;
  const double width = tile.width(), height = tile.height();
  map.homography << width, 0, 0, 0, -height, height, 0, 0, 1;
  map.middle = Vec2(width, height) / 2;
  map.radius = std::max(width, height) / 2;
  reading_.lattice.copies = 1;
  beginCell(Mat2::Identity());
}

bool SeamlessReader::advance() {
  if (sampled_) {
    if (sampled_->advance(TileReadingTuning::kPlacesAtOnce)) return true;
    reading_.cell = sampled_->picture();
    sampled_.reset();
    smaller_ = std::make_unique<SmallerCellSearch>(reading_.cell, reading_.gram);
    return true;
  }
  if (smaller_) {
    if (!smaller_->advance()) keepCell();
    return true;
  }
  if (groups_ && !groups_->advance()) finish();
  return groups_ != nullptr;
}

/// Starts sampling with a finer lattice, or the same one.
void SeamlessReader::beginCell(const Mat2& finer) {
  LatticeMap& map = reading_.lattice.map;
  map = map.rebased(finer, Vec2::Zero());
  map = map.rebased(reducingMatrix(gramOn(tile_, sides_, map)), Vec2::Zero());
  reading_.gram = gramOn(tile_, sides_, map);
  CellGrid grid;
  grid.columns = grid.rows = samplesFor(map);
  sampled_ = std::make_unique<TileCell>(tile_, map, grid);
}

/// Continues with the smaller cell, or with the groups of this one.
void SeamlessReader::keepCell() {
  const FinerLattice smaller = smaller_->lattice();
  missed_ = std::max(missed_, smaller_->missed());
  smaller_.reset();
  int& copies = reading_.lattice.copies;
  if (!smaller.isWhole() && copies < TileReadingTuning::kMostCopies) {
    copies = static_cast<int>(std::lround(copies / smaller.matrix().determinant()));
    return beginCell(smaller.matrix());
  }
  // Sides are whole numbers of pixels for any lattice.
  const double rounding = TileReadingTuning::kRounding / std::min(tile_.width(), tile_.height());
  reading_.lattice.explained = 1;
  reading_.lattice.uncertainty = rounding;
  reading_.lattice.confidence = Confidence::kSure;
  groups_ = std::make_unique<GroupReader>(reading_.cell, reading_.gram,
                                          std::max(rounding, TileReadingTuning::kTolerance));
}

void SeamlessReader::finish() {
  reading_.groups = groups_->result();
  groups_.reset();
  missed_ = std::max(missed_, best().raw);
}

bool SeamlessReader::isMendedBy(const SeamlessReader& other) const {
  if (other.reading_.groups.stripes) return false;
  if (other.symmetries() != symmetries()) return other.symmetries() > symmetries();
  const bool exactly = missed_ > TileReadingTuning::kLeastExact &&
                       other.missed_ < TileReadingTuning::kExactly * missed_;
  return exactly || (missed_ > TileReadingTuning::kLeastMissed &&
                     other.missed_ < TileReadingTuning::kMended * missed_);
}

}  // namespace seamwise
