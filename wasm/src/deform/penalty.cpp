#include "deform/penalty.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "tuning/paper.h"

namespace seamwise {
PenaltyDeformation::PenaltyDeformation(const Pattern& pattern, bool with_symmetry)
    : pattern_(pattern) {
  int count = 0;
  for (const Piece& piece : pattern.pieces) {
    first_.push_back(count);
    count += static_cast<int>(piece.rest.size());
  }
  rest_.resize(2 * count);
  std::vector<std::pair<int, int>> pairs;
  auto couple = [&](const auto& vertices) {
    for (int a : vertices)
      for (int b : vertices)
        for (int i = 0; i < 4; ++i) pairs.emplace_back(2 * a + i / 2, 2 * b + i % 2);
  };
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
    const Piece& piece = pattern.pieces[p];
    for (std::size_t v = 0; v < piece.rest.size(); ++v)
      rest_.segment<2>(2 * (first_[p] + static_cast<int>(v))) = piece.rest[v];
    for (const auto& t : piece.triangles) {
      const std::array<int, 3> global{first_[p] + t[0], first_[p] + t[1], first_[p] + t[2]};
      triangles_.push_back(
          conformalTriangle(global, piece.rest[t[0]], piece.rest[t[1]], piece.rest[t[2]]));
      couple(global);
    }
  }
  std::set<std::array<int, 4>> seen;  // a dart on its own mirror line lists the same pair twice
  for (const Seam& s : pattern.seams) {
    for (std::size_t i = 0; i + 1 < s.a.vertices.size(); ++i) {
      const int fa = first_[s.a.piece], fb = first_[s.b.piece];
      const EdgePair e{fa + s.a.vertices[i], fa + s.a.vertices[i + 1], fb + s.b.vertices[i],
                       fb + s.b.vertices[i + 1], s.length_ratio};
      if (!seen.insert({e.a0, e.a1, e.b0, e.b1}).second) continue;
      edges_.push_back(e);
      couple(std::array<int, 4>{e.a0, e.a1, e.b0, e.b1});
    }
  }
  if (with_symmetry) {
    for (const Mirror& m : pattern.mirrors) {
      const Piece& piece = pattern.pieces[m.pieces[0]];
      for (const std::vector<int>& loop : loopsOf(piece)) {
        for (int v : loop) {
          if (m.single() && m.image[v] < v) continue;
          mirrors_.push_back({first_[m.pieces[0]] + v, first_[m.pieces[1]] + m.image[v],
                              m.map.linear(), m.map.shift});
          couple(std::array<int, 2>{mirrors_.back().source, mirrors_.back().image});
        }
      }
    }
  }
  hessian_ = SparseHessian(2 * count, pairs);
  x_ = rest_;
}

void PenaltyDeformation::start(std::vector<Target> targets, double alpha, double share) {
  targets_ = std::move(targets);
  for (Target& t : targets_) {
    const Vec2 rest = rest_.segment<2>(2 * t.vertex);
    t.position = rest + share * (t.position - rest);
  }
  alpha_ = alpha;
  gamma_ = 1;
  x_ = rest_;
  iterations_ = at_this_gamma_ = gammas_ = 0;
}

void PenaltyDeformation::stiffen(double alpha) {
  alpha_ = alpha;
  at_this_gamma_ = 0;
}

double PenaltyDeformation::energy(const VectorX& x, VectorX* gradient,
                                  SparseHessian* hessian) const {
  return proximityEnergy(targets_, x, gradient, hessian) +
         conformalEnergy(triangles_, x, alpha_, gradient, hessian) +
         flipEnergy(triangles_, x, PaperTuning::kFlipWeight, gradient, hessian) +
         matchEnergy(edges_, x, gamma_, gradient, hessian) +
         symmetryEnergy(mirrors_, x, gamma_, gradient, hessian);
}

bool PenaltyDeformation::step() {
  VectorX gradient = VectorX::Zero(x_.size());
  hessian_.setZero();
  const double before = energy(x_, &gradient, &hessian_);
  // Motions that no term determines, such as those of a piece whose seams do not count, stay zero.
  for (int i = 0; i < hessian_.size(); ++i) hessian_.add(i, i, 1e-8);
  ++iterations_, ++at_this_gamma_;
  bool converged = true;
  if (hessian_.factorise()) {
    const VectorX direction = -hessian_.solve(gradient);
    const double slope = gradient.dot(direction);
    double scale = 1;
    for (int halving = 0; halving < 30; ++halving, scale /= 2) {
      const VectorX trial = x_ + scale * direction;
      const double after = energy(trial, nullptr, nullptr);
      if (!(after <= before + 1e-4 * scale * slope)) continue;
      x_ = trial;
      converged = scale * direction.lpNorm<Eigen::Infinity>() < PaperTuning::kNewtonStill;
      break;
    }
  }
  if (!converged && at_this_gamma_ < PaperTuning::kMostNewton) return true;
  at_this_gamma_ = 0;
  ++gammas_;
  const double vertices = static_cast<double>(x_.size()) / 2;
  const double match = matchEnergy(edges_, x_, 1, nullptr, nullptr) / vertices;
  const double symmetry = symmetryEnergy(mirrors_, x_, 1, nullptr, nullptr) / vertices;
  // means over many vertices may hide a seam that cannot be sewn, or a vertex off its image
  if (match < PaperTuning::kSatisfied && symmetry < PaperTuning::kSatisfied &&
      greatestSeamError() < PaperTuning::kSeamError &&
      greatestMirrorError() < PaperTuning::kMirrorError)
    return false;
  gamma_ *= 2;
  return gamma_ <= PaperTuning::kMostGamma;
}

double PenaltyDeformation::greatestSeamError() const {
  double greatest = 0;
  const auto length = [&](const SeamSide& side) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < side.vertices.size(); ++i)
      sum += (point(side.piece, side.vertices[i + 1]) - point(side.piece, side.vertices[i])).norm();
    return sum;
  };
  for (const Seam& s : pattern_.seams)
    greatest = std::max(greatest, std::abs(length(s.a) - s.length_ratio * length(s.b)));
  return greatest;
}

double PenaltyDeformation::greatestMirrorError() const {
  double greatest = 0;
  for (const MirrorPair& m : mirrors_)
    greatest = std::max(
        greatest,
        (m.linear * x_.segment<2>(2 * m.source) + m.shift - x_.segment<2>(2 * m.image)).norm());
  return greatest;
}

Vec2 PenaltyDeformation::point(int piece, int vertex) const {
  return x_.segment<2>(2 * (first_[piece] + vertex));
}

Shapes PenaltyDeformation::shapes() const {
  Shapes shapes = restShapes(pattern_);
  for (std::size_t p = 0; p < shapes.size(); ++p)
    for (std::size_t v = 0; v < shapes[p].size(); ++v)
      shapes[p][v] = point(static_cast<int>(p), static_cast<int>(v));
  return shapes;
}

}  // namespace seamwise
