#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "support/small_garments.h"
#include "symmetry/symmetry.h"

namespace seamwise {
namespace {

using small::mirrored;
using small::moved;
using small::polygon;
using small::sew;

using Names = std::set<std::string>;

// "front" for a piece symmetric in itself, "left = right" for a pair, names in alphabetical order.
Names detected(const Garment& g) {
  Names names;
  for (const BodySymmetry& s : detectSymmetries(g)) {
    EXPECT_TRUE(s.map.mirrored);
    EXPECT_LE(s.residual, kMirrorTolerance);
    if (s.single()) {
      EXPECT_LT((s.map(s.map({1, 2})) - Vec2(1, 2)).norm(), 1e-12);
    }
    const std::string &a = g.panels[s.pieces[0]].name, &b = g.panels[s.pieces[1]].name;
    names.insert(s.single() ? a : std::min(a, b) + " = " + std::max(a, b));
  }
  return names;
}

Garment unplaced(Garment g) {
  for (Panel& p : g.panels) p = small::placed(p, Vec3::Zero(), 0);
  return g;
}

const Names kTee{"front", "back", "left sleeve = right sleeve"};
const Names kSkirt{"front", "back", "band front", "band back"};
const Names kTrousers{"front left = front right", "back left = back right"};

TEST(DetectedSymmetries, OfATeeAreItsBodyAndAPairOfSleeves) {
  EXPECT_EQ(detected(small::tee(1.5)), kTee);
  EXPECT_EQ(detected(unplaced(small::tee(1.5))), kTee);
}

TEST(DetectedSymmetries, PairSleevesThatAreAlsoSymmetricInThemselves) {
  EXPECT_EQ(detected(small::tee(0)), kTee);
  EXPECT_EQ(detected(unplaced(small::tee(0))), kTee);
}

TEST(DetectedSymmetries, OfATeeAreExact) {
  for (const BodySymmetry& s : detectSymmetries(small::tee(1.5))) {
    EXPECT_LT(s.residual, 1e-9);
    EXPECT_LT(std::abs(s.map.angle), 1e-12);
    EXPECT_LT(s.map.shift.norm(), 1e-12);
  }
}

TEST(DetectedSymmetries, OfASkirtWithEqualFrontAndBackFollowThePlacement) {
  EXPECT_EQ(detected(small::skirt()), kSkirt);
  // The same pieces and seams, placed sideways: now front and back are the left and the right half.
  Garment g = small::skirt();
  const Vec3 left(15, 0, 0), up(0, 50, 0);
  for (int k = 0; k < 4; ++k)
    g.panels[k] = small::placed(g.panels[k], (k % 2 ? -left : left) + (k < 2 ? 0 : 1) * up,
                                k % 2 ? -kPi / 2 : kPi / 2);
  EXPECT_EQ(detected(g), (Names{"back = front", "band back = band front"}));
}

TEST(DetectedSymmetries, OfARectangleKeepItsSewnEdgeInPlace) {
  for (const BodySymmetry& s : detectSymmetries(unplaced(small::skirt()))) {
    EXPECT_LT(std::abs(s.map.angle), 1e-12);  // never across the horizontal axis
  }
}

TEST(DetectedSymmetries, ReadThePlacementOfPanelsThatWereTurnedFaceUp) {
  // The file shows the back piece from inside: its x is that of the body, and its placement is
  // unturned.
  Garment g = small::skirt();
  for (const int k : {1, 3}) {
    g.panels[k].mirrored_from_input = true;
    g.panels[k].placement_turn = Vec3::Zero();
  }
  EXPECT_EQ(detected(g), kSkirt);
}

TEST(DetectedSymmetries, OfTrousersAreTwoPairs) {
  EXPECT_EQ(detected(small::trousers(true)), kTrousers);
}

TEST(DetectedSymmetries, PairPartsOfAGarmentThatAreNotSewnToEachOther) {
  EXPECT_EQ(detected(small::trousers(false)), kTrousers);
}

TEST(DetectedSymmetries, OfAPatchworkOfOddPiecesAreNone) {
  Garment g;
  g.panels = {polygon("a", {{0, 0}, {30, 0}, {24, 20}, {2, 26}}),
              polygon("b", {{0, 0}, {24, 3}, {31, 20}, {-4, 15}}),
              polygon("c", {{0, 0}, {19, -4}, {23, 14}})};
  sew(g, "a", 0, "b", 1);
  sew(g, "b", 2, "c", 0);
  EXPECT_TRUE(detected(g).empty());
}

TEST(DetectedSymmetries, LeaveOnlyTheOddPiecesFree) {
  Garment g = small::tee(1.5);
  const int right = g.find("right sleeve");
  const Vec3 shift = g.panels[right].placement_shift, turn = g.panels[right].placement_turn;
  g.panels[right] = mirrored(small::sleeve("", 4), "right sleeve");
  g.panels[right].placement_shift = shift;
  g.panels[right].placement_turn = turn;
  EXPECT_EQ(detected(g), (Names{"front", "back"}));
}

TEST(DetectedSymmetries, NeedNeighboursToMapToNeighbours) {
  // Two equal, symmetric pieces, one sewn to a left part and one to a right part. Their asymmetric
  // neighbours allow only the pair, regardless of the pieces' own symmetries.
  const Polyline odd{{0, 0}, {12, 0}, {15, 9}, {3, 14}};
  const Polyline block{{-10, 0}, {10, 0}, {10, 30}, {-10, 30}};
  Garment g;
  g.panels = {polygon("p", block), polygon("q", block), polygon("left", odd),
              mirrored(polygon("", odd), "right")};
  sew(g, "p", 1, "left", 0);
  sew(g, "q", 3, "right", 0);
  sew(g, "p", 2, "q", 2);
  EXPECT_EQ(detected(g), (Names{"left = right", "p = q"}));
}

TEST(DetectedSymmetries, RespectTheSewingDirection) {
  // A tube of two equal symmetric pieces. With one seam sewn the wrong way round, the mirror across
  // the middle of both pieces sews it differently; only the mirror that swaps the pieces keeps both
  // seams.
  Garment g = unplaced(small::skirt());
  g.panels.resize(2);
  g.stitches.resize(2);
  EXPECT_EQ(detected(g), (Names{"front", "back"}));
  g.stitches[1].same_direction = true;
  EXPECT_EQ(detected(g), (Names{"back = front"}));
}

TEST(DetectedSymmetries, AllowAnEdgeThatIsSplitOnOneSideOnly) {
  // The front's left side is split at half height, and so is the back's edge sewn to it.
  Garment g;
  g.panels = {polygon("front", {{-30, 0}, {30, 0}, {15, 50}, {-15, 50}, {-22.5, 25}}),
              polygon("back", {{-30, 0}, {30, 0}, {22.5, 25}, {15, 50}, {-15, 50}})};
  sew(g, "front", 1, "back", 4);
  sew(g, "front", 3, "back", 2);
  sew(g, "front", 4, "back", 1);
  EXPECT_EQ(detected(g), (Names{"front", "back"}));
}

TEST(DetectedSymmetries, OfUnsewnPiecesAreThoseOfTheirShapes) {
  Garment g;
  g.panels = {small::torso("yoke", 5), small::sleeve("one", 2)};
  g.panels.push_back(mirrored(g.panels[1], "two"));
  g.panels.push_back(polygon("facing", {{0, 0}, {30, 0}, {24, 20}, {2, 26}}));
  EXPECT_EQ(detected(g), (Names{"yoke", "one = two"}));
}

TEST(DetectedSymmetries, MatchEqualLoosePiecesAcrossTheBody) {
  Garment g;
  const Polyline flap{{0, 0}, {12, 0}, {14, 5}, {0, 6}};
  const double x[4] = {-20, 8, 20, -8};
  for (int k = 0; k < 4; ++k) {
    Panel p = polygon("", flap);
    if (x[k] > 0) p = mirrored(p, "");
    p.name = std::string(1, static_cast<char>('a' + k));
    g.panels.push_back(small::placed(p, {x[k], 0, 0}, 0));
  }
  EXPECT_EQ(detected(g), (Names{"a = c", "b = d"}));
}

TEST(DetectedSymmetries, DoNotDependOnTheOrderOrTheNamesOfThePieces) {
  for (const Garment& g : {small::tee(0), small::skirt(), small::trousers(true)}) {
    const Names wanted = detected(g);
    const int n = static_cast<int>(g.panels.size());
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    while (std::next_permutation(order.begin(), order.end())) {
      Garment shuffled = g;
      for (int k = 0; k < n; ++k) shuffled.panels[order[k]] = g.panels[k];
      for (Stitch& s : shuffled.stitches) {
        s.a.piece = order[s.a.piece];
        s.b.piece = order[s.b.piece];
        std::swap(s.a, s.b);
      }
      std::reverse(shuffled.stitches.begin(), shuffled.stitches.end());
      EXPECT_EQ(detected(shuffled), wanted);
    }
  }
}

TEST(DetectedSymmetries, DoNotDependOnHowThePiecesLieOnTheTable) {
  for (const Garment& g : {small::tee(1.5), small::trousers(true)}) {
    Garment turned = unplaced(g);
    for (std::size_t k = 0; k < g.panels.size(); ++k)
      turned.panels[k] = moved(turned.panels[k], {0.9 * k + 0.4, Vec2(17.0 * k, -5), false});
    EXPECT_EQ(detected(turned), detected(g));
    for (const BodySymmetry& s : detectSymmetries(turned)) EXPECT_LT(s.residual, 1e-9);
  }
}

TEST(DetectedSymmetries, OfNothingAreNone) { EXPECT_TRUE(detectSymmetries(Garment{}).empty()); }

}  // namespace
}  // namespace seamwise
