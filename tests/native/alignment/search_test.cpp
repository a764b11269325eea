#include "alignment/search/search.h"

#include <gtest/gtest.h>

#include "methods/metrics.h"
#include "support/cut_layout.h"
#include "support/level.h"
#include "support/meshed_samples.h"

namespace seamwise {
namespace {

using testing::cutLayout;
using testing::matchProblem;
using testing::meshedPattern;
using testing::Random;
using testing::randomLeaders;
using testing::sampleGroup;
using testing::Scatter;

constexpr double kZeroFit = 1e-6;  ///< cm2

Alignments searched(const MatchProblem& problem, std::uint64_t seed, SearchBudget budget = {}) {
  AlignmentSearch search(problem, seed, budget);
  while (search.step()) {
  }
  return search.best();
}

/// E_fit of all pieces, measured on the pattern itself. [cm2]
double fitOf(const Pattern& pattern, const MatchProblem& problem, const Alignments& leaders) {
  return totalMismatch(problem.group, pattern, restShapes(pattern), problem.expanded(leaders));
}

TEST(AlignmentSearch, OfVeryManyPiecesTakesNoMoreTimeThanOfMany) {
  SEAMWISE_THOROUGH_ONLY();
  const Pattern pattern =
      cutLayout(sampleGroup(*findGroup("pmm"), 0.2), 12, 10, Scatter::kMirrored, 1);
  const MatchProblem problem = matchProblem(pattern, sampleGroup(*findGroup("p1"), 0.2));
  AlignmentSearch search(problem, 1, {});
  while (search.step()) {
  }
  const double of_many = 2 * 40 * SearchBudget().evaluations;
  EXPECT_GT(search.spent(), 0.2 * of_many) << "it could not fail";
  EXPECT_LT(search.spent(), of_many);
}

class CutLayoutIn : public ::testing::TestWithParam<const char*> {
 protected:
  WallpaperGroup group_ = sampleGroup(*findGroup(GetParam()), 0.2);
};

INSTANTIATE_TEST_SUITE_P(AlignmentSearch, CutLayoutIn,
                         ::testing::ValuesIn(testing::sampleOf<const char*>(
                             3, {"pmm", "p31m", "pgg", "p1", "p2", "p4m"})),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(CutLayoutIn, IsPutTogetherAgain) {
  for (Scatter scatter : {Scatter::kTurned, Scatter::kMirrored}) {
    const Pattern pattern = cutLayout(group_, 3, 2, scatter, 1);
    const MatchProblem problem = matchProblem(pattern, group_);
    Random random(4);
    EXPECT_GT(fitOf(pattern, problem, randomLeaders(problem, random)), 10) << "it could not fail";
    EXPECT_LT(fitOf(pattern, problem, searched(problem, 1)), kZeroFit);
  }
}

TEST_P(CutLayoutIn, IsPutTogetherAroundAPinnedPiece) {
  const Pattern pattern = cutLayout(group_, 2, 2, Scatter::kTurned, 2);
  std::vector<PieceRule> rules(pattern.pieces.size());
  Random random(8);
  rules[1].pin = random.alignment();
  const MatchProblem problem = matchProblem(pattern, group_, rules);
  const Alignments best = problem.expanded(searched(problem, 1));
  EXPECT_EQ(best[1].angle, rules[1].pin->angle);
  EXPECT_EQ(best[1].translation, rules[1].pin->translation);
  EXPECT_LT(totalMismatch(group_, pattern, restShapes(pattern), best), kZeroFit);
}

TEST_P(CutLayoutIn, IsPutTogetherOnGrain) {
  const Pattern pattern = cutLayout(group_, 3, 2, Scatter::kShifted, 3);
  std::vector<PieceRule> rules(pattern.pieces.size());
  for (PieceRule& rule : rules) rule.angles = {0};
  const MatchProblem problem = matchProblem(pattern, group_, rules);
  const Alignments best = searched(problem, 1);
  for (const Alignment& a : best) EXPECT_EQ(a.angle, 0);
  EXPECT_LT(fitOf(pattern, problem, best), kZeroFit);
}

TEST_P(CutLayoutIn, NeedsMirroredSeamsOnlyWhereItWasMirrored) {
  const Pattern turned = cutLayout(group_, 3, 1, Scatter::kTurned, 4);
  const MatchProblem continuous = matchProblem(turned, group_, {}, true);
  EXPECT_LT(continuous.cost(searched(continuous, 1)), kZeroFit);
  if (!group_.carriesPair()) return;
  const Pattern mirrored = cutLayout(group_, 3, 1, Scatter::kMirrored, 4);
  const MatchProblem refused = matchProblem(mirrored, group_, {}, true);
  EXPECT_GT(refused.cost(searched(refused, 1)), 0.1);
}

/// Turns and shifts every panel differently: axes become oblique and pairs glide images.
Garment scattered(Garment garment) {
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const double k = static_cast<double>(p);
    garment.panels[p] = small::moved(garment.panels[p], {0.9 - 0.6 * k, Vec2(7 * k, 3 - k), false});
  }
  return garment;
}

/// Tees and trousers, with their symmetries where the group carries them.
std::vector<std::pair<Pattern, WallpaperGroup>> garments() {
  const Garment tee = scattered(small::tee(1.5)), trousers = scattered(small::trousers(true));
  std::vector<std::pair<Pattern, WallpaperGroup>> all;
  for (const char* name : testing::sampleOf<const char*>(1, {"p4m", "pmm", "cmm", "p6m"}))
    all.emplace_back(meshedPattern(tee, true), sampleGroup(*findGroup(name)));
  for (const char* name : testing::sampleOf<const char*>(1, {"pgg", "pg"}))
    all.emplace_back(meshedPattern(trousers, true), sampleGroup(*findGroup(name)));
  for (const char* name : testing::sampleOf<const char*>(1, {"p4", "p1", "p4g"}))
    all.emplace_back(meshedPattern(tee, false), sampleGroup(*findGroup(name)));
  return all;
}

SearchBudget little() {
  SearchBudget budget;
  budget.trees = 1, budget.idle = 1, budget.evaluations = 1;
  return budget;
}

TEST(AlignmentSearch, IsNeverWorseThanWhatItWasOffered) {
  for (const auto& [pattern, group] : garments()) {
    const MatchProblem problem = matchProblem(pattern, group);
    Random random(5);
    // a good answer, which a short search hardly finds, and a poor one
    for (const Alignments& offered : {searched(problem, 1), randomLeaders(problem, random)}) {
      // the result is independent of the number of samples on the way
      for (double samples : {1000.0, 6.0, 1.0}) {
        SearchBudget budget = little();
        budget.samples = samples;
        AlignmentSearch search(problem, 2, budget);
        search.offer(offered);
        while (search.step()) {
        }
        EXPECT_LE(problem.cost(search.best()), problem.cost(offered) * (1 + 1e-9))
            << group.data().name;
      }
    }
  }
}

TEST(AlignmentSearch, GivesTheSameAnswerForTheSameSeed) {
  for (const auto& [pattern, group] : garments()) {
    const MatchProblem problem = matchProblem(pattern, group);
    const Alignments first = searched(problem, 3), second = searched(problem, 3);
    for (std::size_t l = 0; l < first.size(); ++l) {
      EXPECT_EQ(first[l].angle, second[l].angle);
      EXPECT_EQ(first[l].translation, second[l].translation);
    }
  }
}

TEST(AlignmentSearch, BeatsTheBestOfAHundredRandomAlignments) {
  for (const auto& [pattern, group] : garments()) {
    const MatchProblem problem = matchProblem(pattern, group);
    Random random(6);
    double least = 1e300;
    for (int k = 0; k < 100; ++k)
      least = std::min(least, problem.cost(randomLeaders(problem, random)));
    EXPECT_LT(problem.cost(searched(problem, 1)), least) << group.data().name;
  }
}

TEST(AlignmentSearch, HasAValidAnswerAfterEveryStepAndAProgressThatNeverFalls) {
  const Pattern pattern = meshedPattern(small::tee(1.5), true);
  const MatchProblem problem = matchProblem(pattern, sampleGroup(*findGroup("p4m")));
  AlignmentSearch search(problem, 1, {});
  double fraction = 0;
  bool more = true;
  while (more) {
    more = search.step();
    ASSERT_EQ(search.best().size(), problem.leaders.size());
    EXPECT_GE(search.fraction(), fraction);
    fraction = search.fraction();
  }
  EXPECT_EQ(fraction, 1);
}

TEST(SymmetricProblem, ExpandsToAlignmentsThatObeyTheSymmetry) {
  for (const auto& [pattern, group] : garments()) {
    const MatchProblem problem = matchProblem(pattern, group);
    Random random(7);
    for (const Alignments& leaders : {randomLeaders(problem, random), searched(problem, 1)}) {
      const Alignments all = problem.expanded(leaders);
      for (const Mirror& m : pattern.mirrors)
        EXPECT_LT(testing::asymmetry(group, all[m.pieces[0]], all[m.pieces[1]], m.map), 1e-9)
            << group.data().name << ", " << pattern.pieces[m.pieces[0]].name;
      const Alignments back = problem.ofLeaders(all);
      for (std::size_t l = 0; l < back.size(); ++l)
        EXPECT_LT((back[l].translation - leaders[l].translation).norm(), 1e-9);
    }
  }
}

TEST(SymmetricProblem, CostsWhatTheWholeGarmentCosts) {
  for (const auto& [pattern, group] : garments()) {
    const MatchProblem problem = matchProblem(pattern, group);
    EXPECT_EQ(problem.leaders.size() < pattern.pieces.size(), !pattern.mirrors.empty());
    Random random(9);
    for (int k = 0; k < 5; ++k) {
      const Alignments leaders = randomLeaders(problem, random);
      const double whole = fitOf(pattern, problem, leaders);
      EXPECT_NEAR(problem.cost(leaders), whole, 1e-6 * whole) << group.data().name;
    }
  }
}

TEST(SymmetricProblem, ListsEverySeamOnceTogetherWithItsMirrorImage) {
  // side, shoulder, front and back of the armhole, underarm
  const Pattern pattern = meshedPattern(scattered(small::tee(1.5)), true);
  const MatchProblem problem = matchProblem(pattern, sampleGroup(*findGroup("pmm")));
  EXPECT_EQ(pattern.seams.size(), 10u);
  EXPECT_EQ(problem.seams.size(), 5u);
}

TEST(SymmetricProblem, WithAPinnedTwinLetsItLead) {
  const Pattern pattern = meshedPattern(scattered(small::trousers(true)), true);
  const WallpaperGroup group = sampleGroup(*findGroup("pgg"));
  Random random(10);
  for (const Mirror& m : pattern.mirrors) {
    for (int side : {0, 1}) {
      std::vector<PieceRule> rules(pattern.pieces.size());
      rules[m.pieces[side]].pin = random.alignment();
      const MatchProblem problem = matchProblem(pattern, group, rules);
      const Alignments all = problem.expanded(searched(problem, 1, little()));
      EXPECT_EQ(all[m.pieces[side]].angle, rules[m.pieces[side]].pin->angle);
      EXPECT_LT(testing::asymmetry(group, all[m.pieces[0]], all[m.pieces[1]], m.map), 1e-9);
    }
  }
}

}  // namespace
}  // namespace seamwise
