#include "deform/clearance.h"

#include <algorithm>

#include "geometry/polygon.h"
#include "tuning/shaping.h"

namespace seamwise {
std::vector<double> outsideClearance(const Piece& piece, double horizon) {
  const int n = static_cast<int>(piece.outline.size());
  Polyline rim;
  for (int v : piece.outline) rim.push_back(piece.rest[v]);
  std::vector<double> along(n + 1, 0);
  for (int k = 0; k < n; ++k) along[k + 1] = along[k] + (rim[(k + 1) % n] - rim[k]).norm();
  std::vector<double> clear(n, horizon);
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const int next = (k + 1) % n;
      if (k == i || next == i) continue;
      const Vec2 a = rim[k], d = rim[next] - a;
      const double length = along[k + 1] - along[k];
      // The outline cannot come near enough before this arc length.
      const double skipped = along[k] + (rim[i] - a).norm() - clear[i];
      if (skipped >= along[k + 1]) {
        while (k + 1 < n && along[k + 2] <= skipped) ++k;
        continue;
      }
      const double t = std::clamp((rim[i] - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      const Vec2 q = a + t * d;
      const double distance = (q - rim[i]).norm();
      if (distance >= clear[i]) continue;
      double way = std::abs(along[k] + t * length - along[i]);
      way = std::min(way, along[n] - way);
      if (distance > ShapingTuning::kGapDetour * way || contains(rim, (q + rim[i]) / 2)) continue;
      clear[i] = distance;
    }
  }
  return clear;
}

}  // namespace seamwise
