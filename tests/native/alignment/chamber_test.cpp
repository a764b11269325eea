#include "alignment/model/chamber.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "base/random.h"
#include "support/print_samples.h"

namespace seamwise {
namespace {

using testing::sampleGroup;
using Shape = Chamber::Shape;

template <bool triangle>
double nearest(const Chamber& chamber, const Vec2& p, const Vec2& q) {
  using Point = Folded<triangle, double>;
  const Point x(chamber.shape, p.x(), p.y());
  double best = std::numeric_limits<double>::infinity();
  for (const Chamber::Coset& coset : chamber.cosets) {
    const Vec2 image = coset.m * q + coset.a;
    best = std::min(best, x.squaredTo(Point(chamber.shape, image.x(), image.y()), chamber.shape,
                                      chamber.square0, chamber.square1));
  }
  return std::sqrt(best);
}

double distanceIn(const Chamber& chamber, const Vec2& x, const Vec2& y) {
  const Vec2 p = chamber.to * x + chamber.offset, q = chamber.to * y + chamber.offset;
  return Chamber::isTriangle(chamber.shape) ? nearest<true>(chamber, p, q)
                                            : nearest<false>(chamber, p, q);
}

TEST(Chamber, KeepsTheDistancesOfEveryGroupThatHasMirrors) {
  const std::map<std::string_view, std::size_t> cosets = {
      {"pm", 1},  {"cm", 2},  {"pmm", 1},  {"pmg", 2},  {"cmm", 2},
      {"p4m", 1}, {"p4g", 4}, {"p3m1", 1}, {"p31m", 3}, {"p6m", 1}};
  Random random(7);
  for (const GroupData& data : wallpaperGroups()) {
    for (const double turn : {0.0, 0.3}) {
      const WallpaperGroup group = sampleGroup(data, turn);
      const Chamber chamber = Chamber::of(group);
      EXPECT_EQ(chamber.shape == Shape::kCell, data.mirrors.empty()) << data.name;
      if (data.mirrors.empty()) continue;
      EXPECT_EQ(chamber.cosets.size(), cosets.at(data.name)) << data.name;
      EXPECT_LT((chamber.cosets[0].m - Mat2::Identity()).norm(), 1e-12);
      for (int k = 0; k < 1000; ++k) {
        const auto anywhere = [&] {
          return Vec2(100 * random.uniform() - 50, 100 * random.uniform() - 50);
        };
        const Vec2 x = anywhere(), y = anywhere();
        EXPECT_NEAR(distanceIn(chamber, x, y), group.distance(x, y), 1e-11) << data.name;
      }
    }
  }
}

}  // namespace
}  // namespace seamwise
