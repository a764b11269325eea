#include "alignment/icp/normal_equations.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>

#include "base/random.h"

namespace seamwise {
namespace {

TEST(NormalEquations, AreSolvedAsDenseOnes) {
  Random random(3);
  for (const int n : {1, 2, 7, 40}) {
    std::vector<int> first;
    for (int i = 0; i < n; ++i) first.push_back(std::max(0, i - random.below(6)));
    // a sum of squares of differences, like that of seams, so that no row reaches before its first
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd right(n);
    NormalEquations equations(first);
    for (int i = 0; i < n; ++i) {
      right[i] = equations.right[i] = random.uniform() - 0.5;
      for (int j = first[i]; j < i; ++j) {
        const double w = random.uniform();
        dense(i, i) += w, dense(j, j) += w, dense(i, j) -= w, dense(j, i) -= w;
      }
      dense(i, i) += 0.1;
    }
    double work = 0;
    for (int i = 0; i < n; ++i) {
      work += (i - first[i]) * (i - first[i]) / 2.0;
      for (int j = first[i]; j <= i; ++j) equations.at(i, j) = dense(i, j);
    }
    EXPECT_EQ(equations.work(), work);
    ASSERT_TRUE(equations.solve());
    const Eigen::VectorXd solution = dense.llt().solve(right);
    for (int i = 0; i < n; ++i) EXPECT_NEAR(equations.right[i], solution[i], 1e-6);
  }
}

TEST(NormalEquations, SayWhenTheyHaveNoSolution) {
  NormalEquations equations({0, 0});
  equations.at(0, 0) = 1, equations.at(1, 0) = 2, equations.at(1, 1) = 1;
  EXPECT_FALSE(equations.solve());
  equations.clear();
  equations.at(0, 0) = equations.at(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(equations.solve());
}

}  // namespace
}  // namespace seamwise
