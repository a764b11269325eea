#include <gtest/gtest.h>

#include "support/garment_texts.h"

namespace seamwise {
namespace {

using testing::expectRefused;
using testing::mustRead;
using testing::panelOf;
using testing::twoRectangles;

Json edited(void (*edit)(Json& garment, Json& front)) {
  Json document = twoRectangles();
  edit(document, panelOf(document, "front"));
  return document;
}

TEST(BrokenGarment, WithoutAPatternIsNoGarment) {
  expectRefused(std::string("[]"), Failure::kNotAGarment, {"no JSON object"});
  expectRefused(std::string("{}"), Failure::kNotAGarment, {"'panels'"});
  expectRefused(std::string(R"({"pattern": 3})"), Failure::kNotAGarment, {"'panels'"});
}

TEST(BrokenGarment, OfAnotherKindOfFileIsNamed) {
  expectRefused(std::string(R"({"format": "seamwise-print/1", "group": "p1"})"),
                Failure::kNotAGarment, {"'seamwise-print/1'"});
}

TEST(BrokenGarment, WithPanelsInAListIsNoGarment) {
  expectRefused(std::string(R"({"pattern": {"panels": []}})"), Failure::kNotAGarment,
                {"no object"});
}

TEST(BrokenGarment, WithoutPanelsSaysSo) {
  expectRefused(std::string(R"({"pattern": {"panels": {}}})"), Failure::kNoPanels, {"no panels"});
}

TEST(BrokenGarment, WithThousandsOfPanelsIsTooLarge) {
  Json document = twoRectangles();
  const Json panel = panelOf(document, "front");
  Json::object_t panels;
  for (int i = 0; i < 2001; ++i) panels.emplace_back("p" + std::to_string(i), panel);
  document["pattern"]["panels"] = panels;
  expectRefused(document, Failure::kTooLarge, {"2000 panels"});
}

TEST(BrokenGarment, WithTwoPanelsOfOneNameNamesIt) {
  std::string text = twoRectangles().dump();
  text.replace(text.find("\"back\":"), 7, "\"front\":");
  expectRefused(text, Failure::kNotAGarment, {"two entries named 'front'", "in 'panels'"});
}

TEST(BrokenGarment, WithAPanelThatIsNoObjectNamesIt) {
  expectRefused(edited([](Json&, Json& front) { front = 7; }), Failure::kNotAGarment,
                {"panel 'front'", "the number 7"});
}

TEST(BrokenGarment, WithoutVerticesOrEdgesNamesThePanel) {
  expectRefused(edited([](Json&, Json& front) { front.erase("vertices"); }), Failure::kNotAGarment,
                {"panel 'front'", "'vertices'"});
  expectRefused(edited([](Json&, Json& front) { front.erase("edges"); }), Failure::kNotAGarment,
                {"panel 'front'", "'edges'"});
}

TEST(BrokenGarment, WithOneEdgeHasNoOutline) {
  expectRefused(edited([](Json&, Json& front) {
                  front["edges"] = {{{"endpoints", {0, 1}}}};
                }),
                Failure::kOutlineOpen, {"panel 'front'", "at least two"});
}

TEST(BrokenGarment, WithAnOpenOutlineNamesTheEdgesAndTheGap) {
  expectRefused(edited([](Json&, Json& front) {
                  front["edges"][2]["endpoints"] = {3, 0};
                }),
                Failure::kOutlineOpen, {"panel 'front'", "edge 2", "edge 1", "10 cm"});
}

TEST(BrokenGarment, WhoseOutlineCrossesItselfSaysWhere) {
  // The right side runs up to the left corner and back: a bow tie around (5, 10).
  expectRefused(edited([](Json&, Json& front) {
                  front["vertices"][2] = {0, 20};
                  front["vertices"][3] = {10, 20};
                }),
                Failure::kOutlineSelfIntersects,
                {"panel 'front'", "(5.0, 10.0) cm", "edge 1", "edge 3"});
}

TEST(BrokenGarment, WhoseCurveCrossesTheOppositeEdgeSaysWhere) {
  expectRefused(edited([](Json&, Json& front) {
                  front["edges"][0]["curvature"] = {0.5, 4.5};
                }),
                Failure::kOutlineSelfIntersects, {"panel 'front'", "edge 0", "edge 2", "20.0) cm"});
}

TEST(BrokenGarment, WithoutAreaSaysSo) {
  expectRefused(edited([](Json&, Json& front) {
                  front["vertices"] = {{0, 0}, {10, 10}, {20, 20}, {5, 5}};
                }),
                Failure::kOutlineSelfIntersects, {"panel 'front'", "no area"});
}

TEST(BrokenGarment, WithAnEndpointOutOfRangeNamesIt) {
  expectRefused(edited([](Json&, Json& front) {
                  front["edges"][1]["endpoints"] = {1, 9};
                }),
                Failure::kEdgeIndex, {"panel 'front', edge 1", "vertex 9"});
  expectRefused(edited([](Json&, Json& front) {
                  front["edges"][1]["endpoints"] = {-1, 2};
                }),
                Failure::kEdgeIndex, {"panel 'front', edge 1", "vertex -1"});
  expectRefused(edited([](Json&, Json& front) { front["edges"][1].erase("endpoints"); }),
                Failure::kEdgeIndex, {"panel 'front', edge 1", "'endpoints'"});
  expectRefused(edited([](Json&, Json& front) {
                  front["edges"][1]["endpoints"] = {0.5, 2};
                }),
                Failure::kNumber, {"panel 'front', edge 1", "0.5"});
}

TEST(BrokenGarment, WithAnEdgeOfNoLengthNamesIt) {
  expectRefused(edited([](Json&, Json& front) {
                  front["vertices"][1] = {0, 0.0005};
                }),
                Failure::kEdgeZeroLength, {"panel 'front', edge 0", "0.001 cm"});
  expectRefused(edited([](Json&, Json& front) {
                  front["edges"].insert(front["edges"].begin() + 1,
                                        Json::parse(R"({"endpoints": [1, 1]})"));
                }),
                Failure::kEdgeZeroLength, {"panel 'front', edge 1"});
}

TEST(BrokenGarment, WithTextForANumberShowsIt) {
  expectRefused(edited([](Json&, Json& front) {
                  front["vertices"][2] = {"10", 20};
                }),
                Failure::kNumber, {"panel 'front'", "the text '10'", "vertex 2"});
  expectRefused(edited([](Json&, Json& front) {
                  front["vertices"][2] = {1, 2, 3};
                }),
                Failure::kNumber, {"panel 'front'", "vertex 2", "two numbers"});
  expectRefused(edited([](Json&, Json& front) {
                  front["translation"] = {0, "x", 0};
                }),
                Failure::kNumber, {"panel 'front'", "'translation'", "the text 'x'"});
  expectRefused(edited([](Json&, Json& front) {
                  front["rotation"] = {0, 0};
                }),
                Failure::kNumber, {"panel 'front'", "'rotation'"});
}

TEST(BrokenGarment, BeyondAHundredMetresIsRefused) {
  expectRefused(edited([](Json&, Json& front) {
                  for (Json& v : front["vertices"]) v[0] = v[0].get<double>() + 2e4;
                }),
                Failure::kNumber, {"panel 'front'", "vertex 0", "10000 cm"});
}

TEST(BrokenGarment, WithUnusableUnitsSaysWhatTheyMean) {
  for (const Json& units : {Json(0), Json(-100), Json("cm"), Json(true), Json(1e-300)}) {
    Json document = twoRectangles();
    document["properties"]["units_in_meter"] = units;
    expectRefused(document, Failure::kUnits, {"units_in_meter"});
  }
}

TEST(BrokenGarment, ForGiantsOrAntsSuggestsTheUnits) {
  Json giant = twoRectangles();
  giant.erase("properties");
  for (Json& panel : giant["pattern"]["panels"])
    for (Json& v : panel["vertices"]) v = {v[0].get<double>() * 60, v[1].get<double>() * 60};
  expectRefused(giant, Failure::kUnits, {"1200 cm", "1000 (mm)", "states none"});

  Json ant = twoRectangles();
  ant["properties"]["units_in_meter"] = 3000;
  expectRefused(ant, Failure::kUnits, {"0.666667 cm", "3000"});
}

TEST(BrokenGarment, WithOneVertexFarAwayNamesItsPanel) {
  for (const double far : {1e4, 1e6, 1e299, 1e308}) {
    Json document = twoRectangles();
    document["pattern"]["panels"]["front"]["vertices"][1][0] = far;
    expectRefused(document, Failure::kUnits, {"'front'", "correct its vertices"});
  }
}

TEST(BrokenGarment, WithMalformedCurvatureNamesTheEdge) {
  const auto refuse = [](const char* curvature, std::initializer_list<const char*> words) {
    Json document = twoRectangles();
    panelOf(document, "front")["edges"][0]["curvature"] = Json::parse(curvature);
    expectRefused(document, Failure::kCurvature, {"panel 'front', edge 0"});
    expectRefused(document, Failure::kCurvature, words);
  };
  refuse(R"({"type": "spiral", "params": []})", {"'spiral'", "quadratic, cubic, circle"});
  refuse(R"({"type": "quadratic", "params": []})", {"0 params", "needs 1"});
  refuse(R"({"type": "cubic", "params": [[0.5, 0.5]]})", {"1 params", "needs 2"});
  refuse(R"({"type": "circle", "params": [5, 0]})", {"2 params", "needs 3"});
  refuse(R"({"type": "circle", "params": [0, 0, 1]})", {"radius 0 cm"});
  refuse(R"({"type": "circle", "params": [-3, 0, 1]})", {"radius -3 cm"});
  refuse(R"({"type": "circle", "params": ["big", 0, 1]})", {"the text 'big'"});
  refuse(R"([0.5])", {"a control point"});
  refuse(R"([0.5, 1e9])", {"more than 100 m away"});
  refuse(R"("round")", {"malformed 'curvature'"});
  refuse(R"({"params": [[0.5, 0.5]]})", {"malformed 'curvature'"});
}

TEST(BrokenGarment, WithUnknownCurveCoordinatesSaysWhichAreKnown) {
  expectRefused(edited([](Json& g, Json&) { g["properties"]["curvature_coords"] = "polar"; }),
                Failure::kCurvature, {"'polar'", "relative or absolute"});
}

TEST(BrokenGarment, ThatSewsAMissingPanelNamesTheStitch) {
  expectRefused(edited([](Json& g, Json&) { g["pattern"]["stitches"][1][0]["panel"] = "frnt"; }),
                Failure::kSeamUnknownPiece, {"stitch 1", "'frnt'"});
}

TEST(BrokenGarment, ThatSewsAMissingEdgeNamesTheStitch) {
  expectRefused(edited([](Json& g, Json&) { g["pattern"]["stitches"][1][0]["edge"] = 4; }),
                Failure::kSeamUnknownEdge, {"stitch 1", "edge 4", "'front'", "0 to 3"});
}

TEST(BrokenGarment, ThatSewsAnEdgeTwiceNamesBothStitches) {
  const Json document = edited([](Json& g, Json&) { g["pattern"]["stitches"][1][0]["edge"] = 1; });
  expectRefused(document, Failure::kSeamEdgeTwice,
                {"stitch 1", "edge 1 of panel 'front'", "stitch 0"});
  const Outcome<GarmentFile> file = readGarment(document.dump(), "shirt.json");
  EXPECT_EQ(file.error().seam, 1);
  EXPECT_EQ(file.error().piece, 0);
}

TEST(BrokenGarment, ThatSewsAnEdgeToItselfSaysSo) {
  expectRefused(edited([](Json& g, Json&) {
                  g["pattern"]["stitches"][1][1] = g["pattern"]["stitches"][1][0];
                }),
                Failure::kSeamEdgeTwice, {"stitch 1", "to itself"});
}

TEST(BrokenGarment, WithAMalformedStitchNamesIt) {
  const auto stitch = [](const char* text) {
    Json document = twoRectangles();
    document["pattern"]["stitches"][0] = Json::parse(text);
    return document;
  };
  expectRefused(stitch("3"), Failure::kSeamMalformed, {"stitch 0", "two sides"});
  expectRefused(stitch(R"([{"panel": "front"}, {"panel": "back", "edge": 1}])"),
                Failure::kSeamMalformed, {"stitch 0", "malformed side"});
  expectRefused(
      stitch(R"([{"panel": "front", "edge": 0}, {"panel": "back", "edge": 0}, "twisted"])"),
      Failure::kSeamMalformed, {"stitch 0", "right_wrong"});
}

TEST(BrokenGarment, WithAHoleOutsideItsOutlineNamesIt) {
  const auto with_hole = [](double x) {
    Json document = twoRectangles();
    Json& front = panelOf(document, "front");
    for (const Json& p : {Json{x, 4}, Json{x + 2, 4}, Json{x, 6}}) front["vertices"].push_back(p);
    front["holes"] =
        Json::parse(R"([[{"endpoints": [4, 5]}, {"endpoints": [5, 6]}, {"endpoints": [6, 4]}]])");
    return document;
  };
  EXPECT_EQ(mustRead(with_hole(4)).garment.panels[0].holes.size(), 1u);
  expectRefused(with_hole(30), Failure::kOutlineSelfIntersects,
                {"panel 'front', hole 0", "outside"});
  expectRefused(with_hole(9), Failure::kOutlineSelfIntersects,
                {"panel 'front', hole 0", "crosses"});
}

TEST(BrokenGarment, WithUnusableExtrasNamesThem) {
  expectRefused(edited([](Json&, Json& front) {
                  front["grain"] = {{"lock", "diagonal"}};
                }),
                Failure::kNotAGarment,
                {"panel 'front', grain", "'diagonal'", "free, on, across or bias"});
  expectRefused(edited([](Json&, Json& front) {
                  front["notches"] = {{{"edge", 4}, {"at", 0.5}}};
                }),
                Failure::kEdgeIndex, {"panel 'front', notch 0", "edge 4"});
  expectRefused(edited([](Json& g, Json&) {
                  g["seams"] = {{{"stitch", 2}}};
                }),
                Failure::kSeamMalformed, {"seam 0", "stitch 2"});
  expectRefused(edited([](Json& g, Json&) {
                  g["seams"] = {{{"stitch", 0}, {"direction", "same"}}};
                }),
                Failure::kSeamMalformed, {"seam 0", "'opposite'", "right_wrong"});
  expectRefused(edited([](Json& g, Json&) {
                  g["symmetries"] = {{{"kind", "pair"}}};
                }),
                Failure::kSymmetryMalformed, {"symmetry 0", "'pieces'"});
}

TEST(BrokenGarment, OfANewerFormatAsksForAnUpdate) {
  expectRefused(edited([](Json& g, Json&) { g["format"] = "seamwise-garment/2"; }),
                Failure::kNotAGarment, {"'seamwise-garment/2'", "update the program"});
}

TEST(BrokenGarment, WithAnAllowanceThatCannotBeCutNamesTheEdge) {
  const auto refused = [](const Json& allowance, Failure code,
                          std::initializer_list<const char*> words) {
    Json document = twoRectangles();
    panelOf(document, "front")["edges"][2]["allowance"] = allowance;
    expectRefused(document, code, words);
  };
  refused(-1, Failure::kNumber, {"panel 'front', edge 2", "-1 cm", "0 to 20 cm"});
  refused(20.5, Failure::kNumber, {"panel 'front', edge 2", "20.5 cm"});
  refused("1 cm", Failure::kNumber, {"edge 2", "'allowance'", "write a number"});
  refused({{"corner", "miter"}}, Failure::kNotAGarment, {"edge 2", "'width'"});
  refused({{"width", 1}, {"corner", "round"}}, Failure::kNotAGarment,
          {"edge 2", "'round'", "miter, mirror or square"});
}

TEST(BrokenGarment, WithMarksOrFlagsOfAnotherKindNamesThem) {
  expectRefused(edited([](Json&, Json& front) { front["edges"][1]["open"] = 1; }),
                Failure::kNotAGarment, {"panel 'front', edge 1", "'open'", "true or false"});
  expectRefused(
      edited([](Json&, Json& front) { front["drillHoles"] = Json::parse("[[1, 2], [3]]"); }),
      Failure::kNumber, {"panel 'front', drill hole 1"});
  expectRefused(edited([](Json& garment, Json&) {
                  garment["seams"] = Json::parse(R"([{"stitch": 0, "suggested": "yes"}])");
                }),
                Failure::kSeamMalformed, {"seam 0", "'suggested'"});
}

}  // namespace
}  // namespace seamwise
