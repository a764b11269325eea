#include "alignment/bound/lower_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "alignment/icp/refine.h"
#include "support/level.h"
#include "support/print_samples.h"

namespace seamwise {
namespace {

using testing::Random;
using testing::sampleGroup;

/// Two small pieces and seams between unrelated points, so that no alignment is perfect.
class Made {
 public:
  Made(const char* group, unsigned seed)
      : problem(sampleGroup(*findGroup(group), 0.3)), random_(seed) {}

  void piece(const AdmissibleAlignments& admissible) {
    Leader leader;
    leader.piece = static_cast<int>(problem.leaders.size());
    leader.admissible = admissible;
    leader.centre = random_.point() / 20;
    problem.leaders.push_back(leader);
    component.leaders.push_back(leader.piece);
  }
  void seam(int a, int b, int edges, bool reversing = false) {
    MatchSeam seam;
    seam.a = a, seam.b = b, seam.reversing = reversing;
    for (int k = 0; k < edges; ++k) {
      seam.pa.push_back(problem.leaders[a].centre + random_.point() / 10);
      seam.pb.push_back(problem.leaders[b].centre + random_.point() / 10);
      seam.da.push_back(random_.point()), seam.db.push_back(random_.point());
      seam.w.push_back(random_.between(0.2, 2));
      seam.weight += seam.w.back();
    }
    const int s = static_cast<int>(problem.seams.size());
    problem.leaders[a].seams.push_back(s);
    if (a != b) problem.leaders[b].seams.push_back(s);
    component.seams.push_back(s);
    problem.seams.push_back(std::move(seam));
  }
  Alignments somewhere() {
    Alignments at;
    for (const Leader& leader : problem.leaders)
      at.push_back(leader.admissible.nearest(random_.alignment(), leader.centre));
    return at;
  }
  /// A box around a random alignment: of any size, or of the sizes that matter at the end of a
  /// proof.
  Box box() {
    const double size = std::pow(10, random_.between(-3, 0));
    return {random_.alignment(),
            random_.between(0, 1) < 0.5 ? 0 : random_.between(0, 2) * size,
            {random_.point() / 20 * size, random_.point() / 20 * size}};
  }
  /// Turn and shifts in a box, from -1 to 1; sometimes a corner.
  std::array<double, 3> within() {
    std::array<double, 3> x;
    for (double& v : x) v = std::clamp(random_.between(-1.5, 1.5), -1.0, 1.0);
    return x;
  }
  AdmissibleAlignments mirrored() {
    return AdmissibleAlignments::mirrored(random_.reflection(), problem.group);
  }
  AdmissibleAlignments pinned() { return AdmissibleAlignments::pinned(random_.alignment()); }
  static AdmissibleAlignments onGrain(double tolerance) {
    AdmissibleAlignments admissible;
    admissible.restrictAngles({0.4, 0.4 - kPi}, tolerance);
    return admissible;
  }

  MatchProblem problem;
  Component component;

 private:
  Random random_;
};

/// Runs the search until the answer is proven or the budget is spent.
void run(LowerBound& search, double budget) {
  while (search.spent() < budget && search.step()) {
  }
}

/// The least cost of many random alignments, half of them refined.
double leastOfMany(Made& made, int count) {
  const SampledSeams<double> edges(made.problem, 0);
  std::vector<int> all(made.problem.leaders.size());
  std::iota(all.begin(), all.end(), 0);
  double least = 1e9;
  for (int k = 0; k < count; ++k) {
    Alignments at = made.somewhere();
    if (k % 2 == 0) refine(made.problem, edges, at, all, 10);
    least = std::min(least, made.problem.cost(at));
  }
  return least;
}

/// The bound in per cent of the least cost of many alignments, which it must not exceed.
double checkedShare(Made& made, double budget) {
  LowerBound search(made.problem, made.component, made.somewhere());
  run(search, budget);
  const double least = std::min(search.cost(), leastOfMany(made, testing::cases(1000, 3000)));
  EXPECT_NEAR(search.cost(), made.problem.cost(search.best()), 1e-6);
  EXPECT_LE(search.bound(), least * (1 + 1e-9));
  if (search.proven()) {
    EXPECT_LE(search.cost(), least * (1 + 2e-3));
  }
  return 100 * search.bound() / least;
}

class LowerBoundIn : public ::testing::TestWithParam<const char*> {};
class LowerBoundInMirrors : public LowerBoundIn {};

std::string nameOf(const ::testing::TestParamInfo<const char*>& test) { return test.param; }
INSTANTIATE_TEST_SUITE_P(Groups, LowerBoundIn,
                         ::testing::ValuesIn(testing::sampleOf<const char*>(
                             2, {"pgg", "p31m", "p1", "cm", "p4m", "p2", "pm", "p4", "p6m"})),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(
    Groups, LowerBoundInMirrors,
    ::testing::ValuesIn(testing::sampleOf<const char*>(2, {"pm", "p31m", "cmm", "p4m", "p3m1", "cm",
                                                           "pmm", "pmg", "p4g", "p6m"})),
    nameOf);

TEST_P(LowerBoundIn, SaysOfASeamWhatNoAlignmentInTwoBoxesFallsBelow) {
  for (const bool own : {false, true}) {
    Made made(GetParam(), 9);
    made.piece(AdmissibleAlignments::anywhere()), made.piece(AdmissibleAlignments::anywhere());
    made.seam(0, own ? 0 : 1, 7);
    const SeamBound bound(made.problem, made.problem.seams[0]);
    const Boxes of_a(made.problem, 0);
    double spent = 0;
    int positive = 0, sloping = 0;
    const int pairs = testing::cases(1000, 4000);
    for (int k = 0; k < pairs; ++k) {
      const Box a = made.box(), b = own ? a : made.box();
      const SeamBound::Pair pair = bound.between(a, of_a.reach(), b, of_a.reach(), spent);
      positive += pair.least > 0;
      sloping += pair.least > 0 && pair.middle - pair.steepness() > 0.999 * pair.least;
      for (int sample = 0; sample < 20; ++sample) {
        const std::array<double, 3> x = made.within(), y = own ? x : made.within();
        const auto in = [&](const Box& box, const std::array<double, 3>& at, int leader) {
          return moved(box.at, made.problem.leaders[leader].centre, at[0] * box.turn,
                       at[1] * box.half[0] + at[2] * box.half[1]);
        };
        const double cost = made.problem.cost({in(a, x, 0), in(b, y, own ? 0 : 1)});
        double sloped = pair.middle;
        for (int i = 0; i < 3; ++i) sloped += pair.slope[i] * x[i] + pair.slope[3 + i] * y[i];
        EXPECT_GE(cost, pair.least);
        EXPECT_GE(cost, sloped);
      }
    }
    EXPECT_GT(positive, pairs / 10) << "it could not fail";
    EXPECT_GT(sloping, pairs / 20) << "it could not fail";
    EXPECT_GT(spent, 0);
  }
}

TEST_P(LowerBoundIn, IsNeverAboveTheCostOfPiecesThatAllMeet) {
  Made made(GetParam(), 10);  // all four with each other: too many for exact elimination
  for (int k = 0; k < 4; ++k) made.piece(made.onGrain(0));
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < a; ++b) made.seam(a, b, 3);
  made.seam(2, 2, 2);
  EXPECT_GE(checkedShare(made, 3e7), 0);
}

TEST_P(LowerBoundIn, IsNeverAboveTheCostOfAFreePieceBesideAPinnedOne) {
  Made made(GetParam(), 1);
  made.piece(made.pinned()), made.piece(AdmissibleAlignments::anywhere());
  made.seam(0, 1, 4), made.seam(1, 0, 3);
  EXPECT_GT(checkedShare(made, 2e7), 20);
}

TEST_P(LowerBoundIn, IsNeverAboveTheCostOfASeamOfAPieceWithItself) {
  for (const bool reversing : {false, true}) {
    Made made(GetParam(), 2);
    made.problem.continuous_only = reversing && made.problem.group.carriesPair();
    made.piece(AdmissibleAlignments::anywhere());
    made.seam(0, 0, 5, made.problem.continuous_only);
    EXPECT_GT(checkedShare(made, 1e7), 20);
  }
}

TEST_P(LowerBoundIn, IsNeverAboveTheCostOfTwoFreePieces) {
  Made made(GetParam(), 3);
  made.piece(AdmissibleAlignments::anywhere()), made.piece(AdmissibleAlignments::anywhere());
  made.seam(0, 1, 6), made.seam(0, 0, 3);
  EXPECT_GE(checkedShare(made, 2e6), 0);
}

TEST_P(LowerBoundIn, IsNeverAboveTheCostOfPiecesOnGrain) {
  Made made(GetParam(), 4);
  made.piece(made.onGrain(0)), made.piece(made.onGrain(0));
  made.seam(0, 1, 5);
  EXPECT_GT(checkedShare(made, 1e8), 20);
}

TEST_P(LowerBoundIn, IsNeverAboveTheCostOfAPieceNearGrain) {
  Made made(GetParam(), 4);
  made.piece(made.pinned()), made.piece(made.onGrain(0.05));
  made.seam(0, 1, 5);
  EXPECT_GT(checkedShare(made, 1e7), 90);
}

TEST_P(LowerBoundInMirrors, ProvesTwoMirroredPieces) {
  Made made(GetParam(), 5);
  made.piece(made.mirrored()), made.piece(made.mirrored());
  made.seam(0, 1, 4), made.seam(1, 0, 5);
  LowerBound search(made.problem, made.component, made.somewhere());
  run(search, 1e8);
  EXPECT_TRUE(search.proven());
  EXPECT_GT(search.cost(), 1) << "it could not fail";
  const double least = leastOfMany(made, testing::cases(2000, 20000));
  EXPECT_LE(search.bound(), least * (1 + 1e-9));
  EXPECT_LE(search.cost(), least * (1 + 2e-3));
}

TEST_P(LowerBoundInMirrors, AddsUpOverPairsOfPieces) {
  Made made(GetParam(), 6);
  for (int k = 0; k < 3; ++k) made.piece(made.mirrored());
  made.seam(0, 1, 4), made.seam(1, 2, 4), made.seam(2, 2, 2);
  EXPECT_GT(checkedShare(made, 1e7), 50);
}

TEST(LowerBound, LeavesABadAnswerForTheBest) {
  Made made("pmm", 7);
  made.piece(made.mirrored()), made.piece(made.mirrored());
  made.seam(0, 1, 6);
  Alignments worst = made.somewhere();
  for (int k = 0; k < 1000; ++k) {
    const Alignments at = made.somewhere();
    if (made.problem.cost(at) > made.problem.cost(worst)) worst = at;
  }
  LowerBound search(made.problem, made.component, worst);
  EXPECT_NEAR(search.cost(), made.problem.cost(worst), 1e-9);
  run(search, 1e8);
  EXPECT_TRUE(search.proven());
  EXPECT_LT(search.cost(), 0.8 * made.problem.cost(worst));
  EXPECT_NEAR(search.cost(), made.problem.cost(search.best()), 1e-6);
}

TEST(LowerBound, GrowsStepByStepAndAlwaysTheSame) {
  const auto bounds = [] {
    Made made("p4m", 8);
    made.piece(made.mirrored()), made.piece(made.mirrored()),
        made.piece(AdmissibleAlignments::anywhere());
    made.seam(0, 1, 6), made.seam(1, 2, 6), made.seam(2, 2, 4);
    LowerBound search(made.problem, made.component, made.somewhere());
    std::vector<double> out;
    double before = 0;
    while (search.spent() < 3e6 && search.step()) {
      const double share = search.bound() / search.cost();
      EXPECT_GE(share, before - 1e-12);
      EXPECT_LE(share, 1);
      before = share;
      out.push_back(search.bound());
    }
    EXPECT_FALSE(search.proven()) << "the budget ended it";
    EXPECT_LT(search.spent(), 3.5e6);
    return out;
  };
  EXPECT_EQ(bounds(), bounds());
}

}  // namespace
}  // namespace seamwise
