#include "solve/placing_rules.h"

#include <gtest/gtest.h>

#include "solver_samples.h"

namespace seamwise {
namespace {

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

TEST(Pins, AreKeptExactlyAndDropFoundSymmetriesThatTheyContradict) {
  const Result r = solved(pinned("front", 0.3, 3, 4));
  const Alignment& at = r.alignment[pieceNamed(r, "front")];
  EXPECT_NEAR(at.angle, 0.3, 1e-12);
  EXPECT_LT((at.translation - Vec2(3, 4)).norm(), 1e-12);
  ASSERT_FALSE(r.notes.empty());
  EXPECT_NE(r.notes.front().find("'front' is dropped: as it is pinned"), std::string::npos)
      << r.notes.front();
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
  ASSERT_FALSE(r.notes.empty());
  EXPECT_NE(r.notes.front().find("'front' is dropped"), std::string::npos) << r.notes.front();
  EXPECT_NE(r.notes.front().find("grain"), std::string::npos) << r.notes.front();
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

TEST(Shapes, StayAsDraftedWhereNothingCanBeGained) {
  for (const char* garment : {"gathered-skirt", "tee"}) {
    const Result r = solved(task(garment, "pmm"));
    EXPECT_LE(r.fit.any, r.fit_search * (1 + 1e-6)) << garment;
  }
}

}  // namespace
}  // namespace seamwise
