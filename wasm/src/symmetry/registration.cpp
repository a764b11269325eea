#include "symmetry/registration.h"

#include <algorithm>
#include <limits>

#include "symmetry/symmetry.h"
#include "tuning/symmetry.h"

namespace seamwise {
namespace {

constexpr double kIcpSettled = 1e-9;   // cm; ICP stops when no point moves further
constexpr double kUpright = 1e-9;      // rad
constexpr double kExactCorner = 1e-6;  // cm; coordinates in files carry at least this many digits

// Stride for subsampling `count` items. It is 1 below twice the wanted number.
std::size_t strideFor(std::size_t count) {
  return std::max<std::size_t>(1, count / SymmetryTuning::kSettlingSamples);
}

struct CornerPairs {
  std::vector<Vec2> from, to;
  std::vector<double> distance;
};

// Pairs of corners that are nearest to each other under the map. Large numbers of corners are
// subsampled.
CornerPairs pairCorners(const Outline& a, const Outline& b, const RigidMotion& map, double gate) {
  const RigidMotion back = map.inverse();
  CornerPairs pairs;
  for (std::size_t i = 0; i < a.corners().size(); i += strideFor(a.corners().size())) {
    const Vec2 image = map(a.corners()[i]);
    const Vec2& corner = b.corners()[b.nearestCorner(image)];
    const double d = (corner - image).norm();
    if (d > gate || a.nearestCorner(back(corner)) != static_cast<int>(i)) continue;
    pairs.from.push_back(a.corners()[i]);
    pairs.to.push_back(corner);
    pairs.distance.push_back(d);
  }
  return pairs;
}

// True if the points are far enough apart to determine the angle of the closed form.
bool spread(const std::vector<Vec2>& points) {
  Vec2 low = points.front(), high = points.front();
  for (const Vec2& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm() > 1.0;
}

// Solves the closed form on corresponding corners with a shrinking gate. A corner on one side only
// (an edge split on the left, whole on the right) must not spoil a map that is exact everywhere
// else. So pairs far beyond the median are dropped if the others agree exactly.
RigidMotion polishOnCorners(const Outline& a, const Outline& b, RigidMotion map, double gate) {
  const bool single = &a == &b;
  for (; gate > kMirrorTolerance; gate /= 3) {
    const CornerPairs pairs = pairCorners(a, b, map, gate);
    if (pairs.from.size() < 2 || !spread(pairs.from)) return map;
    map = leastSquaresMirror(pairs.from, pairs.to, single);
  }
  RigidMotion trimmed = map;
  for (int round = 0; round < 12; ++round) {
    const CornerPairs pairs = pairCorners(a, b, trimmed, 2 * kMirrorTolerance);
    if (pairs.from.size() < 2) return map;
    std::vector<double> sorted = pairs.distance;
    std::sort(sorted.begin(), sorted.end());
    const double limit = std::max(kExactCorner, 1.5 * sorted[sorted.size() / 2]);
    std::vector<Vec2> from, to;
    for (std::size_t i = 0; i < pairs.from.size(); ++i)
      if (pairs.distance[i] <= limit) {
        from.push_back(pairs.from[i]);
        to.push_back(pairs.to[i]);
      }
    if (from.size() < 2 || !spread(from)) return map;
    const RigidMotion next = leastSquaresMirror(from, to, single);
    if (limit == kExactCorner)
      return 2 * from.size() * strideFor(a.corners().size()) >= a.corners().size() ? next : map;
    if (next == trimmed) break;  // further rounds would not change it
    trimmed = next;
  }
  return map;
}

/// Iterates closest points from `map`.
/// @param stride   distance of the samples used, as a number of samples
/// @return the map, and the root mean square of the distances before its last step
std::pair<RigidMotion, double> closestPoints(const Outline& a, const Outline& b, RigidMotion map,
                                             std::size_t stride) {
  const bool single = &a == &b;
  std::vector<Vec2> from;
  for (std::size_t i = 0; i < a.samples().size(); i += stride) from.push_back(a.samples()[i]);
  std::vector<Vec2> to(from.size());
  double before = std::numeric_limits<double>::infinity();
  for (int k = 0; k < SymmetryTuning::kMostIterations; ++k) {
    double sum = 0;
    const Mat2 linear = map.linear();
    for (std::size_t i = 0; i < to.size(); ++i) {
      const OutlinePoint foot = b.nearest(linear * from[i] + map.shift);
      to[i] = foot.point;
      sum += foot.distance * foot.distance;
    }
    // The mean never increases. If it stalls above the limit, the greatest distance stays above it,
    // too.
    const double rms = std::sqrt(sum / static_cast<double>(to.size()));
    const bool stalled = rms > kMirrorTolerance && rms > SymmetryTuning::kStalled * before;
    before = rms;
    if (stalled) break;
    const RigidMotion next = leastSquaresMirror(from, to, single);
    const double moved = std::abs(wrapAngle(next.angle - map.angle)) * a.length() +
                         (next(a.corners()[0]) - map(a.corners()[0])).norm();
    map = next;
    if (moved < kIcpSettled) break;
  }
  return {map, before};
}

}  // namespace

RigidMotion leastSquaresMirror(const std::vector<Vec2>& p, const std::vector<Vec2>& q,
                               bool single) {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  for (std::size_t i = 0; i < p.size(); ++i) {
    from += p[i];
    to += q[i];
  }
  from /= static_cast<double>(p.size());
  to /= static_cast<double>(p.size());
  // Adding every pair in reverse makes the least-squares solution a reflection.
  if (single) from = to = (from + to) / 2;
  double re = 0, im = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 u = p[i] - from, v = q[i] - to;
    re += u.x() * v.x() - u.y() * v.y();
    im += u.x() * v.y() + u.y() * v.x();
  }
  double angle = std::atan2(-im, -re);
  const double quarters = std::round(angle / (kPi / 2));
  if (std::abs(angle - quarters * kPi / 2) < kUpright) angle = wrapAngle(quarters * kPi / 2);
  RigidMotion map{angle, Vec2::Zero(), true};
  map.shift = to - map(from);
  return single ? withoutGlide(map) : map;
}

RigidMotion withoutGlide(RigidMotion motion) {
  // R(a) F preserves the direction (a - pi) / 2 and reverses the one at a / 2.
  const Vec2 normal = unit(motion.angle / 2);
  motion.shift = normal * normal.dot(motion.shift);
  return motion;
}

double mirrorResidual(const Outline& a, const Outline& b, const RigidMotion& map, double enough) {
  double worst = 0;
  const auto measure = [&](const Outline& from, const Outline& to, const RigidMotion& motion) {
    const Mat2 linear = motion.linear();
    for (const Vec2& p : from.samples()) {
      worst = std::max(worst, to.nearest(linear * p + motion.shift).distance);
      if (worst > enough) return;
    }
  };
  measure(a, b, map);
  if (&a != &b && worst <= enough) measure(b, a, map.inverse());
  return worst;
}

MirrorRegistration registerMirror(const Outline& a, const Outline& b, const RigidMotion& start,
                                  double enough) {
  const double gate = a.length() / Outline::kEven;
  const RigidMotion begin = &a == &b ? withoutGlide(start) : start;
  const auto measured = [&](const RigidMotion& map) {
    return MirrorRegistration{map, mirrorResidual(a, b, map, std::max(enough, gate))};
  };
  MirrorRegistration direct = measured(polishOnCorners(a, b, begin, gate));
  if (direct.residual <= 2 * Outline::kFlatness) return direct;
  const RigidMotion near = direct.residual < gate ? direct.map : begin;
  const std::size_t samples = a.samples().size();
  if (enough < kFarApart &&
      closestPoints(a, b, near,
                    std::max(SymmetryTuning::kTrialStride, samples / SymmetryTuning::kTrialSamples))
              .second > SymmetryTuning::kPruned * enough)
    return direct;
  MirrorRegistration settled = measured(closestPoints(a, b, near, strideFor(samples)).first);
  MirrorRegistration polished = measured(polishOnCorners(a, b, settled.map, 2 * kMirrorTolerance));
  // Prefer corners if their residual is not larger by more than the flattening error.
  if (polished.residual <= settled.residual + Outline::kFlatness &&
      polished.residual <= direct.residual)
    return polished;
  return direct.residual <= settled.residual + Outline::kFlatness ? direct : settled;
}

}  // namespace seamwise
