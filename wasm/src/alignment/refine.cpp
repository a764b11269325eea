#include "alignment/refine.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace seamwise {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double kFloor = 0.02;  ///< cm: distances below it are weighted as if they were it

/// Normal equations of one seam in (turn, shift) of both sides: for the residual r = x - (A y + a + T),
/// the columns of its Jacobian are -perp(x - ca), I, A perp(y - cb), -A.
void accumulate(const MatchProblem& problem, const MatchSeam& seam, const Alignments& at,
                double slack, Matrix6& hessian, Vector6& gradient) {
  const Alignment &a = at[seam.a], &b = at[seam.b];
  const Mat2 ra = rotation(-a.angle), rb = rotation(-b.angle);
  const Vec2 ca = ra * (problem.leaders[seam.a].centre - a.translation);
  const Vec2 cb = rb * (problem.leaders[seam.b].centre - b.translation);
  for (std::size_t i = 0; i < seam.w.size(); ++i) {
    const Vec2 x = ra * (seam.pa[i] - a.translation), y = rb * (seam.pb[i] - b.translation);
    const auto nearest = problem.nearest(seam, x, y);
    const Mat2& A = problem.group.elements()[nearest.element].A;
    const Vec2& r = nearest.residual;
    const double d = r.norm();
    double pull = 1;
    if (slack > 0) pull = (d > slack ? 1 : 0) + MatchProblem::kLeak;
    const double w = seam.w[i] * pull / std::max(d, kFloor);
    const Vec2 ja = -perp(x - ca), jb = A * perp(y - cb);
    gradient[0] += w * ja.dot(r);
    gradient.segment<2>(1) += w * r;
    gradient[3] += w * jb.dot(r);
    gradient.segment<2>(4) -= w * (A.transpose() * r);
    hessian(0, 0) += w * ja.squaredNorm();
    hessian.block<2, 1>(1, 0) += w * ja;
    hessian(1, 1) += w, hessian(2, 2) += w;
    hessian(3, 0) += w * ja.dot(jb);
    hessian.block<1, 2>(3, 1) += w * jb.transpose();
    hessian(3, 3) += w * jb.squaredNorm();
    hessian.block<2, 1>(4, 0) -= w * (A.transpose() * ja);
    hessian.block<2, 2>(4, 1) -= w * A.transpose();
    hessian.block<2, 1>(4, 3) -= w * (A.transpose() * jb);
    hessian(4, 4) += w, hessian(5, 5) += w;
  }
  hessian.template triangularView<Eigen::StrictlyUpper>() = hessian.transpose();
}

}  // namespace

double refine(const MatchProblem& problem, Alignments& at, const std::vector<int>& active,
              int iterations, double slack) {
  std::vector<int> first(problem.leaders.size(), -1);  // first unknown of a leader
  std::vector<Eigen::Matrix<double, 3, Eigen::Dynamic>> bases(problem.leaders.size());
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
  std::vector<MatchProblem::Pose> poses(problem.leaders.size());
  for (int s : seams)
    for (int l : {problem.seams[s].a, problem.seams[s].b}) poses[l] = problem.pose(at[l]);
  auto costOf = [&](const Alignments& x) {
    for (int l : active) poses[l] = problem.pose(x[l]);
    double total = 0;
    for (int s : seams) {
      const MatchSeam& seam = problem.seams[s];
      total += problem.seamCost(seam, poses[seam.a], poses[seam.b], slack);
    }
    return total;
  };
  double cost = costOf(at);
  if (unknowns == 0) return cost;

  Eigen::MatrixXd hessian(unknowns, unknowns);
  Eigen::VectorXd gradient(unknowns);
  Alignments trial = at;
  for (int k = 0; k < iterations && cost > 1e-9; ++k) {
    hessian.setZero(), gradient.setZero();
    for (int s : seams) {
      const MatchSeam& seam = problem.seams[s];
      Matrix6 h = Matrix6::Zero();
      Vector6 g = Vector6::Zero();
      accumulate(problem, seam, at, slack, h, g);
      const int sides[2] = {seam.a, seam.b};
      for (int i = 0; i < 2; ++i) {
        if (first[sides[i]] < 0) continue;
        const auto& bi = bases[sides[i]];
        gradient.segment(first[sides[i]], bi.cols()) += bi.transpose() * g.segment<3>(3 * i);
        for (int j = 0; j < 2; ++j) {
          if (first[sides[j]] < 0) continue;
          const auto& bj = bases[sides[j]];
          hessian.block(first[sides[i]], first[sides[j]], bi.cols(), bj.cols()) +=
              bi.transpose() * h.block<3, 3>(3 * i, 3 * j) * bj;
        }
      }
    }
    // what no seam determines stays where it is
    hessian.diagonal().array() += 1e-9 * hessian.diagonal().maxCoeff() + 1e-12;
    const Eigen::VectorXd step = -hessian.ldlt().solve(gradient);
    if (!step.allFinite()) break;
    double scale = 1, reached = cost;
    for (int halving = 0; halving < 4; ++halving, scale /= 3) {
      for (int l : active) {
        const Eigen::Vector3d d =
            bases[l] * (scale * step.segment(first[l], bases[l].cols()));
        const Leader& leader = problem.leaders[l];
        trial[l] = moved(at[l], leader.centre, d.x(), d.tail<2>());
        if (leader.freedom.turns()) trial[l] = leader.freedom.nearest(trial[l], leader.centre);
      }
      reached = costOf(trial);
      if (reached < cost) break;
    }
    if (!(reached < cost)) break;
    const double gain = cost - reached;
    for (int l : active) at[l] = trial[l];
    cost = reached;
    if (gain < 1e-4 * cost) break;
  }
  return cost;
}

}  // namespace seamwise
