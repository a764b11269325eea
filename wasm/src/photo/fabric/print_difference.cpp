#include "photo/fabric/print_difference.h"

#include <algorithm>
#include <cmath>

#include "base/sort_by.h"
#include "photo/base/map_inverse.h"
#include "photo/fabric/robust_mean.h"

namespace seamwise {

namespace {

constexpr int kLongerSide = 1280;  // compared image. [px]
constexpr int kFewestSamples = 16, kMostSamples = 160;
constexpr int kPixelsAtOnce = 2'000'000;          // pixels read per step of the reduction
constexpr int kComparedAtOnce = 100'000;          // pixels compared per step
constexpr double kLightNodesAcross = 2;           // too few to follow the brightness of a card
constexpr int kNoiseStep = 5;                     // distance between places where noise is measured
constexpr float kLeastHalf = 4, kTimesNoise = 3;  // see `covered`

float summed(const PixelLanes& off) {
  return std::abs(off[0]) + std::abs(off[1]) + std::abs(off[2]);
}

int reductionOf(const PixelView& pixels) {
  return (std::max(pixels.width, pixels.height) + kLongerSide - 1) / kLongerSide;
}

}  // namespace

PrintDifference::PrintDifference(const PixelView& pixels, const LatticeMap& map)
    : pixels_(pixels),
      map_(map),
      factor_(reductionOf(pixels)),
      reduced_(pixels, factor_),
      fit_(pixels, map, curve_, kLightNodesAcross),
      n_(std::clamp(static_cast<int>(cellSize(map) / factor_), kFewestSamples, kMostSamples)) {}

bool PrintDifference::advance() {
  switch (stage_) {
    case Stage::kReduce:
      if (!reduced_.advance(kPixelsAtOnce)) stage_ = Stage::kFields;
      break;
    case Stage::kFields:
      if (!fit_.advance()) stage_ = Stage::kCopies;
      break;
    case Stage::kCopies:
      canvas_ = latticeCanvas(map_, pixels_.width, pixels_.height, n_);
      sampleCanvas(reduced_.view(), factor_, fit_.fields().shift, &canvas_);
      stage_ = Stage::kMean;
      break;
    case Stage::kMean:
      average();
      break;
    case Stage::kCompare:
      compare();
      break;
    case Stage::kNoise:
      measureNoise();
      stage_ = Stage::kCover;
      break;
    case Stage::kCover:
      cover();
      break;
    case Stage::kDone:
      break;
  }
  return stage_ != Stage::kDone;
}

double PrintDifference::fraction() const {
  return (static_cast<double>(stage_) + (stage_ == Stage::kFields ? fit_.fraction() : 0)) / 7;
}

PixelLanes PrintDifference::flattened(PixelLanes colour, float x, float y) const {
  float light[3];
  fit_.fields().light.at(x, y, light);
  for (int c = 0; c < 3; ++c)
    colour[c] = 255 * curve_.code(curve_.linear(colour[c] / 255) * std::exp(-light[c]));
  return colour;
}

/// Averages some more rows of the cell.
void PrintDifference::average() {
  std::vector<PixelLanes> copies;
  const std::size_t places = static_cast<std::size_t>(n_) * n_;
  const std::size_t at_once = places * kComparedAtOnce / canvas_.size() + n_;
  const std::size_t end = std::min(places, mean_.size() + at_once);
  for (std::size_t place = mean_.size(); place < end; ++place) {
    copies.clear();
    for (int row = static_cast<int>(place) / n_; row < canvas_.rows(); row += n_) {
      for (int column = static_cast<int>(place) % n_; column < canvas_.columns(); column += n_) {
        const std::size_t k = static_cast<std::size_t>(row) * canvas_.columns() + column;
        if (!canvas_.seen[k]) continue;
        const auto& [red, green, blue] = canvas_.planes;
        const PixelLanes coded = {255 * red[k], 255 * green[k], 255 * blue[k], 0};
        PixelLanes colour = flattened(coded, canvas_.x[k], canvas_.y[k]) / 255;
        colour[3] = 1;
        copies.push_back(colour);
      }
    }
    mean_.push_back(255 * agreedColour(copies.data(), static_cast<int>(copies.size())).colour);
  }
  if (end < places) return;
  canvas_ = {};
  stage_ = Stage::kCompare;
}

PixelLanes PrintDifference::printAt(const Vec2& u) const {
  const Vec2 p = n_ * (u - u.array().floor().matrix());
  const int a = static_cast<int>(p.x()), b = static_cast<int>(p.y());
  const float s = static_cast<float>(p.x() - a), t = static_cast<float>(p.y() - b);
  const auto mean = [&](int i, int j) { return mean_[(b + j) % n_ * n_ + (a + i) % n_]; };
  return (1 - t) * ((1 - s) * mean(0, 0) + s * mean(1, 0)) +
         t * ((1 - s) * mean(0, 1) + s * mean(1, 1));
}

/// Compares some more rows of the image.
void PrintDifference::compare() {
  const PixelView view = reduced_.view();
  const MapInverse inverse(map_);
  columns_ = view.width;
  const int end = std::min(view.height, rows_ + 1 + kComparedAtOnce / columns_);
  for (; rows_ < end; ++rows_) {
    for (int column = 0; column < columns_; ++column) {
      const Vec2 p = factor_ * Vec2(column + 0.5, rows_ + 0.5);
      const float x = static_cast<float>(p.x()), y = static_cast<float>(p.y());
      float shift[2];
      fit_.fields().shift.at(x, y, shift);
      const PixelLanes print = printAt(inverse(p - Vec2(shift[0], shift[1])));
      const std::uint8_t* const rgba = &view.rgba[4 * off_.size()];
      off_.push_back(flattened(internal::pixelAt(rgba), x, y) - print);
    }
  }
  if (end == view.height) stage_ = Stage::kNoise;
}

/// Returns the mean over 3 x 3 pixels; the pixel must not be on the image's border.
PixelLanes PrintDifference::averaged(int column, int row) const {
  PixelLanes sum{};
  for (int j = -1; j <= 1; ++j) {
    const PixelLanes* at = &off_[static_cast<std::size_t>(row + j) * columns_ + column];
    sum += at[-1] + at[0] + at[1];
  }
  return sum / 9;
}

void PrintDifference::measureNoise() {
  std::vector<double> sums;
  for (int row = 1; row + 1 < rows_; row += kNoiseStep)
    for (int column = 1; column + 1 < columns_; column += kNoiseStep)
      sums.push_back(static_cast<double>(summed(averaged(column, row))));
  sortNumbers(sums);
  if (!sums.empty()) noise_ = static_cast<float>(sums[sums.size() / 2]);
}

/// Computes the coverage of some more rows of the image.
void PrintDifference::cover() {
  const float half = kLeastHalf + kTimesNoise * noise_;
  const std::size_t end =
      std::min(off_.size(), covered_.size() + kComparedAtOnce + static_cast<std::size_t>(columns_));
  for (std::size_t k = covered_.size(); k < end; ++k) {
    const int column = static_cast<int>(k) % columns_, row = static_cast<int>(k) / columns_;
    const bool inner = column > 0 && row > 0 && column + 1 < columns_ && row + 1 < rows_;
    const float sum = inner ? summed(averaged(column, row)) : 0.0f;
    covered_.push_back(sum * sum / (sum * sum + half * half));
  }
  if (end == off_.size()) stage_ = Stage::kDone;
}

float PrintDifference::step(const Vec2& p, const Vec2& q) const {
  return summed(between(off_, p, PixelLanes{}) - between(off_, q, PixelLanes{}));
}

template <class Value>
Value PrintDifference::between(const std::vector<Value>& map, const Vec2& p,
                               const Value& outside) const {
  const double x = p.x() / factor_ - 0.5, y = p.y() / factor_ - 0.5;
  if (!(x >= 0 && y >= 0 && x < columns_ - 1 && y < rows_ - 1)) return outside;
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  const float s = static_cast<float>(x - i), t = static_cast<float>(y - j);
  const Value* above = &map[static_cast<std::size_t>(j) * columns_ + i];
  const Value* below = above + columns_;
  return (1 - t) * ((1 - s) * above[0] + s * above[1]) + t * ((1 - s) * below[0] + s * below[1]);
}

}  // namespace seamwise
