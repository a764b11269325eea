#include <algorithm>
#include <limits>

#include "symmetry/registration.h"
#include "symmetry/symmetry.h"
#include "tuning/symmetry.h"

namespace seamwise {
namespace {

constexpr double kSettled = 1e-10;  // cm

Polyline sampled(const Curve& curve, int steps) {
  Polyline points(steps + 1);
  for (int k = 0; k <= steps; ++k) points[k] = curve.atFraction(double(k) / steps);
  return points;
}

/// Number of steps that resolves the shape of both curves.
int stepsAlong(const Curve& first, const Curve& second, int least) {
  return std::max(first.stepsAlong(least), second.stepsAlong(least));
}

Vec2 nearestOn(const Polyline& line, const Vec2& p) {
  Vec2 best = line.front();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 step = line[i + 1] - line[i];
    const double square = step.squaredNorm();
    const double t = square > 0 ? std::clamp((p - line[i]).dot(step) / square, 0.0, 1.0) : 0.0;
    const Vec2 foot = line[i] + t * step;
    if ((foot - p).squaredNorm() < (best - p).squaredNorm()) best = foot;
  }
  return best;
}

}  // namespace

RigidMotion registerEdges(const Curve& first, const Curve& second) {
  // The shorter edge is mapped onto the longer. A reflection is its own inverse.
  const bool swapped = first.length() > second.length();
  const int steps = stepsAlong(first, second, SymmetryTuning::kEdgeSamples);
  const Polyline from = sampled(swapped ? second : first, steps);
  Polyline to = sampled(swapped ? first : second, steps);
  const Polyline target = (swapped ? first : second).flattened(Outline::kFlatness);
  // Outlines run counter-clockwise, so mirrored edges run against each other.
  std::reverse(to.begin(), to.end());
  RigidMotion map = leastSquaresMirror(from, to, false);
  for (int k = 0; k < SymmetryTuning::kMostEdgeIterations; ++k) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = nearestOn(target, map(from[i]));
    const RigidMotion next = leastSquaresMirror(from, to, false);
    const double moved = (next(from.front()) - map(from.front())).norm() +
                         (next(from.back()) - map(from.back())).norm();
    map = next;
    if (moved < kSettled) break;
  }
  return withoutGlide(map);
}

double edgeResidual(const Curve& first, const Curve& second, const RigidMotion& map) {
  const bool swapped = first.length() > second.length();
  const RigidMotion motion = swapped ? map.inverse() : map;
  const Polyline target = (swapped ? first : second).flattened(Outline::kFlatness);
  double worst = 0;
  const int steps = stepsAlong(first, second, SymmetryTuning::kEdgeSamples);
  for (const Vec2& p : sampled(swapped ? second : first, steps)) {
    const Vec2 image = motion(p);
    worst = std::max(worst, (nearestOn(target, image) - image).norm());
  }
  return worst;
}

double edgewiseResidual(const Panel& a, const Panel& b, const RigidMotion& map) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const std::size_t n = a.edges.size();
  if (b.edges.size() != n || !a.holes.empty() || !b.holes.empty()) return kNone;
  double best = kNone;
  for (std::size_t shift = 0; shift < n; ++shift) {
    const auto image = [&](std::size_t k) -> const Curve& { return b.edges[(shift + n - k) % n]; };
    double worst = 0;
    for (std::size_t k = 0; k < n && worst <= kMirrorTolerance; ++k)
      worst = std::max(worst, (map(a.edges[k].start()) - image(k).end()).norm());
    for (std::size_t k = 0; k < n && worst <= kMirrorTolerance; ++k) {
      if (a.edges[k].straight() && image(k).straight()) continue;
      const int steps = stepsAlong(a.edges[k], image(k), SymmetryTuning::kCurveSamples);
      for (int i = 1; i < steps; ++i) {
        const double s = double(i) / steps;
        worst =
            std::max(worst, (map(a.edges[k].atFraction(s)) - image(k).atFraction(1 - s)).norm());
      }
    }
    if (worst <= kMirrorTolerance) best = std::min(best, worst);
  }
  return best;
}

}  // namespace seamwise
