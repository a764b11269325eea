#include "photo/steps/photo_tile.h"

#include <algorithm>
#include <cmath>

#include "tuning/photo.h"

namespace seamwise {
namespace {

/// Copies fall between each other's pixels, so together they show more than one does.
GridLimits limitsOf(const PixelView& pixels, bool is_tile) {
  GridLimits limits{PhotoTuning::kLongestTile, 1};
  if (is_tile) return limits;
  const double count = static_cast<double>(pixels.width) * pixels.height;
  limits.denser =
      std::clamp(std::sqrt(PhotoTuning::kDenseSamples / count), 1.0, PhotoTuning::kDenser);
  return limits;
}

}  // namespace

PhotoTile::PhotoTile(const PixelView& pixels, const PhotoTileSettings& settings)
    : pixels_(pixels),
      settings_(settings),
      grid_(nativeGrid(settings.map, settings.gram, Mat2::Identity(), Vec2::Zero(),
                       limitsOf(pixels, settings.is_tile))) {
  if (settings.is_tile)
    cell_ = std::make_unique<TileCell>(SeamlessTile{pixels}, settings.map, grid_);
  else
    fit_ = std::make_unique<CopyFieldsFit>(pixels, settings.map, curve_);
}

bool PhotoTile::advance() {
  if (symmetry_) {
    if (symmetry_->advance(PhotoTuning::kSamplesAtOnce)) return true;
    planes_ = symmetry_->planes();
    return false;
  }
  if (cell_) {
    if (cell_->advance(PhotoTuning::kSamplesAtOnce)) return true;
    return symmetrise(cell_->planes());
  }
  if (mean_) {
    if (mean_->advance(PhotoTuning::kSamplesAtOnce)) return true;
    return symmetrise(mean_->planes());
  }
  if (fit_->advance()) return true;
  mean_ = std::make_unique<CellMean>(pixels_, 1, settings_.map, fit_->fields(), grid_,
                                     settings_.flatten);
  return true;
}

/// Starts the symmetrisation; returns whether more work is left.
bool PhotoTile::symmetrise(std::array<std::vector<float>, 3> planes) {
  if (settings_.group == nullptr) {
    planes_ = std::move(planes);
    return false;
  }
  symmetry_ =
      std::make_unique<TileSymmetry>(std::move(planes), columns(), rows(), *settings_.group);
  return true;
}

double PhotoTile::fraction() const {
  constexpr double kFit = 0.4, kMean = 0.5;
  if (symmetry_) return kFit + kMean + (1 - kFit - kMean) * symmetry_->fraction();
  if (mean_) return kFit + kMean * mean_->fraction();
  if (cell_) return (kFit + kMean) * cell_->fraction();
  return fit_ ? kFit * fit_->fraction() : 0;
}

std::vector<std::uint8_t> PhotoTile::image() const {
  return imageBytes(columns(), rows(), planes_);
}

}  // namespace seamwise
