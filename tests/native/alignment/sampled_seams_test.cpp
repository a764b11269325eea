#include "alignment/model/sampled_seams.h"

#include <gtest/gtest.h>

#include "support/cut_layout.h"
#include "support/meshed_samples.h"
#include "tuning/search.h"

namespace seamwise {
namespace {

using testing::matchProblem;
using testing::meshedPattern;
using testing::Random;
using testing::randomLeaders;
using testing::sampleGroup;

/// Every group, on a tee with random alignments.
class SampledSeamsIn : public ::testing::TestWithParam<const char*> {
 protected:
  WallpaperGroup group_ = sampleGroup(*findGroup(GetParam()), 0.3);
  Pattern pattern_ = meshedPattern(small::tee(1.5), false);
  MatchProblem problem_ = matchProblem(pattern_, group_);
  Random random_{3};

  template <class Real>
  double total(const SampledSeams<Real>& seams, const Alignments& at, double slack = 0) {
    double sum = 0;
    for (std::size_t s = 0; s < problem_.seams.size(); ++s) {
      const int a = problem_.seams[s].a, b = problem_.seams[s].b;
      sum += seams.cost(static_cast<int>(s), seams.pose(a, at[a]), seams.pose(b, at[b]), slack);
    }
    return sum;
  }
};

INSTANTIATE_TEST_SUITE_P(All, SampledSeamsIn,
                         ::testing::Values("p1", "p2", "pm", "pg", "cm", "pmm", "pmg", "pgg", "cmm",
                                           "p4", "p4m", "p4g", "p3", "p3m1", "p31m", "p6", "p6m"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(SampledSeamsIn, CostWhatTheProblemCosts) {
  const SampledSeams<double> exact(problem_, 0);
  const SampledSeams<float> quick(problem_, 0);
  for (int k = 0; k < 20; ++k) {
    const Alignments at = randomLeaders(problem_, random_);
    const double cost = problem_.cost(at);
    EXPECT_NEAR(total(exact, at), cost, 1e-9 * cost);
    EXPECT_NEAR(total(quick, at), cost, 1e-5 * cost);
  }
}

/// The same cost by trying every element and many lattice vectors, in print space.
double costUnderSlack(const MatchProblem& problem, const MatchSeam& seam, const Alignments& at,
                      double slack) {
  std::vector<Vec2> x, y;
  Vec2 mean_x = Vec2::Zero(), mean_y = Vec2::Zero();
  double unshaped = 0;
  for (std::size_t k = 0; k < seam.w.size(); ++k) {
    x.push_back(at[seam.a].toPrint(seam.pa[k])), y.push_back(at[seam.b].toPrint(seam.pb[k]));
    mean_x += seam.w[k] / seam.weight * x[k], mean_y += seam.w[k] / seam.weight * y[k];
    unshaped += seam.w[k] * problem.group.distance(x[k], y[k]);
  }
  double least = std::numeric_limits<double>::max(), within = 0, beyond = 0;
  for (const Element& e : problem.group.elements()) {
    const Vec2 mean = mean_x - (e.A * mean_y + e.a), lattice = mean - problem.group.reduce(mean);
    double squares = 0, all = 0, excess = 0;
    for (std::size_t k = 0; k < seam.w.size(); ++k) {
      const double r = (x[k] - (e.A * y[k] + e.a + lattice)).norm();
      squares += seam.w[k] * r * r, all += seam.w[k] * r;
      excess += seam.w[k] * std::max(0.0, r - slack);
    }
    if (squares < least) least = squares, within = all, beyond = excess;
  }
  if (least > 4 * slack * slack * seam.weight) return unshaped;
  const double shaped = beyond + 0.1 * within;
  return beyond == 0 ? shaped : std::min(shaped, unshaped);
}

TEST_P(SampledSeamsIn, UnderSlackFollowOneElementAlongASeamOrMeetPointByPoint) {
  const SampledSeams<double> exact(problem_, 0);
  const SampledSeams<float> quick(problem_, 0);
  int fewer = 0;
  for (const double slack : {0.3, 1.5, 4.0, 1000.0}) {
    for (int k = 0; k < 10; ++k) {
      const Alignments at = randomLeaders(problem_, random_);
      double cost = 0;
      for (const MatchSeam& seam : problem_.seams)
        cost += costUnderSlack(problem_, seam, at, slack);
      EXPECT_NEAR(total(exact, at, slack), cost, 1e-9 * cost);
      EXPECT_NEAR(total(quick, at, slack), cost, 1e-3 * cost);
      fewer += cost < 0.99 * problem_.cost(at);
    }
  }
  EXPECT_GT(fewer, 10);
}

TEST_P(SampledSeamsIn, CountSeveralTimesWhatExceedsALimit) {
  const Alignments at = randomLeaders(problem_, random_);
  const double free = total(SampledSeams<double>(problem_, 0), at);
  const auto limited = [&](double limit, double slack) {
    for (MatchSeam& seam : problem_.seams) seam.limit = limit;
    return total(SampledSeams<double>(problem_, 0), at, slack);
  };
  EXPECT_EQ(limited(1000, 0), free);
  EXPECT_GT(limited(0.1, 0), 3 * free);
  EXPECT_LT(limited(0.1, 1000), limited(0.1, 0)) << "as shaping is likely to leave less";
}

TEST_P(SampledSeamsIn, StandForTheWholeSeamWithFewSamples) {
  const SampledSeams<double> all(problem_, 0), few(problem_, 3);
  EXPECT_NEAR(few.weight(), all.weight(), 1e-9);
  int fewer = 0;
  for (std::size_t s = 0; s < problem_.seams.size(); ++s) {
    EXPECT_GE(few.count(static_cast<int>(s)), 1);
    fewer += all.count(static_cast<int>(s)) - few.count(static_cast<int>(s));
  }
  EXPECT_GT(fewer, 0);
}

/// Central differences of the cost with respect to a leader's turn and shift.
TEST_P(SampledSeamsIn, HaveTheGradientOfTheirCost) {
  constexpr double kStep = 1e-6;
  const SampledSeams<double> exact(problem_, 0);
  const SampledSeams<float> quick(problem_, 0);
  int equal = 0, unequal = 0;
  for (const double slack : {0.0, 0.0, 2.0, 2.0}) {
    const Alignments at = randomLeaders(problem_, random_);
    for (std::size_t k = 0; k < problem_.seams.size(); ++k) {
      const int s = static_cast<int>(k), a = problem_.seams[k].a, b = problem_.seams[k].b;
      if (a == b) continue;
      const auto model = exact.model(s, exact.pose(a, at[a]), exact.pose(b, at[b]), slack);
      const auto rough = quick.model(s, quick.pose(a, at[a]), quick.pose(b, at[b]), slack);
      const double size = model.gradient.norm();
      EXPECT_LT((rough.gradient - model.gradient).norm(), 1e-3 * size);
      for (int i = 0; i < 6; ++i) {
        double cost[2];
        for (int side : {0, 1}) {
          const double d = side ? kStep : -kStep;
          const int l = i < 3 ? a : b;
          const auto pose =
              exact.pose(l, moved(at[l], problem_.leaders[l].centre, i % 3 == 0 ? d : 0,
                                  Vec2(i % 3 == 1 ? d : 0, i % 3 == 2 ? d : 0)));
          cost[side] = exact.cost(s, i < 3 ? pose : exact.pose(a, at[a]),
                                  i < 3 ? exact.pose(b, at[b]) : pose, slack);
        }
        const double difference = (cost[1] - cost[0]) / (2 * kStep) - model.gradient[i];
        ++(std::abs(difference) < 1e-3 * size + 1e-4 ? equal : unequal);
      }
    }
  }
  // They may differ where a sample's element changes or its distance is below the model's floor.
  EXPECT_GT(equal, 50);
  EXPECT_LT(unequal, equal / 20);
}

/// The sum of J^T J over the edges, with weights 1/d, of the distances to the nearest elements.
TEST_P(SampledSeamsIn, HaveTheHessianOfTheirSquaredDistances) {
  constexpr double kStep = 1e-5;
  const SampledSeams<double> exact(problem_, 0);
  const Alignments at = randomLeaders(problem_, random_);
  for (std::size_t s = 0; s < problem_.seams.size(); ++s) {
    const MatchSeam& seam = problem_.seams[s];
    if (seam.a == seam.b) continue;
    Eigen::Matrix<double, 6, 6> expected = Eigen::Matrix<double, 6, 6>::Zero();
    for (std::size_t k = 0; k < seam.w.size(); ++k) {
      const Vec2 x = at[seam.a].toPrint(seam.pa[k]), y = at[seam.b].toPrint(seam.pb[k]);
      Element nearest;
      double least = std::numeric_limits<double>::max();
      for (const Element& e : group_.elements())
        if (const double d = group_.reduce(x - e(y)).norm(); d < least) least = d, nearest = e;
      Eigen::Matrix<double, 2, 6> slopes;
      for (int i = 0; i < 6; ++i) {
        const int l = i < 3 ? seam.a : seam.b;
        const Vec2& p = i < 3 ? seam.pa[k] : seam.pb[k];
        const auto movedBy = [&](double d) {
          return moved(at[l], problem_.leaders[l].centre, i % 3 == 0 ? d : 0,
                       Vec2(i % 3 == 1 ? d : 0, i % 3 == 2 ? d : 0))
              .toPrint(p);
        };
        const Vec2 slope = (movedBy(kStep) - movedBy(-kStep)) / (2 * kStep);
        slopes.col(i) = i < 3 ? slope : Vec2(-nearest.A * slope);
      }
      expected +=
          seam.w[k] / std::max(least, SearchTuning::kLeastDistance) * slopes.transpose() * slopes;
    }
    const auto hessian = exact
                             .model(static_cast<int>(s), exact.pose(seam.a, at[seam.a]),
                                    exact.pose(seam.b, at[seam.b]), 0)
                             .hessian;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j <= i; ++j)
        EXPECT_NEAR(hessian(i, j), expected(i, j), 1e-6 * expected.norm()) << i << ' ' << j;
  }
}

}  // namespace
}  // namespace seamwise
