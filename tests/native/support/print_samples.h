#pragma once
// Lattices, random points and membership tests that the tests of prints and alignments share.
#include <gtest/gtest.h>

#include <limits>
#include <ostream>
#include <random>
#include <vector>

#include "alignment/model/alignment.h"
#include "support/level.h"
#include "wallpaper/group.h"

namespace seamwise {

/// Name of a group in failure messages of GoogleTest.
inline void PrintTo(const GroupData& data, std::ostream* out) { *out << data.name; }

}  // namespace seamwise

namespace seamwise::testing {

inline constexpr double kExact = 1e-9;  ///< cm: equal up to rounding

/// All groups; every third for a commit.
inline std::vector<GroupData> sampledGroups() {
  std::vector<GroupData> groups;
  for (std::size_t k = 0; k < wallpaperGroups().size(); k += isThorough() ? 1 : 3)
    groups.push_back(wallpaperGroups()[k]);
  return groups;
}

/// A lattice of the group's type, w1 10 cm long at angle `turn`.
inline WallpaperGroup sampleGroup(const GroupData& data, double turn = 0) {
  Vec2 w2 = Vec2::Zero();
  switch (data.lattice) {
    case LatticeType::kOblique:
      w2 = {3, 8};
      break;
    case LatticeType::kRectangular:
      w2 = {0, 7};
      break;
    case LatticeType::kRhombic:
      w2 = {6, 8};
      break;
    case LatticeType::kSquare:
      w2 = {0, 10};
      break;
    case LatticeType::kHexagonal:
      w2 = 10 * unit(kPi / 3);
      break;
  }
  auto group = WallpaperGroup::make(data.name, 10 * unit(turn), rotation(turn) * w2);
  EXPECT_TRUE(group.ok()) << group.error().message;
  return std::move(group).value();
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  double angle() { return between(-kPi, kPi); }
  Vec2 point() {
    const double x = between(-50, 50);
    return {x, between(-50, 50)};
  }
  Alignment alignment() {
    const double turn = angle();
    return {turn, point()};
  }
  /// A pair's map: a glide reflection in general.
  RigidMotion glide() {
    const double turn = angle();
    return {turn, point(), true};
  }
  RigidMotion reflection() {
    const Vec2 a = point();
    return RigidMotion::reflection(a, a + 10 * unit(angle()));
  }

 private:
  std::mt19937 engine_;
};

/// Distance to the nearest image of y under only the elements that preserve, or reverse,
/// orientation.
inline double distanceByHalf(const WallpaperGroup& group, const Vec2& x, const Vec2& y,
                             bool reversing) {
  double best = std::numeric_limits<double>::infinity();
  for (const Element& e : group.elements()) {
    if (e.mirrored == reversing) best = std::min(best, group.reduce(x - e(y)).norm());
  }
  return best;
}

/// Returns whether the motion maps the whole print onto itself.
inline bool isSymmetryOfPrint(const WallpaperGroup& group, const RigidMotion& motion) {
  for (const Element& e : group.elements()) {
    if (e.mirrored == motion.mirrored && (e.A - motion.linear()).norm() < kExact &&
        group.reduce(motion.shift - e.a).norm() < kExact) {
      return true;
    }
  }
  return false;
}

/// Distance of the image piece's print from the mirrored print of the first piece: the greatest
/// distance over sample points p of W'(map p) from W(p), modulo orientation-reversing elements.
/// [cm]
inline double asymmetry(const WallpaperGroup& group, const Alignment& first,
                        const Alignment& second, const RigidMotion& map) {
  Random random(99);
  double worst = 0;
  for (int k = 0; k < 12; ++k) {
    const Vec2 p = random.point();
    worst = std::max(worst, distanceByHalf(group, second.toPrint(map(p)), first.toPrint(p), true));
  }
  return worst;
}

}  // namespace seamwise::testing
