#include "alignment/candidates.h"

#include <algorithm>
#include <cmath>

namespace seamwise {
namespace {

struct Sums {
  Vec2 mean_x = Vec2::Zero(), mean_y = Vec2::Zero();
  double dot = 0, cross = 0;  ///< of centred y against centred x
};

/// Weighted moments for Procrustes of x onto y.
Sums sums(const std::vector<Vec2>& x, const std::vector<Vec2>& y, const std::vector<double>& w) {
  Sums s;
  double total = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    s.mean_x += w[i] * x[i], s.mean_y += w[i] * y[i], total += w[i];
  }
  s.mean_x /= total, s.mean_y /= total;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const Vec2 u = x[i] - s.mean_x, v = y[i] - s.mean_y;
    s.dot += w[i] * u.dot(v), s.cross += w[i] * seamwise::cross(u, v);
  }
  return s;
}

/// The alignment that brings piece points x (given by their moments) onto print points y.
Alignment onto(const Sums& s) {
  const double angle = -std::atan2(s.cross, s.dot);
  return {angle, s.mean_x - rotation(angle) * s.mean_y};
}

void addForMirrored(const MatchProblem& problem, int l, std::vector<Alignment>& out) {
  const Leader& leader = problem.leaders[l];
  for (const Freedom::Place& place : leader.freedom.places()) {
    const int slides = std::clamp(static_cast<int>(place.period), 5, 12);
    for (int k = 0; k < slides; ++k)
      out.push_back(leader.freedom.onPlace(place, leader.centre, place.period * k / slides));
  }
}

}  // namespace

std::vector<Alignment> candidates(const MatchProblem& problem, int l, const Alignments& at,
                                  const std::vector<char>& placed) {
  std::vector<Alignment> out;
  const Leader& leader = problem.leaders[l];
  if (leader.freedom.isPinned()) return {leader.freedom.nearest({}, leader.centre)};
  if (leader.freedom.isMirrored()) {
    addForMirrored(problem, l, out);
    return out;
  }
  const auto& elements = problem.group.elements();
  for (int s : leader.seams) {
    const MatchSeam& seam = problem.seams[s];
    const int other = seam.a == l ? seam.b : seam.a;
    if (other == l || !placed[other]) continue;
    const auto& mine = seam.a == l ? seam.pa : seam.pb;
    std::vector<Vec2> theirs = seam.a == l ? seam.pb : seam.pa;
    const Mat2 r = rotation(-at[other].angle);
    for (Vec2& p : theirs) p = r * (p - at[other].translation);
    bool seen[2] = {false, false};
    std::vector<Vec2> image(theirs.size());
    for (const Element& e : elements) {
      if (!problem.allows(seam, e)) continue;
      // Elements of one orientation differ by a rotation of the print: the same print on the piece,
      // unless its angle is bound.
      if (leader.freedom.turns() && seen[e.mirrored]) continue;
      seen[e.mirrored] = true;
      for (std::size_t i = 0; i < theirs.size(); ++i) image[i] = e(theirs[i]);
      const Sums moments = sums(mine, image, seam.w);
      Alignment fit = onto(moments);
      const Alignment kept = leader.freedom.nearest(fit, moments.mean_x);
      fit.angle = kept.angle;
      fit.translation = moments.mean_x - rotation(fit.angle) * moments.mean_y;
      out.push_back(fit);
    }
  }
  return out;
}

Alignment randomAlignment(const MatchProblem& problem, int l, Random& random) {
  const Leader& leader = problem.leaders[l];
  if (leader.freedom.isMirrored()) {
    const auto& places = leader.freedom.places();
    const auto& place = places[random.below(static_cast<int>(places.size()))];
    return leader.freedom.onPlace(place, leader.centre, place.period * random.uniform());
  }
  const Vec2 print = problem.group.w1() * random.uniform() + problem.group.w2() * random.uniform();
  double angle = 2 * kPi * random.uniform();
  if (random.uniform() < 0.5) {
    // axis of the seam that joins the piece to itself, on a mirrored element's axis
    for (int s : leader.seams) {
      const MatchSeam& seam = problem.seams[s];
      if (seam.a != seam.b) continue;
      double c = 0, d = 0;
      for (std::size_t i = 0; i + 1 < seam.w.size(); ++i) {
        const Vec2 u = seam.pa[i + 1] - seam.pa[i], v = seam.pb[i + 1] - seam.pb[i];
        c += u.x() * v.x() - u.y() * v.y(), d += u.x() * v.y() + u.y() * v.x();
      }
      const double sum = std::atan2(d, c);  // theta + theta'
      std::vector<double> axes;
      for (const Element& e : problem.group.elements())
        if (e.mirrored && problem.allows(seam, e)) axes.push_back(e.angle / 2);
      if (axes.empty()) break;
      const double axis = axes[random.below(static_cast<int>(axes.size()))];
      angle = sum / 2 - axis + (random.uniform() < 0.5 ? kPi : 0);
      break;
    }
  }
  const Alignment any{wrapAngle(angle), leader.centre - rotation(angle) * print};
  return leader.freedom.nearest(any, leader.centre);
}

}  // namespace seamwise
