#include "seam/join.h"

#include <limits>

namespace seamwise {

SeamMidpoints seamMidpoints(const Seam& seam, const Shapes& shapes,
                            const std::vector<Alignment>& at) {
  const auto &a = shapes[seam.a.piece], &b = shapes[seam.b.piece];
  const Alignment &wa = at[seam.a.piece], &wb = at[seam.b.piece];
  const Mat2 ra = rotation(-wa.angle), rb = rotation(-wb.angle);
  SeamMidpoints m;
  const std::size_t n = seam.a.vertices.size() - 1;
  m.x.reserve(n), m.y.reserve(n), m.length.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a0 = a[seam.a.vertices[i]], &a1 = a[seam.a.vertices[i + 1]];
    const Vec2 &b0 = b[seam.b.vertices[i]], &b1 = b[seam.b.vertices[i + 1]];
    m.x.push_back(ra * ((a0 + a1) / 2 - wa.translation));
    m.y.push_back(rb * ((b0 + b1) / 2 - wb.translation));
    m.length.push_back(((a1 - a0).norm() + (b1 - b0).norm()) / 2);
  }
  return m;
}

Join bestJoin(const WallpaperGroup& group, const Seam& seam, const Shapes& shapes,
              const std::vector<Alignment>& at, bool continuous_only) {
  const SeamMidpoints m = seamMidpoints(seam, shapes, at);
  const auto& [u1, u2] = group.reducedBasis();
  double total = 0;
  for (double l : m.length) total += l;
  Join best;
  best.cost = std::numeric_limits<double>::infinity();
  std::vector<Vec2> residual(m.x.size());
  for (const Element& e : group.elements()) {
    if (continuous_only && e.mirrored) continue;
    Vec2 mean = Vec2::Zero();
    for (std::size_t i = 0; i < m.x.size(); ++i) {
      residual[i] = m.x[i] - e(m.y[i]);
      mean += m.length[i] / total * residual[i];
    }
    const Vec2 nearest = mean - group.reduce(mean);
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        const Vec2 shift = nearest + i * u1 + j * u2;
        double cost = 0;
        for (std::size_t k = 0; k < residual.size() && cost < best.cost; ++k)
          cost += m.length[k] * (residual[k] - shift).norm();
        if (cost < best.cost) {
          best.cost = cost;
          best.element = e;
          best.element.a += shift;
        }
      }
    }
  }
  return best;
}

std::vector<double> joinMismatch(const Join& join, const Seam& seam, const Shapes& shapes,
                                 const std::vector<Alignment>& at) {
  const SeamMidpoints m = seamMidpoints(seam, shapes, at);
  std::vector<double> d(m.x.size());
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = (m.x[i] - join.element(m.y[i])).norm();
  return d;
}

}  // namespace seamwise
