#include "symmetry/symmetry.h"

#include <gtest/gtest.h>

#include "support/small_garments.h"

namespace seamwise {
namespace {

using small::mirrored;
using small::moved;
using small::polygon;

Garment garmentOf(std::vector<Panel> panels) {
  Garment g;
  g.panels = std::move(panels);
  return g;
}

// A piece with one mirror axis, x = 0, and curved, concave edges.
Panel bodice(const std::string& name = "bodice") { return small::torso(name, 9); }

BodySymmetry registered(const Garment& g, const SymmetryRequest& request) {
  const auto found = registerSymmetries(g, {request});
  EXPECT_TRUE(found.ok()) << found.error().message;
  return found.ok() ? found.value().at(0) : BodySymmetry{};
}

Error refused(const Garment& g, const std::vector<SymmetryRequest>& requests) {
  const auto found = registerSymmetries(g, requests);
  EXPECT_FALSE(found.ok());
  return found.ok() ? Error{} : found.error();
}

void expectSameMotion(const RigidMotion& got, const RigidMotion& wanted, double tolerance) {
  EXPECT_TRUE(got.mirrored);
  for (const Vec2& p : {Vec2(0, 0), Vec2(50, 0), Vec2(0, 50)})
    EXPECT_LT((got(p) - wanted(p)).norm(), tolerance);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const RigidMotion kAcrossY{0, Vec2::Zero(), true};

TEST(SymmetryAxis, ClickedAFewMillimetresOffIsMovedOntoTheTrueOne) {
  const Garment g = garmentOf({bodice()});
  const BodySymmetry s = registered(g, AxisRequest{"bodice", {0.4, 5}, {-0.3, 60}});
  expectSameMotion(s.map, kAcrossY, 1e-12);
  EXPECT_LT(s.residual, 1e-9);
  EXPECT_TRUE(s.single());
}

TEST(SymmetryAxis, IsExactAndWithoutGlideOnATurnedPiece) {
  const RigidMotion turn{0.7, {13, -8}, false};
  const Garment g = garmentOf({moved(bodice(), turn)});
  const BodySymmetry s = registered(g, AxisRequest{"bodice", turn({0.3, 5}), turn({0, 60})});
  expectSameMotion(s.map, RigidMotion::reflection(turn({0, 0}), turn({0, 1})), 1e-11);
  EXPECT_LT((s.map(s.map({3, 4})) - Vec2(3, 4)).norm(), 1e-12);
  EXPECT_LT(s.residual, 1e-9);
}

TEST(SymmetryAxis, IsReadInTheCoordinatesOfAPanelThatWasTurnedFaceUp) {
  // Face up the axis is x = 10; in the file it is x = -10.
  Panel panel = moved(bodice(), {0, {10, 0}, false});
  panel.mirrored_from_input = true;
  const BodySymmetry s = registered(garmentOf({panel}), AxisRequest{"bodice", {-10, 0}, {-10, 9}});
  expectSameMotion(s.map, {0, {20, 0}, true}, 1e-12);
}

TEST(SymmetryAxis, ThatDoesNotMirrorIsRefusedWithTheResidual) {
  // The axis x = 3 maps the left side x = -25 to x = 31, 6 cm beyond the right one.
  const Error e = refused(garmentOf({bodice()}), {AxisRequest{"bodice", {3, 0}, {3, 50}}});
  EXPECT_EQ(e.code, Failure::kSymmetryDoesNotMirror);
  EXPECT_EQ(e.piece, 0);
  EXPECT_TRUE(contains(e.message, "'bodice'")) << e.message;
  EXPECT_TRUE(contains(e.message, "6.00 cm")) << e.message;
  EXPECT_TRUE(contains(e.message, "0.10 cm")) << e.message;
}

TEST(SymmetryAxis, ChoosesAmongTheMirrorsOfARectangle) {
  const Garment g = garmentOf({polygon("cuff", {{0, 0}, {20, 0}, {20, 6}, {0, 6}})});
  expectSameMotion(registered(g, AxisRequest{"cuff", {10.2, 0}, {10, 6}}).map, {0, {20, 0}, true},
                   1e-12);
  expectSameMotion(registered(g, AxisRequest{"cuff", {0, 3}, {20, 3.3}}).map,
                   RigidMotion::reflection({0, 3}, {1, 3}), 1e-12);
}

TEST(SymmetryAxis, MayHaveAnyDirectionOnARoundPiece) {
  Panel disc;
  disc.name = "pocket";
  disc.edges = {Curve::arc({-5, 0}, {5, 0}, 5, false, true),
                Curve::arc({5, 0}, {-5, 0}, 5, false, true)};
  const BodySymmetry s = registered(garmentOf({disc}), AxisRequest{"pocket", {-4, -3}, {4, 3}});
  EXPECT_LE(s.residual, kMirrorTolerance);
  EXPECT_LT((s.map({4, 3}) - Vec2(4, 3)).norm(), 0.1);
}

TEST(SymmetryAxis, NeedsTwoDifferentPoints) {
  const Error e = refused(garmentOf({bodice()}), {AxisRequest{"bodice", {3, 3}, {3, 3}}});
  EXPECT_EQ(e.code, Failure::kSymmetryMalformed);
}

TEST(SymmetryAxis, IsRefusedWhenAHoleHasNoMirrorImage) {
  Panel panel = bodice();
  const Polyline hole{{5, 10}, {5, 14}, {9, 14}, {9, 10}};
  panel.holes = {polygon("hole", hole).edges};
  const Error e = refused(garmentOf({panel}), {AxisRequest{"bodice", {0, 0}, {0, 9}}});
  EXPECT_EQ(e.code, Failure::kSymmetryDoesNotMirror);
  panel.holes.push_back(mirrored(polygon("hole", hole), "hole").edges);
  EXPECT_TRUE(registerSymmetries(garmentOf({panel}), {AxisRequest{"bodice", {0, 0}, {0, 9}}}).ok());
}

TEST(SymmetryEdges, GiveTheAxisBetweenThem) {
  const RigidMotion turn{-1.2, {4, 30}, false};
  const Garment g = garmentOf({moved(bodice(), turn)});
  const RigidMotion wanted = RigidMotion::reflection(turn({0, 0}), turn({0, 1}));
  for (const auto& [first, second] : {std::pair{1, 7}, {6, 2}, {3, 5}})
    expectSameMotion(registered(g, EdgesRequest{"bodice", first, second}).map, wanted, 1e-11);
}

TEST(SymmetryEdges, OfARectangleChooseBetweenItsTwoAxes) {
  const Garment g = garmentOf({polygon("cuff", {{0, 0}, {20, 0}, {20, 6}, {0, 6}})});
  expectSameMotion(registered(g, EdgesRequest{"cuff", 1, 3}).map, {0, {20, 0}, true}, 1e-12);
  expectSameMotion(registered(g, EdgesRequest{"cuff", 0, 2}).map,
                   RigidMotion::reflection({0, 3}, {1, 3}), 1e-12);
}

TEST(SymmetryEdges, MayBePartsOfEdgesThatAreSplitOnOneSideOnly) {
  // The left side is split at a height of 10 cm; edge 4 is its upper part.
  const Garment g =
      garmentOf({polygon("panel", {{-20, 0}, {20, 0}, {15, 40}, {-15, 40}, {-18.75, 10}})});
  expectSameMotion(registered(g, EdgesRequest{"panel", 1, 3}).map, kAcrossY, 1e-12);
  expectSameMotion(registered(g, EdgesRequest{"panel", 4, 1}).map, kAcrossY, 1e-12);
}

TEST(SymmetryEdges, ThatDoNotMirrorAreRefused) {
  const Error e = refused(garmentOf({bodice()}), {EdgesRequest{"bodice", 1, 3}});
  EXPECT_EQ(e.code, Failure::kSymmetryDoesNotMirror);
  EXPECT_TRUE(contains(e.message, "edges 1 and 3")) << e.message;
  EXPECT_TRUE(contains(e.message, " cm off")) << e.message;
}

TEST(SymmetryEdges, MustBeTwoAndExist) {
  const Garment g = garmentOf({bodice()});
  EXPECT_EQ(refused(g, {EdgesRequest{"bodice", 1, 1}}).code, Failure::kSymmetryMalformed);
  EXPECT_EQ(refused(g, {EdgesRequest{"bodice", -1, 1}}).code, Failure::kSymmetryMalformed);
  const Error e = refused(g, {EdgesRequest{"bodice", 1, 8}});
  EXPECT_EQ(e.code, Failure::kSymmetryMalformed);
  EXPECT_TRUE(contains(e.message, "0 to 7")) << e.message;
}

TEST(SymmetryPiece, HasItsAxisFound) {
  const Garment g = garmentOf({bodice()});
  expectSameMotion(registered(g, PieceRequest{"bodice"}).map, kAcrossY, 1e-12);
}

TEST(SymmetryPiece, WithSeveralAxesGetsTheOneThatCarriesSeamsToSeams) {
  // Both waistbands are rectangles; only the mirror at x = 0 keeps the sewn long edge in place.
  Garment g = small::skirt();
  for (Panel& p : g.panels) p = small::placed(p, Vec3::Zero(), 0);
  expectSameMotion(registered(g, PieceRequest{"band front"}).map, kAcrossY, 1e-12);
}

TEST(SymmetryPiece, WithoutAMirrorIsRefused) {
  const Garment g = garmentOf({small::trouserLeg("leg", 0)});
  const Error e = refused(g, {PieceRequest{"leg"}});
  EXPECT_EQ(e.code, Failure::kSymmetryDoesNotMirror);
  EXPECT_TRUE(contains(e.message, "'leg'")) << e.message;
}

TEST(SymmetryPair, IsExactHoweverThePiecesLie) {
  const RigidMotion turn{2.1, {-70, 12}, false};
  const Panel left = small::sleeve("left", 1.5);
  const Panel right = moved(mirrored(left, "right"), turn);
  const Garment g = garmentOf({left, right});
  const BodySymmetry there = registered(g, PairRequest{"left", "right"});
  EXPECT_EQ(there.pieces[0], 0);
  EXPECT_EQ(there.pieces[1], 1);
  EXPECT_LT(there.residual, 1e-9);
  expectSameMotion(there.map, turn.after(kAcrossY), 1e-11);
  const BodySymmetry back = registered(g, PairRequest{"right", "left"});
  EXPECT_EQ(back.pieces[0], 1);
  expectSameMotion(back.map, there.map.inverse(), 1e-11);
}

TEST(SymmetryPair, OfPiecesThatAreMerelyCongruentIsRefused) {
  // Turned, not mirrored: a left sleeve cut twice.
  const Panel left = small::sleeve("left", 1.5);
  Panel copy = moved(left, {1, {3, 3}, false});
  copy.name = "copy";
  const Error e = refused(garmentOf({left, copy}), {PairRequest{"left", "copy"}});
  EXPECT_EQ(e.code, Failure::kSymmetryDoesNotMirror);
  EXPECT_TRUE(contains(e.message, "'left' and 'copy'")) << e.message;
}

TEST(SymmetryPair, ForgivesAMillimetreOfDraftingErrorAndReportsIt) {
  const Panel left = polygon("left", {{0, 0}, {30, 0}, {24, 40}, {3, 45}});
  const Panel right =
      mirrored(polygon("", {{0.05, 0}, {30, -0.05}, {24, 40.05}, {3, 45}}), "right");
  const BodySymmetry s = registered(garmentOf({left, right}), PairRequest{"left", "right"});
  EXPECT_GT(s.residual, 0.01);
  EXPECT_LE(s.residual, kMirrorTolerance);
}

TEST(SymmetryRequests, NameAPieceThatTheGarmentHas) {
  const Garment g = garmentOf({bodice()});
  for (const SymmetryRequest& r :
       {SymmetryRequest{PieceRequest{"yoke"}}, SymmetryRequest{PairRequest{"bodice", "yoke"}},
        SymmetryRequest{EdgesRequest{"yoke", 0, 1}},
        SymmetryRequest{AxisRequest{"yoke", {0, 0}, {0, 9}}}}) {
    const Error e = refused(g, {r});
    EXPECT_EQ(e.code, Failure::kSymmetryUnknownPiece);
    EXPECT_TRUE(contains(e.message, "'yoke'")) << e.message;
  }
}

TEST(SymmetryRequests, MayNotNameAPieceTwice) {
  const Garment g = garmentOf({bodice("a"), bodice("b")});
  const std::vector<std::vector<SymmetryRequest>> lists = {
      {PieceRequest{"a"}, PieceRequest{"a"}},
      {PieceRequest{"b"}, PairRequest{"a", "b"}},
      {PairRequest{"a", "a"}}};
  for (const auto& requests : lists)
    EXPECT_EQ(refused(g, requests).code, Failure::kSymmetryConflict);
}

TEST(SymmetryRequests, KeepTheirOrder) {
  const Garment g = garmentOf({bodice("a"), bodice("b"), small::sleeve("c", 0)});
  const auto found = registerSymmetries(g, {PieceRequest{"c"}, PairRequest{"b", "a"}});
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found.value()[0].pieces[0], 2);
  EXPECT_EQ(found.value()[1].pieces[0], 1);
  EXPECT_EQ(found.value()[1].pieces[1], 0);
}

}  // namespace
}  // namespace seamwise
