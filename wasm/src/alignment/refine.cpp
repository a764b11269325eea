#include "alignment/refine.h"

#include <algorithm>
#include <cmath>

namespace seamwise {
namespace {

constexpr double kSlow = 1e-4;  ///< a relative gain below it ends the iteration

/// Adds one seam's model to the normal equations; `first` is the first unknown of a leader, -1 if
/// held.
template <class Model>
void assemble(const Model& model, const int sides[2], const std::vector<int>& first,
              const std::vector<Freedom::Basis>& bases, Eigen::MatrixXd& hessian,
              Eigen::VectorXd& gradient) {
  for (int i = 0; i < 2; ++i) {
    const int row = first[sides[i]];
    if (row < 0) continue;
    const auto& bi = bases[sides[i]];
    gradient.segment(row, bi.cols()) += bi.transpose() * model.gradient.template segment<3>(3 * i);
    for (int j = 0; j < 2; ++j) {
      const int column = first[sides[j]];
      if (column < 0) continue;
      const auto& bj = bases[sides[j]];
      Eigen::Matrix3d block =
          model.hessian.template block<3, 3>(3 * std::max(i, j), 3 * std::min(i, j));
      if (i == j)
        block.template triangularView<Eigen::StrictlyUpper>() = block.transpose();
      else if (i < j)
        block.transposeInPlace();
      hessian.block(row, column, bi.cols(), bj.cols()).noalias() += bi.transpose() * block * bj;
    }
  }
}

/// Solves h x = b for a positive definite h, of which the lower half is read, by Cholesky's method;
/// x replaces b, and h is lost. False when h is not positive definite. A handful of unknowns are not
/// worth the blocked routines of Eigen, which would be the largest piece of the whole module.
bool solveInPlace(Eigen::MatrixXd& h, Eigen::VectorXd& b) {
  const int n = static_cast<int>(b.size());
  for (int k = 0; k < n; ++k) {
    double* const pivot = &h(0, k);
    if (!(pivot[k] > 0)) return false;
    pivot[k] = std::sqrt(pivot[k]);
    for (int i = k + 1; i < n; ++i) pivot[i] /= pivot[k];
    for (int j = k + 1; j < n; ++j) {
      double* const column = &h(0, j);
      const double factor = pivot[j];
      for (int i = j; i < n; ++i) column[i] -= factor * pivot[i];
    }
    b[k] /= pivot[k];
    for (int i = k + 1; i < n; ++i) b[i] -= pivot[i] * b[k];
  }
  for (int k = n - 1; k >= 0; --k) {
    for (int i = k + 1; i < n; ++i) b[k] -= h(i, k) * b[i];
    b[k] /= h(k, k);
  }
  return true;
}

}  // namespace

template <class Real>
double refine(const MatchProblem& problem, const SampledSeams<Real>& samples, Alignments& at,
              const std::vector<int>& active, int iterations, double slack) {
  std::vector<int> first(problem.leaders.size(), -1);
  std::vector<Freedom::Basis> bases(problem.leaders.size());
  std::vector<int> seams;
  int unknowns = 0;
  for (int l : active) {
    bases[l] = problem.leaders[l].freedom.basis(at[l]);
    first[l] = unknowns;
    unknowns += static_cast<int>(bases[l].cols());
    for (int s : problem.leaders[l].seams) seams.push_back(s);
  }
  std::sort(seams.begin(), seams.end());
  seams.erase(std::unique(seams.begin(), seams.end()), seams.end());
  std::vector<typename SampledSeams<Real>::Pose> poses(problem.leaders.size());
  for (std::size_t l = 0; l < poses.size(); ++l)
    poses[l] = samples.pose(static_cast<int>(l), at[l]);
  auto total = [&](const auto& of) {
    double sum = 0;
    for (int s : seams)
      sum += samples.cost(s, of[problem.seams[s].a], of[problem.seams[s].b], slack);
    return sum;
  };
  double cost = total(poses);
  if (unknowns == 0) return cost;

  Eigen::MatrixXd hessian(unknowns, unknowns);
  Eigen::VectorXd gradient(unknowns);
  Alignments trial = at;
  auto trial_poses = poses;
  for (int k = 0; k < iterations && cost > 1e-9; ++k) {
    hessian.setZero(), gradient.setZero();
    for (int s : seams) {
      const int sides[2] = {problem.seams[s].a, problem.seams[s].b};
      assemble(samples.model(s, poses[sides[0]], poses[sides[1]], slack), sides, first, bases,
               hessian, gradient);
    }
    // what no seam determines stays where it is
    hessian.diagonal().array() += 1e-9 * hessian.diagonal().maxCoeff() + 1e-12;
    if (!solveInPlace(hessian, gradient) || !gradient.allFinite()) break;
    const Eigen::VectorXd& step = gradient;  // back along it
    double scale = 1, reached = cost;
    for (int halving = 0; halving < 4; ++halving, scale /= 3) {
      for (int l : active) {
        const Eigen::Vector3d d = bases[l] * (-scale * step.segment(first[l], bases[l].cols()));
        const Leader& leader = problem.leaders[l];
        trial[l] = moved(at[l], leader.centre, d.x(), d.tail<2>());
        if (leader.freedom.turns()) trial[l] = leader.freedom.nearest(trial[l], leader.centre);
        trial_poses[l] = samples.pose(l, trial[l]);
      }
      reached = total(trial_poses);
      if (reached < cost) break;
    }
    if (!(reached < cost)) break;
    const double gain = cost - reached;
    at.swap(trial), poses.swap(trial_poses);
    cost = reached;
    if (gain < kSlow * cost) break;
  }
  return cost;
}

template double refine(const MatchProblem&, const SampledSeams<float>&, Alignments&,
                       const std::vector<int>&, int, double);
template double refine(const MatchProblem&, const SampledSeams<double>&, Alignments&,
                       const std::vector<int>&, int, double);

}  // namespace seamwise
