// Garments drafted without a size or a body: the dummy each gets, and the ones that are refused.
#include "drape/fitting_form.h"

#include <gtest/gtest.h>

#include "drape/drape_samples.h"
#include "drape/worn_garment.h"
#include "support/level.h"

namespace seamwise {
namespace {

using namespace testing;

constexpr double kCorner = 3;  ///< cm between samples of outlines

/// Panels from hem to waist, one on each side of a body, tilted away from it as in files of skirts.
Garment gores(double waist, double tilt) {
  Garment garment;
  const double top = waist / 8, hem = top + 20;
  for (int k = 0; k < 4; ++k) {
    const double turn = k * kPi / 2;
    Panel panel =
        small::polygon("gore " + std::to_string(k), {{-hem, 0}, {hem, 0}, {top, 60}, {-top, 60}});
    panel.placement_turn = {tilt, turn, 0};
    panel.placement_shift = {40 * std::sin(turn), 107 - 60, 40 * std::cos(turn)};
    garment.panels.push_back(panel);
  }
  for (int k = 0; k < 4; ++k) garment.stitches.push_back({{k, 1}, {(k + 1) % 4, 3}});
  return garment;
}

Pattern patternOf(const Garment& garment) { return plainPattern(garment, kCorner); }

FittingForm fitted(const Garment& garment) {
  return fittingForm(garment, patternOf(garment)).value();
}

/// Refusal of a garment on a body; empty when it is accepted.
std::string saidOf(const Garment& garment, const Measures& body) {
  SolvedGarment solved{garment, patternOf(garment), {}};
  solved.shapes = restShapes(solved.pattern);
  WearSettings settings;
  settings.measures = body;
  settings.edge = 2 * kFineCloth;
  auto worn = WornGarment::make(std::move(solved), settings);
  EXPECT_TRUE(worn.ok()) << worn.error().message;
  while (!worn.value()->refusal() && worn.value()->drape().advance(1)) {
  }
  const std::optional<Error> refusal = worn.value()->refusal();
  return refusal ? refusal->message : "";
}

TEST(FittingForms, TiltedGoresAreNoSleeves) {
  const Garment garment = gores(80, -kPi / 5);
  const Form form = Form::make(*measuresOf("m")).value();
  EXPECT_EQ(hang(garment, patternOf(garment), form).value().parts,
            std::vector<BodyPart>(4, BodyPart::kTorso));
}

TEST(FittingForms, WaistsAreThoseOfWhatHangsOnThem) {
  for (const double waist : testing::sampleOf<double>(2, {64, 90, 76})) {
    const FittingForm fitting = fitted(gores(waist, 0));
    EXPECT_NEAR(fitting.measures.waist, waist - 1, 2) << waist;
    EXPECT_GT(fitting.measures.hip, fitting.measures.waist + 5) << waist;
    EXPECT_LT(std::abs(fitting.lift), 6) << waist;
  }
}

TEST(FittingForms, GirthsGiveWayWhereARingIsNarrow) {
  // A tube as wide as the waist down to the hips.
  Garment tube;
  for (const double turn : {0.0, kPi}) {
    Panel panel =
        small::polygon(turn == 0 ? "front" : "back", {{-21, 0}, {21, 0}, {21, 50}, {-21, 50}});
    panel.placement_turn = {0, turn, 0};
    panel.placement_shift = {0, 57, turn == 0 ? 20.0 : -20.0};
    tube.panels.push_back(panel);
  }
  tube.stitches = {{{0, 1}, {1, 3}}, {{0, 3}, {1, 1}}};
  const Measures body = fitted(tube).measures;
  EXPECT_LT(body.hip, 88);
  EXPECT_GT(body.waist, 70);
}

/// A top with sleeves and straight shoulders from 8 to 18 cm, whose tips are lower by `fall` cm.
Garment top(double fall) {
  Garment garment;
  for (const double turn : {0.0, kPi}) {
    Panel panel = small::polygon(turn == 0 ? "front" : "back", {{-25, 0},
                                                                {25, 0},
                                                                {25, 30},
                                                                {18, 50 - fall},
                                                                {8, 50},
                                                                {-8, 50},
                                                                {-18, 50 - fall},
                                                                {-25, 30}});
    panel.placement_turn = {0, turn, 0};
    panel.placement_shift = {0, 93, turn == 0 ? 20.0 : -20.0};
    garment.panels.push_back(panel);
  }
  garment.stitches = {{{0, 1}, {1, 7}}, {{0, 7}, {1, 1}}, {{0, 3}, {1, 5}}, {{0, 5}, {1, 3}}};
  for (const double side : {1.0, -1.0}) {
    for (const double depth : {15.0, -15.0}) {
      Panel sleeve = small::polygon(
          (side > 0 ? "left sleeve " : "right sleeve ") + std::string(depth > 0 ? "front" : "back"),
          {{-10, -15}, {10, -15}, {10, 15}, {-10, 15}});
      sleeve.placement_turn = {0, 0, side * kPi / 4};
      sleeve.placement_shift = {side * 38, 128, depth};
      garment.panels.push_back(sleeve);
    }
    const int front = static_cast<int>(garment.panels.size()) - 2;
    garment.stitches.push_back({{front, 1}, {front + 1, 1}});
    garment.stitches.push_back({{front, 3}, {front + 1, 3}});
  }
  return garment;
}

TEST(FittingForms, FlatShouldersLieOnWideOnes) {
  const double sloped = fitted(top(10)).measures.shoulder_width;
  EXPECT_LE(sloped, measuresOf("m")->shoulder_width);
  EXPECT_GT(fitted(top(0)).measures.shoulder_width, sloped + 3);
}

TEST(FittingForms, WhatSlidesOffIsSaid) {
  SEAMWISE_THOROUGH_ONLY();
  const std::string said = saidOf(gores(120, 0), *measuresOf("xs"));
  EXPECT_EQ(said.substr(0, said.find(':')), "The garment slides off the form");
  EXPECT_EQ(saidOf(gores(80, 0), *measuresOf("m")), "");
}

}  // namespace
}  // namespace seamwise
