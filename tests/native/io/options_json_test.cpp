#include "io/options_json.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/garment_texts.h"

namespace seamwise {
namespace {

using testing::expectError;
using testing::mustRead;
using testing::twoRectangles;

Outcome<SolveOptions> options(const std::string& text) {
  return readOptions(text, "options.json", mustRead(twoRectangles()).garment);
}

// --- print ---------------------------------------------------------------------------------------

TEST(OptionsFile, KeepsTheDefaultsOfWhatItLeavesOut) {
  const auto read = options("{}");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read.value().max_change_cm, 1.0);
  EXPECT_FALSE(read.value().alpha.has_value());
  EXPECT_TRUE(read.value().problem().empty());
}

TEST(OptionsFile, IsReadInAllItsFields) {
  const auto read = options(R"({
      "maxChangeCm": 0.5, "alpha": 2, "edgeLengthCm": 0.8, "continuousOnly": true,
      "averageSeamShapes": false, "visibility": "even", "proof": 0.5, "starts": 50, "clipTargets": true,
      "grain": {"default": "bias", "toleranceDeg": 9,
                "pieces": {"front": "on", "back": {"lock": "free", "toleranceDeg": 18}}},
      "pins": {"back": {"angle": 0.25, "translation": [1, 2]}},
      "weights": {"1": 0.5}, "unmatched": [0], "plain": ["back"],
      "matches": [{"a": {"piece": "front", "line": [[1, 0], [1, 4], [1, 10]]},
                   "b": {"piece": "back", "line": [[9, 0], [9, 10]]}, "weight": 3}]})");
  ASSERT_TRUE(read.ok()) << read.error().message;
  const SolveOptions& o = read.value();
  EXPECT_EQ(o.max_change_cm, 0.5);
  EXPECT_EQ(o.alpha, 2);
  EXPECT_EQ(o.edge_length_cm, 0.8);
  EXPECT_TRUE(o.continuous_only);
  EXPECT_EQ(o.average_seam_shapes, false);
  EXPECT_EQ(o.visibility, Visibility::kEven);
  EXPECT_EQ(o.proof, 0.5);
  EXPECT_EQ(o.starts, 50);
  EXPECT_TRUE(o.clip_targets);
  EXPECT_EQ(o.grain.lock, GrainLock::kBias);
  EXPECT_EQ(o.piece_grain.at(0).rule->lock, GrainLock::kOn);
  EXPECT_NEAR(o.piece_grain.at(0).rule->tolerance, kPi / 20, 1e-12);
  EXPECT_NEAR(o.piece_grain.at(1).rule->tolerance, kPi / 10, 1e-12);
  EXPECT_EQ(o.pins.at(1).angle, 0.25);
  EXPECT_EQ(o.pins.at(1).translation, Vec2(1, 2));
  EXPECT_EQ(o.weights.at(1), 0.5);
  EXPECT_EQ(o.unmatched, std::vector<int>{0});
  EXPECT_EQ(o.plain, std::vector<int>{1});
  ASSERT_EQ(o.matches.size(), 1u);
  EXPECT_EQ(o.matches[0].weight, 3);
  ASSERT_EQ(o.matches[0].a.size(), 11u);  // 10 cm in steps of at most 1 cm, on both sides
  ASSERT_EQ(o.matches[0].b.size(), 11u);
  EXPECT_LT((o.matches[0].a[7] - Vec2(1, 7)).norm(), 1e-12);
}

TEST(OptionsFile, MayTurnTheGrainOfAPieceAndSayWhereItsLineRuns) {
  const auto turned = options(R"({"grain": {"default": "on", "pieces": {
      "front": "across", "back": {"lock": "bias", "angleDeg": 30}}}})");
  ASSERT_TRUE(turned.ok()) << turned.error().message;
  const auto& rules = turned.value().piece_grain;
  EXPECT_EQ(rules.at(0).rule->lock, GrainLock::kAcross);
  EXPECT_FALSE(rules.at(0).line.has_value());
  EXPECT_EQ(rules.at(1).rule->lock, GrainLock::kBias);
  EXPECT_NEAR(rules.at(1).line.value(), kPi / 6, 1e-12);

  const auto only_line = options(R"({"grain": {"pieces": {"front": {"angleDeg": -90}}}})");
  ASSERT_TRUE(only_line.ok()) << only_line.error().message;
  EXPECT_FALSE(only_line.value().piece_grain.at(0).rule.has_value());
  EXPECT_NEAR(only_line.value().piece_grain.at(0).line.value(), -kPi / 2, 1e-12);
}

TEST(OptionsFile, ThatIsUnusableNamesTheField) {
  const auto refuse = [](const char* text, std::initializer_list<const char*> words) {
    const auto read = options(text);
    expectError(read, Failure::kOptions, {"options.json"});
    expectError(read, Failure::kOptions, words);
  };
  refuse(R"({"maxChange": 1})", {"unknown field 'maxChange'", "maxChangeCm"});
  refuse(R"({"maxChangeCm": -1})", {"maxChangeCm"});
  refuse(R"({"proof": -1})", {"proof"});
  refuse(R"({"starts": 0})", {"starts", "1000"});
  refuse(R"({"starts": 1.5})", {"'starts'"});
  refuse(R"({"clipTargets": 1})", {"'clipTargets'"});
  refuse(R"({"maxChangeCm": "1"})", {"'maxChangeCm'", "the text '1'"});
  refuse(R"({"maxChangeCm": null})", {"null for 'maxChangeCm'", "leave it out"});
  refuse(R"({"edgeLengthCm": 2})", {"edgeLengthCm", "1.05"});
  refuse(R"({"edgeLengthCm": 0})", {"edgeLengthCm"});
  refuse(R"({"alpha": 0})", {"alpha"});
  refuse(R"({"continuousOnly": "yes"})", {"'continuousOnly'"});
  refuse(R"({"matches": [{"a": {"piece": "front", "line": [[500, 0], [500, 9]]},
                          "b": {"piece": "front", "line": [[1, 0], [1, 9]]}}]})",
         {"match 0, side a", "cm outside piece 'front'"});
  refuse(R"({"grain": {"lock": "on"}})", {"unknown field 'lock'"});
  refuse(R"({"grain": {"default": "straight"}})", {"'straight'", "free, on, across or bias"});
  refuse(R"({"grain": {"toleranceDeg": 91}})", {"toleranceDeg"});
  refuse(R"({"grain": {"pieces": {"front": {"lock": "on", "angleDeg": "30"}}}})",
         {"'angleDeg'", "the text '30'"});
  refuse(R"({"grain": {"pieces": {"front": {"toleranceDeg": 5}}}})", {"'front'", "'lock'"});
  refuse(R"({"grain": {"pieces": {"sleeve": "on"}}})", {"'sleeve'", "grain.pieces"});
  refuse(R"({"pins": {"sleeve": {"angle": 0, "translation": [0, 0]}}})", {"'sleeve'", "'pins'"});
  refuse(R"({"pins": {"front": {"angle": 0}}})", {"'front'", "'translation'"});
  refuse(R"({"weights": {"2": 1}})", {"seam 2", "'weights'"});
  refuse(R"({"weights": {"first": 1}})", {"'first'", "'weights'"});
  refuse(R"({"weights": {"1": -1}})", {"weights", "seam 1"});
  refuse(R"({"unmatched": [-1]})", {"seam -1", "'unmatched'"});
  refuse(R"({"plain": ["lining"]})", {"'lining'", "'plain'"});
  refuse(R"({"matches": [{"a": {"piece": "front", "line": [[0, 0], [0, 5]]}}]})",
         {"match 0", "'b'"});
  refuse(R"({"matches": [{"a": {"piece": "cuff", "line": [[0, 0], [0, 5]]}, "b": 1}]})",
         {"match 0, side a", "'cuff'"});
  refuse(R"({"matches": [{"a": {"piece": "front", "line": [[0, 0], [0, 0]]}, "b": 1}]})",
         {"match 0, side a", "shorter than"});
  refuse(R"({"matches": [{"a": {"piece": "front", "line": [[1, 0], [1, 9]]},
                          "b": {"piece": "back", "line": [[9, 0], [9, 9]]}, "wieght": 3}]})",
         {"match 0", "unknown field 'wieght'"});
}

TEST(SolveOptions, FindsWhatNoFileCouldHold) {
  SolveOptions o;
  EXPECT_EQ(o.problem(), "");
  o.max_change_cm = NAN;
  EXPECT_NE(o.problem().find("maxChangeCm"), std::string::npos);
  o = {};
  o.pins[0].angle = NAN;
  EXPECT_NE(o.problem().find("pins"), std::string::npos);
  o = {};
  o.weights[0] = INFINITY;
  EXPECT_NE(o.problem().find("weights"), std::string::npos);
  const Polyline point = {{0, 0}}, line = {{0, 0}, {1, 1}};
  for (const MatchLine& match :
       {MatchLine{0, 1, line, point, 1.0}, MatchLine{0, 1, point, point, 1.0},
        MatchLine{0, 1, line, line, -1.0}, MatchLine{0, -1, line, line, 1.0}}) {
    o = {};
    o.matches = {match};
    EXPECT_NE(o.problem().find("matches"), std::string::npos);
  }
}

// --- problem -------------------------------------------------------------------------------------

}  // namespace
}  // namespace seamwise
