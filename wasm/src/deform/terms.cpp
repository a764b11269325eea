#include "deform/terms.h"

#include <cmath>
#include <limits>

#include "tuning/paper.h"

namespace seamwise {
namespace {

Vec2 at(const VectorX& x, int v) { return x.segment<2>(2 * v); }

/// Adds force * row to the gradient and stiffness * row row^T to the Hessian, for a residual's row
/// over a few coordinates.
template <std::size_t N>
void addRow(const std::array<int, N>& index, const std::array<double, N>& row, double force,
            double stiffness, VectorX* gradient, SparseHessian* hessian) {
  if (gradient)
    for (std::size_t a = 0; a < N; ++a) (*gradient)[index[a]] += force * row[a];
  if (hessian)
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t b = 0; b <= a; ++b)
        hessian->add(index[a], index[b], stiffness * row[a] * row[b]);
}

std::array<int, 6> coordinates(const std::array<int, 3>& v) {
  return {2 * v[0], 2 * v[0] + 1, 2 * v[1], 2 * v[1] + 1, 2 * v[2], 2 * v[2] + 1};
}

}  // namespace

double proximityEnergy(const std::vector<Target>& targets, const VectorX& x, VectorX* gradient,
                       SparseHessian* hessian) {
  double energy = 0;
  for (const Target& t : targets) {
    const Vec2 r = at(x, t.vertex) - t.position;
    energy += t.weight * r.squaredNorm();
    for (int c = 0; c < 2; ++c) {
      if (gradient) (*gradient)[2 * t.vertex + c] += 2 * t.weight * r[c];
      if (hessian) hessian->add(2 * t.vertex + c, 2 * t.vertex + c, 2 * t.weight);
    }
  }
  return energy;
}

ConformalTriangle conformalTriangle(const std::array<int, 3>& vertices, const Vec2& a,
                                    const Vec2& b, const Vec2& c) {
  ConformalTriangle t{vertices, triangleArea(a, b, c), {}};
  const Vec2 corner[3] = {a, b, c};
  for (int k = 0; k < 3; ++k) {
    const Vec2 opposite = corner[(k + 2) % 3] - corner[(k + 1) % 3];
    const Vec2 grad = perp(opposite) / (2 * t.area);  // gradient of the hat function of corner k
    t.rows[0][2 * k] = grad.x(), t.rows[0][2 * k + 1] = -grad.y();
    t.rows[1][2 * k] = grad.y(), t.rows[1][2 * k + 1] = grad.x();
  }
  return t;
}

double conformalEnergy(const std::vector<ConformalTriangle>& triangles, const VectorX& x,
                       double weight, VectorX* gradient, SparseHessian* hessian) {
  // |J - cof J|^2 / 2 = (u_x - v_y)^2 + (u_y + v_x)^2
  double energy = 0;
  for (const ConformalTriangle& t : triangles) {
    const auto index = coordinates(t.vertices);
    for (const auto& row : t.rows) {
      double r = 0;
      for (int a = 0; a < 6; ++a) r += row[a] * x[index[a]];
      energy += weight * t.area * r * r;
      addRow(index, row, 2 * weight * t.area * r, 2 * weight * t.area, gradient, hessian);
    }
  }
  return energy;
}

double flipEnergy(const std::vector<ConformalTriangle>& triangles, const VectorX& x, double weight,
                  VectorX* gradient, SparseHessian* hessian) {
  double energy = 0;
  for (const ConformalTriangle& t : triangles) {
    const Vec2 a = at(x, t.vertices[0]), b = at(x, t.vertices[1]), c = at(x, t.vertices[2]);
    const double scale = PaperTuning::kFlipStart * t.area;
    const double d = triangleArea(a, b, c) / scale;
    if (d >= 1) continue;
    if (d <= 0) return std::numeric_limits<double>::infinity();
    const double g = d * d * d - 3 * d * d + 3 * d;
    const double g1 = 3 * (d - 1) * (d - 1), g2 = 6 * (d - 1);
    const double w = weight * t.area;
    energy += w * (1 / g - 1);
    const double first = -g1 / (g * g), second = 2 * g1 * g1 / (g * g * g) - g2 / (g * g);
    const Vec2 da = perp(c - b) / (2 * scale), db = perp(a - c) / (2 * scale),
               dc = perp(b - a) / (2 * scale);
    const std::array<double, 6> row{da.x(), da.y(), db.x(), db.y(), dc.x(), dc.y()};
    addRow(coordinates(t.vertices), row, w * first, w * second, gradient, hessian);
  }
  return energy;
}

double matchEnergy(const std::vector<EdgePair>& pairs, const VectorX& x, double weight,
                   VectorX* gradient, SparseHessian* hessian) {
  double energy = 0;
  for (const EdgePair& p : pairs) {
    const Vec2 a = at(x, p.a1) - at(x, p.a0), b = at(x, p.b1) - at(x, p.b0);
    const double la = a.norm(), lb = b.norm(), r = la - p.rho * lb;
    energy += weight * r * r;
    if (!gradient && !hessian) continue;
    const Vec2 na = a / la, nb = -p.rho * b / lb;
    const std::array<int, 8> index{2 * p.a0, 2 * p.a0 + 1, 2 * p.a1, 2 * p.a1 + 1,
                                   2 * p.b0, 2 * p.b0 + 1, 2 * p.b1, 2 * p.b1 + 1};
    const std::array<double, 8> row{-na.x(), -na.y(), na.x(), na.y(),
                                    -nb.x(), -nb.y(), nb.x(), nb.y()};
    // edges of a dart share a vertex: rows of one coordinate must add up before they are squared
    if (gradient)
      for (int k = 0; k < 8; ++k) (*gradient)[index[k]] += 2 * weight * r * row[k];
    if (!hessian) continue;
    for (int k = 0; k < 8; ++k)
      for (int l = 0; l < 8; ++l)
        if (index[k] > index[l] || (index[k] == index[l]))
          hessian->add(index[k], index[l], 2 * weight * row[k] * row[l]);
  }
  return energy;
}

double symmetryEnergy(const std::vector<MirrorPair>& pairs, const VectorX& x, double weight,
                      VectorX* gradient, SparseHessian* hessian) {
  double energy = 0;
  for (const MirrorPair& p : pairs) {
    const Vec2 r = at(x, p.image) - (p.linear * at(x, p.source) + p.shift);
    energy += weight * r.squaredNorm();
    const Vec2 back = p.linear.transpose() * r;
    // J = [I, -Q] over (image, source); on the axis both are one vertex and J = I - Q
    const bool fixed = p.source == p.image;
    for (int c = 0; c < 2; ++c) {
      if (gradient) {
        (*gradient)[2 * p.image + c] += 2 * weight * r[c];
        (*gradient)[2 * p.source + c] -= 2 * weight * back[c];
      }
      if (!hessian) continue;
      if (fixed) {
        const Mat2 j = Mat2::Identity() - p.linear;
        const Mat2 h = 2 * weight * j.transpose() * j;
        for (int d = 0; d <= c; ++d) hessian->add(2 * p.image + c, 2 * p.image + d, h(c, d));
        continue;
      }
      hessian->add(2 * p.image + c, 2 * p.image + c, 2 * weight);
      hessian->add(2 * p.source + c, 2 * p.source + c, 2 * weight);
      for (int d = 0; d < 2; ++d)
        hessian->add(2 * p.image + c, 2 * p.source + d, -2 * weight * p.linear(c, d));
    }
  }
  return energy;
}

}  // namespace seamwise
