#include "alignment/icp/refine.h"

#include <algorithm>
#include <utility>

#include "alignment/icp/normal_equations.h"
#include "tuning/search.h"

namespace seamwise {
namespace {

/// Adds one seam's model to the normal equations; `first` is the first unknown of a leader, -1 if
/// it is fixed.
template <class Model>
void assemble(const Model& model, const int sides[2], const std::vector<int>& first,
              const std::vector<AdmissibleAlignments::Basis>& bases, NormalEquations& equations) {
  for (int i = 0; i < 2; ++i) {
    const int row = first[sides[i]];
    if (row < 0) continue;
    const auto& bi = bases[sides[i]];
    const Eigen::Vector3d pull = model.gradient.template segment<3>(3 * i);
    for (int r = 0; r < bi.cols(); ++r) equations.right[row + r] += bi.col(r).dot(pull);
    for (int j = 0; j < 2; ++j) {
      const int column = first[sides[j]];
      if (column < 0 || column > row) continue;
      const auto& bj = bases[sides[j]];
      Eigen::Matrix3d block =
          model.hessian.template block<3, 3>(3 * std::max(i, j), 3 * std::min(i, j));
      if (i == j)
        block.template triangularView<Eigen::StrictlyUpper>() = block.transpose();
      else if (i < j)
        block.transposeInPlace();
      for (int r = 0; r < bi.cols(); ++r) {
        const Eigen::Vector3d left = block.transpose() * bi.col(r);
        for (int c = 0; c < bj.cols() && column + c <= row + r; ++c)
          equations.at(row + r, column + c) += left.dot(bj.col(c));
      }
    }
  }
}

}  // namespace

template <class Real>
double refine(const MatchProblem& problem, const SampledSeams<Real>& samples, Alignments& at,
              std::vector<int> active, int iterations, double slack, double* work) {
  std::sort(active.begin(), active.end(),
            [&](int l, int k) { return samples.rank(l) < samples.rank(k); });
  std::vector<int> first(problem.leaders.size(), -1);
  std::vector<AdmissibleAlignments::Basis> bases(problem.leaders.size());
  std::vector<int> seams, tied;
  for (int l : active) {
    bases[l] = problem.leaders[l].admissible.basis(at[l]);
    first[l] = static_cast<int>(tied.size());
    int least = first[l];
    for (int s : problem.leaders[l].seams) {
      seams.push_back(s);
      for (int k : {problem.seams[s].a, problem.seams[s].b})
        if (first[k] >= 0) least = std::min(least, first[k]);
    }
    tied.resize(tied.size() + bases[l].cols(), least);
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
  if (tied.empty()) return cost;

  NormalEquations equations(std::move(tied));
  const std::vector<double>& step = equations.right;  // the negative step, once solved
  Alignments trial = at;
  auto trial_poses = poses;
  for (int k = 0; k < iterations && cost > 1e-9; ++k) {
    equations.clear();
    for (int s : seams) {
      const int sides[2] = {problem.seams[s].a, problem.seams[s].b};
      assemble(samples.model(s, poses[sides[0]], poses[sides[1]], slack), sides, first, bases,
               equations);
    }
    if (work) *work += equations.work();
    if (!equations.solve()) break;
    double scale = 1, reached = cost;
    for (int halving = 0; halving < 4; ++halving, scale /= 3) {
      for (int l : active) {
        Eigen::Vector3d d = Eigen::Vector3d::Zero();
        for (int c = 0; c < bases[l].cols(); ++c) d -= scale * step[first[l] + c] * bases[l].col(c);
        const Leader& leader = problem.leaders[l];
        trial[l] = moved(at[l], leader.centre, d.x(), d.tail<2>());
        if (leader.admissible.mayRotate())
          trial[l] = leader.admissible.nearest(trial[l], leader.centre);
        trial_poses[l] = samples.pose(l, trial[l]);
      }
      reached = total(trial_poses);
      if (reached < cost) break;
    }
    if (!(reached < cost)) break;
    const double gain = cost - reached;
    at.swap(trial), poses.swap(trial_poses);
    cost = reached;
    if (gain < SearchTuning::kSlowGain * cost) break;
  }
  return cost;
}

template double refine(const MatchProblem&, const SampledSeams<float>&, Alignments&,
                       std::vector<int>, int, double, double*);
template double refine(const MatchProblem&, const SampledSeams<double>&, Alignments&,
                       std::vector<int>, int, double, double*);

}  // namespace seamwise
