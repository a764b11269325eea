#include "photo/fabric/coin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/sort_by.h"
#include "photo/base/map_inverse.h"
#include "photo/base/normal_matrix.h"

namespace seamwise {

namespace {

constexpr KnownObject kKnownObjects[] = {
    {"eur1", 2.325, 2.325, true}, {"eur2", 2.575, 2.575, true}, {"quarter", 2.426, 2.426, true},
    {"gbp1", 2.34, 2.34, true},   {"card", 8.56, 5.398, false}, {"a4", 29.7, 21, false}};

constexpr double kCompareShare = 0.8;   // share of the time
constexpr double kLeastRadius = 6;      // minimum half of the longer side, compared image. [px]
constexpr double kMostOfPicture = 0.4;  // maximum half, relative to the image's longer side
constexpr double kScaleStep = 1.04;     // 110 steps from the smallest to the largest size
constexpr double kCenterStep = 0.12;    // relative to half the longer side
constexpr int kCenterSteps = 3;         // steps to each side
constexpr int kTurnSteps = 30;          // steps in half a turn
constexpr double kCoarseReach = 0.08;  // both sides of an outline, relative to half the longer side
constexpr double kWindows[] = {0.06, 0.05, 0.04, 0.03};  // same unit
// Rims are tried from a little outside the coverage to well inside it: a shadow of 5 mm takes 0.3
// of a coin's outline.
constexpr double kLargestRim = 1.1, kSmallestRim = 0.6, kRimStep = 0.985;
constexpr double kRimCenterStep = 0.04;  // relative to half the longer side
constexpr int kRimCenterSteps = 3;       // steps to each side
constexpr int kRimTurnSteps = 2;         // thirds of a step of kTurnSteps to each side
constexpr double kRimReach = 0.025;      // both sides of a rim, relative to half the longer side
constexpr float kAsSharp = 0.5f;  // share of the sharpest rim's sharpness; inner rings are sharper
constexpr double kBeside = 1.08;  // place of the shadow beside a rim
constexpr int kBrightBits = kOutlineBits / 6;  // bits of a shadow that may be brighter than print
constexpr int kBluntBits = kOutlineBits * 2 / 5;  // bits of a rim that may have a fainter edge
constexpr double kCloseTo = 0.02;     // maximum distance of an edge from the outline, same unit
constexpr double kClosePixels = 0.5;  // minimum of that distance, compared image. [px]
constexpr double kLeastWindow = 2;    // same unit: coverage ends up to a pixel outside
constexpr int kFewestSupports = kOutlineBits / 3;  // chosen
constexpr int kWindowSamples = 12;                 // samples to each side
constexpr float kUnclear = 0.3f;                   // minimum edge of the coverage of an object
constexpr float kFaint = 12;                       // minimum sharpness of a bit or rim, of 3 x 255
constexpr float kAsClear = 0.8f;  // share of the best outline's clearness: coins have inner rings
constexpr double kPixelError = 0.2;   // error of outlines in the compared image. [px]
constexpr double kThickness = 0.007;  // error of the size caused by the height of a coin
constexpr double kCorner = 0.12;      // share of a card's side omitted at rounded corners

std::array<OutlineBit, kOutlineBits> outlineOf(const KnownObject& object) {
  std::array<OutlineBit, kOutlineBits> bits;
  const double ratio = object.height / object.width;
  for (int k = 0; k < kOutlineBits; ++k) {
    const double part = (k + 0.5) / kOutlineBits;
    if (object.round) {
      bits[k].at = bits[k].normal = unit(2 * kPi * part);
      continue;
    }
    const int side = k % 4;
    const double along = (1 - kCorner) * (2 * part - 1);
    const Vec2 normal = side < 2 ? Vec2(0, side == 0 ? 1 : -1) : Vec2(side == 2 ? 1 : -1, 0);
    bits[k] = {side < 2 ? Vec2(along, ratio * normal.y()) : Vec2(normal.x(), ratio * along),
               normal};
  }
  return bits;
}

Error notSeen(const KnownObject& object) {
  const std::string thing = object.round ? "coin" : object.name == "a4" ? "sheet" : "card";
  return {Failure::kPicture,
          "No " + thing +
              " is seen at that point; tap its middle, or drag a line of known length instead.",
          -1, -1, "object"};
}

}  // namespace

std::span<const KnownObject> knownObjects() { return kKnownObjects; }

ObjectSearch::ObjectSearch(const PixelView& pixels, const LatticeMap& map, const Mat2& gram,
                           const KnownObject& object, const Vec2& tapped)
    : difference_(pixels, map),
      map_(map),
      object_(object),
      bits_(outlineOf(object)),
      best_(kUnclear) {
  const double along = std::sqrt(gram(0, 0)), across = gram(0, 1) / along;
  const double up = std::sqrt(std::max(gram(1, 1) - across * across, 1e-300));
  to_lattice_ << 1 / along, -across / (along * up), 0, 1 / up;
  to_fabric_ << along, across, 0, up;
  const Vec2 u = MapInverse(map)(tapped);
  tapped_ = to_fabric_ * u;
  const Mat2 d = derivative(map, u) * to_lattice_;
  const double px = std::sqrt(std::abs(cross(d.col(0), d.col(1))));  // px per unit of length
  size_ = kLeastRadius * difference_.factor() / px;
  most_ = kMostOfPicture * std::max(pixels.width, pixels.height) / px;
}

bool ObjectSearch::advance() {
  switch (stage_) {
    case Stage::kCompare:
      if (!difference_.advance()) stage_ = Stage::kSizes;
      break;
    case Stage::kSizes:
      if (size_ < most_ && count_ < kMostSizes) {
        trySize();
        break;
      }
      if (chooseSize()) {
        stage_ = Stage::kRims;
        whole_ = placing_;
        size_ = kLargestRim * placing_.size;
        count_ = 0;
        break;
      }
      error_ = notSeen(object_);
      stage_ = Stage::kDone;
      break;
    case Stage::kRims:
      if (size_ > kSmallestRim * whole_.size) {
        tryRim();
        break;
      }
      if (chooseRim()) {
        stage_ = Stage::kRefine;
        break;
      }
      error_ = notSeen(object_);
      stage_ = Stage::kDone;
      break;
    case Stage::kRefine:
      for (const double window : kWindows) refine(std::max(window, kLeastWindow * pixel()));
      if (supports_ < kFewestSupports) {
        error_ = notSeen(object_);
      } else {
        finish();
      }
      stage_ = Stage::kDone;
      break;
    case Stage::kDone:
      break;
  }
  return stage_ != Stage::kDone;
}

double ObjectSearch::fraction() const {
  switch (stage_) {
    case Stage::kCompare:
      return kCompareShare * difference_.fraction();
    case Stage::kSizes:
      return kCompareShare + (1 - kCompareShare) * std::min(1.0, size_ / most_);
    case Stage::kRims:
    case Stage::kRefine:
    case Stage::kDone:
      break;
  }
  return 1;
}

Vec2 ObjectSearch::onPicture(const Vec2& bit) const {
  return pictureOf(placing_.center + placing_.size * (rotation(placing_.turn) * bit));
}

/// Returns the size of a pixel of the compared image, relative to half the longer side.
double ObjectSearch::pixel() const {
  return 2 * difference_.factor() / (onPicture(Vec2(1, 0)) - onPicture(Vec2(-1, 0))).norm();
}

/// Returns the edge that three quarters of the outline exceed, or 0 if it is not above `least`.
float ObjectSearch::clearness(const ObjectPlacing& placing, float least) const {
  std::vector<double> edges(kOutlineBits);
  const Mat2 turned = rotation(placing.turn);
  int faint = 0;
  for (int k = 0; k < kOutlineBits; ++k) {
    const Vec2 at = placing.center + placing.size * (turned * bits_[k].at);
    const Vec2 reach = placing.size * kCoarseReach * (turned * bits_[k].normal);
    const float here =
        difference_.covered(pictureOf(at - reach)) - difference_.covered(pictureOf(at + reach));
    edges[k] = static_cast<double>(here);
    if (here <= least && ++faint > kOutlineBits / 4) return 0;
  }
  sortNumbers(edges);
  return static_cast<float>(edges[kOutlineBits / 4]);
}

void ObjectSearch::trySize() {
  std::pair<float, ObjectPlacing> clearest{0.0f, {}};
  for (int turn = 0; turn < (object_.round ? 1 : kTurnSteps); ++turn) {
    for (int j = -kCenterSteps; j <= kCenterSteps; ++j) {
      for (int i = -kCenterSteps; i <= kCenterSteps; ++i) {
        const ObjectPlacing placing{tapped_ + kCenterStep * size_ * Vec2(i, j), size_,
                                    turn * kPi / kTurnSteps};
        const float clear =
            clearness(placing, std::max({kUnclear, kAsClear * best_, clearest.first}));
        if (clear > clearest.first) clearest = {clear, placing};
      }
    }
  }
  best_ = std::max(best_, clearest.first);
  sizes_[count_++] = clearest;
  size_ *= kScaleStep;
}

/// Chooses the largest outline that is nearly as clear as the clearest; returns false without any.
bool ObjectSearch::chooseSize() {
  for (int k = count_; k-- > 0;) {
    if (sizes_[k].first <= kUnclear || sizes_[k].first < kAsClear * best_) continue;
    // The clearest of neighbouring sizes is used.
    while (k > 0 && sizes_[k - 1].first > sizes_[k].first) --k;
    placing_ = sizes_[k].second;
    return true;
  }
  return false;
}

/// Returns the step of the difference that three fifths of the outline exceed, or 0 if it is not
/// above `least`.
float ObjectSearch::sharpness(const ObjectPlacing& placing, float least) const {
  std::vector<double> steps(kOutlineBits);
  const Mat2 turned = rotation(placing.turn);
  const double share = std::max(kRimReach, pixel());
  int faint = 0;
  for (int k = 0; k < kOutlineBits; ++k) {
    const Vec2 at = placing.center + placing.size * (turned * bits_[k].at);
    const Vec2 reach = placing.size * share * (turned * bits_[k].normal);
    const float here = difference_.step(pictureOf(at - reach), pictureOf(at + reach));
    steps[k] = static_cast<double>(here);
    if (here <= least && ++faint > kBluntBits) return 0;
  }
  sortNumbers(steps);
  return static_cast<float>(steps[kBluntBits]);
}

void ObjectSearch::tryRim() {
  std::pair<float, ObjectPlacing> sharpest{0.0f, whole_};
  const int turns = object_.round ? 0 : kRimTurnSteps;
  for (int turn = -turns; turn <= turns; ++turn) {
    for (int j = -kRimCenterSteps; j <= kRimCenterSteps; ++j) {
      for (int i = -kRimCenterSteps; i <= kRimCenterSteps; ++i) {
        const ObjectPlacing placing{whole_.center + kRimCenterStep * whole_.size * Vec2(i, j),
                                    size_, whole_.turn + turn * kPi / (3 * kTurnSteps)};
        const float sharp = sharpness(placing, std::max(kFaint, sharpest.first));
        if (sharp > sharpest.first) sharpest = {sharp, placing};
      }
    }
  }
  sizes_[count_++] = sharpest;
  size_ *= kRimStep;
}

/// Returns whether the print beside a rim is no brighter than elsewhere, or the rim is the whole
/// outline.
bool ObjectSearch::isInShadow(const ObjectPlacing& rim) const {
  if (kBeside * rim.size > whole_.size) return true;
  const Mat2 turned = rotation(rim.turn);
  int bright = 0;
  for (const OutlineBit& bit : bits_) {
    const Vec2 beside = rim.center + kBeside * rim.size * (turned * bit.at);
    if (difference_.brighter(pictureOf(beside)) > kFaint) ++bright;
  }
  return bright <= kBrightBits;
}

/// Chooses the largest rim that is nearly as sharp as the sharpest; returns false without any.
bool ObjectSearch::chooseRim() {
  float sharpest = 0;
  for (int k = 1; k + 1 < count_; ++k) {
    const float sharp = sizes_[k].first;
    const bool is_rim = sharp >= sizes_[k - 1].first && sharp >= sizes_[k + 1].first &&
                        isInShadow(sizes_[k].second);
    if (is_rim) sharpest = std::max(sharpest, sharp);
    is_rim_[k] = is_rim;
  }
  for (int k = 1; k + 1 < count_; ++k) {
    if (!is_rim_[k] || sizes_[k].first <= std::max(kFaint, kAsSharp * sharpest)) continue;
    placing_ = sizes_[k].second;
    return true;
  }
  return false;
}

void ObjectSearch::refine(double window) {
  // Unknowns: shift of the centre, growth and turn, relative to the size; a circle does not turn.
  constexpr int kUnknowns = 4;
  NormalMatrix normal{}, inverse{};
  double gradient[kUnknowns] = {};
  double squares = 0, weights = 1e-12;
  supports_ = 0;
  const Mat2 turned = rotation(placing_.turn);
  const double close = std::max(kCloseTo, kClosePixels * pixel());
  const double step = window * placing_.size / kWindowSamples;
  for (const OutlineBit& bit : bits_) {
    const Vec2 at = placing_.center + placing_.size * (turned * bit.at), n = turned * bit.normal;
    std::array<float, 2 * kWindowSamples + 1> edges;
    for (int k = 0; k <= 2 * kWindowSamples; ++k) {
      const Vec2 p = at + (k - kWindowSamples) * step * n;
      edges[k] = difference_.step(pictureOf(p - 1.5 * step * n), pictureOf(p + 1.5 * step * n));
    }
    const int top =
        static_cast<int>(std::max_element(edges.begin() + 1, edges.end() - 1) - edges.begin());
    if (edges[top] < kFaint) continue;
    const float before = edges[top - 1], after = edges[top + 1];
    const float bend = before - 2 * edges[top] + after;
    const double peak = top + (bend < 0 ? 0.5 * (before - after) / bend : 0.0);
    const double off = (peak - kWindowSamples) * window / kWindowSamples;
    const double weight = 1 / (1 + 9 * off * off / (window * window));
    const double slope[kUnknowns] = {n.x(), n.y(), bit.at.dot(bit.normal),
                                     object_.round ? 0.0 : perp(bit.at).dot(bit.normal)};
    for (int i = 0; i < kUnknowns; ++i) {
      for (int j = 0; j < kUnknowns; ++j) normal[i][j] += weight * slope[i] * slope[j];
      gradient[i] += weight * slope[i] * off;
    }
    if (std::abs(off) < close) ++supports_;
    squares += weight * off * off;
    weights += weight;
  }
  for (int i = 0; i < kUnknowns; ++i) normal[i][i] += 1e-9;
  left_ = std::sqrt(squares / weights);
  if (!invertNormal(normal, kUnknowns, inverse)) return;
  double change[kUnknowns] = {};
  for (int i = 0; i < kUnknowns; ++i)
    for (int j = 0; j < kUnknowns; ++j) change[i] += inverse[i][j] * gradient[j];
  placing_.center += placing_.size * Vec2(change[0], change[1]);
  placing_.size *= 1 + change[2];
  placing_.turn += change[3];
}

void ObjectSearch::finish() {
  const int corners = object_.round ? kOutlineBits : 4;
  const double ratio = object_.height / object_.width;
  for (int k = 0; k < corners; ++k) {
    const Vec2 bit = object_.round ? unit(2 * kPi * k / corners)
                                   : Vec2(k == 0 || k == 3 ? -1 : 1, k < 2 ? -ratio : ratio);
    found_.outline.push_back(onPicture(bit));
  }
  found_.scale = object_.width / 2 / placing_.size;
  const double misplaced = kPixelError * pixel();
  found_.error = std::sqrt(kThickness * kThickness + left_ * left_ / (kOutlineBits / 4.0) +
                           misplaced * misplaced);
}

}  // namespace seamwise
