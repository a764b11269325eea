#include "recognition/cloth/coin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/sort_by.h"
#include "recognition/base/map_inverse.h"
#include "recognition/cloth/print_difference.h"

namespace seamwise {

namespace {

constexpr KnownObject kKnownObjects[] = {
    {"eur1", 2.325, 2.325, true}, {"eur2", 2.575, 2.575, true}, {"quarter", 2.426, 2.426, true},
    {"gbp1", 2.34, 2.34, true},   {"card", 8.56, 5.398, false}, {"a4", 29.7, 21, false}};

constexpr int kOutlinePoints = 48;
constexpr double kLeastRadius = 6;      // half the longer side, of what is compared. [px]
constexpr double kMostOfPicture = 0.4;  // half of it, over the picture's longer side
constexpr double kScaleStep = 1.04;
constexpr double kCenterStep = 0.12;   // of half the longer side
constexpr int kCenterSteps = 3;        // to each side
constexpr int kTurnSteps = 30;         // of half a turn
constexpr double kCoarseReach = 0.08;  // to both sides of an outline, of half the longer side
constexpr double kWindows[] = {0.14, 0.1, 0.07, 0.05, 0.04, 0.03};  // of the same
constexpr int kWindowSamples = 12;                                  // to each side
constexpr float kFaint = 24;          // of 3 x 255: things that stand out less are none
constexpr float kAsGood = 0.8f;       // of the best outline: coins have rings within
constexpr double kPixelError = 0.2;   // of what is compared, by which outlines lie off. [px]
constexpr double kThickness = 0.007;  // what the height of a coin makes of its size
constexpr double kCorner = 0.12;      // of a card's side, left out: corners are round

/// A bit of an outline whose longer half side is 1: place, and unit normal outwards.
struct OutlineBit {
  Vec2 at, normal;
};

std::vector<OutlineBit> outlineOf(const KnownObject& object) {
  std::vector<OutlineBit> bits;
  const double ratio = object.height / object.width;
  for (int k = 0; k < kOutlinePoints; ++k) {
    const double part = (k + 0.5) / kOutlinePoints;
    if (object.round) {
      bits.push_back({unit(2 * kPi * part), unit(2 * kPi * part)});
      continue;
    }
    const int side = k % 4;
    const double along = (1 - kCorner) * (2 * part - 1);
    const Vec2 normal = side < 2 ? Vec2(0, side == 0 ? 1 : -1) : Vec2(side == 2 ? 1 : -1, 0);
    bits.push_back(
        {side < 2 ? Vec2(along, ratio * normal.y()) : Vec2(normal.x(), ratio * along), normal});
  }
  return bits;
}

/// How an outline lies on the cloth, in the gram's unit of length, w1 along x.
struct Placing {
  Vec2 center = Vec2::Zero();
  double size = 1, turn = 0;
};

class ObjectSearch {
 public:
  ObjectSearch(const PixelView& pixels, const LatticeMap& map, const Mat2& gram,
               const KnownObject& object)
      : difference_(pixels, map),
        longer_(std::max(pixels.width, pixels.height)),
        map_(map),
        bits_(outlineOf(object)),
        round_(object.round) {
    const double along = std::sqrt(gram(0, 0)), across = gram(0, 1) / along;
    const double up = std::sqrt(std::max(gram(1, 1) - across * across, 1e-300));
    to_lattice_ << 1 / along, -across / (along * up), 0, 1 / up;
    to_cloth_ << along, across, 0, up;
  }

  /// The largest of the outlines that are nearly as clear as the clearest; false when none is.
  bool findCoarse(const Vec2& tapped, Placing* found) const;
  /// One step of least squares; the root mean square of what is left, over the size.
  double refine(double window, Placing* placing) const;
  /// Half its longer side in pixels of what is compared.
  double pixels(const Placing& placing) const {
    return (onPicture(placing, Vec2(1, 0)) - onPicture(placing, Vec2(-1, 0))).norm() / 2 /
           difference_.factor();
  }
  Vec2 onPicture(const Placing& placing, const Vec2& bit) const {
    return pictureOf(placing.center + placing.size * (rotation(placing.turn) * bit));
  }

 private:
  Vec2 pictureOf(const Vec2& cloth) const { return map_(to_lattice_ * cloth); }
  /// By how much more the inside differs from the print than the outside; 0 where it does not.
  float edge(const Vec2& inside, const Vec2& outside) const {
    return std::max(0.0f, difference_.at(pictureOf(inside)) - difference_.at(pictureOf(outside)));
  }
  float clearness(const Placing& placing, float least) const;

  PrintDifference difference_;
  int longer_;
  LatticeMap map_;
  std::vector<OutlineBit> bits_;
  bool round_;
  Mat2 to_lattice_, to_cloth_;
};

/// The edge that three quarters of the outline exceed, or 0 when that is not more than `least`.
float ObjectSearch::clearness(const Placing& placing, float least) const {
  std::vector<double> edges(kOutlinePoints);
  const Mat2 turned = rotation(placing.turn);
  int faint = 0;
  for (int k = 0; k < kOutlinePoints; ++k) {
    const Vec2 at = placing.center + placing.size * (turned * bits_[k].at);
    const Vec2 reach = placing.size * kCoarseReach * (turned * bits_[k].normal);
    const float here = edge(at - reach, at + reach);
    edges[k] = static_cast<double>(here);
    if (here <= least && ++faint > kOutlinePoints / 4) return 0;
  }
  sortNumbers(edges);
  return static_cast<float>(edges[kOutlinePoints / 4]);
}

bool ObjectSearch::findCoarse(const Vec2& tapped, Placing* found) const {
  const Vec2 u = MapInverse(map_)(tapped);
  const Mat2 d = derivative(map_, u) * to_lattice_;
  const double px = std::sqrt(std::abs(cross(d.col(0), d.col(1))));  // of a unit of length
  const double least = kLeastRadius * difference_.factor() / px;
  const double most = kMostOfPicture * longer_ / px;
  float best = kFaint;
  std::vector<std::pair<float, Placing>> sizes;
  for (double size = least; size < most; size *= kScaleStep) {
    std::pair<float, Placing> clearest{0.0f, {}};
    for (int turn = 0; turn < (round_ ? 1 : kTurnSteps); ++turn) {
      for (int j = -kCenterSteps; j <= kCenterSteps; ++j) {
        for (int i = -kCenterSteps; i <= kCenterSteps; ++i) {
          const Placing placing{to_cloth_ * u + kCenterStep * size * Vec2(i, j), size,
                                turn * kPi / kTurnSteps};
          const float clear =
              clearness(placing, std::max({kFaint, kAsGood * best, clearest.first}));
          if (clear > clearest.first) clearest = {clear, placing};
        }
      }
    }
    best = std::max(best, clearest.first);
    sizes.push_back(clearest);
  }
  for (std::size_t k = sizes.size(); k-- > 0;) {
    if (sizes[k].first <= kFaint || sizes[k].first < kAsGood * best) continue;
    // Of neighbouring sizes, the clearest.
    while (k > 0 && sizes[k - 1].first > sizes[k].first) --k;
    *found = sizes[k].second;
    return true;
  }
  return false;
}

double ObjectSearch::refine(double window, Placing* placing) const {
  // Unknowns: the center's shift, growth and turn, in sizes; a circle does not turn.
  double normal[4][5] = {};
  double squares = 0, weights = 1e-12;
  const Mat2 turned = rotation(placing->turn);
  const double step = window * placing->size / kWindowSamples;
  for (const OutlineBit& bit : bits_) {
    const Vec2 at = placing->center + placing->size * (turned * bit.at), n = turned * bit.normal;
    std::array<float, 2 * kWindowSamples + 1> edges;
    for (int k = 0; k <= 2 * kWindowSamples; ++k) {
      const Vec2 p = at + (k - kWindowSamples) * step * n;
      edges[k] = edge(p - 1.5 * step * n, p + 1.5 * step * n);
    }
    const int top =
        static_cast<int>(std::max_element(edges.begin() + 1, edges.end() - 1) - edges.begin());
    if (edges[top] < kFaint / 2) continue;
    const float before = edges[top - 1], after = edges[top + 1];
    const float bend = before - 2 * edges[top] + after;
    const double peak = top + (bend < 0 ? 0.5 * (before - after) / bend : 0.0);
    const double off = (peak - kWindowSamples) * window / kWindowSamples;
    const double weight = 1 / (1 + 9 * off * off / (window * window));
    const double slope[4] = {n.x(), n.y(), bit.at.dot(bit.normal),
                             round_ ? 0.0 : perp(bit.at).dot(bit.normal)};
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) normal[i][j] += weight * slope[i] * slope[j];
      normal[i][4] += weight * slope[i] * off;
    }
    squares += weight * off * off;
    weights += weight;
  }
  double change[4];
  for (int i = 0; i < 4; ++i) normal[i][i] += 1e-9;
  for (int k = 0; k < 4; ++k) {
    for (int i = k + 1; i < 4; ++i) {
      const double factor = normal[i][k] / normal[k][k];
      for (int j = k; j < 5; ++j) normal[i][j] -= factor * normal[k][j];
    }
  }
  for (int k = 3; k >= 0; --k) {
    change[k] = normal[k][4];
    for (int j = k + 1; j < 4; ++j) change[k] -= normal[k][j] * change[j];
    change[k] /= normal[k][k];
  }
  placing->center += placing->size * Vec2(change[0], change[1]);
  placing->size *= 1 + change[2];
  placing->turn += change[3];
  return std::sqrt(squares / weights);
}

}  // namespace

std::span<const KnownObject> knownObjects() { return kKnownObjects; }

Outcome<FoundObject> findObject(const PixelView& pixels, const LatticeMap& map, const Mat2& gram,
                                const KnownObject& object, const Vec2& tapped) {
  const ObjectSearch search(pixels, map, gram, object);
  Placing placing;
  if (!search.findCoarse(tapped, &placing)) {
    const std::string thing = object.round ? "coin" : object.name == "a4" ? "sheet" : "card";
    return Error{Failure::kPicture,
                 "No " + thing +
                     " is seen at that point; tap its middle, or drag a line of known length "
                     "instead.",
                 -1, -1, "object"};
  }
  double left = 0;
  for (const double window : kWindows) left = search.refine(window, &placing);
  FoundObject found;
  const int corners = object.round ? kOutlinePoints : 4;
  const double ratio = object.height / object.width;
  for (int k = 0; k < corners; ++k) {
    const Vec2 bit = object.round ? unit(2 * kPi * k / corners)
                                  : Vec2(k == 0 || k == 3 ? -1 : 1, k < 2 ? -ratio : ratio);
    found.outline.push_back(search.onPicture(placing, bit));
  }
  found.scale = object.width / 2 / placing.size;
  found.error = std::hypot(kThickness, left / std::sqrt(kOutlinePoints / 4.0),
                           kPixelError / search.pixels(placing));
  return found;
}

MetricReading scaledByObject(const MetricReading& metric, const FoundObject& object) {
  MetricReading scaled = metric;
  scaled.gram *= object.scale * object.scale;
  scaled.scaled = true;
  scaled.length_error = std::hypot(object.error, metric.aspect_error / 2);
  return scaled;
}

}  // namespace seamwise
