#include "photo/fabric/copy_fields_fit.h"

#include <algorithm>
#include <cmath>

#include "photo/base/map_inverse.h"
#include "photo/fabric/differing.h"

namespace seamwise {

namespace {

constexpr double kReducedCell = 160;  // minimum px of a cell's side, if the image has them
constexpr int kFewestPerCell = 16, kMostPerCell = 64;  // samples of a cell's side for registration
constexpr double kMostCopySamples = 500'000;           // samples of all cells
constexpr double kPixelsPerSample = 1.2;               // minimum pixels of the sampled image
constexpr int kCoarsePerCell = 20;   // samples of a cell's side that creases do not affect
constexpr int kLightPerCell = 16;    // samples of a cell's side for the light
constexpr double kUsualRepeats = 8;  // maximum visible repeats for relating shifts to a repeat
constexpr int kPixelsPerStep = 2'000'000;  // pixels read per step of a reduction

int reductionFor(double cell_size, double wanted) {
  return std::max(1, static_cast<int>(cell_size / wanted));
}

int samplesPerCell(const PixelView& pixels, double cell_size) {
  const double cells =
      static_cast<double>(pixels.width) * pixels.height / (cell_size * cell_size) + 1;
  const double most = std::min(std::sqrt(kMostCopySamples / cells), cell_size / 2);
  return std::clamp(static_cast<int>(most) / 8 * 8, kFewestPerCell, kMostPerCell);
}

}  // namespace

CopyFieldsFit::CopyFieldsFit(const PixelView& pixels, const LatticeMap& map, const SrgbCurve& curve,
                             double nodes_across)
    : pixels_(pixels),
      map_(map),
      curve_(curve),
      cell_size_(cellSize(map)),
      nodes_across_(nodes_across),
      samples_(samplesPerCell(pixels, cell_size_)),
      reduced_(pixels, reductionFor(cell_size_, kReducedCell)) {}

bool CopyFieldsFit::advance() {
  switch (stage_) {
    case Stage::kReduce:
      if (reduced_.advance(kPixelsPerStep)) return true;
      fine_ = std::make_unique<ReducedPixels>(
          reduced_.view(),
          reductionFor(cell_size_ / reduced_.factor(), samples_ * kPixelsPerSample));
      stage_ = Stage::kReduceFine;
      return true;
    case Stage::kReduceFine:
      if (fine_->advance(kPixelsPerStep)) return true;
      coarse_ =
          std::make_unique<ReducedPixels>(fine_->view(), reductionFor(samples_, kCoarsePerCell));
      stage_ = Stage::kReduceCoarse;
      return true;
    case Stage::kReduceCoarse:
      if (coarse_->advance(kPixelsPerStep)) return true;
      beginLight();
      stage_ = Stage::kLight;
      return true;
    case Stage::kLight:
      if (light_->advance()) return true;
      beginShift();
      stage_ = Stage::kShift;
      return true;
    case Stage::kShift:
      if (registration_->advance()) return true;
      finish();
      stage_ = Stage::kDone;
      return false;
    case Stage::kDone:
      return false;
  }
  return false;
}

double CopyFieldsFit::fraction() const { return static_cast<double>(stage_) / 5; }

void CopyFieldsFit::beginLight() {
  const int width = pixels_.width, height = pixels_.height;
  const SmoothField flat(2, width, height, std::max(width, height));
  LatticeCanvas canvas = latticeCanvas(map_, width, height, std::min(kLightPerCell, samples_));
  sampleCanvas(coarse_->view(), reduced_.factor() * fine_->factor() * coarse_->factor(), flat,
               &canvas);
  light_ = std::make_unique<LightFit>(std::move(canvas), curve_, width, height, cell_size_,
                                      nodes_across_);
}

void CopyFieldsFit::beginShift() {
  fields_.light = light_->field();
  light_.reset();
  const int factor = reduced_.factor() * fine_->factor();
  registration_ = std::make_unique<CopyRegistration>(
      latticeCanvas(map_, pixels_.width, pixels_.height, samples_), fine_->view(), factor,
      coarse_->view(), factor * coarse_->factor(), fields_.light, curve_, pixels_.width,
      pixels_.height, cell_size_);
}

void CopyFieldsFit::finish() {
  fields_.shift = registration_->shift();
  const double repeat = longerRepeat(map_);
  const double most_cells =
      std::max(registration_->canvas().cells_u, registration_->canvas().cells_v);
  const double seen =
      std::min<double>(std::max(pixels_.width, pixels_.height), most_cells * repeat);
  fields_.unevenness = registration_->rms() / std::max(repeat, seen / kUsualRepeats);
  findDiffering(*registration_, cell_size_, &fields_);
  registration_.reset();
}

}  // namespace seamwise
