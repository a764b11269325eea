#include "drape/pleats.h"

#include <gtest/gtest.h>

#include "drape/drape_samples.h"
#include "drape/pleat_ties.h"
#include "drape/terms.h"
#include "drape/worn_garment.h"

namespace seamwise {
namespace {

constexpr double kWidth = 30, kHeight = 10;

/// A rectangle with a pleat from x = 10 cm to 20 cm.
Garment pleated(FoldKind kind) {
  Garment garment = testing::rectangle(kWidth, kHeight);
  Fold fold;
  fold.kind = kind;
  fold.line = {Vec2(10, 0), Vec2(10, kHeight)}, fold.to = {Vec2(20, 0), Vec2(20, kHeight)};
  garment.panels[0].folds = {fold};
  return garment;
}

std::vector<UprightPleat> uprightPleats(const Garment& garment) {
  const Pattern pattern = testing::plainPattern(garment);
  std::vector<UprightPleat> upright;
  for (const Pleat& pleat : pleatsOf(garment.panels[0], pattern.pieces[0]))
    upright.push_back(*uprightPleat(pleat, [](const Vec2& p) { return p; }));
  return upright;
}

TEST(Pleats, AKnifePleatLiesBehindTheFabricBeforeItsLine) {
  const std::vector<UprightPleat> pleats = uprightPleats(pleated(FoldKind::kKnife));
  const auto closed = [&](double x) { return closedAt(pleats, {x, 5}, 0); };
  EXPECT_DOUBLE_EQ(closed(8).across, 8);
  EXPECT_DOUBLE_EQ(closed(8).layer, 0);
  EXPECT_NEAR(closed(13).across, 7, 1e-9);
  EXPECT_DOUBLE_EQ(closed(13).layer, -1);
  EXPECT_NEAR(closed(17).across, 7, 1e-9);
  EXPECT_DOUBLE_EQ(closed(17).layer, -2);
  EXPECT_NEAR(closed(25).across, 15, 1e-9);
}

TEST(Pleats, OpenPleatsKeepTheLengthOfTheFabric) {
  for (const FoldKind kind : {FoldKind::kKnife, FoldKind::kBox, FoldKind::kInverted}) {
    const std::vector<UprightPleat> pleats = uprightPleats(pleated(kind));
    double walked = 0;
    for (double x = 0; x < kWidth; x += 0.01)
      walked += std::abs(closedAt(pleats, {x + 0.01, 5}, 0.3).across -
                         closedAt(pleats, {x, 5}, 0.3).across);
    EXPECT_NEAR(walked, kWidth, 0.1) << static_cast<int>(kind);
    EXPECT_NEAR(closedAt(pleats, {25, 5}, 0.3).across, 25 - 7, 1e-9);
  }
}

TEST(Pleats, ABoxPleatIsInFrontOfTheFabric) {
  const std::vector<UprightPleat> pleats = uprightPleats(pleated(FoldKind::kBox));
  EXPECT_DOUBLE_EQ(closedAt(pleats, {11.2, 5}, 0).layer, 1);
  EXPECT_DOUBLE_EQ(closedAt(pleats, {15, 5}, 0).layer, 2);
}

TEST(Pleats, AFoldIsPressedAlongItsLinesOnly) {
  const Garment garment = pleated(FoldKind::kKnife);
  const Pattern pattern = testing::plainPattern(garment);
  Outcome<SewnLevel> level = sewnLevel(pattern, 1.5, pleatsOf(garment, pattern));
  ASSERT_TRUE(level.ok());
  const SewnMesh mesh = testing::uncut(level.value(), pattern);
  const Positions flat = testing::laid(
      level.value(), [](int, const Vec2& at) { return Vec3(0.01 * at.x(), 0.01 * at.y(), 0); });
  double pressed = 0;
  for (const SewnMesh::Hinge& hinge : mesh.hinges)
    if (hinge.folded > 0) {
      const double x = flat[hinge.vertices[0]].x();
      EXPECT_TRUE(std::abs(x - 0.1) < 1e-6 || std::abs(x - 0.15) < 5e-3) << x;
      pressed += length(Vec3(flat[hinge.vertices[0]] - flat[hinge.vertices[1]]));
    }
  EXPECT_NEAR(pressed, 2 * 0.01 * kHeight, 1e-3);
}

TEST(Pleats, ThePressedFoldsOfASkirtStartFoldedWithoutCrossings) {
  SolvedGarment solved{testing::readSample("box-pleated-skirt-m"), {}, {}};
  solved.pattern = testing::meshedPattern(solved.garment, true);
  solved.shapes = restShapes(solved.pattern);
  const auto worn = WornGarment::make(std::move(solved), {});
  ASSERT_TRUE(worn.ok()) << worn.error().message;
  const SewnLevel& level = worn.value()->levels().coarse;
  const SewnMesh mesh = testing::uncut(level, worn.value()->garment().pattern);
  const Positions& x = worn.value()->drape().positions();
  EXPECT_TRUE(crossingsOf(mesh, x).empty());
  EXPECT_GT(pleatTies(level, 0.001).size(), 8U);  // the waist holds all layers
}

}  // namespace
}  // namespace seamwise
