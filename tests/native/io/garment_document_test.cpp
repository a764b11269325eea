#include "io/garment_document.h"

#include <gtest/gtest.h>

#include "support/garment_texts.h"

namespace seamwise {
namespace {

using testing::panelOf;
using testing::twoRectangles;

Json documentOf(const Json& garment) {
  const Outcome<std::string> document = garmentDocument(garment.dump(), "shirt.json");
  if (!document.ok()) {
    ADD_FAILURE() << document.error().message;
    return {};
  }
  return Json::parse(document.value());
}

/// The front's loop runs the other way round, so that it shows its back.
Json seenFromTheBack() {
  Json garment = twoRectangles();
  panelOf(garment, "front")["edges"] = Json::parse(R"([
      {"endpoints": [0, 3]}, {"endpoints": [3, 2]}, {"endpoints": [2, 1]}, {"endpoints": [1, 0]}])");
  return garment;
}

TEST(GarmentDocument, HoldsPiecesWithTheirEdgesAndSeamsByNumber) {
  Json garment = twoRectangles();
  panelOf(garment, "front")["edges"][1]["curvature"] = {{"type", "cubic"},
                                                        {"params", {{0.25, 0.1}, {0.75, 0.1}}}};
  panelOf(garment, "front")["edges"][2]["curvature"] = {{"type", "circle"}, {"params", {5, 0, 1}}};
  garment["seams"] = Json::parse(R"([{"stitch": 1, "name": "Side", "weight": 2, "tape": true}])");
  const Json document = documentOf(garment);
  ASSERT_EQ(document["pieces"].size(), 2u);
  const Json& front = document["pieces"][0];
  EXPECT_EQ(front["name"], "front");
  EXPECT_EQ(front["outline"][0]["points"], Json::parse("[[0, 0], [10, 0]]"));
  EXPECT_EQ(front["outline"][1]["points"], Json::parse("[[10, 0], [8, 5], [8, 15], [10, 20]]"));
  EXPECT_EQ(front["outline"][2]["radius"], 5);
  EXPECT_NEAR(front["outline"][2]["sweep"], kPi, 1e-9);
  ASSERT_EQ(document["seams"].size(), 2u);
  EXPECT_EQ(document["seams"][0]["a"], Json::parse(R"({"piece": 0, "edge": 1})"));
  EXPECT_EQ(document["seams"][0]["weight"], 1);
  EXPECT_EQ(document["seams"][1]["name"], "Side");
  EXPECT_EQ(document["seams"][1]["weight"], 2);
  EXPECT_EQ(document["seams"][1]["more"], Json::parse(R"({"tape": true})"));
}

TEST(GarmentDocument, TakesUnitsOutOfEveryLengthAndLaysPiecesFaceUp) {
  Json garment = seenFromTheBack();
  garment["properties"]["units_in_meter"] = 200;
  Json& front = panelOf(garment, "front");
  front["grain"] = Json::parse(R"({"line": [[2, 0], [2, 30]], "lock": "on"})");
  front["cutLine"] = front["internalLines"] = Json::parse("[[-2, -2], [12, -2]]");
  front["internalLines"] = Json::array({front["cutLine"]});
  front["rotation"] = {10, 20, 30};
  garment["symmetries"] = Json::parse(
      R"([{"kind": "piece", "piece": "front", "axis": [[2.5, 0], [2.5, 10]], "residual": 0}])");
  const Json document = documentOf(garment);
  const Json& piece = document["pieces"][0];
  EXPECT_TRUE(piece["mirroredFromInput"]);
  EXPECT_EQ(piece["outline"][1]["points"], Json::parse("[[0, 10], [-5, 10]]"));
  EXPECT_EQ(piece["grain"], Json::parse(R"({"line": [[-1, 0], [-1, 15]], "lock": "on"})"));
  EXPECT_EQ(piece["cutLine"], Json::parse("[[1, -1], [-6, -1]]"));
  EXPECT_EQ(piece["internalLines"], Json::parse("[[[1, -1], [-6, -1]]]"));
  EXPECT_EQ(piece["placement"],
            Json::parse(R"({"translation": [0, 50, 10], "rotation": [-10, 200, 30]})"));
  EXPECT_EQ(
      document["symmetries"],
      Json::parse(R"([{"kind": "piece", "piece": "front", "axis": [[-2.5, 0], [-2.5, 10]]}])"));
  EXPECT_FALSE(document["pieces"][1]["mirroredFromInput"]);
}

TEST(GarmentDocument, KeepsWhatItDoesNotKnowAndLeavesOutWordsThatAreNone) {
  Json garment = twoRectangles();
  garment["author"] = {{"name", "Ada"}};
  garment["title"] = 5;
  panelOf(garment, "front")["label"] = "Vorderteil";
  panelOf(garment, "back")["label"] = 7;
  panelOf(garment, "back")["pockets"] = 2;
  panelOf(garment, "back")["edges"][0]["finish"] = "raw";
  panelOf(garment, "back")["quantity"] = 2;
  const Json document = documentOf(garment);
  EXPECT_EQ(document["more"], Json::parse(R"({"author": {"name": "Ada"}})"));
  EXPECT_FALSE(document.contains("title"));
  EXPECT_EQ(document["pieces"][0]["label"], "Vorderteil");
  EXPECT_FALSE(document["pieces"][1].contains("label"));
  EXPECT_EQ(document["pieces"][1]["more"], Json::parse(R"({"pockets": 2})"));
  EXPECT_EQ(document["pieces"][1]["outline"][0]["more"], Json::parse(R"({"finish": "raw"})"));
  EXPECT_EQ(document["pieces"][1]["quantity"], 2);
}

TEST(GarmentDocument, HoldsAllowancesDrillHolesAndWhatStaysOpenOrIsSuggested) {
  Json garment = seenFromTheBack();
  garment["properties"]["units_in_meter"] = 1000;
  Json& front = panelOf(garment, "front");
  front["edges"][0]["allowance"] = 10;
  front["edges"][1]["allowance"] = {{"width", 30}, {"corner", "mirror"}};
  front["edges"][1]["open"] = true;
  front["edges"][2]["open"] = false;
  front["drillHoles"] = Json::parse("[[20, 30]]");
  for (Json& vertex : front["vertices"])
    for (Json& x : vertex) x = 10 * x.get<double>();
  for (Json& vertex : panelOf(garment, "back")["vertices"])
    for (Json& x : vertex) x = 10 * x.get<double>();
  garment["seams"] = Json::parse(R"([{"stitch": 1, "suggested": true}])");
  const Json document = documentOf(garment);
  const Json& piece = document["pieces"][0];
  EXPECT_EQ(piece["outline"][0]["allowance"], Json::parse(R"({"width": 1})"));
  EXPECT_EQ(piece["outline"][1]["allowance"], Json::parse(R"({"width": 3, "corner": "mirror"})"));
  EXPECT_EQ(piece["outline"][1]["open"], true);
  EXPECT_FALSE(piece["outline"][2].contains("open"));
  EXPECT_FALSE(piece["outline"][2].contains("more"));
  EXPECT_EQ(piece["drillHoles"], Json::parse("[[-2, 3]]"));
  EXPECT_FALSE(document["seams"][0].contains("suggested"));
  EXPECT_EQ(document["seams"][1]["suggested"], true);
}

TEST(GarmentDocument, AsksForUnitsInWhichNobodyCouldWearIt) {
  EXPECT_EQ(documentOf(twoRectangles())["questions"], Json::array());
  Json tiny = twoRectangles();
  tiny["properties"]["units_in_meter"] = 1000;
  const Json asked = documentOf(tiny)["questions"];
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_EQ(asked[0]["about"], "units");
  EXPECT_NEAR(asked[0]["tallestCm"], 2, 1e-9);
  EXPECT_EQ(asked[0]["likely"], Json::parse(R"(["cm", "inch"])"));
}

TEST(GarmentDocument, RefusesWhatTheReaderRefuses) {
  Json garment = twoRectangles();
  panelOf(garment, "front")["quantity"] = 0;
  testing::expectError(garmentDocument(garment.dump(), "shirt.json"), Failure::kNumber,
                       {"shirt.json", "'front'", "'quantity'", "write how many are cut"});
  panelOf(garment, "front")["quantity"] = 1;
  panelOf(garment, "front")["internalLines"] = Json::parse("[[[0, 0]]]");
  testing::expectError(garmentDocument(garment.dump(), "shirt.json"), Failure::kNotAGarment,
                       {"'front'", "internal line 0", "fewer than two points"});
}

}  // namespace
}  // namespace seamwise
