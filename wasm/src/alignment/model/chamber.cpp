#include "alignment/model/chamber.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace seamwise {
namespace {

using Shape = Chamber::Shape;

constexpr double kSame = 1e-6;  ///< greatest difference of chamber coordinates of one point

/// Folds a point of numbers, and reduces the length of a strip modulo its repeat.
Vec2 folded(Shape shape, const Vec2& p) {
  if (Chamber::isTriangle(shape)) {
    const Folded<true, double> in(shape, p.x(), p.y());
    return {in.x, in.y};
  }
  const Folded<false, double> in(shape, p.x(), p.y());
  return {in.x, shape == Shape::kStrip ? in.y - std::floor(in.y) : in.y};
}

/// A coordinate across the lines of a family, in cm-1. The lines are at multiples of one half.
struct Across {
  Vec2 gradient;
  double offset;
};
Across acrossOf(const MirrorFamily& family, const Mat2& basis) {
  const Vec2 h(-family.direction[1], family.direction[0]);
  const double spacing = 1.0 / static_cast<double>(family.constants.size());
  return {basis.inverse().transpose() * h / (2 * spacing), -family.constants[0] / (2 * spacing)};
}

}  // namespace

Chamber Chamber::of(const WallpaperGroup& group) {
  const Mat2 basis = (Mat2() << group.w1(), group.w2()).finished();
  const MirrorFamilies& mirrors = group.data().mirrors;
  Chamber chamber;
  const auto coordinates = [&](const Vec2& first, const Vec2& second) {
    chamber.to << first.transpose(), second.transpose();
    chamber.square0 = 1 / first.squaredNorm(), chamber.square1 = 1 / second.squaredNorm();
  };
  if (mirrors.empty()) return chamber;
  if (mirrors.size() == 1) {
    chamber.shape = Shape::kStrip;
    const Across x = acrossOf(mirrors[0], basis);
    const auto& along = mirrors[0].direction;
    const Vec2 repeat = along[0] * group.w1() + along[1] * group.w2();
    coordinates(x.gradient, repeat / repeat.squaredNorm());
    chamber.offset.x() = x.offset;
  } else if (mirrors.size() % 3 != 0) {
    chamber.shape = mirrors.size() == 2 ? Shape::kRectangle : Shape::kHalfSquare;
    const Across x = acrossOf(mirrors[0], basis), y = acrossOf(mirrors[1], basis);
    coordinates(x.gradient, y.gradient);
    chamber.offset = {x.offset, y.offset};
  } else {
    // The last three families (of six, those with the closest lines), all through the origin.
    chamber.shape = mirrors.size() == 3 ? Shape::kEquilateral : Shape::kHalfEquilateral;
    const Vec2 a = 2 * acrossOf(mirrors[mirrors.size() - 3], basis).gradient;
    const Vec2 b = 2 * acrossOf(mirrors[mirrors.size() - 2], basis).gradient;
    // All three are at 120 degrees and add up to 0: a = x - y, b = y - z, c = z - x.
    const Vec2 at_120 = a.dot(b) < 0 ? b : -b, c = -a - at_120;
    coordinates((a - c) / 3, (at_120 - a) / 3);
    // x2 + y2 + z2 = 2/3 |p|2 |a|2 / 2, as a, b and c are of one length
    chamber.square0 = 2 / a.squaredNorm();
  }
  // Elements of the group, with neighbouring shifts, that carry some point to different ones.
  const Vec2 probe(0.1234, 0.0567);
  const Mat2 from = chamber.to.inverse();
  std::vector<Vec2> seen;
  for (const Element& e : group.elements()) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const Vec2 shift = e.a + i * group.w1() + j * group.w2();
        const Mat2 m = chamber.to * e.A * from;
        const Coset coset{m, chamber.to * shift + chamber.offset - m * chamber.offset};
        const Vec2 image = folded(chamber.shape, coset.m * probe + coset.a);
        if (std::any_of(seen.begin(), seen.end(),
                        [&](const Vec2& other) { return (other - image).norm() < kSame; }))
          continue;
        seen.push_back(image);
        chamber.cosets.push_back(coset);
      }
    }
  }
  return chamber;
}

}  // namespace seamwise
