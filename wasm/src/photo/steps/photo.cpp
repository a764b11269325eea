#include "photo/steps/photo.h"

#include <algorithm>
#include <cmath>

#include "tuning/photo.h"

namespace seamwise {
namespace {

Mat2 matrixOf(const std::array<int, 4>& m) { return (Mat2() << m[0], m[1], m[2], m[3]).finished(); }

bool isEqualSided(LatticeType type) {
  return type != LatticeType::kOblique && type != LatticeType::kRectangular;
}

/// Returns the nearest Gram matrix of a cell of this type.
Mat2 constrained(LatticeType type, const Mat2& gram) {
  const double both = std::sqrt(gram(0, 0) * gram(1, 1));
  Mat2 exact = gram;
  switch (type) {
    case LatticeType::kOblique:
      break;
    case LatticeType::kRectangular:
      exact(0, 1) = exact(1, 0) = 0;
      break;
    case LatticeType::kRhombic:
      exact(0, 0) = exact(1, 1) = (gram(0, 0) + gram(1, 1)) / 2;
      break;
    case LatticeType::kSquare:
      exact << both, 0, 0, both;
      break;
    case LatticeType::kHexagonal:
      exact << both, both / 2, both / 2, both;
      break;
  }
  return exact;
}

}  // namespace

Photo::Photo(const PixelView& pixels, const PhotoSettings& settings)
    : pixels_(pixels), settings_(settings) {
  if (settings.is_tile) {
    tile_ = std::make_unique<TileReader>(pixels, settings.any_edges);
    return;
  }
  search_ = settings.lattice
                ? std::make_unique<LatticeSearch>(pixels, *settings.lattice, settings.use)
                : std::make_unique<LatticeSearch>(pixels);
}

bool Photo::advance() {
  if (error_ || stage_ == PhotoStage::kDone) return false;
  switch (stage_) {
    case PhotoStage::kRepeat:
      if (tile_)
        readWholeTile();
      else if (!search())
        stage_ = PhotoStage::kLight;
      break;
    case PhotoStage::kLight:
      if (!fitFields()) stage_ = PhotoStage::kSymmetry;
      break;
    case PhotoStage::kSymmetry:
      if (reader_)
        readSymmetry();
      else if (tile_)
        readWholeTile();
      else
        meanCopies();
      break;
    case PhotoStage::kDone:
      break;
  }
  return !error_ && stage_ != PhotoStage::kDone;
}

double Photo::fraction() const {
  if (tile_) return tile_->fraction();
  switch (stage_) {
    case PhotoStage::kRepeat:
      return search_ ? PhotoTuning::kSearchShare * search_->fraction() : 0;
    case PhotoStage::kLight:
      return PhotoTuning::kSearchShare + (fit_ ? PhotoTuning::kFieldsShare * fit_->fraction() : 0);
    case PhotoStage::kSymmetry:
      return PhotoTuning::kSearchShare + PhotoTuning::kFieldsShare +
             (mean_ ? PhotoTuning::kMeanShare * mean_->fraction() : 0) +
             (reader_ ? PhotoTuning::kGroupsShare * reader_->fraction() : 0);
    case PhotoStage::kDone:
      break;
  }
  return 1;
}

void Photo::fail(const Error& error) { error_ = error; }

void Photo::readWholeTile() {
  const bool more = tile_->advance();
  if (tile_->readsGroups()) stage_ = PhotoStage::kSymmetry;
  if (more) return;
  if (tile_->error()) return fail(*tile_->error());
  const SeamlessReading& reading = tile_->reading();
  lattice_ = reading.lattice;
  cell_ = reading.cell;
  groups_ = reading.groups;
  seams_ = tile_->seams();
  identify();
}

bool Photo::search() {
  if (search_->advance()) return true;
  if (search_->error()) {
    fail(*search_->error());
    return false;
  }
  lattice_ = search_->result();
  if (lattice_.confidence == Confidence::kUncertain) {
    const auto& all = search_->candidates();
    for (std::size_t k = 1; k < all.size(); ++k) others_.push_back(all[k]);
  }
  search_.reset();
  fit_ = std::make_unique<CopyFieldsFit>(pixels_, lattice_.map, curve_);
  return false;
}

bool Photo::fitFields() {
  if (fit_->advance()) return true;
  const CopyFields& fields = fit_->fields();
  differing_ = fields.regions;
  if (fields.unevenness > PhotoTuning::kUneven) {
    fail(settings_.lattice
             ? Error{Failure::kPicture,
                     "the print does not repeat by the cell that was given: put its corners onto "
                     "the same spot of neighbouring motifs",
                     -1, -1, "misplaced"}
             : Error{Failure::kPicture,
                     "the fabric does not lie flat: smooth it out and photograph it again", -1, -1,
                     "uneven"});
    return false;
  }
  if (fields.unevenness > CopyFields::kFlat) notes_.push_back(PhotoNote::kUneven);
  if (!differing_.empty()) notes_.push_back(PhotoNote::kDiffers);
  CellGrid grid;
  grid.columns = grid.rows = PhotoTuning::kSamples;
  const ReducedPixels& reduced = fit_->reduced();
  mean_ = std::make_unique<CellMean>(reduced.view(), reduced.factor(), lattice_.map, fields, grid,
                                     settings_.flatten);
  return false;
}

void Photo::meanCopies() {
  if (mean_->advance(PhotoTuning::kSamplesAtOnce)) return;
  MetricHints camera;
  camera.f35 = settings_.hints.f35;
  const auto metric = measured(lattice_.map, camera);
  if (!metric.ok()) return fail(metric.error());
  const MetricReading& shape = metric.value();
  const double tolerance =
      std::max(PhotoTuning::kLeastTolerance,
               PhotoTuning::kErrors *
                   std::max({shape.aspect_error, shape.angle_error, lattice_.uncertainty}));
  cell_ = mean_->picture();
  reader_ = std::make_unique<GroupReader>(cell_, shape.gram, tolerance);
}

void Photo::readSymmetry() {
  if (reader_->advance()) return;
  groups_ = reader_->result();
  reader_.reset();
  if (!measured_gram_) return identify();
  const Mat2 basis = matrixOf(best().basis);
  place(basis.transpose() * *measured_gram_ * basis, Vec2::Zero());
}

Outcome<MetricReading> Photo::measured(const LatticeMap& map, const MetricHints& hints) const {
  LatticeReading reading = lattice_;
  reading.map = map;
  return readMetric(reading, pixels_.width, pixels_.height, hints);
}

/// Measures the best group's w1 and w2. Two known lengths may show that sides differ which the
/// group makes equal. Groups are then read once more, and a smaller one becomes the best.
void Photo::identify() {
  const auto metric = measured(mapOf(best()), settings_.hints);
  if (!metric.ok()) return fail(metric.error());
  const MetricReading& reading = metric.value();
  is_scaled_ = reading.scaled;
  if (reading.source == MetricSource::kAssumedFocalLength &&
      reading.aspect_error > PhotoTuning::kWorthSaying) {
    notes_.push_back(PhotoNote::kAssumedFocalLength);
  }
  const double tolerance = std::max(PhotoTuning::kMeasured, 2 * reading.length_error);
  const double aspect = std::sqrt(reading.gram(1, 1) / reading.gram(0, 0));
  const bool is_apart = std::abs(aspect - 1) > tolerance;
  if (reading.source != MetricSource::kTwoLengths || groups_.stripes || !is_apart ||
      !isEqualSided(best().group->lattice)) {
    return place(reading.gram, reading.along);
  }
  notes_.push_back(PhotoNote::kUnequal);
  const Mat2 back = matrixOf(best().basis).inverse();
  const Mat2 gram = back.transpose() * reading.gram * back;
  measured_gram_ = gram;
  reader_ = std::make_unique<GroupReader>(cell_, gram, tolerance);
  stage_ = PhotoStage::kSymmetry;
}

/// Runs the last step.
/// @param measured_gram   measured Gram matrix of the best group's w1 and w2
/// @param along           direction of a measured length, which stays that long whatever the group
///                        does to the sides
void Photo::place(const Mat2& measured_gram, const Vec2& along) {
  Mat2 gram = constrained(best().group->lattice, measured_gram);
  const double squared = along.dot(gram * along);
  if (squared > 0) gram *= along.dot(measured_gram * along) / squared;
  if (groups_.stripes) {
    const double across = std::sqrt(gram.determinant() / gram(1, 1));
    const double stripe =
        is_scaled_ ? PhotoTuning::kAlongStripe : across * PhotoTuning::kStripeSide;
    gram << across * across, 0, 0, stripe * stripe;
  }
  vectors_ = placedLattice(mapOf(best()), gram);
  see();
  stage_ = PhotoStage::kDone;
}

/// Determines the proportions of the best group's cell by the image alone.
void Photo::see() {
  MetricHints camera;
  camera.f35 = settings_.hints.f35;
  const auto metric = measured(mapOf(best()), camera);
  if (!metric.ok()) return fail(metric.error());
  const MetricReading& seen = metric.value();
  seen_aspect_ = std::sqrt(seen.gram(1, 1) / seen.gram(0, 0));
  seen_error_ = seen.source == MetricSource::kAssumedFocalLength ? PhotoTuning::kAnyCamera
                                                                 : PhotoTuning::kCreased;
}

LatticeMap Photo::mapOf(const GroupVerdict& verdict) const {
  return lattice_.map.rebased(matrixOf(verdict.basis), verdict.origin);
}

Confidence Photo::confidence() const {
  const Confidence worst = std::max(lattice_.confidence, groups_.confidence);
  const bool is_flat = std::find(notes_.begin(), notes_.end(), PhotoNote::kUneven) == notes_.end();
  return is_flat ? worst : std::max(worst, Confidence::kLikely);
}

}  // namespace seamwise
