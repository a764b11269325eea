#include "drape/contacts.h"

#include <gtest/gtest.h>

#include "drape/cloth_ties.h"
#include "drape/drape_check.h"
#include "drape/drape_samples.h"
#include "drape/newton_cg.h"

namespace seamwise {
namespace {

constexpr double kGap = 0.002;  // m

/// Two squares of 12 cm, the second one `apart` m over the first, its face upwards as well.
struct TwoSheets {
  Pattern pattern;
  SewnLevel level;
  SewnMesh mesh;
  TwoSheets() {
    Garment garment = testing::rectangle(12, 12);
    garment.panels.push_back(garment.panels[0]);
    garment.panels[1].name = "upper";
    pattern = testing::plainPattern(garment);
    level = testing::levelOf(pattern, 3);
    mesh = testing::uncut(level, pattern);
  }
  Positions apart(double height) const {
    return testing::laid(level, [&](int piece, const Vec2& at) {
      return Vec3(0.01 * at.x() + 0.007 * piece, 0.004 * at.x() / 12 + piece * height,
                  -0.01 * at.y() - 0.004 * piece);
    });
  }
};

TEST(DrapeContacts, PushApartByTheGradientOfAnEnergy) {
  const TwoSheets sheets;
  ClothContacts contacts(sheets.mesh, {{1, 0}}, {}, {}, {}, kGap);
  contacts.setTouching(true);
  Positions x = sheets.apart(-0.001);  // the upper one is below
  contacts.look(x);
  Positions gradient(x.size(), Vec3::Zero()), product = gradient;
  EXPECT_GT(contacts.energy(x, &gradient), 0);
  testing::Chance chance;
  Positions along(x.size());
  for (Vec3& v : along) v = chance.vector();
  const double h = 1e-6;
  Positions before = x, after = x, slope_before = product, slope_after = product;
  addScaled(before, -h, along), addScaled(after, h, along);
  const double fall = contacts.energy(after, &slope_after) - contacts.energy(before, &slope_before);
  EXPECT_NEAR(fall / (2 * h), dot(gradient, along), 1e-4 * std::abs(dot(gradient, along)));
  contacts.addProduct(x, along, product);
  addScaled(slope_after, -1, slope_before);
  const double bend = dot(slope_after, along) / (2 * h);
  EXPECT_NEAR(bend, dot(product, along), 1e-4 * bend);
  // the upper one is pushed up
  EXPECT_LT(gradient[sheets.level.sewn[1].back()].y(), 0);
}

TEST(DrapeContacts, KeepTheSideThatIsSeenFirstWhereNoPieceIsAbove) {
  const TwoSheets sheets;
  for (const double side : {1.0, -1.0}) {
    ClothContacts contacts(sheets.mesh, {}, {}, {}, {}, kGap);
    contacts.setTouching(true);
    contacts.look(sheets.apart(side * 0.004));
    EXPECT_EQ(contacts.energy(sheets.apart(side * 0.004), nullptr), 0);
    for (int k = 0; k < 4; ++k) contacts.look(sheets.apart(-side * 0.001));
    Positions gradient(sheets.mesh.size, Vec3::Zero());
    EXPECT_GT(contacts.energy(sheets.apart(-side * 0.001), &gradient), 0);
    EXPECT_LT(side * gradient[sheets.level.sewn[1].back()].y(), 0);
  }
}

TEST(DrapeContacts, KeepLayersAsTheyWereLaidOrButtoned) {
  const TwoSheets sheets;
  // The second sheet starts 4 mm above the first one; now it has slipped 2 mm below it.
  std::vector<signed char> laps(sheets.mesh.size, -1);
  for (const int v : sheets.level.sewn[1]) laps[v] = 1;
  for (const bool buttoned : {false, true}) {
    ClothContacts contacts(sheets.mesh, {}, {}, buttoned ? laps : std::vector<signed char>{},
                           buttoned ? Positions{} : sheets.apart(0.004), kGap);
    EXPECT_EQ(contacts.hasLayers(), !buttoned);
    contacts.setTouching(true);
    const Positions now = sheets.apart(-0.002);
    contacts.look(now);
    Positions gradient(sheets.mesh.size, Vec3::Zero());
    EXPECT_GT(contacts.energy(now, &gradient), 0);
    EXPECT_LT(gradient[sheets.level.sewn[1].back()].y(), 0);
  }
}

TEST(DrapeContacts, HoldAPatchOnWhatItIsStitchedTo) {
  const TwoSheets sheets;
  const Polyline line{{1, 1}, {11, 1}, {11, 11}, {1, 11}};
  MatchLine match;
  match.piece_a = 1, match.piece_b = 0, match.a = line, match.b = line;
  const std::vector<Overlap> overlaps{{1, 0}};
  const std::vector<ClothTie> ties = heldLayers(sheets.level, {match}, overlaps, kGap).ties;
  ASSERT_EQ(ties.size(), 21u);  // 30 cm, each 1.5 cm
  ClothContacts contacts(sheets.mesh, overlaps, ties, {}, {}, kGap);
  contacts.setTouching(true);
  const testing::Sphere floor(Vec3(0.06, -50, -0.06), 49.98);
  ClothOptions options;
  options.friction = false;
  for (const int v : sheets.level.sewn[0]) {  // the lower sheet does not move
    options.held.resize(sheets.mesh.size, 0);
    options.held[v] = 1;
  }
  ClothSolver solver(sheets.mesh, kPoplin, floor, sheets.apart(0.01), options, &contacts);
  for (int k = 0; k < 20; ++k) solver.newtonStep();
  for (const ClothTie& tie : ties) {
    Vec3 between = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      between += tie.b.weights[k] * solver.positions()[tie.b.vertices[k]];
      between -= tie.a.weights[k] * solver.positions()[tie.a.vertices[k]];
    }
    EXPECT_NEAR(length(between), kGap, 3e-4);
  }
  EXPECT_TRUE(crossingsOf(sheets.mesh, solver.positions()).empty());
}

/// Tilts the second sheet, so that its far side reaches below the first one.
Positions leaning(const TwoSheets& sheets) {
  return testing::laid(sheets.level, [](int piece, const Vec2& at) {
    const double height = piece == 0 ? 0 : 0.006 - 0.001 * at.x();
    return Vec3(0.01 * at.x() + 0.007 * piece, height, -0.01 * at.y() - 0.004 * piece);
  });
}

TEST(DrapeContacts, DrawCrossingSheetsApart) {
  const TwoSheets sheets;
  const testing::Sphere far_away(Vec3(0, -9, 0), 1);
  ClothOptions options;
  options.friction = false;
  for (const bool untangle : {true, false}) {
    ClothContacts contacts(sheets.mesh, {}, {}, {}, {}, kGap);
    contacts.setTouching(true);
    if (untangle) contacts.untangle();
    ClothSolver solver(sheets.mesh, kPoplin, far_away, leaning(sheets), options, &contacts);
    solver.setWeight(false);
    EXPECT_GT(crossingsOf(sheets.mesh, solver.positions()).size(), 10u);
    for (int k = 0; k < 30; ++k) solver.newtonStep();
    EXPECT_EQ(crossingsOf(sheets.mesh, solver.positions()).empty(), untangle);
  }
}

/// Folds a strip onto itself at a line of its mesh, more and more.
TEST(DrapeContacts, KeepASharpFoldOpenBesideIt) {
  const Pattern pattern = testing::plainPattern(testing::rectangle(8, 4));
  const SewnLevel level = testing::levelOf(pattern, 1);
  const SewnMesh mesh = testing::uncut(level, pattern);
  const auto folded = [&](double height) {
    return testing::laid(level, [&](int, const Vec2& at) {
      const double out = at.x() - 4;
      return Vec3(0.01 * std::abs(out), out < 0 ? 0 : height * out, 0.01 * at.y());
    });
  };
  ClothContacts contacts(mesh, {}, {}, {}, {}, kGap);
  contacts.setTouching(true);
  contacts.look(folded(0.003));
  const Positions through = folded(-0.0005);
  for (int k = 0; k < 3; ++k) contacts.look(through);
  Positions gradient(mesh.size, Vec3::Zero());
  EXPECT_GT(contacts.energy(through, &gradient), 0);
  for (int v = 0; v < mesh.size; ++v)
    if (through[v].y() < 0 && through[v].x() < 0.012) EXPECT_LT(gradient[v].y(), 0);
}

}  // namespace
}  // namespace seamwise
