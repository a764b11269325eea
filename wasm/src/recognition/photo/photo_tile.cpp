#include "recognition/photo/photo_tile.h"

#include "tuning/photo.h"

namespace seamwise {

PhotoTile::PhotoTile(const PixelView& pixels, const LatticeMap& map, const Mat2& gram,
                     double flatten)
    : pixels_(pixels), map_(map), gram_(gram), flatten_(flatten), fit_(pixels, map, curve_) {}

bool PhotoTile::advance() {
  if (mean_) return mean_->advance(PhotoTuning::kSamplesAtOnce);
  if (fit_.advance()) return true;
  const CellGrid grid =
      nativeGrid(map_, gram_, Mat2::Identity(), Vec2::Zero(), PhotoTuning::kLongestTile);
  mean_ = std::make_unique<CellMean>(pixels_, 1, map_, fit_.fields(), grid, flatten_, curve_);
  return true;
}

double PhotoTile::fraction() const {
  constexpr double kFit = 0.4;
  return mean_ ? kFit + (1 - kFit) * mean_->fraction() : kFit * fit_.fraction();
}

std::vector<std::uint8_t> PhotoTile::image() const {
  return imageBytes(columns(), rows(), mean_->planes());
}

}  // namespace seamwise
