#include <gtest/gtest.h>

#include <cmath>

#include "support/garment_texts.h"

namespace seamwise {
namespace {

using testing::mustRead;
using testing::panelOf;
using testing::twoRectangles;

double lengthOf(const Panel& panel) {
  double length = 0;
  for (const Curve& edge : panel.edges) length += edge.length();
  return length;
}

void expectNear(const Vec2& p, double x, double y) {
  EXPECT_NEAR(p.x(), x, 1e-9);
  EXPECT_NEAR(p.y(), y, 1e-9);
}

/// The rectangles with `curvature` on the front's hem, which runs from (0, 0) to (10, 0).
Curve hemWith(const Json& curvature, const char* coords = "relative") {
  Json document = twoRectangles();
  document["properties"]["curvature_coords"] = coords;
  panelOf(document, "front")["edges"][0]["curvature"] = curvature;
  const GarmentFile file = mustRead(document);
  return file.garment.panels.empty() ? Curve::line({0, 0}, {1, 0})
                                     : file.garment.panels[0].edges[0];
}

TEST(GarmentFile, KeepsPanelsEdgesAndStitchesInTheOrderOfTheFile) {
  const Garment garment = mustRead(twoRectangles()).garment;
  ASSERT_EQ(garment.panels.size(), 2u);
  EXPECT_EQ(garment.panels[0].name, "front");
  EXPECT_EQ(garment.panels[1].name, "back");
  ASSERT_EQ(garment.panels[0].edges.size(), 4u);
  expectNear(garment.panels[0].edges[1].start(), 10, 0);
  expectNear(garment.panels[0].edges[1].end(), 10, 20);
  ASSERT_EQ(garment.stitches.size(), 2u);
  EXPECT_EQ(garment.stitches[1].a, (EdgeRef{0, 3}));
  EXPECT_EQ(garment.stitches[1].b, (EdgeRef{1, 1}));
  EXPECT_FALSE(garment.stitches[1].same_direction);
  EXPECT_NEAR(garment.panels[1].placement_turn.y(), kPi, 1e-12);
  EXPECT_NEAR(garment.panels[1].placement_shift.z(), -20, 1e-12);
}

TEST(GarmentFile, ConvertsEveryLengthFromTheUnitsOfTheFile) {
  Json document = twoRectangles();
  document["properties"]["units_in_meter"] = 300;
  panelOf(document, "front")["edges"][0]["curvature"] = {{"type", "circle"}, {"params", {5, 0, 1}}};
  const Panel panel = mustRead(document).garment.panels[0];
  expectNear(panel.edges[1].end(), 10 / 3.0, 20 / 3.0);
  EXPECT_NEAR(panel.edges[0].length(), kPi * 5 / 3.0,
              1e-9);  // a half circle: the radius scales too
  EXPECT_NEAR(panel.placement_shift.y(), 100 / 3.0, 1e-12);
}

TEST(GarmentFile, ReadsAnOldQuadraticCurveRelativeToItsEdge) {
  expectNear(hemWith({0.5, -0.4}).at(0.5), 5, -2);
}

TEST(GarmentFile, ReadsAQuadraticCurve) {
  expectNear(hemWith({{"type", "quadratic"}, {"params", {{0.5, -0.4}}}}).at(0.5), 5, -2);
}

TEST(GarmentFile, ReadsACubicCurve) {
  expectNear(hemWith({{"type", "cubic"}, {"params", {{0.2, -0.4}, {0.8, -0.4}}}}).at(0.5), 5, -3);
}

TEST(GarmentFile, ReadsControlPointsInPanelCoordinates) {
  expectNear(hemWith({5, -4}, "absolute").at(0.5), 5, -2);
  expectNear(hemWith({{"type", "cubic"}, {"params", {{2, -4}, {8, -4}}}}, "absolute").at(0.5), 5,
             -3);
}

TEST(GarmentFile, ReadsACircleArcCounterClockwiseWhenItTurnsRight) {
  // Counter-clockwise from (0, 0) to (10, 0): the arc bulges downwards, out of the panel.
  const Curve outwards = hemWith({{"type", "circle"}, {"params", {5, 0, 1}}});
  expectNear(outwards.at(0.5), 5, -5);
  const Curve inwards = hemWith({{"type", "circle"}, {"params", {5, false, false}}});
  expectNear(inwards.at(0.5), 5, 5);
}

TEST(GarmentFile, ReadsTheLongerArcWhenAsked) {
  const double radius = 10 / std::sqrt(2.0);
  EXPECT_NEAR(hemWith({{"type", "circle"}, {"params", {radius, 0, 1}}}).length(), radius * kPi / 2,
              1e-8);
  EXPECT_NEAR(hemWith({{"type", "circle"}, {"params", {radius, 1, 1}}}).length(),
              radius * kPi * 1.5, 1e-8);
}

TEST(GarmentFile, TurnsAPanelThatShowsItsBackFaceUpWithItsCurves) {
  Json document = twoRectangles();
  Json& front = panelOf(document, "front");
  front["edges"] = Json::parse(R"([
    {"endpoints": [0, 3]}, {"endpoints": [3, 2]}, {"endpoints": [2, 1]},
    {"endpoints": [1, 0], "curvature": {"type": "circle", "params": [6, 0, 0]}}])");
  front["vertices"][1] = {9, 0};
  front["vertices"][0] = {1, 0};
  const Garment garment = mustRead(document).garment;
  const Panel& panel = garment.panels[0];
  EXPECT_TRUE(panel.mirrored_from_input);
  EXPECT_FALSE(garment.panels[1].mirrored_from_input);
  expectNear(panel.edges[0].start(), -1, 0);
  expectNear(panel.edges[3].start(), -9, 0);
  // The arc runs clockwise from (9, 0) to (1, 0) in the file, so it sags below the hem.
  const double sag = 6 - std::sqrt(36.0 - 16.0);
  expectNear(panel.edges[3].at(0.5), -5, -sag);
  double twice = 0;
  for (const Curve& edge : panel.edges) twice += cross(edge.start(), edge.end());
  EXPECT_GT(twice, 0);
}

TEST(GarmentFile, ReadsDartsAndSeamsOfUnequalLength) {
  Json document = twoRectangles();
  document["pattern"]["stitches"] = Json::parse(R"([
    [{"panel": "front", "edge": 0}, {"panel": "front", "edge": 1}, "right_wrong"],
    [{"panel": "back", "edge": 1}, {"panel": "back", "edge": 3}, null]])");
  const Garment garment = mustRead(document).garment;
  ASSERT_EQ(garment.stitches.size(), 2u);
  EXPECT_TRUE(garment.stitches[0].same_direction);
  EXPECT_EQ(garment.stitches[0].a.piece, garment.stitches[0].b.piece);
  EXPECT_FALSE(garment.stitches[1].same_direction);
}

TEST(GarmentFile, DoesWithoutEverythingThatIsOptionalAndSaysWhatItAssumes) {
  Json document = twoRectangles();
  document.erase("properties");
  document["pattern"].erase("stitches");
  for (const char* name : {"front", "back"})
    for (const char* key : {"translation", "rotation"}) panelOf(document, name).erase(key);
  panelOf(document, "back")["edges"][0]["curvature"] = {0.5, -0.1};
  const GarmentFile file = mustRead(document);
  ASSERT_EQ(file.garment.panels.size(), 2u);
  EXPECT_NEAR(lengthOf(file.garment.panels[0]), 60, 1e-9);
  EXPECT_TRUE(file.garment.stitches.empty());
  ASSERT_EQ(file.notes.size(), 2u);
  EXPECT_NE(file.notes[0].text.find("100 units per metre"), std::string::npos);
  EXPECT_NE(file.notes[1].text.find("relative"), std::string::npos);
}

TEST(GarmentFile, AssumesNothingWhenTheFileSaysAll) {
  EXPECT_TRUE(mustRead(twoRectangles()).notes.empty());
}

TEST(GarmentFile, ReadsALensOfTwoCurves) {
  Json document = twoRectangles();
  panelOf(document, "front")["edges"] = Json::parse(R"([
    {"endpoints": [0, 1], "curvature": [0.5, -0.5]}, {"endpoints": [1, 0], "curvature": [0.5, -0.5]}])");
  document["pattern"].erase("stitches");
  EXPECT_EQ(mustRead(document).garment.panels[0].edges.size(), 2u);
}

TEST(GarmentFile, JoinsCornersThatAreStoredTwice) {
  Json document = twoRectangles();
  Json& front = panelOf(document, "front");
  front["vertices"].push_back({10, 1e-9});
  front["edges"][1]["endpoints"] = {4, 2};
  const Panel panel = mustRead(document).garment.panels[0];
  EXPECT_EQ(panel.edges[0].end(), panel.edges[1].start());
}

TEST(GarmentFile, ReadsGrainHolesSeamsAndMatchesOfItsOwnFormat) {
  Json document = twoRectangles();
  document["format"] = "seamwise-garment/1";
  Json& front = panelOf(document, "front");
  for (const Json& p : {Json{4, 4}, Json{6, 4}, Json{6, 6}}) front["vertices"].push_back(p);
  front["holes"] =
      Json::parse(R"([[{"endpoints": [4, 5]}, {"endpoints": [5, 6]}, {"endpoints": [6, 4]}]])");
  front["grain"] = {{"line", {{0, 0}, {3, 3}}}, {"lock", "on"}, {"toleranceDeg", 90}};
  front["notches"] = {{{"edge", 1}, {"at", 0.25}}};
  document["seams"] = Json::parse(
      R"([{"stitch": 1, "name": "side", "weight": 0.5, "matched": false, "direction": "opposite"}])");
  document["matches"] = Json::parse(
      R"([{"a": {"piece": "front", "line": [[1, 0], [1, 10]]}, "b": {"piece": "back", "line": [[2, 0], [2, 5.5]]}}])");
  const GarmentFile file = mustRead(document);
  const Panel& panel = file.garment.panels[0];
  EXPECT_NEAR(panel.grain_angle, kPi / 4, 1e-12);
  EXPECT_TRUE(panel.grain_stated);
  EXPECT_EQ(panel.grain_lock, GrainLock::kOn);
  EXPECT_NEAR(panel.grain_tolerance, kPi / 2, 1e-12);
  ASSERT_EQ(panel.holes.size(), 1u);
  double twice = 0;  // listed counter-clockwise, stored clockwise
  for (const Curve& edge : panel.holes[0]) twice += cross(edge.start(), edge.end());
  EXPECT_NEAR(twice, -4, 1e-9);
  EXPECT_EQ(file.garment.stitches[1].weight, 0.5);
  EXPECT_FALSE(file.garment.stitches[1].matched);
  EXPECT_TRUE(file.garment.stitches[0].matched);
  ASSERT_EQ(file.garment.matches.size(), 1u);
  const MatchLine& match = file.garment.matches[0];
  ASSERT_EQ(match.a.size(), 11u);
  ASSERT_EQ(match.b.size(), 11u);
  expectNear(match.a[3], 1, 3);
  expectNear(match.b[10], 2, 5.5);
}

TEST(GarmentFile, TurnsTheGrainLineAndMarkedLinesWithTheirPanel) {
  Json document = twoRectangles();
  Json& front = panelOf(document, "front");
  front["edges"] = Json::parse(
      R"([{"endpoints": [0, 3]}, {"endpoints": [3, 2]}, {"endpoints": [2, 1]}, {"endpoints": [1, 0]}])");
  front["grain"] = {{"line", {{0, 0}, {3, 3}}}};
  document["matches"] = Json::parse(
      R"([{"a": {"piece": "front", "line": [[1, 0], [1, 10]]}, "b": {"piece": "back", "line": [[2, 0], [2, 10]]}}])");
  const Garment garment = mustRead(document).garment;
  EXPECT_NEAR(garment.panels[0].grain_angle, 3 * kPi / 4, 1e-12);
  expectNear(garment.matches[0].a[0], -1, 0);
  expectNear(garment.matches[0].b[0], 2, 0);
}

TEST(GarmentFile, NotesALengthRatioThatIsNotTheDraftedOne) {
  Json document = twoRectangles();
  document["seams"] = Json::parse(R"([{"stitch": 0, "lengthRatio": 1.5}])");
  const GarmentFile file = mustRead(document);
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_NE(file.notes[0].text.find("1.5"), std::string::npos);
  EXPECT_STREQ(file.notes[0].code, "lengthRatio");
  EXPECT_EQ(file.notes[0].numbers.front(), 1.5);
}

}  // namespace
}  // namespace seamwise
