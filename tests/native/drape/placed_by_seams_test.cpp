#include <gtest/gtest.h>

#include <cmath>

#include "drape/parts.h"
#include "drape/turn.h"
#include "support/meshed_samples.h"

namespace seamwise {
namespace {

struct Worn {
  Garment garment;
  Pattern pattern;
};

Worn wornSample(const std::string& name) {
  Worn worn{testing::readSample(name), {}};
  const std::vector<BodySymmetry> known = detectSymmetries(worn.garment);
  Outcome<Pattern> sampled = discretise(worn.garment, known, known, 3);
  EXPECT_TRUE(sampled.ok()) << name;
  worn.pattern = meshed(std::move(sampled).value(), 3).value();
  return worn;
}

void unplace(Garment* garment) {
  for (Panel& panel : garment->panels) {
    panel.placement_shift.setZero();
    panel.placement_turn.setZero();
  }
}

const Form& formM() {
  static const Form kForm = Form::make(*measuresOf("m")).value();
  return kForm;
}

class PlacedBySeams : public ::testing::TestWithParam<const char*> {};

TEST_P(PlacedBySeams, HangOnThePartsAndSidesThatTheirFilesSay) {
  Worn worn = wornSample(std::string(GetParam()) + "-m");
  const Hanging drafted = hang(worn.garment, worn.pattern, formM()).value();
  EXPECT_FALSE(drafted.by_seams);
  unplace(&worn.garment);
  const Hanging found = hang(worn.garment, worn.pattern, formM()).value();
  EXPECT_TRUE(found.by_seams);
  EXPECT_EQ(found.parts, drafted.parts);
  for (std::size_t p = 0; p < found.parts.size(); ++p) {
    const std::string& name = worn.pattern.pieces[p].name;
    const Vec3 &here = found.middles[p], &there = drafted.middles[p];
    // Pieces at a side, in front or at the back of the body stay there.
    if (std::abs(there.x()) > 12) {
      EXPECT_GT(here.x() * there.x(), 0) << name;
    }
    if (drafted.parts[p] != BodyPart::kTorso) continue;
    EXPECT_NEAR(here.y(), there.y(), 11) << name;
    if (std::abs(there.z()) > 16) {
      EXPECT_GT(here.z() * there.z(), 0) << name;
    }
  }
}

TEST_P(PlacedBySeams, FaceTheFrontByTheirNamesWithoutSymmetries) {
  Worn worn = wornSample(std::string(GetParam()) + "-m");
  const Hanging drafted = hang(worn.garment, worn.pattern, formM()).value();
  unplace(&worn.garment);
  worn.pattern.mirrors.clear();
  const Hanging found = hang(worn.garment, worn.pattern, formM()).value();
  for (std::size_t p = 0; p < found.parts.size(); ++p) {
    if (drafted.parts[p] != BodyPart::kTorso || std::abs(drafted.middles[p].z()) < 16) continue;
    EXPECT_GT(found.middles[p].z() * drafted.middles[p].z(), 0) << worn.pattern.pieces[p].name;
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, PlacedBySeams,
                         ::testing::Values("tee", "shift-dress", "raglan", "princess-dress",
                                           "asymmetric-dress", "trousers", "gathered-skirt",
                                           "six-gore-skirt", "shirt", "hoodie", "apron",
                                           "patchwork-jacket"));

TEST(PlacedPieces, HaveShouldersAtTheSidesWithoutSymmetriesAndNames) {
  Worn worn = wornSample("tee-m");
  const Hanging drafted = hang(worn.garment, worn.pattern, formM()).value();
  unplace(&worn.garment);
  worn.pattern.mirrors.clear();
  for (Piece& piece : worn.pattern.pieces) piece.name = "piece";
  const Hanging found = hang(worn.garment, worn.pattern, formM()).value();
  for (std::size_t p = 0; p < found.parts.size(); ++p)
    if (drafted.parts[p] == BodyPart::kTorso) {
      EXPECT_LT(std::abs(found.middles[p].x()), 3) << "piece " << p;
    }
}

TEST(PlacedPieces, HangAlikeHoweverTheirPanelsAreDrawn) {
  Worn worn = wornSample("shirt-m");
  unplace(&worn.garment);
  const Hanging upright = hang(worn.garment, worn.pattern, formM()).value();
  // All pieces turned by 90 degrees, grain to the right, as in cutting programs.
  for (std::size_t p = 0; p < worn.garment.panels.size(); ++p) {
    worn.garment.panels[p].grain_angle -= kPi / 2;
    for (Vec2& point : worn.pattern.pieces[p].rest) point = Vec2(point.y(), -point.x());
  }
  for (MatchLine& match : worn.garment.matches)
    for (Polyline* line : {&match.a, &match.b})
      for (Vec2& point : *line) point = Vec2(point.y(), -point.x());
  const Hanging lying = hang(worn.garment, worn.pattern, formM()).value();
  EXPECT_EQ(lying.parts, upright.parts);
  for (std::size_t p = 0; p < lying.middles.size(); ++p)
    EXPECT_LT((lying.middles[p] - upright.middles[p]).norm(), 0.5)
        << worn.pattern.pieces[p].name << " at " << lying.middles[p].transpose() << ", not "
        << upright.middles[p].transpose();
}

TEST(PlacedPieces, AreRefusedWithThePieceThatNoSeamJoins) {
  Worn worn = wornSample("tee-m");
  unplace(&worn.garment);
  worn.pattern.seams.clear();
  const Outcome<Hanging> hanging = hang(worn.garment, worn.pattern, formM());
  ASSERT_FALSE(hanging.ok());
  EXPECT_EQ(hanging.error().code, Failure::kNotAGarment);
  EXPECT_EQ(hanging.error().message,
            "No seam joins piece 'back' to the others, and the file does not say where it hangs: "
            "sew it, or give the panels of the garment a 'translation' each.");
}

}  // namespace
}  // namespace seamwise
