#include "methods/metrics.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "methods/seam_rules.h"
#include "tuning/shaping.h"

namespace seamwise {
namespace {

constexpr double kStrictTurn = 0.1;  ///< rad

double strictMismatch(const WallpaperGroup& group, const Seam& seam, const Shapes& shapes,
                      const std::vector<Alignment>& at) {
  const SeamMidpoints m = seamMidpoints(seam, shapes, at);
  const auto& elements = group.elements();
  const Mat2 ra = rotation(-at[seam.a.piece].angle), rb = rotation(-at[seam.b.piece].angle);
  double total = 0;
  std::vector<double> turn(elements.size());
  for (std::size_t i = 0; i < m.x.size(); ++i) {
    const auto &a = shapes[seam.a.piece], &b = shapes[seam.b.piece];
    const Vec2 da = ra * (a[seam.a.vertices[i + 1]] - a[seam.a.vertices[i]]);
    const Vec2 db = rb * (b[seam.b.vertices[i + 1]] - b[seam.b.vertices[i]]);
    for (std::size_t k = 0; k < elements.size(); ++k) {
      const Vec2 v = elements[k].A * db;
      turn[k] = std::abs(turnBetween(da, v));
    }
    const double least = *std::min_element(turn.begin(), turn.end());
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (turn[k] <= least + kStrictTurn)
        best = std::min(best, group.reduce(m.x[i] - elements[k](m.y[i])).norm());
    total += m.length[i] * best;
  }
  return total;
}

/// Sum of weight times length times mismatch over the counted seams. [cm2]
template <class WeightOf>
double weighedMismatch(const WallpaperGroup& group, const Pattern& pattern, const Shapes& shapes,
                       const std::vector<Alignment>& at, WeightOf weight_of) {
  double total = 0;
  for (const Seam& seam : pattern.seams) {
    if (!counts(seam)) continue;
    const double weight = weight_of(seam);
    const SeamMidpoints m = seamMidpoints(seam, shapes, at);
    for (std::size_t i = 0; i < m.x.size(); ++i)
      total += weight * (m.length[i] * group.distance(m.x[i], m.y[i]));
  }
  return total;
}

}  // namespace

double totalMismatch(const WallpaperGroup& group, const Pattern& pattern, const Shapes& shapes,
                     const std::vector<Alignment>& at) {
  return weighedMismatch(group, pattern, shapes, at, [](const Seam&) { return 1.0; });
}

double unmatchedCost(const WallpaperGroup& group, const Pattern& pattern, const Shapes& shapes,
                     const std::vector<Alignment>& at) {
  double total = 0;
  const std::vector<double> lengths = seamLengths(pattern, shapes);
  for (std::size_t s = 0; s < lengths.size(); ++s) {
    const Seam& seam = pattern.seams[s];
    if (canMatch(seam))
      total += ShapingTuning::kUnmatchedCost * seam.visibility * lengths[s] *
               unmatched(offShare(group, seam, shapes, at));
  }
  return total;
}

double answerCost(const WallpaperGroup& group, const Pattern& pattern, const Shapes& shapes,
                  const std::vector<Alignment>& at) {
  return weighedMismatch(group, pattern, shapes, at, costWeight) +
         unmatchedCost(group, pattern, shapes, at);
}

TotalMismatch measureTotal(const WallpaperGroup& group, const Pattern& pattern,
                           const Shapes& shapes, const std::vector<Alignment>& at) {
  TotalMismatch total;
  total.nearest = totalMismatch(group, pattern, shapes, at);
  for (const Seam& seam : pattern.seams) {
    if (!counts(seam)) continue;
    total.strict += strictMismatch(group, seam, shapes, at);
    total.joined += bestJoin(group, seam, shapes, at).cost;
  }
  return total;
}

std::vector<std::vector<Alignment>> randomAlignments(const WallpaperGroup& group,
                                                     std::size_t pieces) {
  constexpr int kDraws = 60;
  std::uint32_t state = 12345;
  auto draw = [&] {
    state = state * 1664525u + 1013904223u;
    return static_cast<double>(state) / 4294967296.0;
  };
  const double cell = group.w1().norm() + group.w2().norm();
  std::vector<std::vector<Alignment>> draws(kDraws, std::vector<Alignment>(pieces));
  for (auto& at : draws)
    for (Alignment& a : at) {
      a.angle = draw() * 2 * kPi;
      a.translation.x() = draw() * cell;
      a.translation.y() = draw() * cell;
    }
  return draws;
}

double randomMismatch(const WallpaperGroup& group, const Pattern& pattern, const Shapes& shapes) {
  const auto draws = randomAlignments(group, pattern.pieces.size());
  double total = 0;
  for (const auto& at : draws) total += totalMismatch(group, pattern, shapes, at);
  return total / static_cast<double>(draws.size());
}

double greatestMovement(const Pattern& pattern, const Shapes& shapes) {
  double greatest = 0;
  for (std::size_t p = 0; p < shapes.size(); ++p) {
    const Piece& piece = pattern.pieces[p];
    std::vector<int> rim;
    for (const auto& loop : loopsOf(piece)) rim.insert(rim.end(), loop.begin(), loop.end());
    Vec2 c0 = Vec2::Zero(), c1 = Vec2::Zero();
    for (int v : rim) c0 += piece.rest[v], c1 += shapes[p][v];
    c0 /= static_cast<double>(rim.size()), c1 /= static_cast<double>(rim.size());
    double dot = 0, turn = 0, as_it_lies = 0, fitted = 0;
    for (int v : rim) {
      dot += (piece.rest[v] - c0).dot(shapes[p][v] - c1);
      turn += cross(piece.rest[v] - c0, shapes[p][v] - c1);
    }
    const Mat2 r = rotation(std::atan2(turn, dot));
    for (int v : rim) {
      as_it_lies = std::max(as_it_lies, (shapes[p][v] - piece.rest[v]).norm());
      fitted = std::max(fitted, (shapes[p][v] - c1 - r * (piece.rest[v] - c0)).norm());
    }
    greatest = std::max(greatest, std::min(as_it_lies, fitted));
  }
  return greatest;
}

}  // namespace seamwise
