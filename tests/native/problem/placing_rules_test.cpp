#include "problem/placing_rules.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/level.h"
#include "support/solver_samples.h"

namespace seamwise {
namespace {

using testing::panelsOf;
using testing::problemOf;
using testing::solved;
using testing::Task;
using testing::task;

Task pinned(const char* piece, double angle, double x, double y) {
  Task t = task("tee", "p4m");
  t.options["pins"][piece] = {{"angle", angle}, {"translation", {x, y}}};
  return t;
}

int pieceNamed(const Result& r, const std::string& name) {
  for (std::size_t p = 0; p < r.pattern.pieces.size(); ++p)
    if (r.pattern.pieces[p].name == name) return static_cast<int>(p);
  return -1;
}

bool isNoted(const std::vector<Note>& notes, std::initializer_list<const char*> words) {
  return std::any_of(notes.begin(), notes.end(), [&](const Note& note) {
    return std::all_of(words.begin(), words.end(),
                       [&](const char* word) { return note.text.find(word) != std::string::npos; });
  });
}

TEST(Pins, AreKeptExactlyAndDropFoundSymmetriesThatTheyContradict) {
  const Result r = solved(pinned("front", 0.3, 3, 4));
  const Alignment& at = r.alignment[pieceNamed(r, "front")];
  EXPECT_NEAR(at.angle, 0.3, 1e-12);
  EXPECT_LT((at.translation - Vec2(3, 4)).norm(), 1e-12);
  ASSERT_FALSE(r.notes.empty());
  EXPECT_NE(r.notes.front().text.find("'front' is dropped: as it is pinned"), std::string::npos)
      << r.notes.front().text;
  EXPECT_STREQ(r.notes.front().code, "symmetryPins");
  EXPECT_EQ(r.notes.front().pieces.size(), 1u);
  EXPECT_FALSE(r.pattern.mirrors.empty()) << "the others stay";
}

TEST(Pins, LeaveSymmetriesThatHoldWithThem) {
  const Result free = solved(task("tee", "p4m"));
  const int front = pieceNamed(free, "front");
  const Alignment at = free.alignment[front];
  const Result r = solved(pinned("front", at.angle, at.translation.x(), at.translation.y()));
  EXPECT_EQ(r.pattern.mirrors.size(), free.pattern.mirrors.size());
  EXPECT_NEAR((r.alignment[front].translation - at.translation).norm(), 0, 1e-9);
}

TEST(Pins, OfBothPiecesOfAPairMustMirrorEachOther) {
  Task t = pinned("sleeve_left", 0.3, 3, 4);
  t.options["pins"]["sleeve_right"] = {{"angle", 0.1}, {"translation", {1, 1}}};
  const Result r = solved(t);
  EXPECT_LT((r.alignment[pieceNamed(r, "sleeve_left")].translation - Vec2(3, 4)).norm(), 1e-12);
  EXPECT_LT((r.alignment[pieceNamed(r, "sleeve_right")].translation - Vec2(1, 1)).norm(), 1e-12);
}

TEST(Grain, IsKeptByBothPiecesOfAPairWhereThePrintCan) {
  for (const char* group : {"pmm", "p4m", "p3m1"}) {
    Task t = task("tee", group);
    t.options["grain"]["default"] = "on";
    const Result r = solved(t);
    for (const char* sleeve : {"sleeve_left", "sleeve_right"}) {
      const double angle = r.alignment[pieceNamed(r, sleeve)].angle;
      EXPECT_NEAR(std::sin(angle), 0, 1e-9) << sleeve << " " << group;
    }
  }
}

/// Stripes along the warp: their mirrors run along and across.
Task striped() {
  Task t = task("tee", "pm");
  t.print = {{"group", "pm"}, {"w1", {0.0, 6.0}}, {"w2", {-8.0, 0.0}}};
  t.options["grain"]["default"] = "on";
  return t;
}

TEST(Grain, GoesBeforeFoundSymmetriesThatItContradicts) {
  Task t = striped();
  t.print = {{"group", "pm"}, {"w1", {6.0, 0.0}}, {"w2", {0.0, 8.0}}};  // mirrors only across
  const Result r = solved(t);
  EXPECT_TRUE(isNoted(r.notes, {"'front' is dropped", "grain"}));
  for (const Alignment& at : r.alignment) EXPECT_NEAR(std::sin(at.angle), 0, 1e-9);
}

TEST(Grain, LeavesSymmetriesThatHoldWithIt) {
  const Result r = solved(striped());
  EXPECT_EQ(r.pattern.mirrors.size(), 3u);
  for (const Alignment& at : r.alignment) EXPECT_NEAR(std::sin(at.angle), 0, 1e-9);
}

TEST(Grain, RefusesAnAskedForSymmetryThatItContradicts) {
  Task t = striped();
  t.print = {{"group", "pm"}, {"w1", {6.0, 0.0}}, {"w2", {0.0, 8.0}}};
  t.symmetry = R"({"symmetries": [{"kind": "piece", "piece": "front"}]})";
  const Outcome<Result> r = solve(problemOf(t));
  ASSERT_FALSE(r.ok());
  EXPECT_EQ(r.error().code, Failure::kSymmetryConflict);
  EXPECT_NE(r.error().message.find("grain"), std::string::npos) << r.error().message;
}

/// Possible angles of a tee's front. [degrees, of its grain line from the warp]
std::vector<double> frontAngles(const Json& grain, bool one_way = false) {
  Task t = task("tee", "p1");
  t.print["oneWay"] = one_way;
  t.options["grain"]["pieces"]["front"] = grain;
  const Problem problem = problemOf(t);
  const std::vector<PieceRule> rules = pieceRules(problem);
  std::vector<double> degrees;
  for (const double angle : rules[problem.garment.find("front")].angles)
    degrees.push_back(std::round(wrapAngle(angle) * 180 / kPi));
  std::sort(degrees.begin(), degrees.end());
  return degrees;
}

TEST(Grain, AcrossIsAQuarterTurnEitherWayAlsoOfAPrintWithAnUpside) {
  EXPECT_EQ(frontAngles("across"), (std::vector<double>{-90, 90}));
  EXPECT_EQ(frontAngles("across", true), (std::vector<double>{-90, 90}));
}

TEST(Grain, RunsWhereTheOptionsSayItDoes) {
  EXPECT_EQ(frontAngles({{"lock", "on"}, {"angleDeg", 30}}, true), std::vector<double>{-60});
  EXPECT_EQ(frontAngles({{"lock", "across"}, {"angleDeg", 30}}), (std::vector<double>{-150, 30}));
  EXPECT_EQ(frontAngles({{"lock", "bias"}, {"angleDeg", 90}}, true),
            (std::vector<double>{-45, 45}));
}

TEST(Grain, OfTheOptionsGoesBeforeThatOfTheFile) {
  Task t = task("tee", "p1");
  panelsOf(t.garment)["front"]["grain"] = {{"line", {{0, 0}, {9, 0}}}};
  const auto front = [&] {
    const Problem problem = problemOf(t);
    return wrapAngle(pieceRules(problem)[problem.garment.find("front")].angles.at(0));
  };
  t.options["grain"]["default"] = "on";
  EXPECT_NEAR(front(), -kPi / 2, 1e-12);
  t.options["grain"]["pieces"]["front"] = {{"angleDeg", 90}};
  EXPECT_NEAR(front(), 0, 1e-12);
}

TEST(Grain, ThatNobodyStatesIsAssumedToRunUpwardsAndNotedOnlyWhereItIsUsed) {
  Task t = task("tee", "p1");
  EXPECT_FALSE(isNoted(problemOf(t).notes, {"grain"}));
  t.print["oneWay"] = true;
  EXPECT_TRUE(
      isNoted(problemOf(t).notes, {"no grain line", "'front'", "'sleeve_left'", "angleDeg"}));
  t.print["oneWay"] = false;
  t.options["grain"]["default"] = "on";
  for (const char* piece : {"back", "sleeve_left", "sleeve_right"})
    t.options["grain"]["pieces"][piece] = {{"lock", "on"}, {"angleDeg", 90}};
  EXPECT_TRUE(isNoted(problemOf(t).notes, {"no grain line", "as drawn: 'front';"}));
  panelsOf(t.garment)["front"]["grain"] = {{"line", {{0, 0}, {0, 9}}}};
  EXPECT_FALSE(isNoted(problemOf(t).notes, {"grain"}));
}

/// Greatest deviation of a piece from upright. [degrees]
double mostOffUpright(const Result& r) {
  double most = 0;
  for (const Alignment& at : r.alignment) most = std::max(most, std::abs(wrapAngle(at.angle)));
  return most * 180 / kPi;
}

TEST(OneWayPrints, NeverHangUpsideDownThoughTheGrainIsFree) {
  for (const char* garment : {"tee", "asymmetric-dress"})
    for (const char* group : testing::sampleOf<const char*>(2, {"pm", "p3m1", "p1", "pg"}))
      for (std::uint32_t seed : testing::sampleOf<std::uint32_t>(1, {1, 2, 3})) {
        Task t = task(garment, group);
        t.print["oneWay"] = true, t.seed = seed, t.options["maxChangeCm"] = 0;
        EXPECT_LE(mostOffUpright(solved(t)), 60 + 1e-6) << garment << " " << group << " " << seed;
      }
}

TEST(OneWayPrints, KeepBothPiecesOfAPairUprightWhereTheMirrorsAreTilted) {
  Task t = task("tee", "pm");
  const double tilt = kPi / 9;
  t.print = {{"group", "pm"},
             {"w1", {-8 * std::sin(tilt), 8 * std::cos(tilt)}},
             {"w2", {-10 * std::cos(tilt), -10 * std::sin(tilt)}},
             {"oneWay", true}};
  const Result r = solved(t);
  EXPECT_FALSE(r.pattern.mirrors.empty());
  EXPECT_LE(mostOffUpright(r), 60 + 1e-6);
}

TEST(OneWayPrints, DropAFoundPairWhoseImageWouldHangUpsideDown) {
  Task t = task("tee", "pg");
  t.print = {{"group", "pg"}, {"w1", {8.0, 0.0}}, {"w2", {0.0, 10.0}}, {"oneWay", true}};
  const Result lying = solved(t);
  EXPECT_TRUE(isNoted(lying.notes, {"'sleeve_left' and 'sleeve_right'", "is dropped", "grain"}));
  t.print["w1"] = {0.0, 8.0}, t.print["w2"] = {-10.0, 0.0};
  const Result upright = solved(t);
  EXPECT_EQ(upright.pattern.mirrors.size(), 1u);
  for (const Result* r : {&lying, &upright}) EXPECT_LE(mostOffUpright(*r), 60 + 1e-6);
}

TEST(Shapes, StayAsDraftedWhereNothingCanBeGained) {
  for (const char* garment : {"gathered-skirt", "tee"}) {
    const Result r = solved(task(garment, "pmm"));
    EXPECT_LE(r.total.nearest, r.total_search * (1 + 1e-6)) << garment;
  }
}

}  // namespace
}  // namespace seamwise
