#include "drape/closed_bands.h"

#include <gtest/gtest.h>

#include "drape/drape_samples.h"

namespace seamwise {
namespace {

/// A sleeve of 24 x 30 cm, closed down to `slit` cm above its hem, and a cuff, longer by `lap` cm.
Garment sleeveWithCuff(double slit, double lap) {
  Garment garment;
  Polyline cuff{{0, 0}, {24 + lap, 0}, {24 + lap, 6}, {24, 6}, {0, 6}};
  if (lap == 0) cuff.erase(cuff.begin() + 3);
  garment.panels = {small::polygon("cuff", cuff)};
  if (slit > 0) {
    garment.panels.push_back(
        small::polygon("sleeve", {{0, 0}, {24, 0}, {24, slit}, {24, 30}, {0, 30}, {0, slit}}));
    small::sew(garment, "sleeve", 2, "sleeve", 4);
  } else {
    garment.panels.push_back(small::polygon("sleeve", {{0, 0}, {24, 0}, {24, 30}, {0, 30}}));
    small::sew(garment, "sleeve", 1, "sleeve", 3);
  }
  small::sew(garment, "sleeve", 0, "cuff", lap > 0 ? 3 : 2);
  return garment;
}

TEST(ClosedBands, JoinTheEndsOfACuff) {
  Pattern pattern = testing::plainPattern(sleeveWithCuff(0, 0));
  closeBands(&pattern);
  ASSERT_EQ(pattern.seams.size(), 3u);
  const Seam& closed = pattern.seams.back();
  EXPECT_EQ(closed.a.piece, 0);
  EXPECT_EQ(closed.b.piece, 0);
  EXPECT_FALSE(closed.matched);
  ASSERT_EQ(closed.a.vertices.size(), closed.b.vertices.size());
  const std::vector<Vec2>& rest = pattern.pieces[0].rest;
  for (std::size_t k = 0; k < closed.a.vertices.size(); ++k) {
    const Vec2 a = rest[closed.a.vertices[k]], b = rest[closed.b.vertices[k]];
    EXPECT_NEAR(std::abs(a.x() - b.x()), 24, 1e-9);
    EXPECT_NEAR(a.y(), b.y(), 1e-9);
  }
}

TEST(ClosedBands, LeaveSlitsAndLapsOpen) {
  for (const auto& [slit, lap] : {std::pair(8.0, 0.0), {0.0, 2.0}}) {
    Pattern pattern = testing::plainPattern(sleeveWithCuff(slit, lap));
    const std::size_t before = pattern.seams.size();
    closeBands(&pattern);
    EXPECT_EQ(pattern.seams.size(), before) << slit << " " << lap;
  }
}

}  // namespace
}  // namespace seamwise
