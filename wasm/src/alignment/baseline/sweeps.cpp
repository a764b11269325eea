#include "alignment/baseline/sweeps.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <utility>

#include "tuning/paper.h"

namespace seamwise {
namespace {

/// Points and directions of a seam, as seen from one of its sides.
struct View {
  int other;
  const std::vector<Vec2>&mine, &theirs, &my_direction, &their_direction;
};

View viewFrom(const MatchSeam& seam, bool from_a) {
  if (from_a) return {seam.b, seam.pa, seam.pb, seam.da, seam.db};
  return {seam.a, seam.pb, seam.pa, seam.db, seam.da};
}

Alignments randomStart(const MatchProblem& problem, std::uint64_t seed) {
  Random random(seed);
  Alignments at;
  for (const Leader& leader : problem.leaders) {
    const double angle = 2 * kPi * random.uniform();
    const double along = random.uniform(), up = random.uniform();
    const Vec2 print = problem.group.w1() * along + problem.group.w2() * up;
    const Alignment any{wrapAngle(angle), leader.centre - rotation(angle) * print};
    at.push_back(leader.admissible.nearest(any, leader.centre));
  }
  return at;
}

}  // namespace

LocalSweeps::LocalSweeps(const MatchProblem& problem, std::uint64_t seed)
    : LocalSweeps(problem, randomStart(problem, seed)) {}

LocalSweeps::LocalSweeps(const MatchProblem& problem, Alignments start)
    : problem_(problem), at_(std::move(start)) {}

double LocalSweeps::turn(int l) {
  const Leader& leader = problem_.leaders[l];
  const double before = at_[l].angle;
  Vec2 sum = unit(before) * 1e-9;
  for (int s : leader.seams) {
    const MatchSeam& seam = problem_.seams[s];
    for (bool from_a : {true, false}) {
      if ((from_a ? seam.a : seam.b) != l || (!from_a && seam.a == seam.b)) continue;
      const View view = viewFrom(seam, from_a);
      for (std::size_t i = 0; i < seam.w.size(); ++i) {
        const double mine = directionOf(view.my_direction[i]);
        double wanted = 0, least = std::numeric_limits<double>::infinity();
        for (const Element& e : problem_.group.elements()) {
          if (!problem_.allows(seam, e)) continue;
          double angle;
          if (view.other == l) {
            // The angle cancels under a rotation. A reflection requires its axis along the
            // bisector.
            if (!e.mirrored) continue;
            angle = (mine + directionOf(view.their_direction[i])) / 2 - e.angle / 2;
            if (std::abs(wrapAngle(angle - before)) > kPi / 2) angle += kPi;
          } else {
            const Vec2 other = rotation(-at_[view.other].angle) * view.their_direction[i];
            angle = mine - directionOf(e.A * other);
          }
          const double off = std::abs(wrapAngle(angle - before));
          if (off < least) least = off, wanted = angle;
        }
        if (std::isfinite(least)) sum += seam.w[i] * unit(wanted);
      }
    }
  }
  at_[l] = leader.admissible.nearest(
      moved(at_[l], leader.centre, wrapAngle(directionOf(sum) - before), Vec2::Zero()),
      leader.centre);
  return std::abs(wrapAngle(at_[l].angle - before));
}

double LocalSweeps::shift(int l) {
  const Leader& leader = problem_.leaders[l];
  Vec2 sum = Vec2::Zero();
  double weight = 0;
  const Mat2 r = rotation(-at_[l].angle);
  for (int s : leader.seams) {
    const MatchSeam& seam = problem_.seams[s];
    for (bool from_a : {true, false}) {
      if ((from_a ? seam.a : seam.b) != l || (!from_a && seam.a == seam.b)) continue;
      const View view = viewFrom(seam, from_a);
      const Alignment& other = at_[view.other];
      const Mat2 ro = rotation(-other.angle);
      for (std::size_t i = 0; i < seam.w.size(); ++i) {
        const Vec2 x = at_[l].toPrint(view.mine[i]), y = other.toPrint(view.theirs[i]);
        const Vec2 dx = r * view.my_direction[i], dy = ro * view.their_direction[i];
        double least_turn = std::numeric_limits<double>::infinity();
        for (const Element& e : problem_.group.elements())
          if (problem_.allows(seam, e))
            least_turn =
                std::min(least_turn, std::abs(wrapAngle(directionOf(e.A * dy) - directionOf(dx))));
        Vec2 step = Vec2::Zero();
        double least = std::numeric_limits<double>::infinity();
        for (const Element& e : problem_.group.elements()) {
          if (!problem_.allows(seam, e)) continue;
          if (std::abs(wrapAngle(directionOf(e.A * dy) - directionOf(dx))) >
              least_turn + PaperTuning::kSameTurn)
            continue;
          const Vec2 residual = problem_.group.reduce(x - e(y));
          if (residual.norm() >= least) continue;
          least = residual.norm();
          step = -residual;
          if (view.other == l) {
            // Both sides move, so solve (I - A) step = -residual as far as possible.
            const Mat2 both = Mat2::Identity() - e.A;
            if (e.mirrored)
              step = -both * residual / 4;  // I - A = 2 n n^T
            else if (std::abs(both.determinant()) > 1e-9)
              step = -both.inverse() * residual;
            else
              step.setZero();
          }
        }
        if (std::isfinite(least)) sum += seam.w[i] * step;
        weight += seam.w[i];
      }
    }
  }
  if (weight <= 0) return 0;
  const Vec2 before = at_[l].translation;
  at_[l] = leader.admissible.nearest(moved(at_[l], leader.centre, 0, sum / weight), leader.centre);
  return (at_[l].translation - before).norm();
}

bool LocalSweeps::step() {
  double change = 0;
  for (std::size_t l = 0; l < at_.size(); ++l) {
    if (problem_.leaders[l].admissible.isPinned()) continue;
    const int leader = static_cast<int>(l);
    change = std::max(change, turning_ ? turn(leader) : shift(leader));
  }
  ++sweeps_;
  const bool ended =
      change < PaperTuning::kSweepStill || ++of_this_kind_ >= PaperTuning::kMostSweeps;
  if (!ended) return true;
  if (!turning_) return false;
  turning_ = false;
  of_this_kind_ = 0;
  return true;
}

}  // namespace seamwise
