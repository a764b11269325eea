#include "drape/drape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "drape/drape_samples.h"
#include "support/level.h"

namespace seamwise {
namespace {

/// A square of 40 cm on a sphere of 20 cm in diameter.
struct Laid {
  Pattern pattern = testing::plainPattern(testing::rectangle(40, 40));
  testing::Sphere sphere{Vec3::Zero(), 0.1};
  DrapeProblem problem() const {
    Outcome<SewnLevels> levels = sewnLevels(pattern);
    EXPECT_TRUE(levels.ok());
    DrapeProblem problem;
    problem.levels = std::move(levels).value();
    problem.pattern = pattern, problem.shapes = restShapes(pattern);
    problem.warp = testing::upright(pattern);
    problem.body = &sphere;
    problem.start = testing::laid(problem.levels.coarse, [](int, const Vec2& at) {
      return Vec3(0.01 * (at.x() - 20), 0.102, 0.01 * (at.y() - 20));
    });
    return problem;
  }
};

TEST(Drapes, ASquareIsSewnHungSettledAndFoundInOrder) {
  const Laid laid;
  Drape drape(laid.problem());
  while (drape.advance(1)) {
  }
  ASSERT_EQ(drape.stages().size(), 3u);
  const DrapeCheck& check = drape.check();
  for (const auto& stage : drape.stages()) EXPECT_LT(stage.energies.back(), stage.energies.front());
  EXPECT_LT(check.tension.most, 0.05);
  EXPECT_EQ(check.depth, 0);
  EXPECT_EQ(check.crossings, 0);
  EXPECT_EQ(drape.fraction(), 1);
}

TEST(Drapes, SlicesOfWorkChangeNoByte) {
  const Laid laid{testing::plainPattern(testing::rectangle(20, 20))};
  Drape whole(laid.problem()), sliced(laid.problem());
  while (whole.advance(1e9)) {
  }
  double before = 0;
  while (sliced.advance(0.05)) {
    EXPECT_GE(sliced.fraction(), before);
    before = sliced.fraction();
  }
  EXPECT_EQ(whole.positions(), sliced.positions());
}

TEST(Drapes, AnotherCutIsSettledFromTheLastOneForLess) {
  SEAMWISE_THOROUGH_ONLY();
  const Laid laid;
  Drape first(laid.problem());
  while (first.advance(1)) {
  }
  DrapeProblem recut = laid.problem();
  for (auto& points : recut.shapes)
    for (Vec2& p : points) p += Vec2(0.2 * std::sin(p.y() / 8), 0.2 * std::sin(p.x() / 9));
  DrapeProblem warm = recut;
  warm.settled = first.positions();
  Drape cold(std::move(recut)), again(std::move(warm));
  while (cold.advance(1)) {
  }
  while (again.advance(1)) {
  }
  EXPECT_EQ(again.stages().size(), 1u);
  EXPECT_LT(again.work(), cold.work());
  EXPECT_EQ(again.check().crossings, 0);
  const double above = again.stages()[0].energies.back() - cold.stages()[2].energies.back();
  EXPECT_LT(above, 1e-3 * 0.16 * kPoplin.density * kGravity);  // less than a lift by 1 mm
}

TEST(Drapes, AFreeEdgeStaysOnItsSideOfTheMiddle) {
  Laid laid{testing::plainPattern(testing::rectangle(20, 20)),
            testing::Sphere{Vec3(0.1, 0, 0), 0.1}};
  DrapeProblem problem = laid.problem();
  // Compressed; its left edge is 3 mm from the middle.
  problem.start = testing::laid(problem.levels.coarse, [](int, const Vec2& at) {
    return Vec3(0.003 + 0.009 * at.x(), 0.102, 0.01 * (at.y() - 10));
  });
  Drape drape(std::move(problem));
  while (drape.advance(1)) {
  }
  double least = 1;
  for (const Vec3& x : drape.positions()) least = std::min(least, x.x());
  EXPECT_GT(least, 0);
}

TEST(Drapes, WhatHasNoStartIsSaid) {
  const Laid laid;
  DrapeProblem problem = laid.problem();
  problem.start[3].x() = std::numeric_limits<double>::quiet_NaN();
  Drape drape(std::move(problem));
  while (drape.advance(1)) {
  }
  ASSERT_EQ(drape.notes().size(), 1u);
  EXPECT_NE(drape.notes()[0].text.find("start"), std::string::npos);
}

TEST(Drapes, AnExhaustedBudgetIsSaid) {
  const Laid laid;
  DrapeProblem problem = laid.problem();
  problem.budget = 0.1;
  Drape drape(std::move(problem));
  while (drape.advance(1)) {
  }
  ASSERT_EQ(drape.notes().size(), 1u);
  EXPECT_NE(drape.notes()[0].text.find("still moving"), std::string::npos);
}

TEST(DrapeChecks, CrossingsAreCountedOnce) {
  const Pattern pattern = testing::plainPattern(testing::rectangle(20, 20));
  const SewnLevel level = testing::levelOf(pattern, 3);
  const SewnMesh mesh = testing::uncut(level, pattern);
  const auto flat = [](int, const Vec2& at) { return Vec3(0.01 * at.x(), 0.01 * at.y(), 0); };
  EXPECT_TRUE(crossingsOf(mesh, testing::laid(level, flat)).empty());
  // rolled into a spiral whose end is pushed through the turn below it
  const auto rolled = [](double growth) {
    return [growth](int, const Vec2& at) {
      const double angle = at.x() / 20 * 3 * kPi, radius = 0.03 + growth * angle;
      return Vec3(radius * std::cos(angle), 0.01 * at.y(), radius * std::sin(angle));
    };
  };
  EXPECT_TRUE(crossingsOf(mesh, testing::laid(level, rolled(0.003))).empty());
  EXPECT_FALSE(crossingsOf(mesh, testing::laid(level,
                                               [](int, const Vec2& at) {
                                                 const double angle = at.x() / 20 * 3 * kPi,
                                                              radius = 0.03 + 0.002 * at.y() / 20;
                                                 return Vec3(
                                                     (radius + 0.004 * std::sin(angle / 2)) *
                                                         std::cos(angle),
                                                     0.01 * at.y(), radius * std::sin(angle));
                                               }))
                   .empty());
}

}  // namespace
}  // namespace seamwise
