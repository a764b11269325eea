// A mesh taken over from the solve before must be the mesh that would have been made.
#include <gtest/gtest.h>

#include "io/result_json.h"
#include "solve/prepare.h"
#include "solver_samples.h"

namespace seamwise {
namespace {

using testing::Task;
using testing::task;

/// The result file of a solve.
std::string solved(const Task& t, MeshMemo* memo) {
  Outcome<Solver> solver = Solver::make(testing::problemOf(t), memo);
  EXPECT_TRUE(solver.ok()) << solver.error().message;
  const Outcome<Result> result = solver.value().finish();
  EXPECT_TRUE(result.ok()) << result.error().message;
  return writeResult(result.value());
}

TEST(MeshMemo, GivesTheSameResultsAsNoMemo) {
  MeshMemo memo;
  const Task plain = task("apron", "pmm");
  solved(plain, &memo);
  const auto changed = [&](const std::function<void(Task&)>& change) {
    Task t = plain;
    change(t);
    return t;
  };
  const Task changes[] = {
      changed([](Task& t) { t.print = testing::samplePrint("pmm", 7); }),
      changed([](Task& t) { t.print = testing::samplePrint("p1"); }),  // carries no symmetry
      changed([](Task& t) {
        t.options["weights"] = {{"0", 3}};
      }),
      changed([](Task& t) {
        t.options["grain"] = {{"default", "on"}};
      }),
      changed([](Task& t) { t.options["maxChangeCm"] = 0.2; }),
      changed([](Task& t) { t.options["edgeLengthCm"] = 0.8; }),
      changed([](Task& t) { t.symmetry = "none"; }),
      task("tee", "pmm"),
  };
  for (const Task& t : changes) EXPECT_EQ(solved(t, &memo), solved(t, nullptr)) << t.options;
}

TEST(MeshMemo, KeepsTheMeshOverChangesThatLeaveItAsItIs) {
  MeshMemo memo;
  Task t = task("apron", "pmm");
  solved(t, &memo);
  const Pattern* const mesh = &memo.last->pattern;
  const auto* const vertices = mesh->pieces[0].rest.data();
  t.options["weights"] = {{"0", 3}};
  t.print = testing::samplePrint("pmm", 7);
  solved(t, &memo);
  EXPECT_EQ(memo.last->pattern.pieces[0].rest.data(), vertices);
  t.options["edgeLengthCm"] = 0.8;
  solved(t, &memo);
  EXPECT_NE(memo.last->pattern.pieces[0].rest.data(), vertices);
}

TEST(MeshMemo, RemembersWhichSymmetryWasDroppedAndSaysSoAgain) {
  MeshMemo memo;
  Task t = task("tee", "pmm");
  Json& corner = t.garment["pattern"]["panels"]["front"]["vertices"][0][0];
  corner = corner.get<double>() + 0.03;  // nearly symmetric,
  t.options["maxChangeCm"] = 1e-3;       // and not allowed to become so
  const std::string first = solved(t, &memo);
  ASSERT_FALSE(memo.last->notes.empty());
  EXPECT_EQ(solved(t, &memo), first);
}

}  // namespace
}  // namespace seamwise
