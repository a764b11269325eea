#include <gtest/gtest.h>

#include "garment_texts.h"

namespace seamwise {
namespace {

using testing::mustRead;
using testing::panelOf;
using testing::twoRectangles;

/// Our own format with everything it can hold, and with fields nobody knows.
Json richGarment() {
  Json document = twoRectangles();
  document["format"] = "seamwise-garment/1";
  document["parameters"] = {{"length", 20.125}, {"note", "caf\u00e9"}};
  document["properties"]["units_in_meter"] = 300.5;
  Json& front = panelOf(document, "front");
  front["label"] = "body";
  front["edges"][0]["curvature"] = {{"type", "cubic"},
                                    {"params", {{0.1, -0.1}, {0.9, -0.30000000000000004}}}};
  front["grain"] = {{"line", {{5, 0}, {5, 20}}}, {"lock", "bias"}, {"colour", "red"}};
  front["cutLine"] = {{-1, -1}, {11, -1}, {11, 21}};
  front["notches"] = {{{"edge", 1}, {"at", 0.5}, {"depth", 0.4}}};
  document["seams"] = {{{"stitch", 0}, {"weight", 0.1}, {"thread", "blue"}}};
  document["symmetries"] = {{{"kind", "piece"}, {"piece", "front"}, {"why", "centre front"}}};
  document["x-shop"] = {
      {"price", 49.9}, {"tags", {"a", nullptr, false}}, {"big", 12345678901234567890u}};
  return document;
}

void expectSameCurve(const Curve& a, const Curve& b) {
  for (const double s : {0.0, 0.3, 1.0}) EXPECT_EQ(a.at(s), b.at(s));
}

TEST(GarmentRoundTrip, GivesTheSameBytesTheSecondTime) {
  for (const Json& document : {twoRectangles(), richGarment()}) {
    const std::string once = writeGarment(mustRead(document));
    EXPECT_EQ(writeGarment(mustRead(once)), once);
  }
}

TEST(GarmentRoundTrip, KeepsEveryFieldUnknownOnesIncluded) {
  const Json document = richGarment();
  const Json written = Json::parse(writeGarment(mustRead(document)));
  for (const auto& [key, value] : document.items()) EXPECT_EQ(written[key], value) << key;
  EXPECT_EQ(written.size(), document.size());
}

TEST(GarmentRoundTrip, KeepsThePanelsInOrder) {
  Json document = twoRectangles();
  Json panels = Json::object();
  for (const char* name : {"zip", "Apron", "10", "front", "back"})
    panels[name] = panelOf(document, "front");
  document["pattern"]["panels"] = panels;
  document["pattern"].erase("stitches");
  const Garment garment = mustRead(writeGarment(mustRead(document))).garment;
  ASSERT_EQ(garment.panels.size(), 5u);
  EXPECT_EQ(garment.panels[0].name, "zip");
  EXPECT_EQ(garment.panels[2].name, "10");
}

TEST(GarmentRoundTrip, MeansTheSameGarment) {
  const GarmentFile first = mustRead(richGarment());
  const GarmentFile second = mustRead(writeGarment(first));
  ASSERT_EQ(second.garment.panels.size(), first.garment.panels.size());
  for (std::size_t p = 0; p < first.garment.panels.size(); ++p) {
    const Panel &a = first.garment.panels[p], &b = second.garment.panels[p];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.mirrored_from_input, b.mirrored_from_input);
    EXPECT_EQ(a.grain_angle, b.grain_angle);
    EXPECT_EQ(a.grain_lock, b.grain_lock);
    EXPECT_EQ(a.placement_shift, b.placement_shift);
    ASSERT_EQ(a.edges.size(), b.edges.size());
    for (std::size_t k = 0; k < a.edges.size(); ++k) expectSameCurve(a.edges[k], b.edges[k]);
  }
  ASSERT_EQ(second.garment.stitches.size(), 2u);
  EXPECT_EQ(second.garment.stitches[0].weight, 0.1);
  EXPECT_EQ(second.symmetries.size(), 1u);
}

TEST(GarmentRoundTrip, UpgradesAPlainSpecificationAndStatesWhatWasAssumed) {
  Json document = twoRectangles();
  document["format"] = "seamwise-garment/0";
  document["properties"] = nullptr;
  const GarmentFile file = mustRead(document);
  EXPECT_FALSE(file.notes.empty());
  const Json written = Json::parse(writeGarment(file));
  EXPECT_EQ(written["format"], "seamwise-garment/1");
  EXPECT_EQ(written.begin().key(), "format");
  EXPECT_EQ(written["properties"]["units_in_meter"], 100);
  EXPECT_EQ(written["properties"]["curvature_coords"], "relative");
  EXPECT_TRUE(mustRead(written).notes.empty());
}

TEST(GarmentRoundTrip, StaysReadableForWhoeverKnowsThePlainFormatOnly) {
  const Json plain = twoRectangles();
  const Json written = Json::parse(writeGarment(mustRead(plain)));
  EXPECT_EQ(written["pattern"], plain["pattern"]);
  EXPECT_EQ(written["properties"], plain["properties"]);
}

}  // namespace
}  // namespace seamwise
