#include "drape/drape.h"

#include <gtest/gtest.h>

#include "drape_samples.h"

namespace seamwise {
namespace {

/// A square of 40 cm on a sphere of 20 cm across.
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
  for (const auto& stage : drape.stages())
    printf("stage %d: %d vertices %d steps %.2f u E %.6f -> %.6f\n", int(stage.stage),
           stage.vertices, stage.steps, stage.work, stage.energies.front(), stage.energies.back());
  const DrapeCheck& check = drape.check();
  printf("tension %.4f %.4f %.4f compression %.4f %.4f %.4f depth %.5f crossings %d notes %zu\n",
         check.tension.median, check.tension.p99, check.tension.most, check.compression.median,
         check.compression.p99, check.compression.most, check.depth, check.crossings,
         drape.notes().size());
  for (const auto& stage : drape.stages()) EXPECT_LT(stage.energies.back(), stage.energies.front());
  EXPECT_LT(check.tension.most, 0.05);
  EXPECT_EQ(check.depth, 0);
  EXPECT_EQ(check.crossings, 0);
  EXPECT_EQ(drape.fraction(), 1);
}

TEST(Drapes, SlicesOfWorkChangeNoByte) {
  const Laid laid;
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

TEST(Drapes, AnExhaustedBudgetIsSaid) {
  const Laid laid;
  DrapeProblem problem = laid.problem();
  problem.budget = 0.1;
  Drape drape(std::move(problem));
  while (drape.advance(1)) {
  }
  ASSERT_EQ(drape.notes().size(), 1u);
  EXPECT_NE(drape.notes()[0].find("still moving"), std::string::npos);
}

TEST(DrapeChecks, CrossingsAreCountedOnce) {
  const Pattern pattern = testing::plainPattern(testing::rectangle(20, 20));
  const SewnLevel level = testing::levelOf(pattern, 3);
  const SewnMesh mesh = testing::uncut(level, pattern);
  const auto flat = [](int, const Vec2& at) { return Vec3(0.01 * at.x(), 0.01 * at.y(), 0); };
  EXPECT_EQ(countCrossings(mesh, testing::laid(level, flat)), 0);
  // rolled to a spiral whose end is pushed through the turn below it
  const auto rolled = [](double growth) {
    return [growth](int, const Vec2& at) {
      const double angle = at.x() / 20 * 3 * kPi, radius = 0.03 + growth * angle;
      return Vec3(radius * std::cos(angle), 0.01 * at.y(), radius * std::sin(angle));
    };
  };
  EXPECT_EQ(countCrossings(mesh, testing::laid(level, rolled(0.003))), 0);
  EXPECT_GT(countCrossings(mesh, testing::laid(level,
                                               [](int, const Vec2& at) {
                                                 const double angle = at.x() / 20 * 3 * kPi,
                                                              radius = 0.03 + 0.002 * at.y() / 20;
                                                 return Vec3(
                                                     (radius + 0.004 * std::sin(angle / 2)) *
                                                         std::cos(angle),
                                                     0.01 * at.y(), radius * std::sin(angle));
                                               })),
            0);
}

}  // namespace
}  // namespace seamwise
