#include "methods/seam_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tuning/shaping.h"

namespace seamwise {
double localMismatch(const WallpaperGroup& group, const Seam& seam, const Shapes& shapes,
                     const std::vector<Alignment>& at) {
  const SeamMidpoints m = seamMidpoints(seam, shapes, at);
  double total = 0, length = 0;
  for (std::size_t i = 0; i < m.x.size(); ++i) {
    total += m.length[i] * group.distance(m.x[i], m.y[i]);
    length += m.length[i];
  }
  return length > 0 ? total / length : 0;
}

double offShare(const WallpaperGroup& group, const Seam& seam, const Shapes& shapes,
                const std::vector<Alignment>& at) {
  const SeamMidpoints m = seamMidpoints(seam, shapes, at);
  double length = 0, off = 0;
  for (std::size_t i = 0; i < m.x.size(); ++i) {
    length += m.length[i];
    if (group.distance(m.x[i], m.y[i]) > ShapingTuning::kSeen) off += m.length[i];
  }
  return length > 0 ? off / length : 0;
}

std::vector<double> localMismatches(const WallpaperGroup& group, const Pattern& pattern,
                                    const Shapes& shapes, const std::vector<Alignment>& at) {
  std::vector<double> means(pattern.seams.size(), 0);
  for (std::size_t s = 0; s < means.size(); ++s)
    if (counts(pattern.seams[s])) means[s] = localMismatch(group, pattern.seams[s], shapes, at);
  return means;
}

std::vector<double> seamLengths(const Pattern& pattern, const Shapes& shapes) {
  std::vector<double> lengths(pattern.seams.size(), 0);
  const std::vector<Alignment> anywhere(pattern.pieces.size());
  for (std::size_t s = 0; s < lengths.size(); ++s)
    if (counts(pattern.seams[s]))
      for (const double length : seamMidpoints(pattern.seams[s], shapes, anywhere).length)
        lengths[s] += length;
  return lengths;
}

double meanMismatch(const std::vector<double>& mismatches, const std::vector<double>& lengths) {
  double total = 0, length = 0;
  for (std::size_t s = 0; s < lengths.size(); ++s)
    total += lengths[s] * mismatches[s], length += lengths[s];
  return length > 0 ? total / length : 0;
}

double costWeight(const Seam& seam) {
  if (seam.visibility <= 0) return 1;
  return isGathered(seam) ? ShapingTuning::kGatheredCost : seam.visibility;
}

double unmatched(double off) {
  const double t = std::min(1.0, off / ShapingTuning::kUnmatchedShare);
  return t * t * (3 - 2 * t);
}

double greatestMean(double placed, double visibility) {
  double met = ShapingTuning::kMet;
  if (visibility > 0) {
    if (placed > ShapingTuning::kLost) return std::numeric_limits<double>::infinity();
    if (visibility < ShapingTuning::kVisible) met = ShapingTuning::kSeen;
  }
  return std::max(met, placed + ShapingTuning::kUnseen);
}

double mismatchUnderRules(const Pattern& pattern, const std::vector<double>& mismatches,
                          const std::vector<double>& lengths, const std::vector<double>& placed) {
  double total = 0;
  for (std::size_t s = 0; s < lengths.size(); ++s) {
    const Seam& seam = pattern.seams[s];
    const double excess = std::max(0.0, mismatches[s] - greatestMean(placed[s], seam.visibility));
    total +=
        costWeight(seam) * (lengths[s] * (mismatches[s] + ShapingTuning::kBeyondLimit * excess));
  }
  return total;
}

Verdict verdictOn(const SeamMeans& means, double moved, double visibility) {
  const bool bent = moved > ShapingTuning::kStraight;
  const double most = means.shaped > ShapingTuning::kBroken ? ShapingTuning::kWorthwhileBroken
                      : visibility > 0                      ? ShapingTuning::kWorthwhileSeen
                                                            : ShapingTuning::kWorthwhile;
  if (bent && means.shaped > most * means.aligned) return Verdict::kInVain;
  if (means.shaped > greatestMean(std::min(means.placed, means.aligned), visibility))
    return Verdict::kWorse;
  return Verdict::kKept;
}

bool isWithinReach(const std::vector<double>& mismatch, double reach) {
  double left = 0;
  for (const double d : mismatch) left += std::max(0.0, d - 2 * reach);
  return left <= ShapingTuning::kBroken * static_cast<double>(mismatch.size());
}

double seamMovement(const Seam& seam, const Pattern& pattern, const Shapes& shapes) {
  double moved = 0;
  for (const SeamSide* side : {&seam.a, &seam.b})
    for (std::size_t k = 1; k + 1 < side->vertices.size(); ++k) {
      const int v = side->vertices[k];
      moved =
          std::max(moved, (shapes[side->piece][v] - pattern.pieces[side->piece].rest[v]).norm());
    }
  return moved;
}

double seamBend(const Seam& seam, const Pattern& pattern, const Shapes& shapes) {
  double bend = 0;
  for (const SeamSide* side : {&seam.a, &seam.b}) {
    const std::vector<Vec2>&rest = pattern.pieces[side->piece].rest, &shape = shapes[side->piece];
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
    for (const int v : side->vertices) from += rest[v], to += shape[v];
    const auto count = static_cast<double>(side->vertices.size());
    from /= count, to /= count;
    double dot = 0, turn = 0;
    for (const int v : side->vertices) {
      dot += (rest[v] - from).dot(shape[v] - to);
      turn += cross(rest[v] - from, shape[v] - to);
    }
    const Mat2 turned = rotation(std::atan2(turn, dot));
    for (std::size_t k = 1; k + 1 < side->vertices.size(); ++k) {
      const int v = side->vertices[k];
      bend = std::max(bend, (shape[v] - to - turned * (rest[v] - from)).norm());
    }
  }
  return bend;
}

}  // namespace seamwise
