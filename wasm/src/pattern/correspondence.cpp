#include "pattern/correspondence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/sort_by.h"

namespace seamwise {
namespace {

using Anchor = Correspondence::Anchor;

constexpr double kLeastTolerance = 1e-3;  // cm; closer corners are identical
constexpr double kGreatestTolerance = 0.3;

/// Corners strictly between two positions, ascending, not wrapped.
std::vector<double> cornersBetween(const Loop& loop, double from, double to) {
  std::vector<double> found;
  const double turn = loop.length();
  for (double offset = std::floor(from / turn) * turn; offset < to; offset += turn)
    for (const double corner : loop.corners()) {
      const double p = corner + offset;
      if (p > from + 1e-9 && p < to - 1e-9) found.push_back(p);
    }
  return found;
}

/// Greatest distance from mapped corners and edge middles of `a` to loop `b`. [cm]
double deviation(const Loop& a, const Loop& b, const RigidMotion& map) {
  double worst = 0;
  const auto measure = [&](double p) {
    const Vec2 image = map(a.at(p));
    worst = std::max(worst, (b.at(b.nearest(image, 0, b.length())) - image).norm());
  };
  for (const double p : a.corners()) measure(p);
  for (int k = 0; k < a.edges(); ++k) measure((a.corner(k) + a.corner(k + 1)) / 2);
  return worst;
}

/// The factor exists because a sharp corner moves by more than its outline.
double toleranceFor(double worst) {
  return std::clamp(3 * worst, kLeastTolerance, kGreatestTolerance);
}

/// The longest matching of corners in order, nearest first among equals (dynamic programming).
void matchCorners(const Loop& a, const std::vector<double>& us, const Loop& b,
                  const std::vector<double>& vs, const RigidMotion& map, double tolerance,
                  std::vector<Anchor>* anchors) {
  const std::size_t m = us.size(), n = vs.size();
  std::vector<Vec2> images, targets;
  for (const double u : us) images.push_back(map(a.at(u)));
  for (const double v : vs) targets.push_back(b.at(v));
  const auto gain = [&](std::size_t i, std::size_t j) {
    const double d = (images[i] - targets[j]).norm();
    return d <= tolerance ? 2 - d / tolerance : -1.0;
  };
  std::vector<std::vector<double>> best(m + 1, std::vector<double>(n + 1, 0));
  for (std::size_t i = m; i-- > 0;)
    for (std::size_t j = n; j-- > 0;) {
      best[i][j] = std::max(best[i + 1][j], best[i][j + 1]);
      const double g = gain(i, j);
      if (g > 0) best[i][j] = std::max(best[i][j], g + best[i + 1][j + 1]);
    }
  for (std::size_t i = 0, j = 0; i < m && j < n;) {
    const double g = gain(i, j);
    if (g > 0 && best[i][j] == g + best[i + 1][j + 1])
      anchors->push_back({us[i++], vs[j++], true});
    else if (best[i][j] == best[i + 1][j])
      ++i;
    else
      ++j;
  }
}

/// Anchors of the stretch u0 < u < u1 of loop a that runs against v0 > v > v1 of loop b, both ends
/// included.
std::vector<Anchor> matchStretch(const Loop& a, double u0, double u1, const Loop& b, double v0,
                                 double v1, const RigidMotion& map, double tolerance) {
  const std::vector<double> us = cornersBetween(a, u0, u1);
  std::vector<double> vs = cornersBetween(b, v1, v0);
  std::reverse(vs.begin(), vs.end());
  std::vector<Anchor> anchors{{u0, v0, true}};
  matchCorners(a, us, b, vs, map, tolerance, &anchors);
  anchors.push_back({u1, v1, true});

  // A corner without a partner is matched to the nearest point between its neighbours' images. The
  // margin keeps different corners apart.
  const auto free_range = [](double low, double high) {
    const double margin = std::min(0.05 * (high - low), 2 * kLeastTolerance);
    return std::pair{low + margin, high - margin};
  };
  for (const double u : us) {
    const auto next =
        std::lower_bound(anchors.begin(), anchors.end(), u,
                         [](const Anchor& x, double value) { return x.from < value; });
    if (next->from == u) continue;
    const auto [low, high] = free_range(next->to, (next - 1)->to);
    anchors.insert(next, {u, b.nearest(map(a.at(u)), low, high), false});
  }
  const RigidMotion back = map.inverse();
  for (const double v : vs) {
    const auto next = std::lower_bound(anchors.begin(), anchors.end(), v,
                                       [](const Anchor& x, double value) { return x.to > value; });
    if (next->to == v) continue;
    const auto [low, high] = free_range((next - 1)->from, next->from);
    anchors.insert(next, {a.nearest(back(b.at(v)), low, high), v, false});
  }
  return anchors;
}

/// Positions in [0, length) where the axis of a reflection crosses a loop.
std::vector<double> axisCrossings(const Loop& a, const RigidMotion& map, double tolerance) {
  const Vec2 normal = perp(unit((map.angle - kPi) / 2));
  const auto side = [&](const Vec2& p) { return normal.dot(p - map(p)) / 2; };
  std::vector<double> found;
  // Find corners that are their own image.
  for (const double corner : a.corners()) {
    const Vec2 image = map(a.at(corner));
    const double own = (image - a.at(corner)).norm();
    bool nearest = own <= tolerance;
    for (std::size_t j = 0; j < a.corners().size() && nearest; ++j)
      if ((image - a.at(a.corners()[j])).norm() < own) nearest = false;
    if (nearest) found.push_back(corner);
  }
  const std::size_t corners = found.size();
  const auto taken = [&](double p) {
    return std::any_of(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(corners),
                       [&](double q) {
                         const double gap = std::abs(p - q);
                         return std::min(gap, a.length() - gap) <= tolerance;
                       });
  };
  // Find changes of side between these corners.
  const auto& samples = a.samples();
  const auto sign = [&](std::size_t i) {
    const double d = side(samples[i % (samples.size() - 1)].point);
    return d > 1e-9 ? 1 : d < -1e-9 ? -1 : 0;
  };
  const std::size_t n = samples.size() - 1;
  std::size_t start = 0;
  while (start < n && sign(start) == 0) ++start;
  for (std::size_t i = start, last = start; i <= start + n; ++i) {
    if (sign(i) == 0) continue;
    if (sign(i) != sign(last)) {
      const auto position = [&](std::size_t k) {
        return samples[k % n].position + (k >= n ? a.length() : 0);
      };
      double low = position(last), high = position(i);
      if (i - last > 1) {  // use the middle one of the points on the axis
        low = high = position((i + last) / 2);
      }
      while (high - low > 1e-12 * a.length()) {
        const double middle = (low + high) / 2;
        if (middle <= low || middle >= high) break;
        ((side(a.at(middle)) > 0) == (sign(last) > 0) ? low : high) = middle;
      }
      const double p = a.wrapped((low + high) / 2);
      if (!taken(p)) found.push_back(p);
    }
    last = i;
  }
  return found;
}

}  // namespace

std::optional<Correspondence> correspond(const Loop& a, const Loop& b, const RigidMotion& map,
                                         double greatest) {
  const double worst = std::max(deviation(a, b, map), deviation(b, a, map.inverse()));
  if (!(worst <= greatest)) return {};
  Correspondence c;
  c.tolerance = toleranceFor(worst);
  double u = a.corner(0), v = 0, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < a.edges(); ++i)
    for (int j = 0; j < b.edges(); ++j) {
      const double d = (map(a.at(a.corner(i))) - b.at(b.corner(j))).norm();
      if (d < least) least = d, u = a.corner(i), v = b.corner(j);
    }
  if (least > c.tolerance) v = b.nearest(map(a.at(u)), 0, b.length());
  c.anchors = matchStretch(a, u, u + a.length(), b, v, v - b.length(), map, c.tolerance);
  c.anchors.pop_back();  // repeats the first anchor
  return c;
}

std::optional<Correspondence> correspondToItself(const Loop& a, const RigidMotion& map,
                                                 double greatest) {
  const double worst = deviation(a, a, map);
  if (!(worst <= greatest)) return {};
  Correspondence c;
  c.tolerance = toleranceFor(worst);
  std::vector<double> fixed = axisCrossings(a, map, c.tolerance);
  if (fixed.size() < 2) return {};
  // A reflection has two fixed points on a simple loop. If noise near the axis causes more, use the
  // two that halve the loop.
  sortNumbers(fixed);
  double p = 0, q = 0, least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < fixed.size(); ++i)
    for (std::size_t j = i + 1; j < fixed.size(); ++j) {
      const double uneven = std::abs(2 * (fixed[j] - fixed[i]) - a.length());
      if (uneven < least) least = uneven, p = fixed[i], q = fixed[j];
    }
  c.anchors = matchStretch(a, p, q, a, p + a.length(), q, map, c.tolerance);
  return c;
}

}  // namespace seamwise
