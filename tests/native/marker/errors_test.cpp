#include <gtest/gtest.h>

#include <regex>

#include "marker/marker_samples.h"

namespace seamwise {
namespace {

using testing::box;
using testing::groupOf;
using testing::laid;
using testing::pieceOf;
using testing::refusalOf;

/// The last length in a message. [cm]
double lastLength(const std::string& sentence) {
  static const std::regex length("([0-9.]+) cm");
  double last = 0;
  for (std::sregex_iterator at(sentence.begin(), sentence.end(), length), end; at != end; ++at)
    last = std::stod((*at)[1]);
  return last;
}

MarkerProblem oneBar(const char* group, double width, double height) {
  MarkerProblem problem{groupOf(group, {10, 0}, {0, 10})};
  problem.pieces = {pieceOf("front", box(width, height))};
  problem.selvedge = 1;
  problem.effort = 0.001;
  return problem;
}

TEST(MarkerErrors, NameAPieceThatIsTooWideAndAWidthThatIsEnough) {
  MarkerProblem problem = oneBar("p2", 30.04, 12);
  problem.width = 28;
  const std::string refusal = refusalOf(problem);
  EXPECT_NE(refusal.find("front is 30.1 cm wide"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("26.0 cm between the selvedges"), std::string::npos) << refusal;
  problem.width = lastLength(refusal);
  problem.phases = {1};  // start of the print at which the piece fits
  EXPECT_NEAR(problem.width, 32.04, 0.1);
  EXPECT_EQ(refusalOf(problem), "");
}

TEST(MarkerErrors, NameAWidthAtWhichAPieceFindsADotOfThePrint) {
  MarkerProblem problem = oneBar("p1", 25, 12);
  problem.pieces[0].alignment.shift = {4, 0};  // at 6, 16, ... from an origin of the print
  problem.width = 30;                          // room 28, from 1 to 29
  const std::string refusal = refusalOf(problem);
  EXPECT_NE(refusal.find("front fits nowhere across 30.0 cm"), std::string::npos) << refusal;
  EXPECT_NEAR(lastLength(refusal), 6 + 25 + 1, 0.5);
  problem.width = lastLength(refusal);
  EXPECT_EQ(refusalOf(problem), "");
}

TEST(MarkerErrors, AreNoneWhereAnyTurnOfThePrintMakesAPieceFit) {
  const double h = std::sqrt(3.0) / 2;
  MarkerProblem problem{groupOf("p6", {10, 0}, {5, 10 * h})};
  problem.pieces = {pieceOf("binding", box(4, 60))};
  problem.pieces[0].turns = LayTurns::kAny;
  problem.width = 30;
  problem.effort = 0.001;
  problem.pieces[0].alignment.angle =
      kPi / 3;  // a further turn by 120 degrees puts it along the warp
  const auto marker = laid(problem);
  ASSERT_TRUE(marker);
  EXPECT_NEAR(marker->length(), 60, 1e-6);
}

TEST(MarkerErrors, NameTheLeastWidthOfAPieceThatMayBeTurned) {
  MarkerProblem problem = oneBar("p4", 30, 20);
  problem.pieces[0].turns = LayTurns::kQuarter;
  problem.width = 15;
  problem.phases = {1};
  EXPECT_NEAR(lastLength(refusalOf(problem)), 22, 0.05);
  problem.width = 22;
  EXPECT_EQ(refusalOf(problem), "");
}

TEST(MarkerErrors, NameAPieceThatCannotPointUp) {
  MarkerProblem problem = oneBar("p1", 8, 12);
  problem.width = 30;
  problem.nap = Nap::kOneWay;
  EXPECT_EQ(refusalOf(problem), "");
  problem.pieces[0].alignment.angle = kPi;
  EXPECT_EQ(refusalOf(problem),
            "front cannot lie with its upper end up on this print; allow both ways.");
  problem.group = groupOf("p2", {10, 0}, {0, 10});
  EXPECT_EQ(refusalOf(problem), "");
}

TEST(MarkerErrors, SayThatFlawsLeaveNoRoom) {
  MarkerProblem problem = oneBar("p2", 8, 12);
  problem.width = 30;
  problem.start = 0;
  problem.flaws = {{{12, -10}, {14, -10}, {14, 9000}, {12, 9000}},
                   {{20, -10}, {22, -10}, {22, 9000}, {20, 9000}}};
  EXPECT_EQ(refusalOf(problem), "");  // room from 1 to 12, with a dot at 2 after a half turn
  problem.flaws.push_back({{5, -10}, {6, -10}, {6, 9000}, {5, 9000}});
  EXPECT_EQ(refusalOf(problem), "front finds no place between the flaws; take fabric with fewer.");
}

TEST(MarkerErrors, SayThatThereIsNothingToLay) {
  MarkerProblem problem = oneBar("p2", 8, 12);
  problem.width = 30;
  problem.pieces.clear();
  EXPECT_EQ(refusalOf(problem), "There is no piece to lay.");
}

TEST(MarkerErrors, SayThatPinnedPiecesOverlapOrLeaveTheFabric) {
  MarkerProblem problem = oneBar("p2", 8, 12);
  problem.width = 30;
  problem.start = 0;
  problem.pieces.push_back(pieceOf("back", box(8, 12)));
  problem.pieces[0].pin = RigidMotion{0, {2, 2}};
  problem.pieces[1].pin = RigidMotion{0, {6, 6}};
  EXPECT_NE(refusalOf(problem), "");
  problem.pieces[1].pin = RigidMotion{0, {26, 6}};
  EXPECT_NE(refusalOf(problem), "");
  problem.pieces[1].pin = RigidMotion{0, {11, 6}};
  EXPECT_EQ(refusalOf(problem), "");
}

}  // namespace
}  // namespace seamwise
