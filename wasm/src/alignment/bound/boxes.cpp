#include "alignment/bound/boxes.h"

#include <Eigen/LU>
#include <cmath>

namespace seamwise {

Boxes::Boxes(const MatchProblem& problem, int leader) : problem_(problem), leader_(leader) {
  const auto& [piece, admissible, centre, seams] = problem.leaders[leader];
  double weight = 0;
  for (const int s : seams) {
    const MatchSeam& seam = problem.seams[s];
    for (std::size_t i = 0; i < seam.w.size(); ++i) {
      if (seam.a == leader) reach_ += seam.w[i] * (seam.pa[i] - centre).norm();
      if (seam.b == leader) reach_ += seam.w[i] * (seam.pb[i] - centre).norm();
    }
    weight += seam.weight * ((seam.a == leader) + (seam.b == leader));
  }
  reach_ /= weight;
}

std::vector<Box> Boxes::all(bool first) const {
  const auto& [piece, admissible, centre, seams] = problem_.leaders[leader_];
  if (admissible.isPinned()) return {{admissible.nearest({0, centre}, centre)}};
  if (admissible.isMirrored()) return onMirrors(first);
  if (!admissible.mayRotate()) {
    std::vector<Box> boxes;
    for (const double angle : admissible.angles())
      boxes.push_back({admissible.nearest({angle, centre}, centre), 0, cell(first)});
    return boxes;
  }
  // A turn of the piece by a rotation of the print does not change its print.
  int rotations = 0;
  for (const Element& e : problem_.group.elements()) rotations += !e.mirrored;
  return {{{0, centre}, admissible.angles().empty() ? kPi / rotations : kPi, cell(first)}};
}

/// Returns whether the shift, applied to both points, changes no distance modulo the group.
bool Boxes::neutral(const Vec2& shift) const {
  const auto& elements = problem_.group.elements();
  return std::all_of(elements.begin(), elements.end(), [&](const Element& e) {
    return problem_.group.reduce(e.A * shift - shift).norm() < 1e-9;
  });
}

/// Half the sides of a cell of shifts.
std::array<Vec2, 2> Boxes::cell(bool first) const {
  const auto& [r1, r2] = problem_.group.reducedBasis();
  std::array<Vec2, 2> half{r1 / 2, r2 / 2};
  if (!first) return half;
  // The shifts that no element changes: all of them, one direction or none.
  Mat2 kept = Mat2::Zero();
  for (const Element& e : problem_.group.elements()) kept += e.A;
  kept /= static_cast<double>(problem_.group.elements().size());
  if (kept.trace() > 1.5) return {Vec2::Zero(), Vec2::Zero()};
  if (kept.trace() > 0.5) {
    const Mat2 basis = (Mat2() << r1, r2).finished();
    const Vec2 along = basis.inverse() * kept.col(kept(0, 0) > kept(1, 1) ? 0 : 1);
    half[std::abs(along.x()) > std::abs(along.y()) ? 0 : 1].setZero();
    return half;
  }
  if (neutral(r1 / 2) || neutral((r1 + r2) / 2)) half[0] /= 2;
  if (neutral(r2 / 2)) half[1] /= 2;
  return half;
}

std::vector<Box> Boxes::onMirrors(bool first) const {
  const Leader& leader = problem_.leaders[leader_];
  const auto& repeats = problem_.group.reducedBasis();
  const Vec2 shifts[3] = {repeats[0] / 2, repeats[1] / 2, (repeats[0] + repeats[1]) / 2};
  std::vector<AdmissibleAlignments::Place> taken;
  std::vector<Box> boxes;
  for (const AdmissibleAlignments::Place& place : leader.admissible.places()) {
    const auto reached = [&](const AdmissibleAlignments::Place& other) {
      if ((place.along - other.along).norm() > 1e-9) return false;
      for (const Vec2& shift : shifts) {
        const double lines =
            perp(place.along).dot(other.on_line + shift - place.on_line) / place.spacing;
        if (neutral(shift) && std::abs(lines - std::round(lines)) < 1e-9) return true;
      }
      return false;
    };
    if (first && std::any_of(taken.begin(), taken.end(), reached)) continue;
    taken.push_back(place);
    Vec2 half = place.along * (place.period / 2);
    // A hundredth is not in the lattice, so all shifts along the line are neutral.
    if (first && neutral(half / 100))
      half.setZero();
    else if (first && neutral(half))
      half /= 2;
    boxes.push_back({leader.admissible.onPlace(place, leader.centre, 0), 0, {half, Vec2::Zero()}});
  }
  return boxes;
}

std::vector<HalfBox> Boxes::halves(const Box& box) const {
  const Leader& leader = problem_.leaders[leader_];
  const double sides[3] = {box.turn * reach_, box.half[0].norm(), box.half[1].norm()};
  const int widest = static_cast<int>(std::max_element(sides, sides + 3) - sides);
  std::vector<HalfBox> halves;
  if (sides[widest] <= 0) return halves;
  for (const int sign : {-1, 1}) {
    Box half = box;
    if (widest > 0) {
      half.half[widest - 1] /= 2;
      half.at = moved(box.at, leader.centre, 0, sign * half.half[widest - 1]);
    } else {
      half.turn /= 2;
      half.at = moved(box.at, leader.centre, sign * half.turn, Vec2::Zero());
      const double admissible = leader.admissible.nearest(half.at, leader.centre).angle;
      if (std::abs(wrapAngle(admissible - half.at.angle)) > half.turn + 1e-9) continue;
    }
    halves.push_back({half, widest, sign});
  }
  return halves;
}

}  // namespace seamwise
