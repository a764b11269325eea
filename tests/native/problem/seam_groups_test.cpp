#include "problem/seam_groups.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "io/garment_json.h"
#include "support/garment_texts.h"
#include "symmetry/detection.h"

namespace seamwise {
namespace {

using testing::mustRead;
using testing::twoRectangles;

/// A sample garment in its middle size, with the placements of its file or without.
Garment sample(const std::string& name, bool placed = true) {
  std::ifstream file(std::string(SEAMWISE_GARMENTS) + "/" + name + "-m.json");
  std::ostringstream text;
  text << file.rdbuf();
  Garment garment = readGarment(text.str(), name).value().garment;
  for (Panel& panel : garment.panels)
    if (!placed) panel.placement_shift = panel.placement_turn = Vec3::Zero();
  return garment;
}

std::vector<SeamGroup> groupsOf(const Garment& garment) {
  SymmetryDetection detection(garment);
  while (detection.advance()) {
  }
  return seamGroups(garment, detection.found());
}

/// Names of places by stitch.
std::vector<std::string> placesOf(const Garment& garment) {
  std::vector<std::string> places(garment.stitches.size());
  for (const SeamGroup& group : groupsOf(garment))
    for (const int s : group.seams) places[s] = placeName(group.place);
  return places;
}

struct Rectangle {
  const char* name;
  double x, y, z, width, height;  ///< x, y of its lower corner in front, z ahead. [cm]
};
/// Rectangles hung in front of and behind a body, without seams. Edges: 0 hem, 1 and 3 sides, 2
/// top.
Json hung(const std::vector<Rectangle>& pieces) {
  Json text = twoRectangles();
  text["pattern"]["panels"] = Json::object();
  text["pattern"]["stitches"] = Json::array();
  for (const Rectangle& r : pieces) {
    Json panel = twoRectangles()["pattern"]["panels"]["front"];
    panel["translation"] = {r.x, r.y, r.z};
    panel["vertices"] = {{0, 0}, {r.width, 0}, {r.width, r.height}, {0, r.height}};
    text["pattern"]["panels"][r.name] = panel;
  }
  return text;
}
void sew(Json& text, const char* a, int edge_a, const char* b, int edge_b) {
  text["pattern"]["stitches"].push_back(
      {{{"panel", a}, {"edge", edge_a}}, {{"panel", b}, {"edge", edge_b}}});
}

struct Expected {
  const char* garment;
  std::map<int, std::string> places;  ///< by stitch
};

const Expected kExpected[] = {{"tee",
                               {{0, "side"},
                                {1, "side"},
                                {2, "shoulder"},
                                {4, "sleeve head, front"},
                                {6, "sleeve head, back"},
                                {8, "sleeve"}}},
                              {"princess-dress",
                               {{0, "princess"},
                                {6, "dart"},
                                {8, "side"},
                                {14, "shoulder"},
                                {18, "princess"},
                                {24, "centre back"}}},
                              {"raglan",
                               {{0, "centre front"},
                                {1, "centre back"},
                                {2, "side"},
                                {4, "sleeve head, front"},
                                {6, "sleeve head, back"},
                                {10, "sleeve"}}},
                              {"trousers",
                               {{0, "outseam"},
                                {6, "inseam"},
                                {10, "centre front"},
                                {11, "centre back"},
                                {14, "dart"},
                                {16, "band"}}}};

TEST(SeamGroups, HavePlacesFromThePlacementsOfTheFile) {
  for (const Expected& one : kExpected) {
    const std::vector<std::string> places = placesOf(sample(one.garment));
    for (const auto& [stitch, place] : one.places)
      EXPECT_EQ(places[stitch], place) << one.garment << " stitch " << stitch;
  }
  const std::vector<std::string> hoodie = placesOf(sample("hoodie"));
  EXPECT_EQ(hoodie[10], "cuff");
  EXPECT_EQ(hoodie[14], "hood");
  EXPECT_EQ(hoodie[21], "band");
  EXPECT_EQ(placesOf(sample("shirt"))[26], "collar");
}

TEST(SeamGroups, HavePlacesFromTheSeamsWithoutPlacements) {
  for (const Expected& one : kExpected) {
    const std::vector<std::string> places = placesOf(sample(one.garment, false));
    for (const auto& [stitch, place] : one.places)
      EXPECT_EQ(places[stitch], place) << one.garment << " stitch " << stitch;
  }
}

TEST(SeamGroups, JoinStitchesAcrossDartsAlongOneLine) {
  const Garment garment = sample("shift-dress");
  std::vector<int> stitches(garment.stitches.size());
  for (const SeamGroup& group : groupsOf(garment)) {
    for (const int s : group.seams) ++stitches[s];
    if (group.place == SeamPlace::kSide) {
      EXPECT_EQ(group.seams.size(), 2u);  // below and above the bust dart
      EXPECT_EQ(group.ends[0] == SeamEnd::kTop, group.ends[1] == SeamEnd::kBottom);
    }
  }
  EXPECT_EQ(stitches, std::vector<int>(stitches.size(), 1));
}

TEST(SeamGroups, TellLeftAndRightOfTheWearer) {
  for (const bool placed : {true, false}) {
    const Garment garment = sample("trousers", placed);
    std::vector<BodySide> sides(garment.stitches.size());
    for (const SeamGroup& group : groupsOf(garment))
      for (const int s : group.seams) sides[s] = group.side;
    EXPECT_EQ(sides[0], BodySide::kLeft);  // outseam
    EXPECT_EQ(sides[1], BodySide::kRight);
    EXPECT_EQ(sides[6], BodySide::kLeft);  // inseam
    EXPECT_EQ(sides[7], BodySide::kRight);
    EXPECT_EQ(sides[10], BodySide::kMiddle);  // centre front
  }
}

TEST(SeamGroups, AreSeparateAtCorners) {
  // both sides and the top of two rectangles
  Json text = twoRectangles();
  text["pattern"]["stitches"].push_back(
      {{{"panel", "front"}, {"edge", 2}}, {{"panel", "back"}, {"edge", 2}}});
  EXPECT_EQ(groupsOf(mustRead(text).garment).size(), 3u);
}

TEST(SeamGroups, CallAWaistbandBetweenBodiceAndSkirtABand) {
  Json text = hung({{"a1", -20, 100, 20, 40, 35},
                    {"a2", -20, 100, -20, 40, 35},
                    {"b1", -20, 90, 20, 40, 10},
                    {"b2", -20, 90, -20, 40, 10},
                    {"c1", -20, 40, 20, 40, 50},
                    {"c2", -20, 40, -20, 40, 50}});
  for (const auto& [front, back] : {std::pair("a1", "a2"), {"b1", "b2"}, {"c1", "c2"}})
    sew(text, front, 1, back, 1), sew(text, front, 3, back, 3);
  for (const auto& [upper, lower] :
       {std::pair("a1", "b1"), {"a2", "b2"}, {"b1", "c1"}, {"b2", "c2"}})
    sew(text, upper, 0, lower, 2);
  const std::vector<std::string> places = placesOf(mustRead(text).garment);
  EXPECT_EQ(places[0], "side");
  for (const int stitch : {2, 3, 6, 7, 8, 9}) EXPECT_EQ(places[stitch], "band") << stitch;
}

TEST(SeamGroups, CallAPointedInsertNoBand) {
  Json text = hung({{"skirt", -20, 40, 20, 40, 60}, {"insert", -20, 30, 20, 40, 10}});
  Json& insert = text["pattern"]["panels"]["insert"];
  insert["vertices"] = {{0, 0}, {40, 0}, {20, 9}};
  insert["edges"].erase(3);
  insert["edges"][2]["endpoints"] = {2, 0};
  sew(text, "insert", 1, "skirt", 0);
  EXPECT_EQ(placesOf(mustRead(text).garment)[0], "waist");
}

TEST(SeamGroups, TellCuffsOfLegsFromThoseOfSleeves) {
  Json text = hung({{"l1", 2, 40, 15, 24, 60},
                    {"l2", 2, 40, -15, 24, 60},
                    {"r1", -26, 40, 15, 24, 60},
                    {"r2", -26, 40, -15, 24, 60},
                    {"m1", 4, 28, 15, 20, 12},
                    {"m2", 4, 28, -15, 20, 12},
                    {"n1", -24, 28, 15, 20, 12},
                    {"n2", -24, 28, -15, 20, 12}});
  for (const auto& [front, back] :
       {std::pair("l1", "l2"), {"r1", "r2"}, {"m1", "m2"}, {"n1", "n2"}})
    sew(text, front, 1, back, 1), sew(text, front, 3, back, 3);
  for (const auto& [leg, cuff] : {std::pair("l1", "m1"), {"l2", "m2"}, {"r1", "n1"}, {"r2", "n2"}})
    sew(text, leg, 0, cuff, 2);
  const std::vector<std::string> places = placesOf(mustRead(text).garment);
  EXPECT_EQ(places[0], "outseam");
  EXPECT_EQ(places[1], "inseam");
  EXPECT_EQ(places[4], "outseam");
}

TEST(Visibility, SetsWeightsThatTheFileLeavesOpen) {
  Garment garment = sample("gathered-skirt");  // 0, 1 sides, 4, 5 gathered
  for (Stitch& stitch : garment.stitches) stitch.weight = 1;
  garment.stitches[1].weight = 0.5;
  garment.matches.push_back({0, 1, {{0, 0}, {0, 1}}, {{0, 0}, {0, 1}}, 1});
  garment.matches.push_back({0, 1, {{0, 0}, {0, 1}}, {{0, 0}, {0, 1}}, 3});
  weighByVisibility(groupsOf(garment), &garment, &garment.matches);
  EXPECT_EQ(garment.stitches[0].weight, 2);
  EXPECT_EQ(garment.stitches[1].weight, 0.5);
  EXPECT_EQ(garment.stitches[1].visibility, 2);
  EXPECT_EQ(garment.stitches[4].weight, 0.1);
  EXPECT_EQ(garment.matches[0].weight, 2);
  EXPECT_EQ(garment.matches[1].weight, 3);
}

}  // namespace
}  // namespace seamwise
