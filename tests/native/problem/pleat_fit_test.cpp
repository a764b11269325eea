#include "problem/pleat_fit.h"

#include <gtest/gtest.h>

namespace seamwise {
namespace {

/// Two pleats of 4 and 6 cm, which become 5 and 5 cm wide.
PleatFit twoPleats() { return {0, Vec2::UnitX(), {{10, 14, 1}, {20, 26, -1}}}; }

TEST(PleatFit, MovesThePartsBetweenPleatsRigidly) {
  const PleatFit fit = twoPleats();
  EXPECT_NEAR(fit.fitted(Vec2(0, 7)).x(), 0, 1e-12);
  EXPECT_NEAR(fit.fitted(Vec2(14, 7)).x() - fit.fitted(Vec2(10, 7)).x(), 5, 1e-12);
  EXPECT_NEAR(fit.fitted(Vec2(20, 7)).x() - fit.fitted(Vec2(14, 7)).x(), 6, 1e-12);
  EXPECT_NEAR(fit.fitted(Vec2(26, 7)).x() - fit.fitted(Vec2(20, 7)).x(), 5, 1e-12);
  EXPECT_EQ(fit.fitted(Vec2(17, 7)).y(), 7);
  EXPECT_NEAR(fit.movement(), 1, 1e-12);
}

TEST(PleatFit, MapsBack) {
  const PleatFit fit = twoPleats();
  for (double x = 0; x < 30; x += 0.7)
    EXPECT_LT((fit.drafted(fit.fitted(Vec2(x, 3))) - Vec2(x, 3)).norm(), 1e-12) << x;
}

TEST(PleatFit, CentresTheChangeOfWidth) {
  const PleatFit fit{0, Vec2::UnitX(), {{-10, 10, 2}}};
  EXPECT_NEAR(fit.fitted(Vec2(-20, 0)).x(), -21, 1e-12);
  EXPECT_NEAR(fit.fitted(Vec2(20, 0)).x(), 21, 1e-12);
  EXPECT_NEAR(fit.fitted(Vec2(0, 0)).x(), 0, 1e-12);
}

TEST(PleatFit, FindsTheStripOfAnEdge) {
  const PleatFit fit = twoPleats();
  EXPECT_EQ(fit.stripOf(Curve::line(Vec2(10, 0), Vec2(14, 1))), 0);
  EXPECT_EQ(fit.stripOf(Curve::line(Vec2(14, 0), Vec2(20, 0))), -1);
  EXPECT_EQ(fit.stripOf(Curve::line(Vec2(10, 0), Vec2(10, 9))), -1);
  EXPECT_EQ(fit.stripOf(Curve::line(Vec2(12, 0), Vec2(20, 0))), -2);
  EXPECT_EQ(fit.stripOf(Curve::arc(Vec2(10, 0), Vec2(14, 0), 3, false, true)), -2);
}

TEST(PleatFit, StretchesCurvesWithTheirStrip) {
  const PleatFit fit = twoPleats();
  const Curve drawn = Curve::cubic(Vec2(10, 0), Vec2(12, 1), Vec2(13, 2), Vec2(14, 0));
  const Curve fitted = fit.fitted(drawn);
  for (double t = 0; t <= 1; t += 0.25)
    EXPECT_NEAR(fitted.at(t).x(),
                10 + 1.25 * (drawn.at(t).x() - 10) + fit.fitted(Vec2(10, 0)).x() - 10, 1e-9)
        << t;
}

}  // namespace
}  // namespace seamwise
