#include "symmetry/outline.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.h"
#include "support/small_garments.h"
#include "symmetry/mirror_search.h"

namespace seamwise {
namespace {

/// A round piece with a wavy outline of so many straight edges.
Panel wavy(int edges) {
  Polyline corners;
  for (int k = 0; k < edges; ++k)
    corners.push_back((20 + 3 * std::cos(5 * 2 * kPi * k / edges)) * unit(2 * kPi * k / edges));
  return small::polygon("wavy", corners);
}

TEST(OutlineOfManyEdges, FindsWhatLooksAtAllOfThemFind) {
  const Outline outline(wavy(1000));
  const Polyline& corners = outline.corners();
  Random random(7);
  for (int k = 0; k < 300; ++k) {
    const Vec2 p(60 * random.uniform() - 30, 60 * random.uniform() - 30);
    double corner = 1e9, point = 1e9;
    int first = -1;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const double d = (corners[i] - p).squaredNorm();
      if (d < corner) corner = d, first = static_cast<int>(i);
      const Vec2 step = corners[(i + 1) % corners.size()] - corners[i];
      const double t = std::clamp((p - corners[i]).dot(step) / step.squaredNorm(), 0.0, 1.0);
      point = std::min(point, (corners[i] + t * step - p).norm());
    }
    EXPECT_EQ(outline.nearestCorner(p), first);
    EXPECT_NEAR(outline.nearest(p).distance, point, 1e-9);
  }
}

TEST(OutlineOfManyEdges, IsFoundToBeSymmetric) {
  const Outline outline(wavy(2500));
  const std::vector<MirrorRegistration> mirrors = findMirrors(outline, outline);
  ASSERT_FALSE(mirrors.empty());
  EXPECT_LT(mirrors[0].residual, 1e-6);
}

}  // namespace
}  // namespace seamwise
