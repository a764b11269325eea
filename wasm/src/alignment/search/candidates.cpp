#include "alignment/search/candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tuning/search.h"

namespace seamwise {
namespace {

/// The alignment that brings a stretch of a piece's seam best onto `image` of its placed
/// neighbour's side (weighted Procrustes), moved to the nearest one that is admissible for the
/// piece.
Alignment onto(const AdmissibleAlignments& admissible, const Stretch& stretch, bool from_a,
               const Alignment& other, const Element& image) {
  const Vec2 &mine = from_a ? stretch.mean_a : stretch.mean_b,
             &theirs = from_a ? stretch.mean_b : stretch.mean_a;
  const Mat2 covariance = from_a ? stretch.covariance : Mat2(stretch.covariance.transpose());
  const Mat2 linear = image.A * rotation(-other.angle);
  const double dot = linear.cwiseProduct(covariance).sum();
  const double cross = linear.row(1).dot(covariance.row(0)) - linear.row(0).dot(covariance.row(1));
  const Vec2 print = linear * (theirs - other.translation) + image.a;
  const double angle = -std::atan2(cross, dot);
  return admissible.nearest({angle, mine - rotation(angle) * print}, mine);
}

void addForMirrored(const MatchProblem& problem, int l, std::vector<Alignment>& out) {
  const Leader& leader = problem.leaders[l];
  for (const AdmissibleAlignments::Place& place : leader.admissible.places()) {
    const int slides = std::clamp(static_cast<int>(place.period), SearchTuning::kFewestSlides,
                                  SearchTuning::kMostSlides);
    for (int k = 0; k < slides; ++k)
      out.push_back(leader.admissible.onPlace(place, leader.centre, place.period * k / slides));
  }
}

/// A random stretch, from one edge to half of the seam.
Stretch randomStretch(const MatchSeam& seam, Random& random) {
  const int edges = static_cast<int>(seam.w.size());
  const int size = 1 + random.below(1 + edges / 2), first = random.below(edges - size + 1);
  return seam.stretch(first, first + size);
}

/// Puts two random edges of a piece's seam on images of their partners that are about as far apart.
/// The print of a gathered or eased seam may still meet wherever the sides cross its repeats in
/// step.
std::optional<Alignment> inStep(const MatchProblem& problem, const AdmissibleAlignments& admissible,
                                const MatchSeam& seam, bool from_a, const Alignment& other,
                                Random& random) {
  const int edges = static_cast<int>(seam.w.size());
  if (edges < 2) return std::nullopt;
  const int i = random.below(edges - 1), j = i + 1 + random.below(edges - 1 - i);
  const auto &mine = from_a ? seam.pa : seam.pb, &theirs = from_a ? seam.pb : seam.pa;
  const Vec2 along = mine[j] - mine[i];
  const double apart = along.norm(), theirs_apart = (theirs[j] - theirs[i]).norm();
  if (std::abs(apart - theirs_apart) < SearchTuning::kEased * std::max(apart, theirs_apart))
    return std::nullopt;
  const auto& elements = problem.group.elements();
  const int count = static_cast<int>(elements.size());
  const Element &e = elements[random.below(count)], &f = elements[random.below(count)];
  if (!problem.allows(seam, e) || !problem.allows(seam, f)) return std::nullopt;
  const Vec2 from = e(other.toPrint(theirs[i])), to = f(other.toPrint(theirs[j]));
  Vec2 best = Vec2::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < SearchTuning::kDirections; ++k) {
    const double angle = 2 * kPi * random.uniform();
    const Vec2 wanted = apart * Vec2(std::cos(angle), std::sin(angle));
    const Vec2 step = wanted - problem.group.reduce(from + wanted - to);
    const double off = std::abs(step.norm() - apart);
    if (off < least) least = off, best = step;
  }
  const double turn = turnBetween(along, best);
  const Vec2 middle = (mine[i] + mine[j]) / 2;
  return admissible.nearest({wrapAngle(-turn), middle - rotation(-turn) * (from + best / 2)},
                            middle);
}

}  // namespace

std::vector<Alignment> candidates(const MatchProblem& problem, int l, const Alignments& at,
                                  const std::vector<char>& placed, int stretches, Random& random) {
  std::vector<Alignment> out;
  const Leader& leader = problem.leaders[l];
  if (leader.admissible.isPinned()) return {leader.admissible.nearest({}, leader.centre)};
  if (leader.admissible.isMirrored()) addForMirrored(problem, l, out);
  const auto& elements = problem.group.elements();
  for (int s : leader.seams) {
    const MatchSeam& seam = problem.seams[s];
    const int other = seam.a == l ? seam.b : seam.a;
    if (other == l || !placed[other]) continue;
    for (int k = 0; k <= stretches; ++k) {
      const Stretch part = k == 0 ? seam.whole : randomStretch(seam, random);
      bool seen[2] = {false, false};
      for (const Element& e : elements) {
        if (!problem.allows(seam, e)) continue;
        // Elements of one orientation differ by a rotation of the print. They put the same print on
        // the piece, unless its angle is bound.
        if (leader.admissible.mayRotate() && seen[e.mirrored]) continue;
        seen[e.mirrored] = true;
        out.push_back(onto(leader.admissible, part, seam.a == l, at[other], e));
      }
      if (k > 0)
        if (auto stepped = inStep(problem, leader.admissible, seam, seam.a == l, at[other], random))
          out.push_back(*stepped);
    }
  }
  return out;
}

Alignment randomAlignment(const MatchProblem& problem, int l, Random& random) {
  const Leader& leader = problem.leaders[l];
  if (leader.admissible.isMirrored()) {
    const auto& places = leader.admissible.places();
    const auto& place = places[random.below(static_cast<int>(places.size()))];
    return leader.admissible.onPlace(place, leader.centre, place.period * random.uniform());
  }
  const double along = random.uniform(), up = random.uniform();
  const Vec2 print = problem.group.w1() * along + problem.group.w2() * up;
  double angle = 2 * kPi * random.uniform();
  if (random.uniform() < 0.5) {
    // The axis of the seam that joins the piece to itself, on a mirrored element's axis.
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
  return leader.admissible.nearest(any, leader.centre);
}

}  // namespace seamwise
