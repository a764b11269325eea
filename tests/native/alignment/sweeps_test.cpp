#include "alignment/baseline/sweeps.h"

#include <gtest/gtest.h>

#include "support/cut_layout.h"
#include "support/meshed_samples.h"

namespace seamwise {
namespace {

using testing::matchProblem;
using testing::meshedPattern;
using testing::sampleGroup;

TEST(LocalSweeps, ReduceTheFitOfRandomStarts) {
  for (bool symmetric : {false, true}) {
    const Pattern pattern = meshedPattern(small::tee(1.5), symmetric);
    for (const char* name : {"pm", "pmm", "p4m", "p6m"}) {
      const MatchProblem problem = matchProblem(pattern, sampleGroup(*findGroup(name)));
      double before = 0, after = 0;
      for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        LocalSweeps sweeps(problem, seed);
        before += problem.cost(sweeps.at());
        while (sweeps.step()) {
        }
        after += problem.cost(sweeps.at());
      }
      EXPECT_LT(after, 0.8 * before) << name;
    }
  }
}

TEST(LocalSweeps, KeepTheSymmetryAfterEverySweep) {
  const Pattern pattern = meshedPattern(small::tee(1.5), true);
  ASSERT_EQ(pattern.mirrors.size(), 3u);
  for (const char* name : {"pm", "cmm", "p4g", "p31m"}) {
    const WallpaperGroup group = sampleGroup(*findGroup(name));
    const MatchProblem problem = matchProblem(pattern, group);
    LocalSweeps sweeps(problem, 1);
    do {
      const Alignments all = problem.expanded(sweeps.at());
      for (const Mirror& m : pattern.mirrors)
        EXPECT_LT(testing::asymmetry(group, all[m.pieces[0]], all[m.pieces[1]], m.map), 1e-9);
    } while (sweeps.step());
  }
}

TEST(LocalSweeps, LeavePinnedPiecesAndGrainAlone) {
  const Pattern pattern = meshedPattern(small::tee(1.5), false);
  std::vector<PieceRule> rules(pattern.pieces.size());
  testing::Random random(3);
  rules[0].pin = random.alignment();
  rules[1].angles = {0.2, 0.2 + kPi};
  const MatchProblem problem = matchProblem(pattern, sampleGroup(*findGroup("p4m")), rules);
  LocalSweeps sweeps(problem, 1);
  do {
    EXPECT_EQ(sweeps.at()[0].angle, rules[0].pin->angle);
    EXPECT_EQ(sweeps.at()[0].translation, rules[0].pin->translation);
    EXPECT_LT(std::abs(std::sin(sweeps.at()[1].angle - 0.2)), 1e-9);
  } while (sweeps.step());
}

TEST(LocalSweeps, GiveTheSameAnswerForTheSameSeedAndOthersForOthers) {
  const Pattern pattern = meshedPattern(small::tee(1.5), false);
  const MatchProblem problem = matchProblem(pattern, sampleGroup(*findGroup("pmm")));
  auto ended = [&](std::uint64_t seed) {
    LocalSweeps sweeps(problem, seed);
    while (sweeps.step()) {
    }
    EXPECT_GT(sweeps.sweeps(), 1);
    return sweeps.at();
  };
  const Alignments first = ended(1), again = ended(1), other = ended(2);
  bool differs = false;
  for (std::size_t l = 0; l < first.size(); ++l) {
    EXPECT_EQ(first[l].angle, again[l].angle);
    EXPECT_EQ(first[l].translation, again[l].translation);
    differs |= first[l].angle != other[l].angle;
  }
  EXPECT_TRUE(differs);
}

TEST(LocalSweeps, GoOnFromAStartOfOnesOwnAndStayWhereOthersEnded) {
  const Pattern pattern = meshedPattern(small::tee(1.5), true);
  const MatchProblem problem = matchProblem(pattern, sampleGroup(*findGroup("pmm")));
  LocalSweeps sweeps(problem, 1);
  while (sweeps.step()) {
  }
  LocalSweeps again(problem, sweeps.at());
  while (again.step()) {
  }
  EXPECT_LT(again.sweeps(), sweeps.sweeps());
  for (std::size_t l = 0; l < sweeps.at().size(); ++l) {
    EXPECT_NEAR(again.at()[l].angle, sweeps.at()[l].angle, 1e-3);
    EXPECT_LT((again.at()[l].translation - sweeps.at()[l].translation).norm(), 1e-2);
  }
}

TEST(LocalSweeps, ConvergeToAPerfectFitOfTwoPieces) {
  // one seam between two pieces of a cut plane: nothing can trap the iteration in p1
  const WallpaperGroup group = sampleGroup(*findGroup("p1"));
  const Pattern pattern = testing::cutLayout(group, 2, 1, testing::Scatter::kTurned, 1);
  const MatchProblem problem = matchProblem(pattern, group);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    LocalSweeps sweeps(problem, seed);
    while (sweeps.step()) {
    }
    EXPECT_LT(problem.cost(sweeps.at()), 1e-2);
  }
}

}  // namespace
}  // namespace seamwise
