#include "drape/half_cloth.h"

#include <gtest/gtest.h>

#include "drape/drape_samples.h"
#include "drape/terms.h"

namespace seamwise {
namespace {

constexpr int kAcross = 7, kUp = 5;  // vertices of a sheet; an odd number of columns

/// A sheet of 12 x 8 cm whose triangles are symmetric about its middle column.
struct Sheet {
  SewnLevel level;
  SewnMesh mesh;
  Sheet() {
    Piece piece;
    const auto number = [](int column, int row) { return row * kAcross + column; };
    for (int row = 0; row < kUp; ++row)
      for (int column = 0; column < kAcross; ++column) {
        piece.rest.push_back({2.0 * (column - kAcross / 2), 2.0 * row});
        level.image.push_back(number(kAcross - 1 - column, row));
      }
    for (int row = 0; row + 1 < kUp; ++row)
      for (int column = 0; column + 1 < kAcross; ++column) {
        const int a = number(column, row), b = a + 1, c = number(column, row + 1), d = c + 1;
        const bool left = column < kAcross / 2;
        piece.triangles.push_back(left ? std::array{a, b, c} : std::array{a, b, d});
        piece.triangles.push_back(left ? std::array{b, d, c} : std::array{a, d, c});
      }
    level.size = kAcross * kUp;
    level.sewn.emplace_back(level.size);
    for (int v = 0; v < level.size; ++v) level.sewn[0][v] = v;
    level.pattern.pieces.push_back(std::move(piece));
    mesh = sewnMesh(level, restShapes(level.pattern), {Vec2(0, 1)});
  }
  /// Symmetric random positions.
  Positions crumpled() const {
    testing::Chance chance;
    Positions x(level.size);
    for (int v = 0; v < level.size; ++v) {
      const Vec2& at = level.pattern.pieces[0].rest[v];
      x[v] = 0.01 * Vec3(at.x(), at.y(), 0) + 0.004 * chance.vector();
      if (level.image[v] == v) x[v].x() = 0;
      if (level.image[v] < v) x[v] = mirrored(x[level.image[v]]);
    }
    return x;
  }
};

TEST(DrapeHalves, ResistHalfOfWhatTheWholeDoes) {
  const Sheet sheet;
  const Positions x = sheet.crumpled();
  const auto half = halved(sheet.mesh, sheet.level.image, x);
  ASSERT_TRUE(half);
  EXPECT_EQ(half->mesh.size, (kAcross / 2 + 1) * kUp);
  EXPECT_EQ(half->whole(half->half(x)), x);
  const Positions y = half->half(x);
  Positions whole_pull(x.size(), Vec3::Zero()), half_pull(y.size(), Vec3::Zero());
  const double stretch = membraneEnergy(sheet.mesh, kPoplin, x, &whole_pull, nullptr);
  const double bend = bendingEnergy(sheet.mesh, kPoplin, x, &whole_pull, nullptr);
  EXPECT_NEAR(2 * membraneEnergy(half->mesh, kPoplin, y, &half_pull, nullptr) / stretch, 1, 1e-12);
  EXPECT_NEAR(2 * bendingEnergy(half->mesh, kPoplin, y, &half_pull, nullptr) / bend, 1, 1e-12);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const bool in_plane = half->inPlane(static_cast<int>(i));
    for (int c = in_plane ? 1 : 0; c < 3; ++c)
      EXPECT_NEAR(whole_pull[half->vertex[i]][c], (in_plane ? 2 : 1) * half_pull[i][c], 1e-9);
  }
}

TEST(DrapeHalves, AreOfSymmetricClothsOnly) {
  const Sheet sheet;
  Positions x = sheet.crumpled();
  EXPECT_FALSE(halved(sheet.mesh, {}, x));
  x[0].y() += 1e-3;
  EXPECT_FALSE(halved(sheet.mesh, sheet.level.image, x));
  // asymmetric cut
  Shapes shapes = restShapes(sheet.level.pattern);
  shapes[0][0].x() -= 0.1;
  const SewnMesh askew = sewnMesh(sheet.level, shapes, {Vec2(0, 1)});
  EXPECT_FALSE(halved(askew, sheet.level.image, sheet.crumpled()));
  // bias cut
  const double c = std::sqrt(0.5);
  const SewnMesh bias = sewnMesh(sheet.level, restShapes(sheet.level.pattern), {Vec2(c, c)});
  EXPECT_FALSE(halved(bias, sheet.level.image, sheet.crumpled()));
}

}  // namespace
}  // namespace seamwise
